#include "probe/Picture.h"

#include "base/Error.h"
#include "base/Format.h"
#include "probe/Raster.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fpm {

namespace {

constexpr double pageWidth = 760; ///< of the picture on the page, CSS pixels
constexpr int density = 2;        ///< picture pixels per CSS pixel, for fine screens
constexpr int supersampling = 2;  ///< samples per picture pixel and direction
constexpr double margin = 10;     ///< picture pixels around the model
constexpr double lineWidth = 1.5; ///< of a mesh line between two faces, picture pixels
constexpr double lineStrength = 0.62, creaseStrength = 0.9;

double dot(const Point& a, const Point& b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Light from the upper left behind the eye; never darker than 0.76, so that colours stay readable
/// against the bar. `normal` in view components.
double lightOn(const Point& normal)
{
    constexpr Point lamp{-0.35, 0.55, 0.758};
    return 0.76 + 0.28 * std::max(0.0, dot(normal, lamp));
}

std::vector<Index> partNumbers(const PictureSpec& spec, const Mesh& mesh)
{
    std::vector<Index> numbers;
    for (const std::string& name : spec.parts) {
        numbers.push_back(mesh.findPart(name));
        if (numbers.back() >= 0) continue;
        std::string names;
        for (const MeshPart& part : mesh.parts) names += " " + part.name;
        throw Error(ExitCode::dictionary, "the mesh has no part '" + name + "'",
                    "its parts are:" + names);
    }
    if (numbers.empty())
        for (std::size_t part = 0; part < mesh.parts.size(); ++part) numbers.push_back(Index(part));
    return numbers;
}

/// Reflections of the model: sign of each coordinate.
std::vector<std::array<bool, 3>> reflections(const MirrorPlanes& mirror)
{
    std::vector<std::array<bool, 3>> list;
    for (unsigned bits = 0; bits < 8; ++bits) {
        std::array<bool, 3> mirrored{};
        bool wanted = true;
        for (unsigned k = 0; k < 3; ++k) {
            mirrored[k] = bits >> k & 1;
            wanted = wanted && (!mirrored[k] || mirror.used[k]);
        }
        if (wanted) list.push_back(mirrored);
    }
    return list;
}

Point reflected(Point point, const std::array<bool, 3>& mirrored, const Point& origin)
{
    for (std::size_t k = 0; k < 3; ++k)
        if (mirrored[k]) point[k] = 2 * origin[k] - point[k];
    return point;
}

/// Mesh lines fade where faces shrink to a few pixels: a black mass would hide the colours.
/// `height` is from the face's centre to the line, in picture pixels.
RasterEdge edgeFor(bool crease, double height)
{
    const double room = std::clamp((height - 1.5) / 4, 0.0, 1.0);
    const double strength = crease ? creaseStrength * std::max(room, 0.5) : lineStrength * room;
    return {(crease ? 0.65 : 0.5) * lineWidth * supersampling, strength};
}

/// Draws the faces of one reflection of the shell.
class FacePainter
{
public:
    FacePainter(Raster& raster, const Shell& shell, const ShellShape& shape, bool edges)
        : raster_(raster),
          shell_(shell),
          shape_(shape),
          edges_(edges)
    {
    }

    void paint(const Camera& camera, const std::array<bool, 3>& mirrored, const Point& origin)
    {
        screen_.resize(shape_.positions.size());
        for (std::size_t i = 0; i < screen_.size(); ++i) {
            screen_[i] = camera.project(reflected(shape_.positions[i], mirrored, origin));
            screen_[i].x *= supersampling, screen_[i].y *= supersampling;
        }
        flipped_ = (mirrored[0] != mirrored[1]) != mirrored[2];
        camera_ = &camera;
        mirrored_ = mirrored;
        for (std::size_t quad = 0; quad < shell_.quads.size(); ++quad) paintQuad(quad);
    }

    const std::vector<double>* vertexValue = nullptr; ///< one value a vertex, or
    bool byPart = false;                              ///< the part's number
    double sign = 1;

private:
    void paintQuad(std::size_t quad)
    {
        std::array<RasterCorner, 4> corners;
        RasterCorner centre{0, 0, 0, 0, 0};
        for (std::size_t k = 0; k < 4; ++k) {
            const std::size_t vertex = std::size_t(shell_.quads[quad][k]);
            const Point normal = reflected(shape_.cornerNormals[quad][k], mirrored_, {0, 0, 0});
            RasterCorner& corner = corners[k];
            corner = {screen_[vertex].x, screen_[vertex].y, screen_[vertex].depth,
                      byPart ? double(shell_.parts[quad]) : sign * (*vertexValue)[vertex],
                      lightOn(camera_->toView(normal))};
            centre.x += corner.x / 4, centre.y += corner.y / 4, centre.depth += corner.depth / 4;
            centre.value += corner.value / 4, centre.light += corner.light / 4;
        }
        // y points downwards: faces seen from outside turn clockwise in numbers
        const double area = (corners[2].x - corners[0].x) * (corners[3].y - corners[1].y)
                            - (corners[2].y - corners[0].y) * (corners[3].x - corners[1].x);
        if (!std::isfinite(area) || (flipped_ ? area <= 0 : area >= 0)) return;
        for (std::size_t k = 0; k < 4; ++k) {
            const RasterCorner &a = corners[k], &b = corners[(k + 1) % 4];
            raster_.triangle(a, b, centre, edge(a, b, centre, shape_.creases[quad] >> k & 1));
        }
    }

    RasterEdge
    edge(const RasterCorner& a, const RasterCorner& b, const RasterCorner& c, bool crease) const
    {
        if (!edges_ && !crease) return {};
        const double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
        return edgeFor(crease, std::abs(area) / std::hypot(b.x - a.x, b.y - a.y) / supersampling);
    }

    Raster& raster_;
    const Shell& shell_;
    const ShellShape& shape_;
    bool edges_;
    bool flipped_ = false;
    std::array<bool, 3> mirrored_{};
    const Camera* camera_ = nullptr;
    std::vector<Projected> screen_;
};

} // namespace

PicturePainter::PicturePainter(const PictureSpec& spec, const Mesh& mesh)
    : spec_(spec),
      mesh_(mesh),
      nodeCount_(mesh.points.size()),
      elementCount_(mesh.hexahedra.size()),
      shell_(makeShell(mesh, partNumbers(spec, mesh), spec.mirror)),
      camera_(spec.view, spec.up, spec.perspective),
      smallest_(std::numeric_limits<double>::infinity()),
      largest_(-smallest_),
      byPart_(spec.field.field == "Part")
{
    for (const MeshPart& part : mesh.parts) partNames_.push_back(part.name);
    for (const Index node : shell_.nodes) undeformed_.push_back(mesh.points[std::size_t(node)]);
}

void PicturePainter::leaveOutDeleted(const Frame& frame)
{
    std::vector<bool> deleted;
    for (const ResultField& field : frame.elementFields)
        if (field.name == "STATUS" && field.values.size() == elementCount_
            && std::ranges::count(field.values, 0.0) > 0)
            for (const double status : field.values) deleted.push_back(status == 0);
    if (deleted == deleted_) return;
    deleted_ = deleted;
    shell_ = makeShell(mesh_, partNumbers(spec_, mesh_), spec_.mirror, deleted_);
    undeformed_.clear();
    for (const Index node : shell_.nodes) undeformed_.push_back(mesh_.points[std::size_t(node)]);
}

std::vector<Point> PicturePainter::positions(const Frame& frame) const
{
    std::vector<Point> deformed = undeformed_;
    for (const ResultField& field : frame.nodeFields) {
        if (field.name != "U" || field.columns != 3) continue;
        if (field.values.size() != 3 * nodeCount_)
            throw Error(ExitCode::mesh,
                        format("displacements of {} nodes do not belong to a mesh of {} nodes",
                               field.values.size() / 3, nodeCount_),
                        "the mesh was changed after the run: run fpmExplicit again");
        for (std::size_t vertex = 0; vertex < deformed.size(); ++vertex)
            for (std::size_t k = 0; k < 3; ++k)
                deformed[vertex][k] +=
                    spec_.warp * field.values[3 * std::size_t(shell_.nodes[vertex]) + k];
    }
    return deformed;
}

std::vector<double> PicturePainter::values(const Frame& frame) const
{
    const ScalarField field = scalarField(frame, spec_.field);
    if (field.values.size() != (field.onNodes ? nodeCount_ : elementCount_))
        throw Error(ExitCode::mesh,
                    "field '" + spec_.field.field + "' does not belong to this mesh",
                    "the mesh was changed after the run: run fpmExplicit again");
    return vertexValues(shell_, field);
}

void PicturePainter::include(const Frame& frame)
{
    leaveOutDeleted(frame);
    const std::vector<Point> deformed = positions(frame);
    const std::vector<double> shown = byPart_ ? std::vector<double>{} : values(frame);
    for (const auto& mirrored : reflections(spec_.mirror)) {
        for (const Point& position : deformed)
            camera_.include(reflected(position, mirrored, spec_.mirror.origin));
        const double sign = mirrorSign(spec_.field.component, mirrored);
        for (const double value : shown) {
            if (!std::isfinite(value)) continue;
            smallest_ = std::min(smallest_, sign * value);
            largest_ = std::max(largest_, sign * value);
        }
    }
}

ColourScale PicturePainter::scale() const
{
    if (spec_.range) {
        const auto [lower, upper] = *spec_.range;
        return {lower, upper, spec_.bands.value_or(roundBands(lower, upper)), spec_.colours};
    }
    const bool any = smallest_ <= largest_;
    ColourScale scale = roundScale(any ? smallest_ : 0, any ? largest_ : 1, spec_.colours);
    if (spec_.bands) scale.bands = *spec_.bands;
    return scale;
}

Image PicturePainter::paint(const Frame& frame)
{
    const double height =
        std::clamp(std::ceil(pageWidth * camera_.aspect()), 0.4 * pageWidth, 1.1 * pageWidth);
    const int columns = int(density * pageWidth), rows = int(density * height);
    camera_.fit(columns, rows, margin);
    Raster raster(columns, rows, supersampling);
    const ShellShape shape = makeShape(shell_, positions(frame));
    const std::vector<double> shown = byPart_ ? std::vector<double>{} : values(frame);
    FacePainter painter(raster, shell_, shape, spec_.edges);
    painter.vertexValue = &shown;
    painter.byPart = byPart_;
    for (const auto& mirrored : reflections(spec_.mirror)) {
        painter.sign = mirrorSign(spec_.field.component, mirrored);
        painter.paint(camera_, mirrored, spec_.mirror.origin);
    }
    if (byPart_)
        return raster.image([](double part) { return categoryColour(std::size_t(part + 0.5)); });
    const ColourScale colours = scale();
    return raster.image([&](double value) { return colours.colour(value); });
}

PictureFiles PicturePainter::draw(const Frame& frame)
{
    leaveOutDeleted(frame);
    const Image image = paint(frame);
    PictureFiles files;
    files.png = encodePng(image);

    PictureNotes notes;
    const std::string time = "t = " + toText(frame.time, 6);
    notes.title = spec_.title.empty() ? spec_.field.text() : spec_.title;
    notes.subtitle = time;
    if (spec_.warp != 1) notes.subtitle += ", displacements × " + toText(spec_.warp, 6);
    notes.quantity = spec_.field.text();
    for (std::size_t k = 0; k < 3; ++k) {
        Point axis{0, 0, 0};
        axis[k] = 1;
        notes.axes[k] = camera_.toView(axis);
    }
    if (byPart_) {
        std::vector<Index> shown = shell_.parts;
        shown.erase(std::unique(shown.begin(), shown.end()), shown.end());
        for (const Index part : shown)
            notes.categories.emplace_back(partNames_[std::size_t(part)],
                                          categoryColour(std::size_t(part)));
    } else {
        notes.scale = scale();
        const std::vector<double> shownValues = values(frame);
        notes.smallest = std::numeric_limits<double>::infinity(), notes.largest = -notes.smallest;
        for (const double value : shownValues) {
            if (!std::isfinite(value)) continue;
            notes.smallest = std::min(notes.smallest, value);
            notes.largest = std::max(notes.largest, value);
        }
    }
    files.svg = pictureSheet(files.png, double(image.width) / density,
                             double(image.height) / density, notes);
    return files;
}

} // namespace fpm
