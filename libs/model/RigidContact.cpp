#include "model/RigidContact.h"

namespace fpm {

namespace {

Index rigidPartAmong(const Mesh& mesh,
                     const std::vector<ElementSide>& sides,
                     const std::vector<bool>& rigid)
{
    for (const ElementSide& side : sides)
        if (const Index part = mesh.partOf(side.element); rigid[std::size_t(part)]) return part;
    return -1;
}

} // namespace

void refuseRigidPair(const Mesh& mesh,
                     const ContactSurfaces& surfaces,
                     const std::vector<bool>& rigid,
                     const Dictionary& pair)
{
    const Index contactor = rigidPartAmong(mesh, surfaces.contactorSides, rigid);
    const Index target = rigidPartAmong(mesh, surfaces.targetSides, rigid);
    if (contactor < 0 || target < 0) return;
    pair.fail("target",
              "parts '" + mesh.parts[std::size_t(contactor)].name + "' and '"
                  + mesh.parts[std::size_t(target)].name
                  + "' are both rigid: no mass limits the contact force",
              "what works: rigid against deformable. Let the part that matters less be elastic and "
              "stiff in constant/partProperties, or remove the pair");
}

void refuseRigidContactor(const Mesh& mesh,
                          const ContactSurfaces& surfaces,
                          const std::vector<bool>& rigid,
                          const Dictionary& pair)
{
    const Index contactor = rigidPartAmong(mesh, surfaces.contactorSides, rigid);
    if (contactor < 0) return;
    pair.fail(
        "contactor",
        "part '" + mesh.parts[std::size_t(contactor)].name
            + "' is rigid, and so is an analytic surface: no mass limits the contact force",
        "what works: a rigid part against a deformable one. Let the part be elastic and stiff in "
        "constant/partProperties; or instead of the surface mesh a block of a few elements, "
        "elastic and held at its back; or remove the pair");
}

} // namespace fpm
