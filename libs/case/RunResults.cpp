#include "case/RunResults.h"

#include "base/Format.h"
#include "io/RunMark.h"

#include <algorithm>

namespace fpm {

namespace {

/// The first few of many names.
std::string listOf(const std::vector<std::string>& names)
{
    constexpr std::size_t most = 5;
    std::string text;
    for (std::size_t i = 0; i < std::min(most, names.size()); ++i)
        text += (i == 0 ? "" : ", ") + names[i];
    return names.size() > most ? text + ", ..." : text;
}

} // namespace

RunResults::RunResults(std::filesystem::path caseRoot)
    : root_(std::move(caseRoot)),
      status_(readStatus(root_))
{
    const auto found = listFrames(root_);
    if (status_)
        runId_ = status_->runId;
    else // ids begin with the date
        for (const FrameFile& frame : found) runId_ = std::max(runId_, frame.runId);
    const std::string mesh = found.empty() ? "" : meshChecksumOf(root_);
    for (const FrameFile& frame : found)
        if (frame.runId != runId_)
            ofOtherRuns_.push_back(frame.time.first);
        else if (!mesh.empty() && frame.meshChecksum != mesh)
            ofOtherMesh_.push_back(frame.time.first);
        else
            frames_.push_back(frame.time);
}

void RunResults::report(Log& log) const
{
    if (status_ && (status_->state == RunState::running || status_->state == RunState::finished))
        log.line(describe(*status_, root_));
    else if (status_)
        log.warning(describe(*status_, root_) + "; its results end there");
    else if (!frames_.empty())
        log.warning("there is no file status: the frames are those of "
                    + (runId_.empty() ? std::string("no named run") : "run " + runId_));
    if (!ofOtherRuns_.empty())
        log.warning(format("left out: {} frames of other runs, at times {}", ofOtherRuns_.size(),
                           listOf(ofOtherRuns_)));
    if (!ofOtherMesh_.empty())
        log.warning(format("left out: {} frames of another mesh than constant/mesh.vtkhdf, at "
                           "times {}; run fpmExplicit with this mesh",
                           ofOtherMesh_.size(), listOf(ofOtherMesh_)));
}

std::string otherRunOf(const Table& table, const std::string& runId)
{
    if (runId.empty()) return "";
    for (const std::string& note : table.notes)
        if (const auto mark = findMark(note); mark && mark->runId != runId) return mark->runId;
    return "";
}

} // namespace fpm
