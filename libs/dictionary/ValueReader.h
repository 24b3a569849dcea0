#pragma once

#include "dictionary/Dictionary.h"
#include "dictionary/Document.h"

#include <span>

namespace fpm {

/// Throws InputError at the values of `key`; at the opening brace of `node` where it is absent.
[[noreturn]] void failAt(const DictionaryNode& node,
                         std::string_view key,
                         const std::string& message,
                         const std::string& advice);

/// Throws InputError for a required key that is absent; an unread key spelt alike is named.
[[noreturn]] void
failMissing(const DictionaryNode& node, std::string_view key, std::string_view kind);

/// Turns the tokens of one entry into typed values. Throws InputError at the token that is wrong.
class ValueReader
{
public:
    /// The entry must exist and hold values; `expected` says of what kind, for the message.
    ValueReader(DictionaryNode& node, std::string_view key, std::string expected);

    double number(const Range& range) const;
    std::int64_t integer(std::int64_t lower, std::int64_t upper) const;
    std::string word() const;
    std::string choice(const std::vector<std::string>& allowed) const;
    std::string firstWord() const;
    std::vector<std::string> words() const;
    std::vector<std::string> items() const;
    /// `skipped` values at the front are not looked at.
    std::vector<double> list(std::size_t skipped) const;
    std::vector<std::vector<double>> rows(std::size_t skipped, std::size_t columns) const;
    /// All numbers after the first word, in brackets or not.
    std::vector<double> tail() const;
    std::vector<std::uint32_t> nodes() const; ///< of ( { } { } )

    /// "'key' must be <expected>, found ..." at the values.
    [[noreturn]] void refuse() const;

private:
    const Token& single() const;
    std::span<const Token> bracketed(std::size_t skipped) const;
    double toNumber(const Token& token) const;
    [[noreturn]] void refuse(std::span<const Token> values, const std::string& advice) const;

    DictionaryNode& node_;
    std::string_view key_;
    std::string expected_;
    const Entry* entry_;
};

} // namespace fpm
