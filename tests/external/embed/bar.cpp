// The blow of tutorials/bar without a case folder and without dictionaries: a bar is built in
// memory, struck and stepped until the wave has doubled at the free end. Units mm, tonne, s.
#include "mesh/Patches.h"
#include "mesh/addBox.h"
#include "solver/Solver.h"

#include <cmath>
#include <cstdio>

int main()
{
    fpm::Model model;
    fpm::addBox(model.mesh, "bar", {100, 1, 1}, {0, 0, 0}, {100, 1, 1});
    fpm::renumber(model.mesh);
    model.parts.resize(1);
    model.parts[0].name = "bar";
    model.parts[0].density = 8e-9;
    model.parts[0].youngsModulus = 200000;
    model.parts[0].linearBulkViscosity = 0; // the pulse is smooth
    fpm::BoundaryCondition blow;
    blow.kind = fpm::BoundaryCondition::Kind::velocity;
    blow.constrains = {true, false, false};
    blow.value = {1000, 0, 0};
    blow.amplitude = {fpm::Amplitude::Kind::smooth, {{0, 0}, {4e-6, 1}, {8e-6, 0}}};
    fpm::Index freeEnd = -1;
    for (std::size_t node = 0; node < model.mesh.points.size(); ++node) {
        const double x = model.mesh.points[node][0];
        if (x < 0.5) blow.nodes.push_back(fpm::Index(node));
        if (x > 99.5) freeEnd = fpm::Index(node);
    }
    model.boundaryConditions = {blow};
    model.control.endTime = 24e-6; // the top of the pulse is at the free end
    model.control.backend = "serial";

    const auto solver = fpm::makeSolver(model);
    solver->start();
    solver->advance(model.control.endTime, 1000000);
    const double speed = solver->nodes().values({freeEnd}).at(1, 0)[0];
    std::printf("%s: %lld steps, free end %.1f mm/s (exact 2000), energy balance %.1e\n",
                solver->description().c_str(), (long long)(solver->clock().steps), speed,
                solver->ledger().energies().balance);
    return std::abs(speed - 2000) < 20 ? 0 : 1;
}
