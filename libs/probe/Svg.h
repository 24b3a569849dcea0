#pragma once

#include <string>
#include <string_view>

namespace fpm {

/// A position on a drawing in CSS pixels, y downwards.
struct Pixel {
    double x, y;
};

enum class Anchor { start, middle, end };

/// How a line of text is set.
struct SvgFont {
    double size = 12;
    Anchor anchor = Anchor::start;
    std::string colour = "#374151";
    bool bold = false;
    double turn = 0;   ///< degrees clockwise about the text's own position
    bool halo = false; ///< a white rim, to be read over lines
};

/// At most two decimals, no trailing zeros, independent of the locale.
std::string svgNumber(double value);
/// & < > " as entities; control characters are dropped.
/// Adds a note that is not shown, in front of what is drawn.
std::string withNote(std::string svg, std::string_view note);
std::string escapeXml(std::string_view text);
/// "#rrggbb" darkened until a small text in it can be read on white.
std::string readableColour(const std::string& colour);
/// Width in pixels of `text` set in a usual sans-serif, estimated on the wide side.
double textWidth(std::string_view text, double size);

/// An SVG drawing on white in system fonts; elements are painted in the order they are added.
class SvgDrawing
{
public:
    SvgDrawing(double width, double height, std::string_view description);

    void line(Pixel from, Pixel to, std::string_view attributes);
    void rectangle(Pixel corner, double width, double height, std::string_view attributes);
    void text(Pixel position, std::string_view text, const SvgFont& font = {});
    void element(std::string_view xml); ///< any other element, as it stands
    std::string str() const;            ///< the whole file

private:
    std::string body_;
};

} // namespace fpm
