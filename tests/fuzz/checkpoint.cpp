#include "base/Log.h"
#include "fuzz/ImageEdits.h"
#include "fuzz/tried.h"
#include "run/Checkpoints.h"
#include "run/TimeLoop.h"
#include "stability/SceneTools.h"
#include "support/TemporaryFolder.h"
#include "support/solverModel.h"

#include <array>
#include <bit>
#include <limits>

// A checkpoint that says anything is refused, or the run goes on from it: to wrong results, since a
// checksum is no signature, but inside its arrays and to an end. The input is a list of edits: of
// the file where its first byte is odd, else of what the file says, which gets checksums that fit.

using namespace fpm;

namespace {

/// Two blocks that slide on each other, in two damped passes, and rows of a history.
Model smallModel()
{
    Model model;
    test::addBox(model.mesh, "lower", {2, 2, 1}, {-1, -1, -2}, {4, 4, 2});
    test::addBox(model.mesh, "upper", {1, 1, 1}, {0.3, 0.2, 0}, {1, 1, 1});
    renumber(model.mesh, 32);
    const Part part = test::aluminium(PartKind::elastoplastic, HourglassForm::physical);
    model.parts = {part, part};
    model.parts[0].name = "lower";
    model.parts[1].name = "upper";
    model.initialVelocities.push_back(
        {"fall", nodesOfPart(model.mesh, "upper"), Point{3e4, -2e4, -1e5}});
    ContactPair& pair = addContact(model, "touch", facing(model.mesh, "upper", {0, 0, -1}),
                                   facing(model.mesh, "lower", {0, 0, 1}));
    pair.friction = 0.3;
    pair.passes = 2;
    pair.normalDamping = 0.1;
    model.control.backend = "serial";
    model.control.simd = "scalar";
    model.control.endTime = 1e-5;
    model.control.historyInterval = 1e-7;
    model.control.histories.resize(1);
    model.control.histories[0].name = "energies";
    model.control.latest = true;
    return model;
}

/// A case that has stopped, with the checkpoint that is edited.
struct Base {
    test::TemporaryFolder folder;
    Model model = smallModel();
    Checkpoint checkpoint;
    std::string label;
    fuzz::ImageEdits content;

    Base()
        : checkpoint(written()),
          label(*hdf5Label(file())),
          content(file(),
                  {"stateVersion", "program", "runId", "time", "steps", "wallSeconds", "settled",
                   "mesh", "files", "fields", "file", "name", "checksum"})
    {
        model.control.checkpoint.keep = 0; // what goes on leaves none behind
    }
    std::filesystem::path file() const { return folder / checkpointFile; }

private:
    Checkpoint written() const
    {
        std::string said;
        Log log = Log::into(said);
        RunOptions options;
        options.maxSteps = touchingStep();
        options.inputs.mesh = "mesh";
        options.inputs.files.push_back({"constant/partProperties", "density 1;\n"});
        const auto solver = makeSolver(model);
        solver->start();
        runTimeLoop(*solver, model, folder.path(), options, log);
        return readCheckpoint(file());
    }
    /// The second step of contact: then friction is stored.
    std::int64_t touchingStep() const
    {
        const auto solver = makeSolver(model);
        solver->start();
        for (int touched = 0; touched < 2;) {
            solver->advance(model.control.endTime, 1);
            touched += solver->contact().force(0).active > 0;
            fuzz::require(solver->clock().time < model.control.endTime, "the blocks touch");
        }
        return solver->clock().steps;
    }
};

std::uint64_t value(fuzz::InputBytes& input)
{
    constexpr double infinity = std::numeric_limits<double>::infinity();
    constexpr std::array reals{0.0, -1.0, 1e-300, 1e300, infinity, -infinity, 1e15, 0.5};
    const std::size_t which = input.byte();
    if (which < 8) return std::bit_cast<std::uint64_t>(reals[which]);
    if (which < 16) return std::uint64_t(1) << (8 * (which - 8) + 7);
    if (which == 16) return std::bit_cast<std::uint64_t>(std::numeric_limits<double>::quiet_NaN());
    if (which == 17) return std::uint64_t(std::numeric_limits<std::int64_t>::max());
    return std::uint64_t(std::int64_t(which) - 32); // numbers of faces, and beyond either end
}

/// Numbers, or where the bytes end.
void editBytes(std::vector<std::byte>& bytes, fuzz::InputBytes& input)
{
    const std::uint8_t kind = input.byte();
    if (kind % 8 == 7) {
        bytes.resize(input.below(bytes.size() + 9));
        return;
    }
    const std::size_t width = std::size_t(1) << kind % 4, count = bytes.size() / width;
    if (count == 0) return;
    std::size_t place = width * input.below(count);
    std::uint64_t number = value(input);
    for (std::size_t i = 0; i < width; ++i, number >>= 8) bytes[place++] = std::byte(number & 255);
}

void editState(std::vector<FieldSet::Images>& state, fuzz::InputBytes& input)
{
    const std::uint8_t kind = input.byte();
    if (state.empty()) return;
    const std::size_t number = input.below(state.size());
    FieldSet::Images& set = state[number];
    if (kind == 0) {
        state.erase(state.begin() + std::ptrdiff_t(number));
        return;
    }
    if (kind == 1) {
        state.push_back(FieldSet::Images(set));
        return;
    }
    if (set.empty()) return;
    auto& [name, bytes] = set[input.below(set.size())];
    if (kind == 2)
        name = input.text(input.byte());
    else
        editBytes(bytes, input);
}

void edit(Checkpoint& checkpoint, fuzz::InputBytes& input)
{
    switch (input.byte() % 8) {
    case 0:
        checkpoint.time = std::bit_cast<double>(value(input));
        return;
    case 1:
        checkpoint.steps = std::bit_cast<std::int64_t>(value(input));
        return;
    case 2:
        checkpoint.wallSeconds = std::bit_cast<double>(value(input));
        checkpoint.settled = input.byte() % 2;
        return;
    case 3:
        checkpoint.runId = input.text(input.byte() % 64);
        return;
    case 4:
        return editBytes(checkpoint.record, input);
    default:
        editState(checkpoint.state, input);
    }
}

void writeEdited(const Base& base, fuzz::InputBytes& input)
{
    if (input.byte() % 2 == 1) {
        fuzz::ImageEdits edits = base.content;
        edits.apply(input);
        edits.write(base.folder.path(), checkpointFile, base.label);
        return;
    }
    Checkpoint forged = base.checkpoint;
    while (!input.isEmpty()) edit(forged, input);
    writeCheckpoint(OutputFolder(base.folder.path()), checkpointFile, forged);
}

void goOn(const Base& base)
{
    constexpr std::int64_t further = 3;
    std::string said;
    Log log = Log::into(said);
    std::filesystem::remove(base.folder / "status"); // it names the run of the input before
    const RunInputs inputs = base.checkpoint.inputs;
    const auto from = findCheckpoint(base.folder.path(), base.model.control, inputs, log);
    if (!from) return;
    const auto solver = makeSolver(base.model);
    solver->restore(from->state);
    RunOptions options;
    options.maxSteps = solver->clock().steps + further;
    options.from = &*from;
    options.inputs = inputs;
    runTimeLoop(*solver, base.model, base.folder.path(), options, log);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* bytes, std::size_t size)
{
    static const Base base;
    fuzz::InputBytes input(bytes, size);
    fuzz::tried([&] { writeEdited(base, input); });
    fuzz::tried([&] { goOn(base); });
    return 0;
}
