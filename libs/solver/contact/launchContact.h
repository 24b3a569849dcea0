#pragma once

#include "kernels/contact/broad/Search.h"
#include "kernels/contact/distribute/ContactLimit.h"
#include "kernels/contact/distribute/ContactStatus.h"
#include "kernels/contact/distribute/PassSums.h"
#include "kernels/contact/lists/ReferenceDisplacement.h"
#include "kernels/contact/narrow/NodeGap.h"
#include "kernels/contact/narrow/Overlap.h"
#include "kernels/particle/SurfaceNodes.h"
#include "solver/contact/ContactLaunches.h"
#include "solver/contact/PassView.h"
#include "solver/nodes/NodeView.h"

namespace fpm {

template <class Numbers, class Executor>
class ContactLaunchesOf final : public ContactLaunches
{
    using Motion = typename Numbers::Motion;

public:
    explicit ContactLaunchesOf(const LaunchContext<Executor>& context) : on_(context) {}

    void forces() override
    {
        ContactFields& c = on_.fields.contact;
        on_.executor.parallelFor(Index(c.sum.size()), ClearContactSum{c.sum.data(), clock()});
        for (std::size_t pass = 0; pass < c.passes.size(); ++pass)
            if (setUp(pass).kinematic)
                continue; // the nodes see to it themselves, once all their forces are known
            else if (setUp(pass).surface >= 0)
                on_.executor.parallelFor(contactors(pass), surfaceForce(pass));
            else if (setUp(pass).ofEdges)
                edges(pass, EdgeLaunch::forces);
            else if (setUp(pass).law.friction > 0)
                launchFaceForces<Numbers, true>(on_, pass);
            else
                launchFaceForces<Numbers, false>(on_, pass);
        NodeFields& n = on_.fields.nodes;
        using Limit = ContactLimit<Motion>;
        on_.executor.parallelBlocks(Index(c.bound.size()), Limit::scratch(),
                                    Limit{Index(c.nodes.size()), c.sum.data(), c.nodes.data(),
                                          n.inverseMass.data<Motion>(), n.fixed.data(),
                                          on_.setUp.contact.scale, c.bound.data(), clock()});
    }

    void measureOverlaps(std::size_t pass) override
    {
        if (setUp(pass).ofEdges) {
            edges(pass, EdgeLaunch::measureOverlaps);
            return;
        }
        on_.executor.parallelFor(
            contactors(pass),
            MeasureOverlap<Numbers>{view(pass), cells(pass), fields(pass).overlap.data()});
    }
    void clearOverlaps(std::size_t pass) override
    {
        on_.executor.parallelFor(contactors(pass), Fill<float>{fields(pass).overlap.data(), 0.f});
    }
    void clearCounts(std::size_t pass) override
    {
        on_.executor.parallelFor(passCounts, Fill<std::int64_t>{fields(pass).counts.data(), 0});
    }

    void sums(std::size_t pass) override
    {
        PassFields& f = fields(pass);
        read(pass);
        on_.executor.parallelBlocks(
            blocks(pass), PassSums::scratch(),
            PassSums{contactors(pass), f.springEnergy.data(), f.dissipated.data(), f.damped.data(),
                     f.surfaceWork.data(), f.injected.data(), f.surfaceForce.data(),
                     f.reading.data(), f.force.data(), on_.setUp.contact.scale, f.sums.data()});
    }

    void status(std::size_t pass) override
    {
        using Faces = StatusSums<FaceStatus<Numbers>>;
        using Surface = StatusSums<SurfaceStatus<Numbers>>;
        double* out = fields(pass).status.data();
        read(pass);
        if (setUp(pass).surface >= 0)
            on_.executor.parallelBlocks(
                blocks(pass), Surface::scratch(),
                Surface{contactors(pass), {surfaceForce(pass), fields(pass).reading.data()}, out});
        else if (setUp(pass).ofEdges)
            edges(pass, EdgeLaunch::status);
        else
            on_.executor.parallelBlocks(blocks(pass), Faces::scratch(),
                                        Faces{contactors(pass), {view(pass)}, out});
    }

    void gaps(std::size_t pass) override
    {
        double* out = fields(pass).gap.data();
        if (setUp(pass).surface >= 0)
            on_.executor.parallelFor(contactors(pass),
                                     SurfaceGap<Numbers>{surfaceForce(pass), out});
        else
            on_.executor.parallelFor(contactors(pass), FaceGap<Numbers>{view(pass), out});
    }

private:
    void edges(std::size_t pass, EdgeLaunch what) { launchEdges<Numbers>(on_, pass, what); }
    /// Forces on the contactors of a kinematic pass, and half works that are not booked yet.
    void read(std::size_t pass)
    {
        if (!setUp(pass).kinematic) return;
        PassFields& f = fields(pass);
        on_.executor.parallelFor(contactors(pass),
                                 ReadSurface<Numbers>{nodeView<Numbers>(on_), contactors(pass),
                                                      f.contactor.data(), f.reading.data()});
    }

    SurfaceForce<Numbers> surfaceForce(std::size_t pass)
    {
        PassFields& f = fields(pass);
        NodeFields& n = on_.fields.nodes;
        ContactSums sums = contactSums(on_);
        sums.alone = on_.executor.threads() > 0; // each contactor pushes its own node only
        return {.contactorCount = contactors(pass),
                .contactor = f.contactor.data(),
                .contactNumber = on_.fields.contact.numberOf.data(),
                .force = f.surfaceForce.data(),
                .work = f.surfaceWork.data(),
                .position = n.position.data<typename Numbers::Position>(),
                .velocity = n.velocity.data<Motion>(),
                .nodeStride = std::size_t(on_.setUp.nodes.count),
                .sums = sums,
                .clock = clock(),
                .amplitudeRows = n.amplitudeRows.data(),
                .reach = setUp(pass).reach,
                .deepest = setUp(pass).deepest,
                .shape = on_.setUp.contact.surfaces[std::size_t(setUp(pass).surface)],
                .law = lawOf<typename Numbers::Work>(setUp(pass), f)};
    }

    const ContactPassSetup& setUp(std::size_t pass) const { return on_.setUp.contact.passes[pass]; }
    PassFields& fields(std::size_t pass) { return *on_.fields.contact.passes[pass]; }
    Index contactors(std::size_t pass) { return Index(fields(pass).contactor.size()); }
    Index blocks(std::size_t pass) { return NodeBlocks::blocks(contactors(pass)); }
    ContactPassView<Numbers> view(std::size_t pass) { return passView<Numbers>(on_, pass); }
    CellLists cells(std::size_t pass) { return cellsOf(setUp(pass), fields(pass)); }
    StepClock* clock() { return on_.fields.clock.clock.data(); }

    LaunchContext<Executor> on_;
};

template <class Numbers, class Executor>
std::unique_ptr<ContactLaunches> makeContactLaunches(const LaunchContext<Executor>& context)
{
    return std::make_unique<ContactLaunchesOf<Numbers, Executor>>(context);
}

} // namespace fpm
