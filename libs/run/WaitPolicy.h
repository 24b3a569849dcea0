#pragma once

namespace fpm {

/// Sets how long OpenMP's threads spin while they wait, before they give their core away. The
/// runtime takes that from the environment when it is loaded, so the program is started again in
/// place, once, under the same process number. Call first in main(). Does nothing where the
/// environment says how threads wait (OMP_WAIT_POLICY, GOMP_SPINCOUNT), or where it cannot be done.
void shortenSpin(char** arguments);

} // namespace fpm
