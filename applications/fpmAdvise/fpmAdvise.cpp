#include "advise/Advise.h"

/// Looks for what a scene does not need, tells what leaving it out saves and costs, and writes the
/// smaller case where asked to.
int main(int argc, char** argv)
{
    const fpm::ApplicationInfo info{
        .name = "fpmAdvise",
        .purpose = "Tells how to model less of a scene, at what price; -apply writes the new case.",
        .dictionary = "",
        .options = fpm::adviseOptions(),
    };
    return fpm::runApplication(info, argc, argv, fpm::advise);
}
