// A run uses the GPU whose number it was given; the stand-in has two.

#include "base/Error.h"
#include "gpu/parityScenes.h"

#include <gtest/gtest.h>

namespace fpm::test {
namespace {

Model onDevice(int number)
{
    Model model = plain();
    model.control.backend = "cuda";
    model.control.device = number;
    return model;
}

TEST(DeviceChoice, ARunUsesTheGpuOfItsNumber)
{
    EXPECT_EQ(makeSolver(onDevice(0))->description(),
              "cuda, first emulated by the processor, double");
    EXPECT_EQ(makeSolver(onDevice(1))->description(),
              "cuda, second emulated by the processor, double");
}

TEST(DeviceChoice, ANumberThatIsNotThereIsRefusedWithThoseThatAre)
{
    try {
        makeSolver(onDevice(2));
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::device);
        EXPECT_STREQ(error.what(),
                     "no GPU 2; this machine has 0 first emulated by the processor, 1 "
                     "second emulated by the processor");
        EXPECT_NE(error.advice().find("-device"), std::string::npos);
    }
}

} // namespace
} // namespace fpm::test
