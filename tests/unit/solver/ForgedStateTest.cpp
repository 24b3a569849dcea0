#include "kernels/contact/broad/CellLists.h"
#include "unit/solver/scenes.h"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>

namespace fpm::test {
namespace {

/// A state whose checksums fit and whose numbers lead nowhere: kernels follow them unseen, so that
/// none may get through.
class ForgedState : public ::testing::Test
{
protected:
    ForgedState()
        : model_(twoBlocks(aluminium(PartKind::elastoplastic, HourglassForm::physical),
                           aluminium(PartKind::elastic, HourglassForm::stiffness),
                           {3e4, -2e4, -1e5},
                           0.3))
    {
        const auto solver = startedSolver(model_);
        solver->advance(1, 60);
        EXPECT_GT(solver->contact().force(0).active, 0);
        state_ = solver->state();
    }

    std::vector<std::byte>& image(const std::string& field)
    {
        for (FieldSet::Images& set : state_)
            for (auto& [name, bytes] : set)
                if (name == field) return bytes;
        throw std::runtime_error("no field " + field);
    }
    template <class T>
    std::vector<T> values(const std::string& field)
    {
        const std::vector<std::byte>& bytes = image(field);
        std::vector<T> out(bytes.size() / sizeof(T));
        std::memcpy(out.data(), bytes.data(), bytes.size());
        return out;
    }
    template <class T>
    void put(const std::string& field, const std::vector<T>& values)
    {
        std::memcpy(image(field).data(), values.data(), values.size() * sizeof(T));
    }
    /// `change` is made to the values of a field, and undone.
    template <class T, class Change>
    void isRefused(const std::string& field, const Change& change)
    {
        const std::vector<T> before = values<T>(field);
        std::vector<T> forged = before;
        change(forged);
        put(field, forged);
        try {
            makeSolver(model_)->restore(state_);
            ADD_FAILURE() << field << " was taken";
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ExitCode::checkpoint) << error.what();
        }
        put(field, before);
        EXPECT_NO_THROW(makeSolver(model_)->restore(state_)) << field;
    }

    Model model_;
    std::vector<FieldSet::Images> state_;
};

TEST_F(ForgedState, HasListsOfCellsThatEnd)
{
    const auto firstOf = [](const std::vector<Index>& heads) {
        return *std::ranges::find_if(heads, [](Index head) { return head >= 0; });
    };
    const Index first = firstOf(values<Index>("head"));
    isRefused<CellEntry>("entries", [&](std::vector<CellEntry>& entries) { // of one
        entries[std::size_t(first)].next = first;
    });
    isRefused<CellEntry>("entries", [&](std::vector<CellEntry>& entries) { // of two
        const Index other = first == 0 ? 1 : 0;
        entries[std::size_t(first)].next = other;
        entries[std::size_t(other)].next = first;
    });
    isRefused<Index>("head", [&](std::vector<Index>& heads) { // two lists with one end
        *std::ranges::find(heads, -1) = first;
    });
}

TEST_F(ForgedState, HasNumbersOfCellEntries)
{
    for (const Index number : {Index(-2), Index(1000), std::numeric_limits<Index>::max(),
                               std::numeric_limits<Index>::min()}) {
        isRefused<CellEntry>("entries", [&](auto& entries) { entries.back().next = number; });
        isRefused<Index>("head", [&](auto& heads) { heads.front() = number; });
        isRefused<Index>("head", [&](auto& heads) { heads.back() = number; });
    }
    const Index beyond = Index(values<CellEntry>("entries").size());
    isRefused<CellEntry>("entries", [&](auto& entries) { entries.front().next = beyond; });
}

TEST_F(ForgedState, HasNumbersOfFaces)
{
    const Index faces = Index(values<CellEntry>("entries").size());
    for (const char* field : {"face", "frictionFace"})
        for (const Index number : {faces, Index(-3), std::numeric_limits<Index>::max()})
            isRefused<Index>(field, [&](auto& values) { values.front() = number; });
}

TEST_F(ForgedState, HasAFaceToEveryForceOfFriction)
{
    const std::vector<Index> frames = values<Index>("frictionFace");
    const std::vector<double> held = values<double>("tangentialForce");
    std::size_t sticks = 0;
    while (sticks < frames.size() && held[sticks] == 0) ++sticks;
    ASSERT_LT(sticks, frames.size());
    isRefused<Index>("frictionFace", [&](auto& values) { values[sticks] = -1; });
}

TEST_F(ForgedState, HasAClockThatRuns)
{
    constexpr double infinity = std::numeric_limits<double>::infinity();
    constexpr std::int64_t huge = std::numeric_limits<std::int64_t>::max();
    for (double StepClock::*span : {&StepClock::time, &StepClock::step, &StepClock::mean})
        for (const double value : {infinity, -1.0, std::numeric_limits<double>::quiet_NaN()})
            isRefused<StepClock>("clock", [&](auto& clock) { clock[0].*span = value; });
    isRefused<StepClock>("clock", [&](auto& clock) { clock[0].lost = infinity; });
    for (std::int64_t StepClock::*count : {&StepClock::steps, &StepClock::deletions,
                                           &StepClock::listsValidUntil, &StepClock::followed})
        for (const std::int64_t value : {std::int64_t(-2), huge})
            isRefused<StepClock>("clock", [&](auto& clock) { clock[0].*count = value; });
}

TEST_F(ForgedState, HasCountsOfSearches)
{
    for (const std::int64_t value : {std::int64_t(-1), std::numeric_limits<std::int64_t>::max()}) {
        isRefused<PassListState>("lists", [&](auto& lists) { lists[0].searches = value; });
        isRefused<std::int64_t>("searches", [&](auto& searches) { searches[0] = value; });
    }
    isRefused<std::int64_t>("nextSearch", [&](auto& next) { next[0] = -1; });
}

/// A pass that has lost its contactors to deletion is never searched: its cells stay empty.
TEST_F(ForgedState, IsNotWhatAPassBeforeItsFirstSearchHas)
{
    const auto solver = makeSolver(model_);
    EXPECT_NO_THROW(makeSolver(model_)->restore(solver->state()));
}

} // namespace
} // namespace fpm::test
