#pragma once

#include "io/Descriptor.h"
#include "io/FullDiskPolicy.h"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace fpm {

/// The folder that all output goes into, as a rule a case. Nothing outside of it can be written,
/// replaced or removed: paths are relative to it without "..", and each folder on the way is opened
/// from the one above it and must not be a link. The folder itself may be reached through links.
/// Copies share it. All functions throw Error(fileIo), FileError where the system refuses; what
/// finds the disk full does as its FullDiskPolicy says, but for renew() and remove().
class OutputFolder
{
public:
    explicit OutputFolder(const std::filesystem::path& folder, FullDiskPolicy policy = {});
    /// Makes the folder and those above it where they are missing.
    static OutputFolder make(const std::filesystem::path& folder);

    std::filesystem::path path(std::string_view relative = "") const; ///< to read from
    const FullDiskPolicy& fullDisk() const;

    /// Makes `file` hold exactly `bytes`, or leaves what was there: temporary (hidden) file beside
    /// it, checked write loop, fsync, rename, fsync of the folder. Creates folders, and keeps the
    /// permissions of a file that was there. A link of this name is replaced, not followed.
    void write(std::string_view file, std::span<const std::byte> bytes) const;
    void write(std::string_view file, std::string_view text) const;
    /// The same without waiting for the disk: after a loss of power the file may be empty.
    void renew(std::string_view file, std::string_view text) const;
    /// The same with content and permissions of a file anywhere.
    void copy(const std::filesystem::path& from, std::string_view file) const;

    /// A file to write in place, `flags` as of open(2): a regular one without a second name, as
    /// that could lie outside. Creates folders with O_CREAT.
    Descriptor open(std::string_view file, int flags) const;
    /// A folder; "" is this one.
    Descriptor openFolder(std::string_view folder) const;
    /// A folder within this one, made where it is missing.
    OutputFolder inner(std::string_view folder) const;

    /// A file or folder within this one, in place of a file of the other name. Creates folders.
    void rename(std::string_view from, std::string_view to) const;
    /// Waits until the names in a folder are on the disk.
    void synchroniseNames(std::string_view folder) const;
    /// A further name for a file; false where the file system has no hard links. Creates folders.
    bool link(std::string_view file, std::string_view name) const;
    /// A file or link, or a folder that is empty. False where it is not there, or is a folder with
    /// content.
    bool remove(std::string_view name) const;

private:
    struct Shared;
    enum class Missing { refuse, create };
    explicit OutputFolder(std::shared_ptr<const Shared> shared) : shared_(std::move(shared)) {}
    struct Place;
    struct Content;

    Descriptor walk(const std::filesystem::path& folder, Missing missing) const;
    Place placeOf(std::string_view relative, Missing missing) const;
    void replace(std::string_view file, const Content& content) const;
    Descriptor openOnce(std::string_view file, int flags) const;

    std::shared_ptr<const Shared> shared_;
};

} // namespace fpm
