#include "probe/Svg.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace fpm {

std::string svgNumber(double value)
{
    char buffer[64];
    const double rounded = std::abs(value) < 0.005 ? 0.0 : std::clamp(value, -1e9, 1e9);
    const auto end =
        std::to_chars(buffer, buffer + sizeof buffer, rounded, std::chars_format::fixed, 2).ptr;
    std::string text(buffer, end);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.ends_with('.')) text.pop_back();
    return text;
}

std::string withNote(std::string svg, std::string_view note)
{
    const std::size_t at = svg.find('>') + 1; // behind the opening tag
    return svg.insert(at, "\n<metadata>" + escapeXml(note) + "</metadata>");
}

std::string escapeXml(std::string_view text)
{
    std::string escaped;
    for (const char c : text) {
        if (c == '&')
            escaped += "&amp;";
        else if (c == '<')
            escaped += "&lt;";
        else if (c == '>')
            escaped += "&gt;";
        else if (c == '"')
            escaped += "&quot;";
        else if (static_cast<unsigned char>(c) >= 0x20)
            escaped += c;
    }
    return escaped;
}

std::string readableColour(const std::string& colour)
{
    std::array<double, 3> part{};
    for (std::size_t i = 0; i < 3; ++i) {
        int value = 0;
        const char* digits = colour.data() + 1 + 2 * i;
        std::from_chars(digits, digits + 2, value, 16);
        part[i] = value;
    }
    // Brightness by the weights of the eye; 255 is white.
    constexpr double most = 125;
    const double bright = 0.299 * part[0] + 0.587 * part[1] + 0.114 * part[2];
    const double share = bright > most ? most / bright : 1;
    std::string text = "#";
    for (const double value : part) {
        const int whole = int(value * share + 0.5);
        for (const int digit : {whole / 16, whole % 16}) text += "0123456789ABCDEF"[digit];
    }
    return text;
}

double textWidth(std::string_view text, double size)
{
    double em = 0;
    for (const char c : text) {
        if ((static_cast<unsigned char>(c) & 0xC0) == 0x80) continue; // UTF-8 continuation byte
        if (std::string_view("iljtfI.,:;'|!() []").find(c) != std::string_view::npos)
            em += 0.36;
        else if (std::string_view("mwMW@%").find(c) != std::string_view::npos)
            em += 0.95;
        else if (c >= 'A' && c <= 'Z')
            em += 0.70;
        else
            em += 0.60;
    }
    return em * size;
}

SvgDrawing::SvgDrawing(double width, double height, std::string_view description)
{
    const std::string w = svgNumber(width), h = svgNumber(height);
    body_ = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + w + "\" height=\"" + h
            + "\" viewBox=\"0 0 " + w + " " + h + "\" role=\"img\" font-family=\"system-ui, "
            + "-apple-system, 'Segoe UI', Roboto, 'Helvetica Neue', Arial, sans-serif\">\n<title>"
            + escapeXml(description) + "</title>\n<rect width=\"" + w + "\" height=\"" + h
            + "\" fill=\"#ffffff\"/>\n";
}

void SvgDrawing::line(Pixel from, Pixel to, std::string_view attributes)
{
    element("<line x1=\"" + svgNumber(from.x) + "\" y1=\"" + svgNumber(from.y) + "\" x2=\""
            + svgNumber(to.x) + "\" y2=\"" + svgNumber(to.y) + "\" " + std::string(attributes)
            + "/>");
}

void SvgDrawing::rectangle(Pixel corner, double width, double height, std::string_view attributes)
{
    element("<rect x=\"" + svgNumber(corner.x) + "\" y=\"" + svgNumber(corner.y) + "\" width=\""
            + svgNumber(width) + "\" height=\"" + svgNumber(height) + "\" "
            + std::string(attributes) + "/>");
}

void SvgDrawing::text(Pixel position, std::string_view text, const SvgFont& font)
{
    const std::string x = svgNumber(position.x), y = svgNumber(position.y);
    std::string xml = "<text x=\"" + x + "\" y=\"" + y + "\" font-size=\"" + svgNumber(font.size)
                      + "\" fill=\"" + font.colour + "\"";
    if (font.anchor == Anchor::middle) xml += " text-anchor=\"middle\"";
    if (font.anchor == Anchor::end) xml += " text-anchor=\"end\"";
    if (font.bold) xml += " font-weight=\"600\"";
    if (font.halo) xml += " stroke=\"#ffffff\" stroke-width=\"2.5\" paint-order=\"stroke\"";
    if (font.turn != 0)
        xml += " transform=\"rotate(" + svgNumber(font.turn) + " " + x + " " + y + ")\"";
    element(xml + ">" + escapeXml(text) + "</text>");
}

void SvgDrawing::element(std::string_view xml)
{
    body_ += xml;
    body_ += '\n';
}

std::string SvgDrawing::str() const
{
    return body_ + "</svg>\n";
}

} // namespace fpm
