#pragma once

#include "case/Case.h"
#include "model/Model.h"

namespace fpm {

/// What a run was made from: a run may go on from its checkpoint as long as this is the same.
struct RunInputs {
    /// Every entry of a dictionary with its value, one a line: "pairs.rodPlate.friction 0.2".
    struct File {
        std::string name, text;
    };
    std::vector<File> files;
    std::string mesh; ///< checksum

    /// First difference to what a checkpoint was made from, such as "constant/partProperties,
    /// parts.rod.density: 8930 now, 7850 in the checkpoint"; empty where the run may go on.
    std::string differenceFrom(const RunInputs& stored) const;
};

/// Dictionaries of the case as they are now, of `control` what a run may not change while it goes
/// on: not its end, machine, output. `effective`: with the choices of the command line.
RunInputs inputsOf(const Case& theCase, const Dictionary& control, const Control& effective);

} // namespace fpm
