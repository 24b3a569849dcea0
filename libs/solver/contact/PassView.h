#pragma once

#include "kernels/contact/ContactPassView.h"
#include "kernels/contact/law/RigidSurface.h"
#include "solver/backend/LaunchContext.h"
#include "solver/contact/Penalties.h"

namespace fpm {

/// Where the forces of contact nodes are added up.
template <class Executor>
[[gnu::always_inline]] inline ContactSums contactSums(const LaunchContext<Executor>& on)
{
    return {on.fields.contact.sum.data(), on.setUp.contact.scale, on.executor.alone(), nullptr};
}

/// Springs, friction and damping of a pass.
template <class Work>
[[gnu::always_inline]] inline PassLaw<Work> lawOf(const ContactPassSetup& setUp, PassFields& f)
{
    const ContactLaw& l = setUp.law;
    return {.count = Index(f.contactor.size()),
            .rule = int(l.penalty),
            .contactorStiffness = f.contactorStiffness.data<Work>(),
            // Mass is halved there by itself.
            .mirrors = entryOf(l.penalty).byMass ? nullptr : f.mirrors.data(),
            .friction = frictionLaw<Work>(l),
            .slipDamping = {Work(l.slipDamping), f.slipRate.data<Work>()},
            .tangentialForce = f.tangentialForce.data<Work>(),
            .frictionFace = f.frictionFace.data(),
            .springEnergy = f.springEnergy.data(),
            .touch = {f.touchGap.data<Work>(), f.touchExtra.data<Work>(), f.touchSurplus.data()},
            .dissipated = f.dissipated.data(),
            .dampingRatio = Work(l.normalDamping),
            .contactorMass = f.contactorMass.data<Work>(),
            .dampingForce = f.dampingForce.data(),
            .damped = f.damped.data(),
            .limitFactor = Work(dampingLimit(l))};
}

[[gnu::always_inline]] inline CellLists cellsOf(const ContactPassSetup& setUp, PassFields& f)
{
    return {f.head.data(), f.entries.data(), f.cellMask, setUp.cellSize, setUp.levels};
}

/// A pass, but for the motion of the nodes, as kernels see it.
template <class Numbers>
[[gnu::always_inline]] inline ContactPassView<Numbers> surfaceView(const ContactPassSetup& setUp,
                                                                   PassFields& f)
{
    using Work = typename Numbers::Work;
    ContactPassView<Numbers> v{};
    v.contactorCount = Index(f.contactor.size());
    v.faceCount = Index(f.faceThickness.size());
    v.targetCount = Index(f.targetCorner.size());
    v.nodeCount = setUp.nodeCount;
    v.contactor = f.contactor.data();
    v.ownFaceStart = f.ownFaceStart.data();
    v.ownFaces = f.ownFaces.data();
    v.ownFaceNode = f.ownFaceNode.data();
    v.faceNode = f.faceNode.data();
    v.nextAround = f.nextAround.data();
    v.neighbour = f.neighbour.data();
    v.mirrorNormal = f.mirrorNormal.data<Work>();
    v.mirrors = f.mirrors.data();
    v.faceStiffness = f.faceStiffness.data<Work>();
    v.faceThickness = f.faceThickness.data();
    v.faceMass = f.faceMass.data<Work>();
    v.targetCorner = f.targetCorner.data();
    v.excludedStart = f.excludedStart.data();
    v.excluded = f.excluded.data();
    v.faceComponent = f.faceComponent.data();
    v.contactorComponent = f.contactorComponent.data();
    v.mayMeet = f.mayMeet.data();
    v.components = setUp.components;
    v.ownNormal = f.ownNormal.data();
    v.face = f.face.data();
    v.xi = f.xi.data<Work>();
    v.eta = f.eta.data<Work>();
    v.around = f.around.data();
    v.force = f.force.data();
    v.contactorForce = f.contactorForce.data();
    v.counts = f.counts.data();
    v.overlap = f.overlap.data();
    v.heldStiffness = f.heldStiffness.data<Work>();
    v.injected = f.injected.data();
    v.fadeTime = setUp.fadeTime;
    v.reach = Work(setUp.reach);
    v.cold = setUp.projection == ContactProjection::cold;
    v.law = lawOf<Work>(setUp, f);
    return v;
}

/// A pass as kernels see it.
template <class Numbers, class Executor>
[[gnu::always_inline]] inline ContactPassView<Numbers> passView(const LaunchContext<Executor>& on,
                                                                std::size_t pass)
{
    PassFields& f = *on.fields.contact.passes[pass];
    ContactPassView<Numbers> v = surfaceView<Numbers>(on.setUp.contact.passes[pass], f);
    NodeFields& nodes = on.fields.nodes;
    v.position = nodes.position.data<typename Numbers::Position>();
    v.velocity = nodes.velocity.data<typename Numbers::Motion>();
    v.nodeStride = std::size_t(on.setUp.nodes.count);
    v.contactNumber = on.fields.contact.numberOf.data();
    v.sums = contactSums(on);
    v.sums.shared = f.shared.data();
    v.clock = on.fields.clock.clock.data();
    return v;
}

} // namespace fpm
