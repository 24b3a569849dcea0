#pragma once

#include "probe/Camera.h"
#include "probe/PictureSheet.h"
#include "probe/Png.h"
#include "probe/Shell.h"

#include <optional>
#include <string>
#include <vector>

namespace fpm {

/// system/probeDict, pictures: one entry.
struct PictureSpec {
    std::string name;
    std::string title;         ///< empty: the field alone
    FieldChoice field;         ///< "Part" colours by part
    std::vector<double> times; ///< empty: the last frame
    double warp = 1;           ///< factor on the displacements drawn
    Point view{1, -1.2, 0.8};  ///< from the model towards the eye
    Point up{0, 0, 1};
    bool perspective = false;
    std::vector<std::string> parts; ///< empty: all
    MirrorPlanes mirror;
    std::optional<std::array<double, 2>> range; ///< absent: common to all times drawn
    std::optional<int> bands; ///< 0 = smooth; absent: a number that makes round steps
    Palette colours = Palette::turbo;
    bool edges = true;
};

/// The two files of a picture.
struct PictureFiles {
    std::string svg;
    std::vector<std::uint8_t> png;
};

/// Draws the deformed surface of a mesh without the elements a frame's STATUS has deleted, one
/// picture a frame. Show it every frame first: all
/// pictures then share one camera and one colour scale.
class PicturePainter
{
public:
    /// The mesh must live as long. Throws Error(dictionary) for an unknown part.
    PicturePainter(const PictureSpec& spec, const Mesh& mesh);

    void include(const Frame& frame);
    PictureFiles draw(const Frame& frame);

private:
    void leaveOutDeleted(const Frame& frame);
    std::vector<Point> positions(const Frame& frame) const;
    std::vector<double> values(const Frame& frame) const;
    ColourScale scale() const;
    Image paint(const Frame& frame);

    PictureSpec spec_;
    const Mesh& mesh_;
    std::vector<bool> deleted_; ///< elements the shell is without; empty: none
    std::vector<std::string> partNames_;
    std::size_t nodeCount_, elementCount_;
    std::vector<Point> undeformed_; ///< of the shell's vertices
    Shell shell_;
    Camera camera_;
    double smallest_, largest_;
    bool byPart_;
};

} // namespace fpm
