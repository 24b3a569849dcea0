#pragma once

// Part of ExplicitSolver.h: what the host reads.

namespace fpm {

template <class Numbers, class Executor>
StepTimes ExplicitSolver<Numbers, Executor>::times() const
{
    StepTimes out = times_;
    for (double* part : {&out.element, &out.contact, &out.node, &out.search})
        *part *= executor_.timedScale();
    out.search += hostSearch_;
    out.threads = cores_ ? cores_->mean() : executor_.threads();
    for (const PassListState& pass : state_.passLists.toHost()) out.searches += pass.searches;
    if (searching_ == Searching::everyStep)
        out.searches += clock().steps * std::int64_t(nearBlocks_.passes().size());
    return out;
}

/// Kinetic energy, and the half work of loads and drives that closes the ledger at this time.
template <class Numbers, class Executor>
std::array<double, 2> ExplicitSolver<Numbers, Executor>::kineticEnergy()
{
    executor_.parallelBlocks(nodeBlocks(), nodeScratch(),
                             KineticEnergy<Numbers>{nodeMotion(), state_.blockEnergy.data()});
    executor_.synchronize();
    std::array<double, 2> sums{0, 0};
    const std::vector<double> blocks = state_.blockEnergy.toHost();
    for (std::size_t i = 0; i < blocks.size(); ++i) sums[i % 2] += blocks[i];
    const StepClock now = clock();
    for (const RigidBody& body : state_.body.bodies.toHost()) {
        const auto [kinetic, closing] = bodyEnergy(body, now.step, massDamping_ + now.damping);
        sums[0] += kinetic;
        sums[1] += closing;
    }
    return sums;
}

template <class Numbers, class Executor>
std::array<double, nodeWorks> ExplicitSolver<Numbers, Executor>::works() const
{
    std::array<double, nodeWorks> sums{};
    const std::vector<double> blocks = state_.blockWork.toHost();
    for (std::size_t i = 0; i < blocks.size(); ++i) sums[i % nodeWorks] += blocks[i];
    for (const RigidBody& body : state_.body.bodies.toHost())
        for (std::size_t k = 0; k < nodeWorks; ++k) sums[k] += body.work[k];
    return sums;
}

template <class Numbers, class Executor>
Energies ExplicitSolver<Numbers, Executor>::energies()
{
    executor_.synchronize();
    Energies out;
    out.time = clock().time;
    const auto [kinetic, closing] = kineticEnergy();
    out.kinetic = kinetic;
    const std::vector<double> patches = state_.patchEnergy.toHost();
    out.parts.resize(data_.materials.size());
    for (std::size_t patch = 0; patch < data_.patches.size(); ++patch) {
        const double* sums = patches.data() + elementEnergies * patch;
        const std::size_t part = std::size_t(data_.patches[patch].material);
        PartEnergies& of = out.parts[part];
        of.internal += sums[0];
        of.plastic += sums[1];
        of.hourglass += sums[2];
        out.bulkViscosity += sums[3];
    }
    for (const PartEnergies& part : out.parts) {
        out.internal += part.internal;
        out.plastic += part.plastic;
        out.hourglass += part.hourglass;
    }
    out.contact = lost_.contact;
    out.friction = lost_.friction;
    out.contactDamping = lost_.contactDamping;
    out.external = lost_.external;
    double faded = 0; // what the end of forgiven overlaps put into springs
    for (std::size_t pass = 0; pass < state_.passes.size(); ++pass) {
        const std::array<double, passSums> sums = sumsOf(pass);
        out.contact += sums[sumSpring];
        out.friction += sums[sumDissipated];
        out.contactDamping += sums[sumDamped];
        out.external += sums[sumSurfaceWork];
        faded += sums[sumInjected];
    }
    if (ledger_) {
        const auto sums = works();
        out.damping = sums[NodeWork::damping];
        out.external += sums[externalBefore] + sums[externalAfter] + sums[driveBefore]
                        + sums[driveAfter] + closing;
    }
    out.external += faded;
    out.total = out.kinetic + out.internal + out.hourglass + out.bulkViscosity + out.contact
                + out.friction + out.contactDamping + out.damping;
    // A body that friction has brought to rest is judged by the energy it came with.
    const double lost = out.friction + out.contactDamping + out.damping;
    largestEnergy_ = std::max(
        {largestEnergy_, out.kinetic, out.internal, std::abs(out.external), lost, startEnergy_});
    out.error = out.total - out.external - startEnergy_;
    out.scale = largestEnergy_;
    out.balance = out.scale > 0 ? out.error / out.scale : 0;
    return out;
}

/// Over the contactors of a pass, added up on the device: a history row must not copy them all.
template <class Numbers, class Executor>
std::array<double, passSums> ExplicitSolver<Numbers, Executor>::sumsOf(std::size_t pass)
{
    ContactPassState<Numbers, Executor>& s = state_.passes[pass];
    const Index count = Index(s.contactor.size()), blocks = NodeBlocks::blocks(count);
    executor_.parallelBlocks(blocks, PassSums::scratch(),
                             PassSums{count, s.spring.data(), s.dissipated.data(), s.damped.data(),
                                      s.surfaceWork.data(), s.injected.data(),
                                      s.surfaceForce.data(), s.force.data(), data_.contactScale,
                                      s.sums.data()});
    executor_.synchronize();
    std::array<double, passSums> total{};
    const std::vector<double> parts = s.sums.toHost();
    for (std::size_t k = 0; k < parts.size(); ++k) total[k % passSums] += parts[k];
    return total;
}

template <class Numbers, class Executor>
NodalWorks ExplicitSolver<Numbers, Executor>::nodalWorks()
{
    executor_.synchronize();
    const auto sums = works();
    return {sums[internalBefore] + sums[internalAfter], sums[contactBefore] + sums[contactAfter],
            sums[externalBefore] + sums[externalAfter], sums[driveBefore] + sums[driveAfter],
            sums[damping]};
}

template <class Numbers, class Executor>
PairForce ExplicitSolver<Numbers, Executor>::pairForce(std::size_t number)
{
    executor_.synchronize();
    PairForce out;
    for (std::size_t pass = 0; pass < data_.passes.size(); ++pass) {
        if (data_.passes[pass].pair != number) continue;
        const std::array<double, passSums> sums = sumsOf(pass);
        const double sign = data_.passes[pass].reversed ? -1 : 1;
        for (std::size_t c = 0; c < 3; ++c) out.force[c] += sign * sums[sumForce + c];
        out.active += Index(sums[sumTouching]);
        out.spring += sums[sumSpring];
        out.friction += sums[sumDissipated];
        out.damping += sums[sumDamped];
        const std::vector<std::int64_t> counts = state_.passes[pass].counts.toHost();
        out.released += counts[countReleased];
        out.overEdge += counts[countOverEdge];
        out.inside += counts[countInside];
        out.mistaken += counts[countMistaken];
        out.crowded += counts[countCrowded];
        out.late += counts[countLate];
    }
    return out;
}

/// [block][touchValues]
template <class Numbers, class Executor>
std::vector<double> ExplicitSolver<Numbers, Executor>::touchOf(std::size_t pass)
{
    using Faces = TouchSums<FaceTouch<Numbers>>;
    using Surface = TouchSums<SurfaceTouch<Numbers>>;
    const Index count = Index(state_.passes[pass].contactor.size()),
                blocks = NodeBlocks::blocks(count);
    Array<double, Executor> out(std::size_t(blocks) * touchValues);
    if (data_.passes[pass].surface >= 0)
        executor_.parallelBlocks(blocks, Surface::scratch(),
                                 Surface{count, {surfaceForce(pass)}, out.data()});
    else
        executor_.parallelBlocks(blocks, Faces::scratch(),
                                 Faces{count, {passView(pass)}, out.data()});
    executor_.synchronize();
    return out.toHost();
}

template <class Numbers, class Executor>
PairTouch ExplicitSolver<Numbers, Executor>::pairTouch(std::size_t number)
{
    executor_.synchronize();
    PairTouch out;
    double weight = 0;
    for (std::size_t pass = 0; pass < data_.passes.size(); ++pass) {
        if (data_.passes[pass].pair != number) continue;
        const double sign = data_.passes[pass].reversed ? -1 : 1;
        const std::vector<double> blocks = touchOf(pass);
        for (const double* of = blocks.data(); of < blocks.data() + blocks.size();
             of += touchValues) {
            out.active += Index(of[touchCount]);
            weight += of[touchWeight];
            out.meanDepth += of[touchDepth];
            out.normal += of[touchNormal];
            out.speed += of[touchSpeed];
            for (std::size_t c = 0; c < 3; ++c) {
                out.friction[c] += sign * of[touchFriction + c];
                out.slip[c] += sign * of[touchSlip + c];
            }
            if (!(of[touchDeepest] > out.maxDepth)) continue;
            out.maxDepth = of[touchDeepest];
            out.thickness = of[touchThickness];
            out.deepest = data_.passes[pass].contactor[std::size_t(of[touchContactor])];
        }
    }
    const double share = weight > 0 ? 1 / weight : 0;
    out.meanDepth *= share;
    out.speed *= share;
    for (double& v : out.slip) v *= share;
    return out;
}

/// [contactor]
template <class Numbers, class Executor>
std::vector<double> ExplicitSolver<Numbers, Executor>::gapsOf(std::size_t pass)
{
    const Index count = Index(state_.passes[pass].contactor.size());
    Array<double, Executor> out{std::size_t(count)};
    if (data_.passes[pass].surface >= 0)
        executor_.parallelFor(count, SurfaceGap<Numbers>{surfaceForce(pass), out.data()});
    else
        executor_.parallelFor(count, FaceGap<Numbers>{passView(pass), out.data()});
    executor_.synchronize();
    return out.toHost();
}

template <class Numbers, class Executor>
std::vector<double> ExplicitSolver<Numbers, Executor>::contactGaps()
{
    executor_.synchronize();
    std::vector<double> least(std::size_t(data_.nodeCount), noGap);
    for (std::size_t pass = 0; pass < data_.passes.size(); ++pass) {
        const std::vector<double> gaps = gapsOf(pass);
        const std::vector<Index> nodes = state_.passes[pass].contactor.toHost();
        for (std::size_t i = 0; i < gaps.size(); ++i) {
            double& of = least[std::size_t(nodes[i])];
            if (gaps[i] < of || std::isnan(of)) of = gaps[i];
        }
    }
    return least;
}

template <class Numbers, class Executor>
ContactBound ExplicitSolver<Numbers, Executor>::contactLimit()
{
    executor_.synchronize();
    ContactBound out;
    const std::vector<std::int64_t> sum = state_.contactSum.toHost();
    double most = 0;
    for (std::size_t i = 0; i < data_.contactNodes.size(); ++i) {
        const std::size_t node = std::size_t(data_.contactNodes[i]);
        if (data_.fixed[node] & imposedNode) continue;
        const double square =
            data_.contactScale.toStiffness(sum[4 * i + 3]) * (1 / data_.nodeMass[node]);
        if (!(square > most)) continue;
        most = square;
        out = {data_.contactNodes[i], -1, std::sqrt(square)};
    }
    const std::vector<double> limits = state_.contactLimit.toHost();
    for (std::size_t body = 0; body < data_.body.part.size(); ++body) {
        const double square = limits[std::size_t(contactBlocks()) + body];
        if (!(square > most)) continue;
        most = square;
        out = {-1, data_.body.part[body], std::sqrt(square)};
    }
    return out;
}

template <class Numbers, class Executor>
NodeValues ExplicitSolver<Numbers, Executor>::nodeValues(const std::vector<Index>& nodes)
{
    const std::size_t count = nodes.empty() ? std::size_t(data_.nodeCount) : nodes.size();
    const Array<Index, Executor> list(nodes);
    Array<double, Executor> out(sampleValues * count);
    executor_.parallelFor(Index(count), NodeSample<Numbers>{nodeMotion(), list.data(), out.data(),
                                                            Index(count), state_.body.bodyOf.data(),
                                                            state_.body.bodies.data()});
    executor_.synchronize();
    return {out.toHost(), count};
}

template <class Numbers, class Executor>
ElementValues ExplicitSolver<Numbers, Executor>::elementValues()
{
    executor_.synchronize();
    const auto state = state_.state.toHost();
    const auto sums = state_.plasticStrain.toHost();
    ElementValues out;
    for (Index element = 0; element < data_.elementCount; ++element) {
        const ElementPlace place = data_.placeOf(element);
        const StateLayout& layout = data_.layouts[place.part];
        // Mean over the integration points.
        const auto mean = [&](const auto& values, std::size_t first, int step, int count) {
            double sum = 0;
            for (int point = 0; point < count; ++point)
                sum += double(values[first + std::size_t(step * point) * std::size_t(tileWidth)]);
            return count > 0 ? sum / count : 0.0;
        };
        const double strain = mean(sums, place.strains, 1, layout.strains());
        const bool deleted = isDeleted(strain);
        for (std::size_t k = 0; k < 6; ++k)
            out.stress.push_back(
                deleted ? 0
                        : mean(state, place.state + k * std::size_t(tileWidth), 6, layout.points));
        out.plasticStrain.push_back(plasticStrainOf(strain));
        out.deleted.push_back(deleted);
        out.eroded.push_back(deleted ? double(state[place.state]) : 0);
        const double start = data_.materials[place.part].general.temperature;
        if (data_.heats)
            out.temperature.push_back(
                start
                + mean(sums,
                       place.strains + std::size_t(layout.temperature(0)) * std::size_t(tileWidth),
                       1, layout.heats ? layout.points : 0));
    }
    return out;
}

template <class Numbers, class Executor>
StateValues ExplicitSolver<Numbers, Executor>::elementState()
{
    executor_.synchronize();
    const auto state = state_.state.toHost();
    const auto strains = state_.plasticStrain.toHost();
    return {{state.begin(), state.end()}, {strains.begin(), strains.end()}};
}

template <class Numbers, class Executor>
std::uint64_t ExplicitSolver<Numbers, Executor>::stateChecksum()
{
    executor_.synchronize();
    std::uint64_t hash = hashStart;
    for (const auto& x : state_.position.toHost()) hash = hashed(hash, double(x));
    for (const auto v : state_.velocity.toHost()) hash = hashed(hash, v);
    const auto state = state_.state.toHost();
    const auto strain = state_.plasticStrain.toHost();
    for (Index element = 0; element < data_.elementCount; ++element) {
        const ElementPlace place = data_.placeOf(element);
        const StateLayout& layout = data_.layouts[place.part];
        const int wide = layout.floatHourglass ? layout.hourglassForces() : layout.size();
        for (std::size_t k = 0; k < std::size_t(wide); ++k)
            hash = hashed(hash, state[place.state + k * std::size_t(tileWidth)]);
        for (int k = 0; layout.floatHourglass && k < layout.hourglass; ++k)
            hash = hashed(hash, floatAt(state, inFloatTiles(place.state, wide, k)));
        for (std::size_t k = 0; k < std::size_t(layout.sums()); ++k)
            hash = hashed(hash, strain[place.strains + k * std::size_t(tileWidth)]);
    }
    for (const auto& pair : state_.passes)
        for (const auto f : pair.friction.toHost()) hash = hashed(hash, f);
    return hash;
}

} // namespace fpm
