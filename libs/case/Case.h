#pragma once

#include "base/Log.h"
#include "dictionary/Dictionary.h"
#include "io/OutputFolder.h"

#include <filesystem>
#include <string_view>

namespace fpm {

/// A case folder: system/, constant/, 0/. Paths given by dictionaries must stay inside it.
class Case
{
public:
    /// Throws Error(commandLine) when `root` has no system/controlDict and no system/meshDict.
    explicit Case(std::filesystem::path root);
    /// No folder: for what an application does without one. Its root is empty.
    static Case none() { return Case(); }

    const std::filesystem::path& root() const { return root_; }
    std::filesystem::path path(std::string_view relative) const { return root_ / relative; }
    /// What is written into the case goes through this.
    OutputFolder output() const { return OutputFolder(root_); }
    /// Throws Error(dictionary) naming the file when it does not exist.
    Dictionary dictionary(std::string_view relative) const;
    bool hasFile(std::string_view relative) const;
    /// A path written in a dictionary: refused (fileIo) when absolute, with "..", or a link out.
    std::filesystem::path inside(std::string_view relative) const;

private:
    Case() = default;

    std::filesystem::path root_;
};

/// Folder `etc` of this installation, found from the executable (../etc or ../share/fpm/etc).
std::filesystem::path etcFolder();

} // namespace fpm
