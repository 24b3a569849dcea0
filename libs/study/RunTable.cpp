#include "study/RunTable.h"

#include "base/Format.h"
#include "dictionary/Number.h"

#include <fcntl.h>

#include <fstream>
#include <map>
#include <sstream>

namespace fpm {

namespace {

constexpr std::size_t columns = 11;

std::string lineOf(const RunRow& row)
{
    std::string line = row.run;
    for (const auto& word : {row.key, toText(row.repeat), row.state, toText(row.wall, 6),
                             toText(row.cpu, 6), toText(row.elements), toText(row.steps),
                             toText(row.nsPerElementStep), toText(row.memory), row.host})
        line += " " + word;
    return line + "\n";
}

/// False when the words are no row.
bool rowOf(const std::vector<std::string>& words, RunRow& row)
{
    if (words.size() != columns || words[0].find('/') != std::string::npos) return false;
    const auto repeat = readInteger(words[2]);
    if (!repeat || *repeat < 1 || *repeat > 1'000'000) return false;
    row.run = words[0], row.key = words[1], row.repeat = int(*repeat), row.state = words[3];
    std::size_t at = 4;
    for (double RunRow::*value : {&RunRow::wall, &RunRow::cpu, &RunRow::elements, &RunRow::steps,
                                  &RunRow::nsPerElementStep, &RunRow::memory}) {
        const auto number = readNumber(words[at++]);
        if (!number) return false;
        row.*value = *number;
    }
    row.host = words[at];
    return true;
}

} // namespace

std::string stateOf(const std::string& program, ExitCode code)
{
    return format("{}:{}", program, int(code));
}

std::string causeOf(const std::string& state)
{
    const auto colon = state.find(':');
    if (colon == state.npos) return state;
    const auto program = state.substr(0, colon), how = state.substr(colon + 1);
    if (const double limit = timeLimitOf(state); limit > 0)
        return format("time limit of {} s ({})", toText(limit), program);
    if (how.starts_with("signal")) return format("{} killed by signal {}", program, how.substr(6));
    static const std::map<std::string, std::string> meanings{
        {"2", "wrong option"},   {"3", "wrong dictionary"}, {"4", "bad mesh"},
        {"5", "bad checkpoint"}, {"6", "file error"},       {"7", "case in use"},
        {"8", "device missing"}, {"9", "device lost"},      {"10", "numerical stop"},
        {"12", "out of memory"}, {"70", "internal error"},  {"75", "stopped"}};
    const auto found = meanings.find(how);
    return format("{} ({}, status {})",
                  found == meanings.end() ? std::string("failed") : found->second, program, how);
}

std::string pastTimeLimit(const std::string& program, double seconds)
{
    return format("{}:timeLimit{}", program, toText(seconds));
}

double timeLimitOf(const std::string& state)
{
    const std::string mark = ":timeLimit";
    const auto at = state.find(mark);
    return at == state.npos ? 0 : readNumber(state.substr(at + mark.size())).value_or(0);
}

RunTable::RunTable(const OutputFolder& output, const std::string& file)
    : output_(output),
      file_(file)
{
    const auto path = output.path(file);
    if (std::error_code error;
        std::filesystem::exists(std::filesystem::symlink_status(path, error)))
        output.open(file, O_RDONLY); // refuses links
    std::ifstream stream(path);
    int number = 0;
    for (std::string line; std::getline(stream, line);) {
        ++number;
        std::istringstream text(line);
        std::vector<std::string> words;
        for (std::string word; text >> word;) words.push_back(word);
        if (words.empty() || words[0].starts_with('#')) continue;
        RunRow row;
        if (!rowOf(words, row))
            throw Error(ExitCode::fileIo,
                        format("{}:{}: this line is no finished run", path.string(), number),
                        "delete the line to repeat the run, or the file to repeat all");
        rows_.push_back(std::move(row));
    }
}

const RunRow* RunTable::find(const std::string& key, int repeat) const
{
    for (const auto& row : rows_)
        if (row.key == key && row.repeat == repeat) return &row;
    return nullptr;
}

void RunTable::add(const RunRow& row)
{
    rows_.push_back(row);
    write();
}

void RunTable::removeRun(const std::string& run)
{
    if (std::erase_if(rows_, [&](const RunRow& row) { return row.run == run; }) > 0) write();
}

void RunTable::write() const
{
    std::string text = "# run key repeat state wall_s cpu_s elements steps nsPerElementStep "
                       "memory_MB host\n";
    for (const auto& row : rows_) text += lineOf(row);
    output_.write(file_, text);
}

} // namespace fpm
