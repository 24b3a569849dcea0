#pragma once

#include "base/Error.h"

#include <hdf5.h>

#include <string>
#include <utility>

/// What Hdf5Image and Hdf5Reader share; only their .cpp files include it.
namespace fpm::hdf5 {

/// An HDF5 identifier closed once, on leaving.
template <herr_t (*closeIdentifier)(hid_t)>
class Handle
{
public:
    Handle() = default;
    explicit Handle(hid_t number) : number_(number) {}
    Handle(Handle&& other) noexcept : number_(std::exchange(other.number_, H5I_INVALID_HID)) {}
    Handle& operator=(Handle&& other) noexcept
    {
        std::swap(number_, other.number_);
        return *this;
    }
    ~Handle()
    {
        if (number_ >= 0) closeIdentifier(number_);
    }
    operator hid_t() const { return number_; }
    explicit operator bool() const { return number_ >= 0; }

private:
    hid_t number_ = H5I_INVALID_HID;
};

using File = Handle<H5Fclose>;
using Dataset = Handle<H5Dclose>;
using Attribute = Handle<H5Aclose>;
using Object = Handle<H5Oclose>;
using Group = Handle<H5Gclose>;
using Space = Handle<H5Sclose>;
using Type = Handle<H5Tclose>;
using Properties = Handle<H5Pclose>;

/// Before any other call: no plug-ins, no exit handler, no messages on the terminal.
void initialise();
/// The innermost message of HDF5's error stack, which is then cleared.
std::string lastError();

/// Passes a result through; throws Error(code, "<what>: <HDF5's reason>") when it is negative.
template <class Result>
Result checked(Result result, ExitCode code, const std::string& what)
{
    if (result < 0) throw Error(code, what + ": " + lastError());
    return result;
}

} // namespace fpm::hdf5
