#include "mesher/MshText.h"

#include "base/Error.h"
#include "base/Format.h"

#include <charconv>
#include <cstdint>
#include <vector>

namespace fpm {

namespace {

[[noreturn]] void refuse(const std::string& name, const std::string& what)
{
    throw Error(ExitCode::mesh, format("{}: {}", name, what),
                "export it again: gmsh -format msh41, or \"Save As\" with extension .msh");
}

/// The next line without its end; `text` keeps the rest.
std::string_view takeLine(std::string_view& text)
{
    const auto end = text.find('\n');
    std::string_view line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.remove_suffix(1);
    return line;
}

std::vector<std::string_view> wordsOf(std::string_view line)
{
    std::vector<std::string_view> words;
    for (std::size_t at = 0; (at = line.find_first_not_of(" \t", at)) != std::string_view::npos;) {
        const auto end = std::min(line.find_first_of(" \t", at), line.size());
        words.push_back(line.substr(at, end - at));
        at = end;
    }
    return words;
}

/// The whole number a line names at `place`; refuses anything else.
std::int64_t countIn(const std::string& name, std::string_view line, std::size_t place)
{
    const auto words = wordsOf(line);
    std::int64_t count = -1;
    if (place < words.size()) {
        const auto word = words[place];
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), count);
        if (error != std::errc() || end != word.data() + word.size()) count = -1;
    }
    if (count < 0)
        refuse(name, format("expected a count of entries as word {} of a line", place + 1));
    return count;
}

/// The lines between $Section and $EndSection.
std::string_view
sectionOf(const std::string& name, std::string_view text, const std::string& section)
{
    const std::string open = "\n$" + section, close = "\n$End" + section;
    const auto begin = text.find(open);
    if (begin == std::string_view::npos) refuse(name, format("has no ${} section", section));
    const auto end = text.find(close, begin);
    if (end == std::string_view::npos)
        refuse(name, format("ends inside its ${} section: the file is cut short", section));
    auto body = text.substr(begin + 1, end - begin);
    takeLine(body);
    return body;
}

/// Format 4.1 gives the number of blocks first: one line each, besides those of the entries.
void checkCounts(const std::string& name,
                 std::string_view body,
                 const std::string& what,
                 bool blocks)
{
    const auto head = takeLine(body);
    const std::int64_t entries = countIn(name, head, blocks ? 1 : 0);
    const std::int64_t blockCount = blocks ? countIn(name, head, 0) : 0;
    const std::int64_t linesEach = blocks && what == "Nodes" ? 2 : 1; // tags, then coordinates
    if (entries > std::int64_t(body.size()) || blockCount > std::int64_t(body.size()))
        refuse(name, format("${} announces {} entries, more than the file holds", what, entries));
    std::int64_t lines = 0;
    while (!body.empty()) lines += !wordsOf(takeLine(body)).empty();
    if (lines != blockCount + linesEach * entries)
        refuse(name, format("${} announces {} entries, which take {} lines, but has {}", what,
                            entries, blockCount + linesEach * entries, lines));
}

} // namespace

void checkMshText(const std::string& name, std::string_view text)
{
    if (text.empty()) refuse(name, "the file is empty");
    const std::string_view whole = text;
    if (takeLine(text) != "$MeshFormat")
        refuse(name, "is not a Gmsh mesh file: its first line is not $MeshFormat");
    const auto head = wordsOf(takeLine(text));
    const std::string version(head.empty() ? "" : head[0]);
    if (version != "2.2" && version != "4.1")
        refuse(name, "is of a format that is not read; only 2.2 and 4.1 are");
    const bool isBinary = head.size() > 1 && head[1] == "1";
    for (const std::string section : {"Nodes", "Elements"}) {
        const auto body = sectionOf(name, whole, section);
        if (!isBinary) checkCounts(name, body, section, version == "4.1");
    }
}

} // namespace fpm
