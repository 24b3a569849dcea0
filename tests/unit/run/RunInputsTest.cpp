#include "run/RunInputs.h"

#include "support/TemporaryFolder.h"

#include <gtest/gtest.h>

#include <fstream>

namespace fpm {
namespace {

class RunInputsTest : public testing::Test
{
protected:
    void write(const std::string& file, const std::string& text)
    {
        std::filesystem::create_directories((folder_.path() / file).parent_path());
        std::ofstream(folder_.path() / file) << text;
    }
    RunInputs inputs(const std::string& control = "endTime 1; massDamping 2;")
    {
        write("system/controlDict", control);
        const Case theCase(folder_.path());
        return inputsOf(theCase, theCase.dictionary("system/controlDict"), effective_);
    }
    void SetUp() override
    {
        write("constant/partProperties", "rod { density 7.85e-9; flow { table ((0 1) (1 2)); } }");
        write("system/contactDict", "pairs { rodPlate { friction 0.2; } }");
    }

    test::TemporaryFolder folder_;
    Control effective_;
};

TEST_F(RunInputsTest, LayoutCommentsAndFormsOfNumbersDoNotMatter)
{
    const RunInputs stored = inputs();
    write("constant/partProperties",
          "// steel\nrod\n{\n    density 0.785e-8;\n    flow { table ((0 1)\n (1 2.0)); }\n}\n");
    EXPECT_EQ(inputs().differenceFrom(stored), "");
}

TEST_F(RunInputsTest, NamesFileEntryAndBothValues)
{
    const RunInputs stored = inputs();
    write("system/contactDict", "pairs { rodPlate { friction 0.3; } }");
    EXPECT_EQ(inputs().differenceFrom(stored),
              "system/contactDict, pairs.rodPlate.friction: 0.3 now, 0.2 in the checkpoint");
    SetUp();
    write("constant/partProperties", "rod { density 7.85e-9; flow { table ((0 1) (1 3)); } }");
    EXPECT_NE(inputs().differenceFrom(stored).find("rod.flow.table"), std::string::npos);
    SetUp();
    write("constant/boundaryConditions", "foot { type fixed; }");
    EXPECT_EQ(inputs().differenceFrom(stored),
              "constant/boundaryConditions, foot.type: not in the checkpoint");
    std::filesystem::remove(folder_.path() / "constant/boundaryConditions");
    EXPECT_EQ(inputs().differenceFrom(stored), "");
    EXPECT_EQ(inputs("endTime 1;").differenceFrom(stored),
              "system/controlDict: 'precision double' now, 'massDamping 2' in the checkpoint");
}

TEST_F(RunInputsTest, EndMachineAndOutputMayChangeAndPrecisionMayNot)
{
    const RunInputs stored = inputs();
    EXPECT_EQ(inputs("endTime 9; massDamping 2; backend cuda; writeInterval 3; startFrom "
                     "latestTime; functions { e { type energies; } } checkpoint { keep 5; }")
                  .differenceFrom(stored),
              "");
    effective_.precision = Precision::mixed; // -precision
    EXPECT_EQ(inputs().differenceFrom(stored),
              "system/controlDict, precision: mixed now, double in the checkpoint");
}

TEST_F(RunInputsTest, AnotherMeshIsTheFirstDifference)
{
    RunInputs stored = inputs();
    stored.mesh = "0123";
    EXPECT_NE(inputs().differenceFrom(stored).find("constant/mesh.vtkhdf"), std::string::npos);
}

} // namespace
} // namespace fpm
