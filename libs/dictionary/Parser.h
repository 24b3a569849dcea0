#pragma once

#include "dictionary/Document.h"

#include <filesystem>
#include <memory>

namespace fpm {

enum class Macros { expand, keep };

/// Reads `file` and what it includes, all beneath `root`. Throws InputError (grammar),
/// Error(dictionary) (refused file), Error(fileIo) (unreadable file).
std::shared_ptr<Document> parseFile(const std::filesystem::path& file,
                                    const std::filesystem::path& root,
                                    Macros macros = Macros::expand);

/// The same for a text in memory, which cannot include files.
std::shared_ptr<Document> parseText(std::string text, const std::string& name);

} // namespace fpm
