#include "base/ChildProcess.h"
#include "base/Format.h"
#include "support/TemporaryFolder.h"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <random>

// Stands in for libFuzzer where the compiler has none:
//   fuzz_<target> <runs> <file for a failing input> <folder of inputs>...
// feeds every file of the folders, then so many seeded mutations of them, all in a child process
// with limits on memory and time; with runs 0 and a single file that one alone, in this process.

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* bytes, std::size_t size);

using namespace fpm;

namespace {

constexpr std::uint64_t memoryBytes = std::uint64_t(2) << 30; // gmsh maps one at once
constexpr unsigned secondsEach = 120;                         // of the clock, on a busy machine too

void feed(const std::string& input)
{
    LLVMFuzzerTestOneInput(reinterpret_cast<const unsigned char*>(input.data()), input.size());
}

std::vector<std::string> corpusOf(const std::vector<std::filesystem::path>& folders)
{
    std::vector<std::filesystem::path> files;
    for (const auto& folder : folders)
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
            if (entry.is_regular_file()) files.push_back(entry.path());
    std::ranges::sort(files);
    std::vector<std::string> inputs;
    for (const auto& file : files) inputs.push_back(test::readBytes(file));
    return inputs;
}

/// The inputs by number: first the corpus, then mutations of it.
class Inputs
{
public:
    explicit Inputs(std::vector<std::string> corpus) : corpus_(std::move(corpus)) {}

    std::string operator()(std::size_t number) const
    {
        if (number < corpus_.size()) return corpus_[number];
        std::mt19937_64 random(number);
        std::string input = corpus_[random() % corpus_.size()];
        for (auto left = 1 + random() % 6; left > 0; --left) mutate(input, random);
        return input;
    }

private:
    void mutate(std::string& input, std::mt19937_64& random) const
    {
        const std::size_t place = random() % (input.size() + 1);
        const std::size_t length = std::min<std::size_t>(1 + random() % 24, input.size() - place);
        switch (random() % 8) {
        case 0:
            if (length > 0) input[place] = char(input[place] ^ (1 << random() % 8));
            break;
        case 1:
            if (length > 0) input[place] = char(random());
            break;
        case 2:
            input.insert(place, 1, "0123456789-.e;,{}()\n\"$#"[random() % 23]);
            break;
        case 3:
            input.erase(place, length);
            break;
        case 4:
            input.insert(random() % (input.size() + 1), input.substr(place, length));
            break;
        case 5:
            for (auto left = random() % 9; left > 0; --left) input.insert(place, 1, char(random()));
            break;
        case 6:
            input.resize(place);
            break;
        default:
            splice(input, place, random);
        }
    }

    /// A piece of another input.
    void splice(std::string& input, std::size_t place, std::mt19937_64& random) const
    {
        const std::string& other = corpus_[random() % corpus_.size()];
        const std::size_t from = random() % (other.size() + 1);
        input.insert(place, other.substr(from, 1 + random() % 64));
    }

    std::vector<std::string> corpus_;
};

/// A number that the child writes and this process reads when the child is gone.
class SharedNumber
{
public:
    SharedNumber()
        : place_(::mmap(nullptr,
                        sizeof(std::size_t),
                        PROT_READ | PROT_WRITE,
                        MAP_SHARED | MAP_ANONYMOUS,
                        -1,
                        0))
    {
        if (place_ == MAP_FAILED) std::abort();
    }
    SharedNumber(const SharedNumber&) = delete;
    SharedNumber& operator=(const SharedNumber&) = delete;
    ~SharedNumber() { ::munmap(place_, sizeof(std::size_t)); }
    volatile std::size_t& value() const { return *static_cast<volatile std::size_t*>(place_); }

private:
    void* place_;
};

bool survivesAll(const Inputs& inputs, std::size_t count, const std::filesystem::path& failing)
{
    const SharedNumber number;
    const ChildTask task{"input", ExitCode::internal, "", memoryBytes, 0};
    try {
        inChild(task, [&] {
            for (std::size_t k = 0; k < count; ++k) {
                number.value() = k;
                ::alarm(secondsEach);
                feed(inputs(k));
            }
            return std::string();
        });
        return true;
    } catch (const Error& error) {
        const std::size_t k = number.value();
        std::ofstream(failing, std::ios::binary) << inputs(k);
        std::printf("input %zu of %zu: %s\nkept as %s; see it again: <program> 0 %s\n", k, count,
                    error.what(), failing.c_str(), failing.c_str());
        return false;
    }
}

} // namespace

int main(int count, char** words)
{
    if (count < 3) {
        std::fprintf(stderr, "%s <runs> <file for a failing input> <folder>...\n", words[0]);
        return 2;
    }
    const auto runs = std::strtoull(words[1], nullptr, 10);
    if (runs == 0) {
        feed(test::readBytes(words[2]));
        return 0;
    }
    const auto corpus = corpusOf({words + 3, words + count});
    if (corpus.empty()) {
        std::fprintf(stderr, "no inputs in the folders\n");
        return 2;
    }
    const test::TemporaryFolder folder; // the child leaves its own behind
    ::setenv("TMPDIR", folder.path().c_str(), 1);
    const std::size_t all = corpus.size() + runs;
    if (!survivesAll(Inputs(corpus), all, words[2])) return 1;
    std::printf("%zu inputs and %zu mutations of them: each read or refused\n", corpus.size(),
                std::size_t(runs));
    return 0;
}
