#include "study/Expression.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

using namespace fpm;

namespace {

double value(const std::string& text, double t = 0)
{
    return Expression(text)(t);
}

std::string refusal(const std::string& text)
{
    try {
        Expression expression(text);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "nothing";
}

} // namespace

TEST(Expression, KnowsTheOrderOfOperations)
{
    EXPECT_EQ(value("1 + 2 * 3"), 7);
    EXPECT_EQ(value("(1 + 2) * 3"), 9);
    EXPECT_EQ(value("8 / 2 / 2"), 2);
    EXPECT_EQ(value("8 - 2 - 2"), 4);
    EXPECT_EQ(value("2 ^ 3 ^ 2"), 512);
    EXPECT_EQ(value("-2 ^ 2"), -4);
    EXPECT_EQ(value("2 ^ -1"), 0.5);
    EXPECT_EQ(value("2 * -3"), -6);
    EXPECT_EQ(value("1e-3 * 2.5e3"), 2.5);
}

TEST(Expression, KnowsTimeAndFunctions)
{
    EXPECT_DOUBLE_EQ(value("3 * sin(2 * pi * t / 8)", 1), 3 * std::sin(std::acos(-1.0) / 4));
    EXPECT_DOUBLE_EQ(value("exp(log(t)) + cos(0) + tan(0)", 5), 6);
    EXPECT_EQ(value("min(t, 2) + max(t, 2)", 7), 9);
    EXPECT_EQ(value("sqrt(abs(-9))"), 3);
    EXPECT_EQ(value("smooth(-1) + 10 * smooth(0.5) + 100 * smooth(7)"), 105);
    EXPECT_NEAR(value("smooth(0.25)"), 0.103515625, 1e-15); // 10/64 - 15/256 + 6/1024
}

TEST(Expression, SaysWhatIsWrongAndWhere)
{
    EXPECT_EQ(refusal("1 +"), "expected a number, t, a function or '(' at the end");
    EXPECT_EQ(refusal("(1"), "expected ')' at the end");
    EXPECT_EQ(refusal("2 t"), "expected an operator at 't'");
    EXPECT_NE(refusal("2 * sine(t)").find("did you mean 'sin'?"), std::string::npos);
    EXPECT_EQ(refusal(""), "expected a number, t, a function or '(' at the end");
    EXPECT_NE(refusal(std::string(100000, '(')).find("too many brackets"), std::string::npos);
    EXPECT_NE(refusal(std::string(100000, '-')).find("too many brackets"), std::string::npos);
}
