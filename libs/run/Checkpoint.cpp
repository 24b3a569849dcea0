#include "run/Checkpoint.h"

#include "base/Error.h"
#include "base/Format.h"
#include "base/Version.h"
#include "io/Checksum.h"
#include "io/Hdf5File.h"

#include <array>
#include <cmath>

namespace fpm {

namespace {

/// Raised whenever a field or the record of a run means something else than before.
constexpr std::int64_t stateVersion = 2;

std::span<const std::uint8_t> octets(std::span<const std::byte> bytes)
{
    return {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()};
}

std::string checksumOf(std::span<const std::byte> bytes)
{
    Checksum sum;
    sum.add(bytes);
    return sum.text();
}

void writeBytes(Hdf5Image& image, const std::string& path, std::span<const std::byte> bytes)
{
    image.write(path, octets(bytes));
    image.attribute(path, "checksum", checksumOf(bytes));
}

std::vector<std::byte> readBytes(const Hdf5Reader& reader, const std::string& path)
{
    std::vector<std::byte> bytes = reader.bytes(path);
    if (reader.text(path, "checksum") != checksumOf(bytes))
        throw Error(ExitCode::checkpoint, format("the checksum of {} does not match", path));
    return bytes;
}

std::string textOf(const std::vector<std::byte>& bytes)
{
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// Groups are read back in the order of their names.
std::string numbered(const char* group, std::size_t number)
{
    const std::string digits = std::to_string(number);
    return format("{}/{}{}", group, std::string(6 - digits.size(), '0'), digits);
}

void writeState(Hdf5Image& image, const std::vector<FieldSet::Images>& state)
{
    for (std::size_t set = 0; set < state.size(); ++set) {
        const std::string group = numbered("/state", set);
        image.attribute(group, "fields",
                        std::array<std::int64_t, 1>{std::int64_t(state[set].size())});
        for (std::size_t field = 0; field < state[set].size(); ++field) {
            const std::string path = numbered(group.c_str(), field);
            writeBytes(image, path, state[set][field].second);
            image.attribute(path, "name", state[set][field].first);
        }
    }
}

std::vector<FieldSet::Images> readState(const Hdf5Reader& reader)
{
    std::vector<FieldSet::Images> state;
    for (const std::string& set : reader.children("/state")) {
        FieldSet::Images& images = state.emplace_back();
        for (const std::string& field : reader.children("/state/" + set)) {
            const std::string path = "/state/" + set + "/" + field;
            images.emplace_back(reader.text(path, "name"), readBytes(reader, path));
        }
    }
    return state;
}

std::int64_t integer(const Hdf5Reader& reader, const std::string& name)
{
    const std::vector<std::int64_t> values = reader.integers("/fpm", name);
    if (values.size() != 1)
        throw Error(ExitCode::checkpoint, format("{} is no single number", name));
    return values.front();
}

Checkpoint read(const std::filesystem::path& file)
{
    const Hdf5Reader reader(file);
    const std::int64_t version = integer(reader, "stateVersion");
    if (version != stateVersion)
        throw Error(ExitCode::checkpoint,
                    format("it is of version {} of the state, written by {}; this is {} with "
                           "version {}",
                           version, reader.text("/fpm", "program"), versionText(), stateVersion),
                    "go on with the program that wrote it, or start from time 0");
    Checkpoint out;
    out.runId = reader.text("/fpm", "runId");
    out.time = reader.number("/fpm", "time");
    out.steps = integer(reader, "steps");
    out.lastStep = reader.number("/fpm", "lastStep");
    out.wallSeconds = reader.number("/fpm", "wallSeconds");
    out.cpuSeconds = reader.number("/fpm", "cpuSeconds");
    out.settled = integer(reader, "settled") != 0;
    // By the label it was chosen, and no other text than a label's word is an id.
    const auto label = checkpointLabel(file);
    if (!label || label->runId != out.runId || label->time != out.time || label->steps != out.steps
        || label->lastStep != out.lastStep || !std::isfinite(out.wallSeconds)
        || !std::isfinite(out.cpuSeconds))
        throw Error(ExitCode::checkpoint, "it is not the one that its label names");
    out.inputs.mesh = reader.text("/fpm", "mesh");
    for (const std::string& name : reader.children("/inputs")) {
        const std::string path = "/inputs/" + name;
        out.inputs.files.push_back({reader.text(path, "file"), textOf(readBytes(reader, path))});
    }
    out.state = readState(reader);
    out.record = readBytes(reader, "/record");
    return out;
}

} // namespace

void writeCheckpoint(const OutputFolder& theCase,
                     const std::string& file,
                     const Checkpoint& checkpoint)
{
    Hdf5Image image;
    const auto integer = [&](const char* name, std::int64_t value) {
        image.attribute("/fpm", name, std::array<std::int64_t, 1>{value});
    };
    integer("stateVersion", stateVersion);
    image.attribute("/fpm", "program", versionText());
    image.attribute("/fpm", "runId", checkpoint.runId);
    image.attribute("/fpm", "time", checkpoint.time);
    integer("steps", checkpoint.steps);
    image.attribute("/fpm", "lastStep", checkpoint.lastStep);
    image.attribute("/fpm", "wallSeconds", checkpoint.wallSeconds);
    image.attribute("/fpm", "cpuSeconds", checkpoint.cpuSeconds);
    integer("settled", checkpoint.settled);
    image.attribute("/fpm", "mesh", checkpoint.inputs.mesh);
    image.attribute("/inputs", "files",
                    std::array<std::int64_t, 1>{std::int64_t(checkpoint.inputs.files.size())});
    for (std::size_t i = 0; i < checkpoint.inputs.files.size(); ++i) {
        const RunInputs::File& input = checkpoint.inputs.files[i];
        const std::string path = numbered("/inputs", i);
        writeBytes(image, path, std::as_bytes(std::span(input.text)));
        image.attribute(path, "file", input.name);
    }
    writeState(image, checkpoint.state);
    writeBytes(image, "/record", checkpoint.record);
    image.save(theCase, file, checkpoint.text());
}

void requireMoment(const Checkpoint& checkpoint, double time, std::int64_t steps)
{
    if (checkpoint.time != time || checkpoint.steps != steps)
        throw Error(ExitCode::checkpoint,
                    format("the checkpoint says time {}, step {}, and its state is of time {}, "
                           "step {}",
                           toText(checkpoint.time), checkpoint.steps, toText(time), steps));
}

Checkpoint readCheckpoint(const std::filesystem::path& file)
{
    try {
        return read(file);
    } catch (const Error& error) {
        throw Error(ExitCode::checkpoint,
                    error.code() == ExitCode::checkpoint
                        ? format("cannot go on from '{}': {}", file.string(), error.what())
                        : error.what(),
                    error.advice());
    }
}

} // namespace fpm
