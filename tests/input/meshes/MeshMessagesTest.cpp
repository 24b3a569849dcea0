#include "support/TemporaryFolder.h"

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

namespace fpm::test {

namespace {

namespace fs = std::filesystem;

const fs::path folder = fs::path(FPM_SOURCE_DIR) / "tests/input/meshes";

/// Names of the wrong dictionaries: <name>.dict beside <name>.txt.
std::vector<std::string> wrongMeshes()
{
    std::vector<std::string> names;
    for (const auto& file : fs::directory_iterator(folder))
        if (file.path().extension() == ".dict") names.push_back(file.path().stem());
    std::sort(names.begin(), names.end());
    return names;
}

/// What fpmMesh answers in a fresh case with this meshDict and the mesh files: exit code, then what
/// it says on standard error. Nothing may be made.
std::string answer(const fs::path& dictionary)
{
    const TemporaryFolder theCase;
    fs::create_directory(theCase / "system");
    fs::copy_file(dictionary, theCase / "system/meshDict");
    fs::copy(folder / "files", theCase.path(), fs::copy_options::recursive);

    const std::string errors = (theCase / "errors").string();
    const std::string command = std::string(FPM_MESH) + " -noLog -case " + theCase.path().string()
                                + " > /dev/null 2> " + errors;
    const int status = std::system(command.c_str());
    if (!WIFEXITED(status)) return "died\n";
    if (fs::exists(theCase / "constant/mesh.vtkhdf")) return "wrote a mesh\n";
    return std::to_string(WEXITSTATUS(status)) + "\n" + readBytes(errors);
}

class WrongMesh : public testing::TestWithParam<std::string>
{};

} // namespace

TEST_P(WrongMesh, IsAnsweredWithItsMessage)
{
    const std::string expected = readBytes(folder / (GetParam() + ".txt"));

    EXPECT_EQ(answer(folder / (GetParam() + ".dict")), expected);
}

INSTANTIATE_TEST_SUITE_P(Input,
                         WrongMesh,
                         testing::ValuesIn(wrongMeshes()),
                         [](const auto& parameter) { return parameter.param; });

} // namespace fpm::test
