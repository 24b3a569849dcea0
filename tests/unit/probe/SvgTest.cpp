#include "probe/Svg.h"

#include <gtest/gtest.h>

using namespace fpm;

TEST(Svg, WritesNumbersShortAndNeverAsMinusZero)
{
    EXPECT_EQ(svgNumber(12.5), "12.5");
    EXPECT_EQ(svgNumber(300), "300");
    EXPECT_EQ(svgNumber(1.0 / 3), "0.33");
    EXPECT_EQ(svgNumber(-0.001), "0");
    EXPECT_EQ(svgNumber(-7.25), "-7.25");
}

TEST(Svg, EscapesTextSoThatATitleCannotAddElements)
{
    SvgDrawing svg(10, 10, "a");

    svg.text({0, 0}, "<script>\"x\" & y\n</script>");

    EXPECT_NE(svg.str().find("&lt;script&gt;&quot;x&quot; &amp; y&lt;/script&gt;"),
              std::string::npos);
    EXPECT_EQ(svg.str().find("<script"), std::string::npos);
}

TEST(Svg, CountsOneWidthForACharacterOfManyBytes)
{
    EXPECT_DOUBLE_EQ(textWidth("µ", 10), textWidth("u", 10));
    EXPECT_LT(textWidth("ill", 10), textWidth("www", 10));
}

TEST(Svg, DarkensColoursThatAreWeakOnWhite)
{
    EXPECT_EQ(readableColour("#0072B2"), "#0072B2");
    EXPECT_EQ(readableColour("#FFFFFF"), "#7D7D7D");
    EXPECT_EQ(readableColour("#F0E442"),
              "#8D8627"); // brightness 213.1, so times 125 / 213.1 = 0.5865
}
