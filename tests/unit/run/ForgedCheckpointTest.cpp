#include "run/Checkpoints.h"
#include "run/ContactHealth.h"
#include "run/TimeLoop.h"
#include "support/TemporaryFolder.h"
#include "unit/solver/scenes.h"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>

namespace fpm::test {
namespace {

/// A checkpoint whose checksums fit, and which says what no run has written.
class ForgedCheckpoint : public ::testing::Test
{
protected:
    ForgedCheckpoint()
        : model_(twoBlocks(aluminium(PartKind::elastic, HourglassForm::physical),
                           aluminium(PartKind::elastic, HourglassForm::physical),
                           {0, 0, -1e5},
                           0.3))
    {
        model_.control.endTime = 1e-5;
        model_.control.historyInterval = 1e-7;
        const auto solver = startedSolver(model_);
        RunOptions options;
        options.maxSteps = 60;
        std::string said;
        Log log = Log::into(said);
        runTimeLoop(*solver, model_, folder_.path(), options, log);
        model_.control.latest = true;
        whole_ = readCheckpoint(file());
    }
    std::filesystem::path file() const { return folder_ / checkpointFile; }
    void write(const Checkpoint& checkpoint) const
    {
        writeCheckpoint(OutputFolder(folder_.path()), checkpointFile, checkpoint);
    }
    void goOn(std::int64_t furtherSteps = 2) const
    {
        std::string said;
        Log log = Log::into(said);
        const auto from = findCheckpoint(folder_.path(), model_.control, {}, log);
        if (!from) throw Error(ExitCode::checkpoint, "none was found");
        const auto solver = makeSolver(model_);
        solver->restore(from->state);
        RunOptions options;
        options.maxSteps = from->steps + furtherSteps;
        options.from = &*from;
        runTimeLoop(*solver, model_, folder_.path(), options, log);
    }
    template <class Change>
    void isRefused(const char* what, const Change& change) const
    {
        Checkpoint forged = whole_;
        change(forged);
        write(forged);
        try {
            goOn();
            ADD_FAILURE() << what << " was taken";
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ExitCode::checkpoint) << what << ": " << error.what();
        }
    }

    TemporaryFolder folder_;
    Model model_;
    Checkpoint whole_;
};

TEST_F(ForgedCheckpoint, GoesOnWhereNothingIsForged)
{
    write(whole_);
    EXPECT_NO_THROW(goOn());
}

TEST_F(ForgedCheckpoint, SaysWhatItsLabelSays)
{
    // No line of `status` or of a history comes from an id.
    isRefused("an id of two lines", [](Checkpoint& c) { c.runId = "a\nstate finished"; });
    isRefused("a time that is none",
              [](Checkpoint& c) { c.time = std::numeric_limits<double>::quiet_NaN(); });
    isRefused("seconds that are none",
              [](Checkpoint& c) { c.wallSeconds = std::numeric_limits<double>::infinity(); });
}

TEST_F(ForgedCheckpoint, SaysWhatItsClockSays)
{
    isRefused("another time", [](Checkpoint& c) { c.time *= 0.5; });
    isRefused("another step", [](Checkpoint& c) { c.steps += 1; });
}

TEST_F(ForgedCheckpoint, HasARecordOfTheRightLength)
{
    isRefused("a longer record", [](Checkpoint& c) { c.record.emplace_back(); });
    isRefused("a shorter record", [](Checkpoint& c) { c.record.pop_back(); });
    isRefused("no record", [](Checkpoint& c) { c.record.clear(); });
}

/// The record names a node where a pair has been deepest.
TEST_F(ForgedCheckpoint, NamesNodesOfTheMesh)
{
    const auto solver = startedSolver(model_);
    const Index beyond = Index(model_.mesh.points.size());
    for (const auto& [depth, node, taken] : {std::tuple{0.1, Index(0), true},
                                             {0.0, Index(-1), true},
                                             {0.1, Index(-1), false},
                                             {0.1, beyond, false},
                                             {0.0, Index(-2), false}}) {
        ContactHealth empty(model_, *solver);
        Archive out;
        empty.keep(out);
        std::vector<std::byte> bytes = out.bytes();
        std::memcpy(bytes.data() + 16, &depth, sizeof depth); // behind two doubles of the pair
        std::memcpy(bytes.data() + 32, &node, sizeof node);   // behind depth and time
        Archive back(bytes);
        ContactHealth health(model_, *solver);
        if (taken)
            EXPECT_NO_THROW(health.keep(back)) << node;
        else
            EXPECT_THROW(health.keep(back), Error) << node;
    }
}

} // namespace
} // namespace fpm::test
