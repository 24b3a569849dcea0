#pragma once

#include "stability/Catalogue.h"

namespace fpm {

/// Entries by what goes on in their scenes; catalogue() sorts them by number.
std::vector<Failure> searchFailures();   ///< a body held inside another
std::vector<Failure> slidingFailures();  ///< a body led over another
std::vector<Failure> impactFailures();   ///< bodies that meet
std::vector<Failure> pressingFailures(); ///< bodies pressed together
std::vector<Failure> setUpFailures();    ///< what must not run at all

} // namespace fpm
