#include "dictionary/Number.h"

#include <gtest/gtest.h>

#include <limits>

namespace fpm {

TEST(Number, ReadsTheWrittenForms)
{
    EXPECT_EQ(readNumber("1"), 1.0);
    EXPECT_EQ(readNumber("-0.5"), -0.5);
    EXPECT_EQ(readNumber(".3"), 0.3);
    EXPECT_EQ(readNumber("-.3e1"), -3.0);
    EXPECT_EQ(readNumber("3."), 3.0);
    EXPECT_EQ(readNumber(".5e-400"), 0.0);
    EXPECT_EQ(readNumber("1."), 1.0);
    EXPECT_EQ(readNumber("1e-3"), 1e-3);
    EXPECT_EQ(readNumber("1.5E+03"), 1500.0);
    EXPECT_EQ(readNumber("007"), 7.0);
    EXPECT_EQ(readNumber("1.7976931348623157e308"), std::numeric_limits<double>::max());
}

TEST(Number, RefusesWhatOtherReadersTakeDifferently)
{
    for (const auto* text :
         {"",    "-",    "+2",  ".",  "-.", ".e1",  "1e",  "1e+", "1.0.0", "0x10", "nan",
          "inf", "-inf", "1,5", "1 ", " 1", "10mm", "--1", "+-1", "1e1.5", "1f",   "1d3"})
        EXPECT_EQ(readNumber(text), std::nullopt) << text;
}

TEST(Number, RefusesWhatExceedsTheLargestDouble)
{
    EXPECT_EQ(readNumber("1e999"), std::nullopt);
    EXPECT_EQ(readNumber("-1e999"), std::nullopt);
    EXPECT_EQ(readNumber("1e99999999999999999999999"), std::nullopt);
    EXPECT_EQ(readNumber("1" + std::string(400, '0')), std::nullopt);
}

TEST(Number, ReadsWhatIsBelowTheSmallestDoubleAsZero)
{
    EXPECT_EQ(readNumber("1e-400"), 0.0);
    EXPECT_EQ(readNumber("1e-99999999999999999999999"), 0.0);
    EXPECT_EQ(readNumber("0." + std::string(400, '0') + "1"), 0.0);
    EXPECT_EQ(readNumber("0e999"), 0.0);
    EXPECT_EQ(readNumber("5e-324"), std::numeric_limits<double>::denorm_min());
}

TEST(Number, ReadsIntegersInPlainDigitsOnly)
{
    EXPECT_EQ(readInteger("42"), 42);
    EXPECT_EQ(readInteger("-9223372036854775808"), std::numeric_limits<std::int64_t>::min());
    for (const auto* text : {"", "-", "1.0", "1e3", "9223372036854775808", "4-2", "+1", "0x1"})
        EXPECT_EQ(readInteger(text), std::nullopt) << text;
}

} // namespace fpm
