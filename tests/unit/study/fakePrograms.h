#pragma once

#include "support/TemporaryFolder.h"

#include <filesystem>
#include <string>

namespace fpm::test {

/// A folder of shell scripts in place of the programs. Each adds its name to <bin>/called.
/// fpmExplicit reads n from controlDict, fails with status n - 100 where n > 100, and else leaves a
/// history with y = t + 1/n^2 and its performance.
class FakePrograms
{
public:
    FakePrograms()
    {
        const std::string called =
            "#!/bin/sh\necho \"${0##*/} $*\" >> \"$(dirname \"$0\")/called\"\n";
        for (const std::string name : {"fpmMesh", "fpmSetContact", "fpmProbe"}) write(name, called);
        write("fpmExplicit", called + R"(
n=$(sed -n 's/^n \([0-9]*\);.*/\1/p' system/controlDict)
[ "$n" -le 100 ] || exit $((n - 100))
mkdir -p postProcessing/performance/0 postProcessing/tip/0 1e-3
echo "elements $((n * n * n)); steps $((10 * n)); nsPerElementStep 12.5;" \
    > postProcessing/performance/0/performance
echo frame > 1e-3/fields.vtkhdf
awk -v n="$n" 'BEGIN { print "# time y"
    for (i = 0; i <= 10; ++i) printf "%.17g %.17g\n", i / 10, i / 10 + 1 / n^2 }' \
    > postProcessing/tip/0/displacement.dat
)");
    }
    std::filesystem::path path() const { return folder_.path(); }
    /// One line a call: name and arguments.
    std::string calls() const { return readBytes(folder_ / "called"); }
    void forgetCalls() const { std::filesystem::remove(folder_ / "called"); }
    void write(const std::string& name, const std::string& script) const
    {
        writeBytes(folder_ / name, script);
        std::filesystem::permissions(folder_ / name, std::filesystem::perms::owner_all);
    }

private:
    TemporaryFolder folder_;
};

} // namespace fpm::test
