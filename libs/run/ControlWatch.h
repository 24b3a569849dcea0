#pragma once

#include "base/Log.h"
#include "dictionary/Dictionary.h"
#include "model/Model.h"

#include <filesystem>
#include <functional>

namespace fpm {

/// Where a run finds its control dictionary while it goes on.
struct ControlSource {
    std::filesystem::path file;       ///< empty: it never changes
    std::function<Dictionary()> read; ///< the same file
};

/// Looks after the control dictionary of a run that is runTimeModifiable.
class ControlWatch
{
public:
    explicit ControlWatch(ControlSource source);
    /// Reads it again if the file has changed: true where `control` has then. A wrong entry is a
    /// warning, and everything stays as it was.
    bool follow(Control& control, Log& log);

private:
    std::filesystem::file_time_type timeOfFile() const;

    ControlSource source_;
    std::filesystem::file_time_type last_;
};

} // namespace fpm
