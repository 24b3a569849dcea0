#include "run/resultFrame.h"

#include "run/ContactPressure.h"
#include "run/SectionFields.h"

#include <cmath>

namespace fpm {

namespace {

double mises(const double* s)
{
    const double a = s[0] - s[1], b = s[1] - s[2], c = s[2] - s[0];
    return std::sqrt(0.5 * (a * a + b * b + c * c) + 3 * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5]));
}

ResultField nodeField(const NodeValues& values,
                      int quantity,
                      const std::string& name,
                      const std::vector<Point>* minus)
{
    ResultField field{name, 3, {}};
    for (std::size_t i = 0; i < values.count; ++i) {
        Point value = values.at(quantity, i);
        for (std::size_t c = 0; c < 3; ++c)
            field.values.push_back(value[c] - (minus ? (*minus)[i][c] : 0));
    }
    return field;
}

std::vector<Point> pointsOf(const NodeValues& values, int quantity)
{
    std::vector<Point> out;
    for (std::size_t i = 0; i < values.count; ++i) out.push_back(values.at(quantity, i));
    return out;
}

/// Those of its fields that some part has; numbers that are 0 everywhere would only fill the disk.
void addSection(Solver& solver, const Model& model, const std::vector<Point>& points, Frame& frame)
{
    bool hourglass = false, bending = false, yields = false;
    for (std::size_t part = 0; part < model.parts.size(); ++part) {
        const StateLayout& layout = solver.elements().setUp().layouts[part];
        hourglass |= layout.hourglass > 0;
        bending |= layout.hourglass > 0 && model.parts[part].hourglass == HourglassForm::physical;
        yields |= layout.plastic && solver.elements().setUp().materials[part].rows > 0;
    }
    if (!hourglass && !yields) return;
    const SectionFields fields = sectionFields(solver, model, points);
    if (hourglass) frame.elementFields.push_back({"HourglassEnergy", 1, fields.hourglass});
    if (bending) frame.elementFields.push_back({"BendingEnergy", 1, fields.bending});
    if (yields) frame.elementFields.push_back({"Utilisation", 1, fields.utilisation});
}

} // namespace

Frame resultFrame(Solver& solver, const Model& model)
{
    Frame frame;
    frame.time = solver.clock().time;
    const NodeValues nodes = solver.nodes().values({});
    frame.nodeFields.push_back(nodeField(nodes, 0, "U", &model.mesh.points));
    frame.nodeFields.push_back(nodeField(nodes, 1, "V", nullptr));
    const ElementValues elements = solver.elements().values();
    if (!model.contactPairs.empty()) {
        frame.nodeFields.push_back(nodeField(nodes, 4, "FCONT", nullptr));
        frame.nodeFields.push_back(
            {"CPRESS", 1,
             contactPressure(model, pointsOf(nodes, 0), pointsOf(nodes, 4),
                             solver.elements().setUp().erodes ? elements.deleted
                                                              : std::vector<bool>{})});
        frame.nodeFields.push_back({"GAP", 1, solver.contact().gaps()});
    }

    ResultField stress{"S", 6, elements.stress}, equivalent{"Mises", 1, {}},
        plastic{"PEEQ", 1, elements.plasticStrain}, part{"Part", 1, {}};
    for (std::size_t e = 0; e < elements.plasticStrain.size(); ++e) {
        equivalent.values.push_back(mises(&elements.stress[6 * e]));
        part.values.push_back(double(model.mesh.partOf(Index(e))));
    }
    frame.elementFields = {stress, equivalent, plastic, part};
    addSection(solver, model, pointsOf(nodes, 0), frame);
    if (!elements.temperature.empty())
        frame.elementFields.push_back({"TEMP", 1, elements.temperature});
    if (solver.elements().setUp().erodes) {
        ResultField status{"STATUS", 1, {}};
        for (const bool deleted : elements.deleted) status.values.push_back(deleted ? 0 : 1);
        frame.elementFields.push_back(status);
    }
    return frame;
}

} // namespace fpm
