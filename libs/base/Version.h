#pragma once

#include <string>

namespace fpm {

/// "0.1.0 (1a2b3c4)": version and git revision of the sources this was built from, "-dirty" behind
/// it where files differed from the commit; "0.1.0" where the sources were no git repository.
std::string versionText();

/// Bytes of a program with its revision blanked: builds that differ in the commit alone, as after
/// one that changes documents only, are equal then.
std::string withoutRevision(std::string program);

} // namespace fpm
