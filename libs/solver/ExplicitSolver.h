#pragma once

#include "base/Error.h"
#include "kernels/contact/ContactForce.h"
#include "kernels/contact/NodeGap.h"
#include "kernels/contact/PassSums.h"
#include "kernels/contact/ReferenceDisplacement.h"
#include "kernels/contact/RigidSurface.h"
#include "kernels/element/ElementForces.h"
#include "kernels/element/ElementKernels.h"
#include "kernels/particle/BodyNodes.h"
#include "kernels/particle/PressureForces.h"
#include "kernels/particle/StepClockUpdate.h"
#include "solver/DeviceState.h"
#include "solver/Erosion.h"
#include "solver/IdleCores.h"
#include "solver/PenaltyData.h"
#include "solver/Solver.h"
#include "solver/checksum.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace fpm {

/// The paper's step, in its order: element solver, contact solver, particle solver.
template <class Numbers, class Executor>
class ExplicitSolver final : public Solver
{
public:
    ExplicitSolver(const Model& model, Executor executor, std::string description, bool audit);

    void start() override;
    void advance(double time, std::int64_t maxSteps) override;
    void useThreads(int threads) override;
    void watch(std::function<void(const StepClock&)> observer) override
    {
        observer_ = std::move(observer);
    }
    StepClock clock() const override { return state_.clock.toHost()[0]; }
    Energies energies() override;
    NodalWorks nodalWorks() override;
    PairForce pairForce(std::size_t pair) override;
    PairTouch pairTouch(std::size_t pair) override;
    BodyMotionValues bodyMotion(std::size_t body) override;
    ContactBound contactLimit() override;
    NodeValues nodeValues(const std::vector<Index>& nodes) override;
    ElementValues elementValues() override;
    StateValues elementState() override;
    std::vector<double> contactGaps() override;
    std::uint64_t stateChecksum() override;
    StepTimes times() const override;
    std::size_t deviceBytes() const override { return state_.bytes(); }
    std::string description() const override { return description_; }
    const SolverData& data() const override { return data_; }
    PairOverlap initialOverlap(std::size_t pair) const override { return overlaps_[pair]; }

private:
    using Work = typename Numbers::Work;
    static constexpr std::int64_t batch = 10; ///< steps between looks of the host
    static double secondsSince(std::chrono::steady_clock::time_point begin)
    {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    }

    void computeForces();
    void integrate();
    void moveClock();
    void relax();
    void launchElements();
    template <class Material, class Element>
    void launchElementGroup(std::size_t group);
    void launchContact();
    template <bool friction>
    void launchFaceContact(std::size_t pass);
    void checkContactLists(Index steps);
    void searchAll(const StepClock* clock);
    void searchOne(std::size_t pass, const NodeBlocks& blocks);
    void searchNow();
    template <class Body>
    void searchByHost(const Body& body);
    void arrangeContact(bool all);
    void shareContactNodes(std::size_t place);
    NearBlocks::Positions contactPositions() const;
    void storeReferencePositions(const StepClock* clock);
    void measureOverlaps();
    void step();
    void launchPressures();
    void moveBodies();
    void followDeletions();
    void endPressures(const std::vector<bool>& deleted);
    void renewContact(const std::vector<bool>& deleted);
    void renewPair(std::size_t pair, const PairRenewal& from, const ForceScale& before);
    void renewContactNodes(const std::vector<Index>& numbers, const ForceScale& before);
    NodeMotion<Numbers> nodeMotion() const;
    ContactSums contactSums();
    ContactPassView<Numbers> passView(std::size_t pair);
    SurfaceForce<Numbers> surfaceForce(std::size_t pair);
    std::array<double, 2> kineticEnergy();
    /// Blocks of contact nodes; the bounds of the bodies follow theirs.
    Index contactBlocks() const
    {
        return Index(state_.referenceDisplacement.size() / displacementValues);
    }
    Index nodeBlocks() const { return Index(state_.blockEnergy.size() / 2); }
    std::array<double, nodeWorks> works() const;
    std::array<double, passSums> sumsOf(std::size_t pass);
    std::vector<double> touchOf(std::size_t pass);
    std::vector<double> gapsOf(std::size_t pass);

    SolverData data_;
    double massDamping_;
    bool midStepStrain_;
    Executor executor_;
    std::unique_ptr<IdleCores> cores_; ///< null where the number of threads is fixed
    std::string description_;
    DeviceState<Numbers, Executor> state_;
    StepTimes times_;
    double hostSearch_ = 0; ///< seconds of searches between steps, not sampled as the others are
    std::vector<PairOverlap> overlaps_; ///< of each pair of the model
    StepRules rules_;
    bool ledger_;
    /// When faces are searched: never, as lists last, every so many steps, or at each.
    enum class Searching { never, lists, interval, everyStep } searching_ = Searching::never;
    double startEnergy_ = 0;
    double largestEnergy_; ///< so far, and what rounding explains
    std::size_t elementScratch_;
    std::unique_ptr<Erosion> erosion_; ///< null unless deletions change contact surfaces
    std::int64_t searchInterval_ = 0, nextSearch_ = 0; ///< where it is given
    NearBlocks nearBlocks_;
    std::int64_t deletions_ = 0; ///< those that pressures and contact surfaces know
    Energies lost_;              ///< booked for contactors that are none any more
    std::function<void(const StepClock&)> observer_;
};

template <class Numbers, class Executor>
ExplicitSolver<Numbers, Executor>::ExplicitSolver(const Model& model,
                                                  Executor executor,
                                                  std::string description,
                                                  bool audit)
    : data_(makeSolverData(model, audit)),
      massDamping_(model.control.massDamping),
      midStepStrain_(model.control.midStepStrain),
      executor_(std::move(executor)),
      description_(std::move(description)),
      state_(data_, model.mesh.points),
      overlaps_(model.contactPairs.size()),
      elementScratch_(fpm::elementScratch<Work>(data_.maxPatchNodes))
{
    largestEnergy_ = roundingEnergy(model);
    ledger_ =
        audit || !data_.conditions.empty() || massDamping_ > 0 || data_.relaxation.tolerance > 0;
    rules_.safety = model.control.timeStepSafety;
    rules_.contactLimit = model.control.contactStepLimit;
    rules_.maximumStep = model.control.maximumTimeStep;
    rules_.fixedStep = model.control.fixedTimeStep;
    rules_.beyondBound = model.control.beyondBound;
    searchInterval_ = model.control.searchInterval;
    if (followsIdleCores(model.control)) {
        cores_ = std::make_unique<IdleCores>(threadCount(model.control));
        executor_.useThreads(cores_->threads());
    }
    nearBlocks_ = NearBlocks(data_);
    if (data_.erodes && !data_.passes.empty()) erosion_ = std::make_unique<Erosion>(model);
    for (const NearBlocks::Pass& pass : nearBlocks_.passes())
        if (data_.passes[pass.number].search == ContactSearch::closestParticle)
            searching_ = Searching::everyStep;
        else if (searching_ == Searching::never)
            searching_ = Searching::lists;
    if (searching_ != Searching::never && searchInterval_ > 0) searching_ = Searching::interval;
    if (searching_ == Searching::lists) state_.setSearches(nearBlocks_);
}

template <class Numbers, class Executor>
void ExplicitSolver<Numbers, Executor>::start()
{
    if (searching_ != Searching::never) {
        searchNow();
        measureOverlaps();
        hostSearch_ = 0; // of steps is asked
    }
    computeForces();
    const Energies first = energies();
    startEnergy_ = first.total - first.external;
}

template <class Numbers, class Executor>
void ExplicitSolver<Numbers, Executor>::advance(double time, std::int64_t maxSteps)
{
    const auto begin = std::chrono::steady_clock::now();
    StepClock now = clock();
    if (now.failed || now.settled || now.time >= time) return;
    now.stop = time;
    now.running = 1;
    state_.clock.fromHost({now});
    const std::int64_t last = now.steps + maxSteps;
    while (!now.failed && !now.settled && now.time < time && now.steps < last) {
        // The size of the first step is not known before it is made.
        std::int64_t steps = std::min(now.step <= 0 ? 1 : batch, last - now.steps);
        if (searching_ == Searching::interval) {
            if (now.steps >= nextSearch_) {
                searchNow();
                nextSearch_ = now.steps + searchInterval_;
            }
            steps = std::min(steps, nextSearch_ - now.steps);
        }
        if (cores_) useThreads(cores_->threads());
        executor_.repeat(
            steps,
            [&] {
                if (searching_ == Searching::lists)
                    executor_.timed(times_.search, [&] { checkContactLists(Index(steps)); });
            },
            [&] { step(); });
        executor_.synchronize();
        now = clock();
        if (now.waits) searchByHost([&] { arrangeContact(false); });
        if (now.deletions != deletions_) followDeletions();
        deletions_ = now.deletions;
        if (observer_) observer_(now);
    }
    if (now.time >= time) moveClock();
    times_.total += secondsSince(begin);
}

template <class Numbers, class Executor>
void ExplicitSolver<Numbers, Executor>::useThreads(int threads)
{
    const int before = executor_.threads();
    executor_.useThreads(threads);
    if (executor_.threads() == before) return;
    for (std::size_t place = 0; place < state_.searches.size(); ++place) shareContactNodes(place);
}

/// Does nothing once contact lists have to be made.
template <class Numbers, class Executor>
void ExplicitSolver<Numbers, Executor>::step()
{
    if constexpr (Executor::sharesMemory)
        if (!state_.clock.data()->mayStep()) return;
    if (searching_ == Searching::everyStep)
        executor_.timed(times_.search, [&] { searchAll(state_.clock.data()); });
    integrate();
    computeForces();
}

template <class Numbers, class Executor>
void ExplicitSolver<Numbers, Executor>::computeForces()
{
    executor_.timed(times_.element, [&] { launchElements(); });
    if (!data_.passes.empty()) executor_.timed(times_.contact, [&] { launchContact(); });
    executor_.timed(times_.node, [&] { launchPressures(); });
}

template <class Numbers, class Executor>
void ExplicitSolver<Numbers, Executor>::integrate()
{
    executor_.timed(times_.node, [&] {
        if (data_.relaxation.tolerance > 0) relax();
        moveClock();
        NodeMotion<Numbers> nodes = nodeMotion();
        if (data_.sharesNodes) {
            nodes.list = state_.listedNodes.data();
            nodes.nodeCount = Index(state_.listedNodes.size());
        }
        executor_.parallelBlocks(Index(state_.blocks(nodes.nodeCount)), nodeScratch(), nodes);
        if (!data_.body.bodies.empty()) moveBodies();
    });
}

/// Where no step follows, judges the state that was reached.
template <class Numbers, class Executor>
void ExplicitSolver<Numbers, Executor>::moveClock()
{
    const StepClockUpdate kernel{state_.patchStep.data(),
                                 Index(state_.patchStep.size()),
                                 state_.contactLimit.data(),
                                 Index(state_.contactLimit.size()),
                                 rules_,
                                 state_.clock.data()};
    executor_.parallelBlocks(1, StepClockUpdate::scratch(), kernel);
}

template <class Numbers, class Executor>
void ExplicitSolver<Numbers, Executor>::relax()
{
    const RelaxationNodes<Numbers> nodes{nodeMotion(), state_.lastForce.data(),
                                         state_.relaxationSum.data()};
    executor_.parallelBlocks(nodeBlocks(), relaxationScratch(), nodes);
    const RelaxationClock relaxation{
        state_.relaxationSum.data(),     nodeBlocks(),     state_.patchEnergy.data(),
        Index(state_.patchStep.size()),  elementEnergies,  state_.body.bodies.data(),
        Index(data_.body.bodies.size()), data_.relaxation, state_.clock.data()};
    executor_.parallelBlocks(1, RelaxationClock::scratch(), relaxation);
}

template <class Numbers, class Executor>
void ExplicitSolver<Numbers, Executor>::launchElements()
{
    for (std::size_t group = 0; group < data_.groups.size(); ++group)
        visitKernel(data_.groups[group].kernel, [&]<class Material, class Element>() {
            launchElementGroup<Material, Element>(group);
        });
}

template <class Numbers, class Executor>
template <class Material, class Element>
void ExplicitSolver<Numbers, Executor>::launchElementGroup(std::size_t group)
{
    const ElementForces<Numbers, Material, Element> kernel{
        .list = state_.groupPatches[group].data(),
        .patches = state_.patches.data(),
        .materials = state_.materials.data(),
        .boundaryNodes = state_.boundaryNodes.data(),
        .corners = state_.corners.data(),
        .cornerStarts = state_.cornerStarts.data(),
        .slotCorners = state_.slotCorners.data(),
        .nodes = {state_.position.data(), state_.velocity.data(), state_.inverseMass.data(),
                  state_.fixed.data(), std::size_t(data_.nodeCount), state_.interiorForce.data(),
                  std::size_t(data_.interiorEnd)},
        .mass = state_.elementMass.data(),
        .massRatio = state_.massRatio.data(),
        .state = state_.state.data(),
        .plasticStrain = state_.plasticStrain.data(),
        .partialForce = state_.partialForce.data(),
        .patchEnergy = state_.patchEnergy.data(),
        .patchStep = state_.patchStep.data(),
        .clock = state_.clock.data(),
        .deletions = &state_.clock.data()->deletions,
        .strainPoint = Work(midStepStrain_ ? 0.5 : 1.0),
        .movesInterior = data_.sharesNodes};
    executor_.parallelBlocks(Index(state_.groupPatches[group].size()), elementScratch_, kernel);
}

template <class Numbers, class Executor>
NodeMotion<Numbers> ExplicitSolver<Numbers, Executor>::nodeMotion() const
{
    auto& s = const_cast<DeviceState<Numbers, Executor>&>(state_);
    return {.nodeCount = data_.nodeCount,
            .list = nullptr,
            .position = s.position.data(),
            .velocity = s.velocity.data(),
            .inverseMass = s.inverseMass.data(),
            .nodeStride = std::size_t(data_.nodeCount),
            .interiorForce = s.interiorForce.data(),
            .interiorEnd = std::size_t(data_.interiorEnd),
            .firstBoundaryNode = std::size_t(data_.firstBoundaryNode),
            .partialSumsStart = s.partialSumsStart.data(),
            .partialSums = s.partialSums.data(),
            .partialForce = s.partialForce.data(),
            .fixed = s.fixed.data(),
            .contactNode = s.contactNumber.data(),
            .contactForce = s.contactSum.data(),
            .contactScale = data_.contactScale,
            .conditionStart = s.conditionStart.data(),
            .uses = s.uses.data(),
            .conditions = s.conditions.data(),
            .amplitudeRows = s.amplitudeRows.data(),
            .frameOf = s.frameOf.data(),
            .frames = s.frames.data(),
            .pressureStart = s.pressureStart.data(),
            .pressureSlots = s.pressureSlots.data(),
            .pressureForce = s.pressureForce.data(),
            .pressureStride = data_.pressureFaceNode.size(),
            .massDamping = typename Numbers::Motion(massDamping_),
            .ledger = ledger_,
            .blockWork = s.blockWork.data(),
            .clock = s.clock.data()};
}

} // namespace fpm

#include "solver/ExplicitSolverBodies.h"
#include "solver/ExplicitSolverContact.h"
#include "solver/ExplicitSolverErosion.h"
#include "solver/ExplicitSolverResults.h"
