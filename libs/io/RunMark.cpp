#include "io/RunMark.h"

#include <algorithm>
#include <fstream>

namespace fpm {
namespace {

constexpr std::string_view opening = "fpm run ";
constexpr const char* noRun = "-";

/// Ids and paths of ours hold none of these.
bool endsWord(char c)
{
    return c <= ' ' || c > '~' || c == '<' || c == '"' || c == ',';
}

std::string_view takeWord(std::string_view& text)
{
    const auto end = std::size_t(std::find_if(text.begin(), text.end(), endsWord) - text.begin());
    const auto word = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    return word;
}

} // namespace

std::string RunMark::text() const
{
    return std::string(opening) + (runId.empty() ? noRun : runId) + " " + file;
}

std::optional<RunMark> findMark(std::string_view text)
{
    const auto at = text.find(opening);
    if (at == text.npos) return std::nullopt;
    text.remove_prefix(at + opening.size());
    const auto runId = takeWord(text), file = takeWord(text);
    if (runId.empty() || file.empty()) return std::nullopt;
    return RunMark{runId == noRun ? "" : std::string(runId), std::string(file)};
}

std::optional<RunMark> markOf(const std::filesystem::path& file)
{
    std::error_code error;
    if (!std::filesystem::is_regular_file(std::filesystem::symlink_status(file, error)))
        return std::nullopt;
    std::string head(1024, '\0');
    std::ifstream stream(file, std::ios::binary);
    stream.read(head.data(), std::streamsize(head.size()));
    return findMark(std::string_view(head).substr(0, std::size_t(stream.gcount())));
}

} // namespace fpm
