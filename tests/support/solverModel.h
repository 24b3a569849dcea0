#pragma once

#include "mesh/Patches.h"
#include "model/Model.h"
#include "support/boxMesh.h"

namespace fpm::test {

/// Aluminium of the plate scene (tonne, mm, s): E 70 GPa, nu 0.3, sigma_y 285 MPa, H 900 MPa.
inline Part aluminium(PartKind kind, HourglassForm form, const std::string& name = "box")
{
    Part part;
    part.name = name;
    part.kind = kind;
    part.density = 2.7e-9;
    part.youngsModulus = 70000;
    part.poissonsRatio = 0.3;
    if (kind == PartKind::elastoplastic) part.hardening = {{0, 285}, {1, 1185}};
    part.hourglass = form;
    part.hourglassCoefficient = form == HourglassForm::stiffness ? 0.05
                                : form == HourglassForm::viscous ? 0.1
                                                                 : 1.0;
    return part;
}

/// One box of bricks, renumbered, ready for makeSolver.
inline Model boxModel(std::array<Index, 3> cells, Point size, const Part& part)
{
    Model model;
    model.mesh = boxMesh(cells, size);
    renumber(model.mesh);
    model.parts = {part};
    model.control.backend = "serial";
    model.control.endTime = 1;
    return model;
}

} // namespace fpm::test
