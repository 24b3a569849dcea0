#include "probe/FieldValues.h"

#include "base/Error.h"

#include <gtest/gtest.h>

using namespace fpm;

namespace {

Frame oneNodeOneElement()
{
    Frame frame;
    frame.nodeFields = {{"U", 3, {1, -2, 2}}};
    frame.elementFields = {{"S", 6, {1, 2, 3, 4, 5, 6}}, {"Mises", 1, {7}}};
    return frame;
}

std::string messageFor(const FieldChoice& choice)
{
    try {
        scalarField(oneNodeOneElement(), choice);
    } catch (const Error& error) {
        return std::string(error.what()) + " | " + error.advice();
    }
    return "none";
}

} // namespace

TEST(FieldValues, PicksComponentsMagnitudesAndScalars)
{
    const Frame frame = oneNodeOneElement();

    EXPECT_DOUBLE_EQ(scalarField(frame, {"U", ""}).values[0], 3);
    EXPECT_DOUBLE_EQ(scalarField(frame, {"U", "y"}).values[0], -2);
    EXPECT_DOUBLE_EQ(scalarField(frame, {"S", "XZ"}).values[0], 6);
    EXPECT_DOUBLE_EQ(scalarField(frame, {"Mises", ""}).values[0], 7);
    EXPECT_FALSE(scalarField(frame, {"Mises", ""}).onNodes);
}

TEST(FieldValues, NamesWhatThereIsWhenAskedForSomethingElse)
{
    EXPECT_EQ(messageFor({"Misses", ""}),
              "field 'Misses' is not among the results of this case | there are: U, S, Mises");
    EXPECT_EQ(
        messageFor({"S", ""}),
        "field 'S' needs a component | write component XX, YY, ZZ, XY, YZ, XZ (one of these)");
    EXPECT_EQ(messageFor({"Mises", "x"}),
              "field 'Mises' has no component 'x' | it is a scalar: leave 'component' out");
}

TEST(FieldValues, ChangeSignUnderReflectionOncePerMirroredAxis)
{
    EXPECT_EQ(mirrorSign("x", {true, false, false}), -1);
    EXPECT_EQ(mirrorSign("z", {true, true, false}), 1);
    EXPECT_EQ(mirrorSign("XX", {true, false, false}), 1);
    EXPECT_EQ(mirrorSign("XY", {true, false, false}), -1);
    EXPECT_EQ(mirrorSign("XY", {true, true, false}), 1);
    EXPECT_EQ(mirrorSign("", {true, true, true}), 1);
    EXPECT_EQ(mirrorSign("magnitude", {true, false, false}), 1);
}
