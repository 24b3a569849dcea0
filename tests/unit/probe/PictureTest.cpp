#include "probe/Picture.h"

#include "base/Error.h"
#include "support/boxMesh.h"
#include "unit/probe/decodePng.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>

using namespace fpm;

namespace {

Mesh block()
{
    Mesh mesh;
    test::addBox(mesh, "block", {2, 2, 1}, {0, 0, 0}, {2, 2, 1});
    return mesh;
}

/// U = 0, T = x on nodes.
Frame ramp(const Mesh& mesh)
{
    Frame frame;
    ResultField temperature{"T", 1, {}},
        displacement{"U", 3, std::vector<double>(3 * mesh.points.size())};
    for (const Point& point : mesh.points) temperature.values.push_back(point[0]);
    frame.nodeFields = {displacement, temperature};
    return frame;
}

PictureSpec fromAbove(const std::string& field)
{
    PictureSpec spec;
    spec.field.field = field;
    spec.view = {0, 0, 1};
    spec.edges = false;
    return spec;
}

PictureFiles draw(const PictureSpec& spec, const Mesh& mesh, const Frame& frame)
{
    PicturePainter painter(spec, mesh);
    painter.include(frame);
    return painter.draw(frame);
}

const Colour& at(const Image& image, double right, double down)
{
    const int x = int(right * image.width), y = int(down * image.height);
    return image.pixels[std::size_t(y) * std::size_t(image.width) + std::size_t(x)];
}

bool isWhite(const Colour& colour)
{
    return colour == Colour{255, 255, 255};
}

} // namespace

TEST(Picture, FillsTheFrameOnWhite)
{
    const Mesh mesh = block();

    const Image image = test::decodePng(draw(fromAbove("T"), mesh, ramp(mesh)).png);

    EXPECT_EQ(image.width, image.height);
    EXPECT_TRUE(isWhite(image.pixels.front()));
    EXPECT_FALSE(isWhite(at(image, 0.5, 0.5)));
}

TEST(Picture, ColoursBandsFromLowToHigh)
{
    const Mesh mesh = block();
    PictureSpec spec = fromAbove("T");
    spec.range = std::array<double, 2>{0, 2};
    spec.bands = 2;

    const Image image = test::decodePng(draw(spec, mesh, ramp(mesh)).png);

    EXPECT_EQ(at(image, 0.2, 0.5), at(image, 0.45, 0.5));
    EXPECT_NE(at(image, 0.45, 0.5), at(image, 0.55, 0.5));
    EXPECT_GT(at(image, 0.2, 0.5)[2], at(image, 0.8, 0.5)[2]); // blue is low
}

TEST(Picture, MakesAQuarterModelWhole)
{
    const Mesh mesh = block();
    PictureSpec spec = fromAbove("T");
    spec.mirror.used = {true, true, false};

    const Image image = test::decodePng(draw(spec, mesh, ramp(mesh)).png);

    for (const double y : {0.2, 0.8})
        for (const double x : {0.05, 0.3})
            for (std::size_t k = 0; k < 3; ++k)
                EXPECT_NEAR(at(image, x, y)[k], at(image, 1 - x, y)[k], 3) << x << " " << y;
}

TEST(Picture, FollowsTheDisplacements)
{
    const Mesh mesh = block();
    Frame frame = ramp(mesh);
    for (std::size_t node = 0; node < mesh.points.size(); ++node)
        frame.nodeFields[0].values[3 * node] = mesh.points[node][0]; // twice as long
    PictureSpec spec = fromAbove("T");

    const Image real = test::decodePng(draw(spec, mesh, frame).png);
    spec.warp = 0;
    const Image still = test::decodePng(draw(spec, mesh, frame).png);

    EXPECT_LT(real.height, 0.6 * real.width);
    EXPECT_EQ(still.height, still.width);
}

TEST(Picture, SurvivesFieldsThatBlewUp)
{
    const Mesh mesh = block();
    Frame frame = ramp(mesh);
    frame.nodeFields[0].values[0] = std::numeric_limits<double>::infinity();
    frame.nodeFields[1].values[8] = std::numeric_limits<double>::quiet_NaN();

    const PictureFiles files = draw(fromAbove("T"), mesh, frame);

    EXPECT_EQ(files.svg.substr(0, files.svg.find("base64")).find("nan"), std::string::npos);
    EXPECT_FALSE(isWhite(at(test::decodePng(files.png), 0.75, 0.25)));
}

TEST(Picture, ColoursByPartWithoutAFrame)
{
    Mesh mesh = block();
    test::addBox(mesh, "second", {1, 1, 1}, {2, 0, 0}, {2, 2, 1});

    const PictureFiles files = draw(fromAbove("Part"), mesh, {});

    EXPECT_NE(files.svg.find(">second</text>"), std::string::npos);
    const Image image = test::decodePng(files.png);
    EXPECT_NE(at(image, 0.25, 0.5), at(image, 0.75, 0.5));
}

TEST(Picture, RefusesUnknownPartsAndResultsOfAnotherMesh)
{
    const Mesh mesh = block();
    PictureSpec spec = fromAbove("T");
    Frame frame = ramp(mesh);
    frame.nodeFields[1].values.pop_back();

    EXPECT_THROW(draw(spec, mesh, frame), Error);
    spec.parts = {"rod"};
    EXPECT_THROW(PicturePainter(spec, mesh), Error);
}

TEST(Picture, IsTheSameFileTwice)
{
    const Mesh mesh = block();
    PictureSpec spec = fromAbove("T");
    spec.view = {1, -1.2, 0.8};
    spec.perspective = true;

    EXPECT_EQ(draw(spec, mesh, ramp(mesh)).svg, draw(spec, mesh, ramp(mesh)).svg);
}

TEST(Picture, LeavesDeletedElementsOut)
{
    const Mesh mesh = block();
    Frame frame = ramp(mesh);
    frame.elementFields.push_back({"STATUS", 1, {1, 0, 1, 1}});

    PicturePainter painter(fromAbove("T"), mesh);
    painter.include(frame);
    const Image holed = test::decodePng(painter.draw(frame).png);
    EXPECT_TRUE(isWhite(at(holed, 0.75, 0.75))); // the element of large x and small y
    EXPECT_FALSE(isWhite(at(holed, 0.25, 0.75)));
    EXPECT_FALSE(isWhite(at(holed, 0.75, 0.25)));

    frame.elementFields[0].values[1] = 1; // another frame is whole again
    EXPECT_FALSE(isWhite(at(test::decodePng(painter.draw(frame).png), 0.75, 0.75)));
}
