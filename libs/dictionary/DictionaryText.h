#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace fpm {

/// Text of a dictionary that a program writes, such that `Dictionary` reads it.
class DictionaryText
{
public:
    /// A first line "// comment".
    explicit DictionaryText(std::string_view comment);
    /// `digits` significant ones; 0: as many as read back the same. A number that a dictionary
    /// cannot hold (none, infinite, beyond limits::largestNumber) and nothing get no entry.
    DictionaryText&
    number(std::string_view key, const std::optional<double>& value, int digits = 0);
    DictionaryText& integer(std::string_view key, std::int64_t value);
    /// In double quotes. Quotes within become apostrophes; other characters that no string holds,
    /// blanks.
    DictionaryText& string(std::string_view key, std::string_view value);
    /// key ( { ... } { ... } );
    DictionaryText& openList(std::string_view key);
    DictionaryText& openItem();
    DictionaryText& closeItem();
    DictionaryText& closeList();

    const std::string& text() const { return text_; }

private:
    DictionaryText& line(const std::string& content);

    std::string text_, indent_;
};

} // namespace fpm
