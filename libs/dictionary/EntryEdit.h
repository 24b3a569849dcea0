#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace fpm {

/// What is to be written to set an entry: the file (the one named, or one it includes, relative to
/// the root) and its whole new text.
struct EntryEdit {
    std::filesystem::path file;
    std::string text;
};

/// Sets the entry at `path` ("timeStep.safety") of `file` to `value`, written as in a dictionary.
/// The values alone are replaced, where they stand; an entry that is absent goes behind the opening
/// brace of its dictionary, at the top behind everything: lines keep their numbers, so that
/// messages about the edited file fit the original. Throws as Dictionary::read, and InputError
/// where the path leads to a dictionary or through something that is none.
EntryEdit setEntry(const std::filesystem::path& file,
                   const std::filesystem::path& root,
                   std::string_view path,
                   std::string_view value);

/// Takes the entry or dictionary at `path` out and leaves `note`, one line, as a comment in its
/// place. Throws as setEntry, and InputError where there is none.
EntryEdit removeEntry(const std::filesystem::path& file,
                      const std::filesystem::path& root,
                      std::string_view path,
                      std::string_view note);

/// The dictionaries of `path` that `file` has: "parts.rod" of "parts.rod.hourglass.form" where
/// there is no hourglass; all of `path` where the entry itself is there. Throws as
/// Dictionary::read.
std::string existingPath(const std::filesystem::path& file,
                         const std::filesystem::path& root,
                         std::string_view path);

} // namespace fpm
