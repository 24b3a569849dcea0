#include "dictionary/SourceFile.h"

#include "dictionary/Dictionary.h"
#include "dictionary/Limits.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>

namespace fpm {

namespace {

namespace fs = std::filesystem;

/// A folder of its own for each test, removed afterwards.
class Files : public testing::Test
{
protected:
    Files() { fs::create_directories(folder_); }
    ~Files() override { fs::remove_all(folder_.parent_path()); }

    void write(const std::string& name, const std::string& text) const
    {
        fs::create_directories((folder_ / name).parent_path());
        std::ofstream(folder_ / name) << text;
    }
    Dictionary read(const std::string& name) const
    {
        return Dictionary::read(folder_ / name, folder_);
    }
    std::string refusal(const std::string& name) const
    {
        try {
            read(name);
        } catch (const Error& error) {
            return std::to_string(int(error.code())) + ' ' + error.what();
        }
        return "";
    }

    fs::path folder_ = fs::path(testing::TempDir()) / ("files" + std::to_string(getpid()))
                       / testing::UnitTest::GetInstance()->current_test_info()->name();
};

bool holds(const std::string& text, const std::string& part)
{
    return text.find(part) != text.npos;
}

} // namespace

TEST_F(Files, AreNamedRelativeToTheRoot)
{
    write("system/controlDict", "a 1;");

    EXPECT_EQ(read("system/controlDict").name(), "system/controlDict");
}

TEST_F(Files, IncludeOneAnotherBesideThem)
{
    write("system/dict", "#include \"parts/one\"\nsub { #include \"../constant/two\"\n }");
    write("system/parts/one", "a 1;\n#include \"three\"\n");
    write("system/parts/three", "c 3;");
    write("constant/two", "b 2;");
    const auto top = read("system/dict");

    EXPECT_EQ(top.number("a"), 1);
    EXPECT_EQ(top.number("c"), 3);
    EXPECT_EQ(top.sub("sub").number("b"), 2);
}

TEST_F(Files, MayBeIncludedTwiceInSequence)
{
    write("dict", "a { #include \"x\"\n } b { #include \"x\"\n }");
    write("x", "k 1;");

    EXPECT_EQ(refusal("dict"), "");
}

TEST_F(Files, IncludeCyclesAreFoundThroughOtherNames)
{
    write("dict", "#include \"folder/../dict\"\n");
    fs::create_directories(folder_ / "folder");
    EXPECT_TRUE(holds(refusal("dict"), "it is the file being read"));

    write("one", "#include \"link\"\n");
    fs::create_symlink("one", folder_ / "link");
    EXPECT_TRUE(holds(refusal("one"), "it is the file being read"));
}

TEST_F(Files, AreLimitedInDepthAndNumber)
{
    const auto deep = [](int number) { return std::string("deep").append(std::to_string(number)); };
    for (int number = 0; number < 40; ++number)
        write(deep(number), std::string("#include \"").append(deep(number + 1)).append("\"\n"));
    EXPECT_TRUE(holds(refusal(deep(0)), "at most 16 deep"));

    std::string many;
    for (int number = 0; number < 300; ++number)
        many.append("a").append(std::to_string(number)).append(" { #include \"x\"\n }");
    write("many", many);
    write("x", "k 1;");
    EXPECT_TRUE(holds(refusal("many"), "at most 256"));
}

TEST_F(Files, LeadingOutOfTheRootAreRefused)
{
    std::ofstream(folder_.parent_path() / "outside") << "a 1;";
    write("up", "#include \"../outside\"\n");
    write("absolute", "#include \"" + (folder_ / "x").string() + "\"\n");
    write("x", "k 1;");
    fs::create_symlink("../outside", folder_ / "link");
    write("throughLink", "#include \"link\"\n");
    fs::create_directory_symlink("..", folder_ / "folderLink");
    write("throughFolder", "#include \"folderLink/outside\"\n");

    EXPECT_TRUE(holds(refusal("up"), "it leads out of the case"));
    EXPECT_TRUE(holds(refusal("absolute"), "it is not a relative path"));
    EXPECT_TRUE(holds(refusal("throughLink"), "it leads out of the case"));
    EXPECT_TRUE(holds(refusal("throughFolder"), "it leads out of the case"));
    EXPECT_TRUE(holds(refusal("link"), "3 cannot read"));
    EXPECT_TRUE(holds(refusal("link"), "it leads out of the case"));
}

TEST_F(Files, ThatAreNoRegularFilesAreRefusedWithoutWaiting)
{
    ASSERT_EQ(mkfifo((folder_ / "pipe").c_str(), 0600), 0);
    write("includesPipe", "#include \"pipe\"\n");
    write("includesFolder", "#include \".\"\n");

    EXPECT_TRUE(holds(refusal("pipe"), "it is not a regular file"));
    EXPECT_TRUE(holds(refusal("includesPipe"), "it is not a regular file"));
    EXPECT_TRUE(holds(refusal("includesFolder"), "it is a folder"));
    EXPECT_THROW(readConfined("/dev/zero", "/dev", 100), ReadFailure);
}

TEST_F(Files, LargerThanTheLimitAreRefusedBeforeParsing)
{
    write("large", "");
    fs::resize_file(folder_ / "large", limits::fileBytes + 1);
    write("includesLarge", "a 1;\n#include \"large\"\n");

    EXPECT_TRUE(holds(refusal("large"), "3 cannot read"));
    EXPECT_TRUE(holds(refusal("large"), "up to 64 MiB"));
    EXPECT_TRUE(holds(refusal("includesLarge"), "dictionaries are read up to"));
}

TEST_F(Files, ThatCannotBeReadAreAFileError)
{
    EXPECT_TRUE(holds(refusal("nowhere"), "6 cannot read"));
    EXPECT_TRUE(holds(refusal("nowhere"), "No such file"));
    write("long", "#include \"" + std::string(5000, 'x') + "\"\n");
    EXPECT_TRUE(holds(refusal("long"), "cannot include"));
}

TEST(SourceText, LosesCarriageReturnsAndTheByteOrderMark)
{
    std::string text = "\xEF\xBB\xBF"
                       "a\r\nb\rc\n\r";

    normaliseText(text);

    EXPECT_EQ(text, "a\nb\nc\n\n");
}

} // namespace fpm
