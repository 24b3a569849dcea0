#include "io/InputFile.h"

#include "base/Error.h"
#include "io/Hdf5File.h"
#include "support/OrdinaryUser.h"
#include "support/TemporaryFolder.h"

#include <gtest/gtest.h>

namespace fpm {
namespace {

namespace fs = std::filesystem;

/// How reading a file as HDF5 ends, without root's rights: "6 <message> = <advice>".
std::string refusal(const fs::path& file)
{
    try {
        const test::OrdinaryUser user;
        const Hdf5Reader reader(file);
        return "";
    } catch (const Error& error) {
        return std::to_string(int(error.code())) + " " + error.what() + " = " + error.advice();
    }
}

TEST(InputFile, SaysWhatKeepsItFromBeingRead)
{
    const test::TemporaryFolder folder;
    fs::permissions(folder.path(), fs::perms(0755));
    test::writeBytes(folder / "closed.h5", "x");
    fs::permissions(folder / "closed.h5", fs::perms::none);
    const std::string name = (folder / "closed.h5").string(),
                      closed = refusal(folder / "closed.h5");

    EXPECT_EQ(
        closed.find("6 cannot read '" + name + "': permission denied: '" + name + "' belongs to "),
        0u)
        << closed;
    EXPECT_FALSE(closed.ends_with(" = ")) << "it says what helps";
    EXPECT_EQ(refusal(folder.path()),
              "4 cannot read '" + folder.path().string() + "': it is a folder = name a file in it");
    EXPECT_EQ(refusal(folder / "none.h5"), "4 cannot read '" + (folder / "none.h5").string()
                                               + "': No such file or directory = ");
}

} // namespace
} // namespace fpm
