#pragma once

#include "io/OutputFolder.h"

#include <optional>
#include <string>

namespace fpm {

/// The file `status` of a case while its run lives: rewritten in place, so that a full disk can
/// still learn how the run ended, and each time with one write of a few hundred bytes that end with
/// a checksum, so that no reader takes half of one text for the whole.
class StatusFile
{
public:
    /// Makes the file, on the disk when it returns.
    StatusFile(const OutputFolder& output, const std::string& text);
    /// Another text; waits for the disk where `last`. A longer one goes into a new file in its
    /// place, as does any where someone has removed the file; on a full disk the last lines are
    /// left out instead.
    void rewrite(const std::string& text, bool last);

private:
    void replace(const std::string& text);
    void open();
    bool isThere() const;

    OutputFolder output_;
    Descriptor file_;
    std::size_t size_ = 0; ///< of the file
};

/// The text in `content` of a status file; as it is where it bears no checksum, nothing where the
/// checksum belongs to another text.
std::optional<std::string> statusText(const std::string& content);

} // namespace fpm
