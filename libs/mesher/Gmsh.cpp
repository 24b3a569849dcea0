#include "mesher/Gmsh.h"

#include "base/Error.h"
#include "base/Format.h"

#include <gmsh.h>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <stdexcept>

namespace fpm {

namespace {

namespace geo = gmsh::model::geo;

constexpr int hexahedronType = 5, hexahedronCorners = 8;

/// gmsh from initialize to finalize, whatever happens between.
class Session
{
public:
    Session()
    {
        // A user's ~/.gmshrc must not change meshes, and the toolkit that gmsh draws with must
        // write no preferences there; one thread makes meshes repeatable.
        ::setenv("HOME", "/dev/null", 1);
        gmsh::initialize(0, nullptr, false);
        gmsh::option::setNumber("General.Terminal", 0);
        gmsh::option::setNumber("General.NumThreads", 1);
        gmsh::logger::start();
    }
    ~Session()
    {
        try {
            gmsh::logger::stop(); // it would go on into the next session
            gmsh::finalize();
        } catch (...) { // the work is done or has failed already; nothing more to say
        }
    }
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;
};

/// Lines gmsh logged at the given level, without the level itself.
std::vector<std::string> logged(const std::string& level)
{
    std::vector<std::string> lines, found;
    gmsh::logger::get(lines);
    for (const auto& line : lines)
        if (line.starts_with(level + ": ")) found.push_back(line.substr(level.size() + 2));
    return found;
}

std::string firstError(const std::string& thrown)
{
    if (!thrown.empty()) return thrown;
    const auto lines = logged("Error");
    return lines.empty() ? "gmsh failed without a message" : lines.front();
}

/// gmsh before 4.9 throws std::string, later ones std::runtime_error.
std::string failureOf(const std::function<void()>& work)
{
    try {
        work();
        const auto lines = logged("Error");
        return lines.empty() ? "" : lines.front();
    } catch (const Error&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& error) {
        return firstError(error.what());
    } catch (const std::string& error) {
        return firstError(error);
    } catch (...) {
        return firstError("");
    }
}

std::vector<int> addBlocks(const Section& section)
{
    std::vector<int> points, curves, surfaces;
    for (const auto& [x, y] : section.points) points.push_back(geo::addPoint(x, y, 0));
    const int centre = geo::addPoint(0, 0, 0);
    for (const auto& curve : section.curves) {
        const int from = points[curve.from], to = points[curve.to];
        curves.push_back(curve.arc ? geo::addCircleArc(from, centre, to) : geo::addLine(from, to));
        geo::mesh::setTransfiniteCurve(curves.back(), curve.cells + 1);
    }
    for (const auto& block : section.blocks) {
        std::vector<int> loop, corners;
        for (const int side : block) {
            const auto& curve = section.curves[std::abs(side) - 1];
            loop.push_back(side > 0 ? curves[side - 1] : -curves[-side - 1]);
            corners.push_back(points[side > 0 ? curve.from : curve.to]);
        }
        surfaces.push_back(geo::addPlaneSurface({geo::addCurveLoop(loop)}));
        geo::mesh::setTransfiniteSurface(surfaces.back(), "Left", corners);
        geo::mesh::setRecombine(2, surfaces.back());
    }
    return surfaces;
}

std::string typeName(int type)
{
    std::string name;
    int dimension = 0, order = 0, nodeCount = 0, primaryNodeCount = 0;
    std::vector<double> local;
    gmsh::model::mesh::getElementProperties(type, name, dimension, order, nodeCount, local,
                                            primaryNodeCount);
    return name;
}

std::vector<Point> fetchPoints(const TagMap& nodes)
{
    std::vector<std::size_t> tags;
    std::vector<double> coordinates, parameters;
    gmsh::model::mesh::getNodes(tags, coordinates, parameters, -1, -1, false, false);
    std::vector<Point> points(nodes.size());
    std::size_t found = 0;
    for (std::size_t entry = 0; entry < tags.size(); ++entry) {
        const Index node = nodes.find(tags[entry]);
        if (node < 0) continue;
        ++found;
        for (int k = 0; k < 3; ++k) points[node][k] = coordinates[3 * entry + k];
    }
    if (found != points.size())
        throw std::runtime_error(format("{} of {} nodes of hexahedra", found, points.size())
                                 + " were found; tags are missing or not unique");
    return points;
}

} // namespace

std::vector<std::string> withGmsh(const std::string& subject, const std::function<void()>& work)
{
    const Session session;
    const std::string failure = failureOf(work);
    if (!failure.empty())
        throw Error(ExitCode::mesh, format("{}: gmsh stopped: {}", subject, failure));
    return logged("Warning");
}

Hexahedra fetchHexahedra(TagMap& nodes, TagMap& tags, std::string& foreign)
{
    std::vector<int> types;
    std::vector<std::vector<std::size_t>> elements, corners;
    gmsh::model::mesh::getElements(types, elements, corners, 3);
    Hexahedra mesh;
    for (std::size_t kind = 0; kind < types.size(); ++kind)
        if (types[kind] != hexahedronType)
            foreign += (foreign.empty() ? "" : ", ")
                       + format("{} x {}", elements[kind].size(), typeName(types[kind]));
    const auto kind = std::find(types.begin(), types.end(), hexahedronType) - types.begin();
    if (kind == std::ptrdiff_t(types.size())) return mesh;

    // Only nodes of hexahedra: construction points have nodes too.
    nodes = TagMap(corners[kind]);
    tags = TagMap(elements[kind]);
    if (tags.size() != elements[kind].size())
        throw std::runtime_error("the tags of the hexahedra are not unique");
    mesh.points = fetchPoints(nodes);
    mesh.cells.resize(tags.size());
    for (std::size_t entry = 0; entry < elements[kind].size(); ++entry) {
        Hexahedron& cell = mesh.cells[tags.find(elements[kind][entry])];
        for (int corner = 0; corner < hexahedronCorners; ++corner)
            cell[corner] = nodes.find(corners[kind][hexahedronCorners * entry + corner]);
    }
    return mesh;
}

Hexahedra extrude(const std::string& subject,
                  const Section& section,
                  int layers,
                  std::int64_t expectedCells,
                  Log& log)
{
    Hexahedra mesh;
    std::string foreign;
    const auto warnings = withGmsh(subject, [&] {
        gmsh::model::add(subject);
        gmsh::vectorpair base, made;
        for (const int surface : addBlocks(section)) base.emplace_back(2, surface);
        geo::extrude(base, 0, 0, 1, made, {layers}, {}, true);
        geo::synchronize();
        gmsh::model::mesh::generate(3);
        TagMap nodes, tags;
        mesh = fetchHexahedra(nodes, tags, foreign);
    });
    // How exactly gmsh meets its own surface does not matter: nodes are placed here.
    for (const auto& line : warnings)
        if (!line.starts_with("Converged at iter."))
            log.warning(format("{}: gmsh: {}", subject, line));
    if (std::int64_t(mesh.cells.size()) != expectedCells || !foreign.empty())
        throw Error(ExitCode::mesh,
                    format("{}: gmsh made {} hexahedra {}where {} were requested", subject,
                           mesh.cells.size(), foreign.empty() ? "" : "and " + foreign + " ",
                           expectedCells));
    return mesh;
}

} // namespace fpm
