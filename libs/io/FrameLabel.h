#pragma once

#include "io/RunMark.h"

#include <optional>
#include <string>
#include <string_view>

namespace fpm {

/// The label behind a mesh or frame (Hdf5Image::save), which tells without opening the file:
/// "fpm run <id> <file> mesh <checksum>", of a mesh without the mark.
struct FrameLabel {
    std::optional<RunMark> mark;
    std::string mesh;
    std::string text() const
    {
        return (mark ? mark->text() + " " : std::string()) + "mesh " + mesh;
    }
};

inline FrameLabel parseFrameLabel(std::string_view text)
{
    constexpr std::string_view key = "mesh ";
    const auto at = text.rfind(key);
    return {findMark(text), at == text.npos ? "" : std::string(text.substr(at + key.size()))};
}

} // namespace fpm
