#include "io/Hdf5Handle.h"

namespace fpm::hdf5 {

void initialise()
{
    static const bool once = [] {
        H5dont_atexit();
        H5open();
        H5PLset_loading_state(0);
        return true;
    }();
    static_cast<void>(once);
    // The error stack belongs to the thread.
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

std::string lastError()
{
    std::string text;
    const auto keep = [](unsigned depth, const H5E_error2_t* error, void* out) -> herr_t {
        if (depth == 0 && error->desc) *static_cast<std::string*>(out) = error->desc;
        return 0;
    };
    H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep, &text);
    H5Eclear2(H5E_DEFAULT);
    return text.empty() ? "HDF5 gave no reason" : text;
}

} // namespace fpm::hdf5
