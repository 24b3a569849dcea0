#pragma once

#include "io/RunMark.h"

#include <optional>
#include <string>
#include <string_view>

namespace fpm {

/// Label behind a mesh or frame (Hdf5Image::save), readable without opening the file: "fpm run <id>
/// <file> mesh <checksum>", for a mesh without the mark and, where it holds the numbers of its
/// nodes and elements, "ids mesh <checksum>".
struct FrameLabel {
    std::optional<RunMark> mark;
    std::string mesh;
    bool ids = false;
    std::string text() const
    {
        return (mark ? mark->text() + " " : std::string()) + (ids ? "ids " : "") + "mesh " + mesh;
    }
};

inline FrameLabel parseFrameLabel(std::string_view text)
{
    constexpr std::string_view key = "mesh ";
    const auto at = text.rfind(key);
    return {findMark(text), at == text.npos ? "" : std::string(text.substr(at + key.size())),
            text.starts_with("ids ")};
}

} // namespace fpm
