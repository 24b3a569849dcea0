#include "unit/solver/scenes.h"

#include <gtest/gtest.h>

// `hourglass { storage float; }`: less memory, the same bits in every way of running, and no more
// than the rounding of the forces between it and full storage.

namespace fpm::test {
namespace {

void keepFloats(Model& model)
{
    for (Part& part : model.parts) part.hourglassStorage = HourglassStorage::float_;
}

/// A plastic block strikes an elastic one and slides; `general`: with backstress and temperature
/// before and beside its hourglass forces.
Model impact(bool general, HourglassForm form)
{
    Part upper = aluminium(PartKind::elastoplastic, form);
    if (general) {
        upper.flow.kinematicModulus = 900;
        upper.flow.heatFraction = 0.9;
        upper.flow.specificHeat = 9e8;
    }
    Model model = twoBlocks(upper, aluminium(PartKind::elastic, HourglassForm::stiffness),
                            {3e4, -2e4, -1e5}, 0.3);
    holdFixed(model, nodesWhere(model.mesh, [](Point p) { return p[2] < -3.99; }));
    return model;
}

std::uint64_t checksumOf(Model model, int threads, const char* simd, int pauses = 1)
{
    model.control.backend = threads > 1 ? "openmp" : "serial";
    model.control.threads = threads;
    model.control.simd = simd;
    const auto solver = startedSolver(model);
    for (int pause = 0; pause < pauses; ++pause) {
        solver->advance(1, 200 / pauses);
        solver->elements().values();
    }
    EXPECT_EQ(solver->clock().steps, 200);
    EXPECT_FALSE(solver->clock().failed);
    EXPECT_GT(solver->ledger().energies().hourglass, 0);
    EXPECT_GT(solver->ledger().energies().plastic, 0);
    return stateChecksum(*solver);
}

TEST(HourglassStorage, FloatIsTheSameBitsInEveryWidthOnAnyThreadsAndWithPauses)
{
    for (const bool general : {false, true})
        for (const HourglassForm form : {HourglassForm::physical, HourglassForm::stiffness}) {
            Model model = impact(general, form);
            const std::uint64_t full = checksumOf(model, 1, "scalar");
            keepFloats(model);
            const std::uint64_t scalar = checksumOf(model, 1, "scalar");
            EXPECT_NE(scalar, full);
            EXPECT_EQ(checksumOf(model, 1, "avx2"), scalar);
            if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq")
                && __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw")) {
                EXPECT_EQ(checksumOf(model, 1, "avx512"), scalar);
            }
            // Threads wait for each other where cores are busy: once is enough.
            if (general && form == HourglassForm::physical) {
                EXPECT_EQ(checksumOf(model, 2, "auto", 8), scalar);
            }
        }
}

TEST(HourglassStorage, ChangesNothingWhereTheStateIsFloatOrHasNoHourglassForces)
{
    for (const Precision precision : {Precision::mixed, Precision::single}) {
        Model model = impact(false, HourglassForm::physical);
        model.control.precision = precision;
        const std::uint64_t full = checksumOf(model, 1, "auto");
        keepFloats(model);
        EXPECT_EQ(checksumOf(model, 1, "auto"), full);
    }
    Model viscous = impact(false, HourglassForm::viscous);
    viscous.parts[0].hourglass = HourglassForm::viscous;
    const std::uint64_t full = checksumOf(viscous, 1, "auto");
    keepFloats(viscous);
    EXPECT_EQ(checksumOf(viscous, 1, "auto"), full);
}

TEST(HourglassStorage, FloatTakesHalfTheMemoryOfTheForces)
{
    const auto bytes = [](HourglassForm form, HourglassStorage storage) {
        Part part = aluminium(PartKind::elastoplastic, form);
        part.hourglassStorage = storage;
        return makeSolver(boxModel({16, 1, 1}, {16, 1, 1}, part))->fields().bytes();
    };
    for (const HourglassForm form : {HourglassForm::physical, HourglassForm::stiffness})
        EXPECT_EQ(bytes(form, HourglassStorage::full) - bytes(form, HourglassStorage::float_),
                  16 * 12 * 4u);
}

/// Work of the hourglass forces of one element that is bent by driven nodes beyond yield; of the
/// physical form that is bending of the section, part of the internal energy.
double workOfBending(HourglassForm form, HourglassStorage storage, int steps)
{
    Part part = aluminium(PartKind::elastoplastic, form);
    part.hourglassStorage = storage;
    Model model = boxModel({1, 1, 1}, {1, 1, 1}, part);
    model.control.fixedTimeStep = 2e-8;
    const double time = steps * model.control.fixedTimeStep;
    for (std::size_t i = 0; i < model.mesh.points.size(); ++i) {
        const Point& p = model.mesh.points[i];
        model.boundaryConditions.push_back(
            condition(BoundaryCondition::Kind::velocity, "drive", {Index(i)}, {true, true, true},
                      {0.04 * (p[0] - 0.5) * (p[2] - 0.5) / time, 0, 0}));
    }
    const auto solver = startedSolver(model);
    solver->advance(time, steps + 10);
    EXPECT_EQ(solver->clock().steps, steps);
    if (form == HourglassForm::physical) {
        EXPECT_GT(solver->ledger().energies().plastic, 0);
    }
    const Energies energies = solver->ledger().energies();
    return form == HourglassForm::physical ? energies.internal : energies.hourglass;
}

// All nodes are driven, so increments dq are the same with both storages and the work W = sum Q dq
// differs by sum dQ dq. Each step adds at most u |Q|, u = 2^-24, to the error dQ of a force; the
// flow of the section, a projection on a convex surface, does not enlarge it: after n steps |dQ| <=
// n u max|Q|. The force grows ever slower as bending goes on, so W >= max|Q| sum|dq| / 2 and |dW|
// <= 2 n u W.
TEST(HourglassStorage, FloatChangesTheWorkOfDrivenBendingByNoMoreThanItsRounding)
{
    const int steps = 200;
    for (const HourglassForm form : {HourglassForm::physical, HourglassForm::stiffness}) {
        const double full = workOfBending(form, HourglassStorage::full, steps),
                     rounded = workOfBending(form, HourglassStorage::float_, steps);
        EXPECT_GT(full, 0);
        EXPECT_NE(rounded, full);
        EXPECT_LE(std::abs(rounded - full), 2 * steps * std::ldexp(1.0, -24) * full);
    }
}

} // namespace
} // namespace fpm::test
