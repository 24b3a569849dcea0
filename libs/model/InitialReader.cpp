#include "base/Format.h"
#include "model/BoundaryReader.h"
#include "model/PointAlgebra.h"

namespace fpm {

namespace {

/// Two entries of type velocity may not give a node different velocities.
class Givers
{
public:
    explicit Givers(std::size_t nodes) : giver_(nodes, -1) {}

    void refuseAnother(const Dictionary& entry, const std::vector<InitialVelocity>& velocities)
    {
        const int number = int(velocities.size()) - 1;
        for (const Index node : velocities.back().nodes) {
            int& earlier = giver_[std::size_t(node)];
            if (earlier >= 0
                && velocities[std::size_t(earlier)].velocity != velocities.back().velocity)
                entry.fail("value",
                           format("node {} already has another velocity from '{}'", node,
                                  velocities[std::size_t(earlier)].name),
                           "let the two entries address different nodes");
            earlier = number;
        }
    }

private:
    std::vector<int> giver_;
};

void readRotation(const Dictionary& entry, InitialVelocity& initial)
{
    const Point axis = entry.vector("axis");
    const double size = length(axis);
    if (!(size > 0)) entry.fail("axis", "the axis has no direction", "such as: axis (0 0 1);");
    initial.centre = entry.vector("centre");
    initial.spin = along({0, 0, 0}, entry.number("angularVelocity") / size, axis);
}

} // namespace

std::vector<InitialVelocity> readInitialVelocities(const Dictionary& dictionary, const Mesh& mesh)
{
    std::vector<InitialVelocity> velocities;
    Givers givers(mesh.points.size());
    for (const std::string& name : dictionary.keys()) {
        const Dictionary entry = dictionary.sub(name);
        const bool turns = entry.choice("type", {"velocity", "rotation"}) == "rotation";
        InitialVelocity initial;
        initial.name = name;
        initial.rotates = turns;
        initial.nodes = selectNodes(entry, mesh);
        if (entry.has("part")) initial.part = mesh.findPart(entry.word("part"));
        if (turns)
            readRotation(entry, initial);
        else
            initial.velocity = entry.vector("value");
        velocities.push_back(initial);
        if (!turns) givers.refuseAnother(entry, velocities);
    }
    dictionary.requireAllUsed();
    return velocities;
}

} // namespace fpm
