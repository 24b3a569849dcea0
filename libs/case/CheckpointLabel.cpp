#include "case/CheckpointLabel.h"

#include "base/Format.h"
#include "dictionary/Number.h"
#include "io/Hdf5File.h"
#include "io/RunMark.h"

namespace fpm {

std::string checkpointFileOf(int age)
{
    return age == 0 ? checkpointFile : format("{}/state.{}.h5", checkpointFolder, age);
}

std::string CheckpointLabel::text() const
{
    return RunMark{runId, checkpointFile}.text()
           + format(" time {} steps {} lastStep {} wall {} cpu {}", toText(time), steps,
                    toText(lastStep), toText(wallSeconds, 9), toText(cpuSeconds, 9));
}

std::optional<CheckpointLabel> checkpointLabel(const std::filesystem::path& file)
{
    const auto text = hdf5Label(file);
    const auto mark = text ? findMark(*text) : std::nullopt;
    if (!mark || mark->file != checkpointFile) return std::nullopt;
    const auto valueOf = [&](const std::string& word) {
        const auto at = text->find(" " + word + " ");
        if (at == text->npos) return std::string();
        const std::string rest = text->substr(at + word.size() + 2);
        return rest.substr(0, rest.find(' '));
    };
    const auto time = readNumber(valueOf("time")), lastStep = readNumber(valueOf("lastStep")),
               wall = readNumber(valueOf("wall")), cpu = readNumber(valueOf("cpu"));
    const auto steps = readInteger(valueOf("steps"));
    if (!time || !steps || !lastStep || !wall || !cpu) return std::nullopt;
    return CheckpointLabel{mark->runId, *time, *steps, *lastStep, *wall, *cpu};
}

} // namespace fpm
