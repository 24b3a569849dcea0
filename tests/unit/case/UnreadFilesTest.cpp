#include "case/UnreadFiles.h"

#include "support/logFile.h"
#include "unit/case/TemporaryCase.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace fpm {

namespace {

/// A complete case but for what is optional.
struct Folder {
    TemporaryCase folder;
    Folder()
    {
        for (const char* file : {"system/controlDict", "system/meshDict", "constant/caseProperties",
                                 "constant/partProperties", "constant/mesh.vtkhdf"})
            folder.write(file, "title \"x\";");
    }
    std::string said(const std::string& dictionary = "system/controlDict") const
    {
        const auto file = folder.root() / "log";
        {
            Log log = test::logInto(file);
            warnOfUnreadFiles(Case(folder.root()), dictionary, log);
        }
        return (std::ostringstream() << std::ifstream(file).rdbuf()).str();
    }
};

} // namespace

TEST(UnreadFiles, MisspeltNamesAreReported)
{
    Folder aCase;
    EXPECT_EQ(aCase.said(), "");
    aCase.folder.write("constant/boundaryCondition", "");
    EXPECT_EQ(aCase.said(),
              "warning: constant/boundaryCondition is not read: is it meant for "
              "constant/boundaryConditions, which is not there? Rename it, or move it out of the "
              "folder\n");
    aCase.folder.write("system/contactdict", "");
    EXPECT_NE(aCase.said().find("system/contactdict is not read"), std::string::npos);
}

TEST(UnreadFiles, SoAreRightNamesInWrongFolders)
{
    Folder aCase;
    aCase.folder.write("constant/initialConditions", "");
    EXPECT_NE(aCase.said().find("constant/initialConditions is not read"), std::string::npos);
    aCase.folder.write("0/initialConditions", "");
    EXPECT_EQ(aCase.said(), ""); // what is there is what is read
}

TEST(UnreadFiles, WhatIsKeptOnPurposeIsNot)
{
    Folder aCase;
    for (const char* name :
         {"boundaryConditions~", "boundaryConditions.orig", "#boundaryConditions#",
          ".boundaryConditions.swp", "boundaryConditionsOld", "boundaryConditions2", "conditions",
          "materials", "mesh.msh", "loads", "contactPairs"})
        aCase.folder.write(std::string("constant/") + name, "");
    for (const char* name : {"contactDict.fine", "fvSchemes", "fvSolution", "decomposeParDict",
                             "blockMeshDict", "adviseDict", "stack"})
        aCase.folder.write(std::string("system/") + name, "");
    std::filesystem::create_directories(aCase.folder.root() / "constant/boundaryCondition");
    EXPECT_EQ(aCase.said(), "");
}

TEST(UnreadFiles, NorIsWhatADictionaryIncludesOrTheCommandLineNames)
{
    Folder aCase;
    aCase.folder.write("constant/contctDict", "");
    EXPECT_NE(aCase.said(), "");
    aCase.folder.write("constant/partProperties", "#include \"contctDict\"\n");
    EXPECT_EQ(aCase.said(), "");
    aCase.folder.write("system/contactDic", "");
    EXPECT_NE(aCase.said(), "");
    EXPECT_EQ(aCase.said("system/contactDic"), "");
}

TEST(UnreadFiles, AMissingDictionaryNamesItsLookalike)
{
    const TemporaryCase folder;
    folder.write("system/meshDict", "");
    folder.write("system/ControlDict", "");
    try {
        Case(folder.root()).dictionary("system/controlDict");
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.advice(), "is 'system/ControlDict' meant for it? Rename it");
    }
}

} // namespace fpm
