#include "dictionary/ValueReader.h"

#include "base/Format.h"
#include "base/Utf8.h"
#include "dictionary/Limits.h"
#include "dictionary/Number.h"
#include "dictionary/Report.h"
#include "dictionary/Suggestion.h"

#include <algorithm>
#include <cmath>

namespace fpm {

namespace {

bool isText(const Token& token)
{
    return token.kind == TokenKind::word || token.kind == TokenKind::string;
}

bool isBracket(const Token& token)
{
    return token.kind == TokenKind::openBracket || token.kind == TokenKind::closeBracket;
}

/// From the first to the last of `values`, as far as that is one stretch of text.
Token stretch(std::span<const Token> values)
{
    Token result = values.front();
    const Token& last = values.back();
    if (last.file == result.file && last.offset > result.offset)
        result.length = last.offset + last.length - result.offset;
    return result;
}

std::string foundText(const Document& document, std::span<const Token> values)
{
    if (values.empty()) return "nothing";
    if (values.size() == 1 && values[0].kind == TokenKind::word)
        return format("the word '{}'", excerpt(document.text(values[0])));

    std::string text;
    for (const auto& value : values) {
        const bool isTouching =
            text.empty() || text.ends_with('(') || value.kind == TokenKind::closeBracket;
        text += isTouching ? "" : " ";
        text += value.kind == TokenKind::dictionary ? "{...}" : document.text(value);
        if (text.size() > 256) break; // the excerpt is shorter
    }
    return excerpt(text);
}

/// What is wrong with the size of a number: nothing where its square is a number too.
std::string sizeAdvice(std::string_view text)
{
    const auto value = readNumber(text);
    if (!value || std::abs(*value) > limits::largestNumber)
        return format("numbers go up to {}, so that their squares are numbers too",
                      limits::largestNumber);
    const bool isZero =
        text.substr(0, text.find_first_of("eE")).find_first_of("123456789") == text.npos;
    if (!isZero && std::abs(*value) < limits::smallestNumber)
        return format("numbers other than 0 are at least {} in size; write 0 if that is meant",
                      limits::smallestNumber);
    return "";
}

std::string typeAdvice(const Document& document, std::span<const Token> values)
{
    if (values.empty()) return "the entry is empty";
    if (values.size() > 1) return isBracket(values[0]) ? "" : "are brackets or a ';' missing?";
    const auto text = document.text(values[0]);
    if (text == "nan" || text == "inf") return "nan and inf are no values here";
    return values[0].kind == TokenKind::number ? sizeAdvice(text) : "";
}

} // namespace

void failAt(const DictionaryNode& node,
            std::string_view key,
            const std::string& message,
            const std::string& advice)
{
    const auto& document = *node.document;
    const auto found = node.numbers.find(key);
    if (found != node.numbers.end()) {
        const auto& entry = node.entries[found->second];
        const auto at = entry.values.empty() ? entry.keyword : stretch(entry.values);
        throw InputError(report(document, at, node.path(), message, advice));
    }
    const auto* place = &node;
    while (place->parent != nullptr && !place->open) place = place->parent;
    if (place->open) throw InputError(report(document, *place->open, node.path(), message, advice));
    throw InputError(report(document.files.front().name, node.path(), message, advice));
}

void failMissing(const DictionaryNode& node, std::string_view key, std::string_view kind)
{
    std::vector<std::string> unread;
    for (const auto& entry : node.entries)
        if (!entry.asked) unread.emplace_back(node.document->unquoted(entry.keyword));

    std::string advice;
    if (const auto alike = nearest(key, unread)) {
        const auto& entry = node.entries[node.numbers.at(*alike)];
        advice = format("is '{}' at {} meant for it?", *alike, node.document->place(entry.keyword));
    }
    failAt(node, key, format("missing {} '{}'", kind, key), advice);
}

ValueReader::ValueReader(DictionaryNode& node, std::string_view key, std::string expected)
    : node_(node),
      key_(key),
      expected_(std::move(expected)),
      entry_(node.ask(key))
{
    if (entry_ == nullptr) failMissing(node, key, "entry");
    if (!entry_->isDictionary()) return;
    failAt(node, key, format("'{}' must be {}, found a dictionary", key, expected_), "");
}

double ValueReader::number(const Range& range) const
{
    const double value = toNumber(single());
    if (!range.holds(value)) refuse(entry_->values, "");
    return value;
}

std::int64_t ValueReader::integer(std::int64_t lower, std::int64_t upper) const
{
    const auto text = node_.document->text(single());
    const auto value = readInteger(text);
    if (!value && isNumber(text) && text.find_first_of(".eE") != text.npos)
        refuse(entry_->values, "write it in plain digits");
    if (!value || *value < lower || *value > upper) refuse();
    return *value;
}

std::string ValueReader::word() const
{
    const auto& token = single();
    if (!isText(token)) refuse();
    return std::string(node_.document->unquoted(token));
}

std::string ValueReader::choice(const std::vector<std::string>& allowed) const
{
    const auto value = word();
    if (std::find(allowed.begin(), allowed.end(), value) != allowed.end()) return value;
    const auto close = nearest(value, allowed);
    refuse(entry_->values, close ? format("did you mean '{}'?", *close) : "");
}

std::string ValueReader::firstWord() const
{
    if (entry_->values.empty() || !isText(entry_->values[0])) refuse();
    return std::string(node_.document->unquoted(entry_->values[0]));
}

std::vector<std::string> ValueReader::words() const
{
    if (entry_->values.size() == 1) return {word()};
    std::vector<std::string> result;
    for (const auto& value : bracketed(0)) {
        if (!isText(value)) refuse({&value, 1}, "");
        result.emplace_back(node_.document->unquoted(value));
    }
    return result;
}

std::vector<std::string> ValueReader::items() const
{
    const bool isOne = entry_->values.size() == 1;
    std::vector<std::string> result;
    int depth = 0;
    for (const auto& value : isOne ? std::span<const Token>(entry_->values) : bracketed(0)) {
        if (value.kind == TokenKind::dictionary) refuse({&value, 1}, "");
        const bool closes = value.kind == TokenKind::closeBracket;
        const auto text = node_.document->text(value);
        if (depth == 0)
            result.emplace_back(text);
        else
            result.back().append(closes || result.back().ends_with('(') ? "" : " ").append(text);
        depth += int(value.kind == TokenKind::openBracket) - int(closes);
    }
    return result;
}

std::vector<double> ValueReader::list(std::size_t skipped) const
{
    std::vector<double> result;
    for (const auto& value : bracketed(skipped)) result.push_back(toNumber(value));
    return result;
}

std::vector<std::vector<double>> ValueReader::rows(std::size_t skipped, std::size_t columns) const
{
    std::vector<std::vector<double>> result;
    const auto inner = bracketed(skipped);
    for (std::size_t at = 0; at < inner.size();) {
        if (inner[at].kind != TokenKind::openBracket) refuse(inner.subspan(at, 1), "");
        const auto begin = at++;
        auto& row = result.emplace_back();
        while (inner[at].kind != TokenKind::closeBracket) row.push_back(toNumber(inner[at++]));
        if (row.size() != columns) refuse(inner.subspan(begin, at + 1 - begin), "");
        ++at;
    }
    return result;
}

std::vector<double> ValueReader::tail() const
{
    firstWord();
    std::vector<double> result;
    for (const auto& value : std::span(entry_->values).subspan(1))
        if (!isBracket(value)) result.push_back(toNumber(value));
    if (result.empty()) refuse();
    return result;
}

std::vector<std::uint32_t> ValueReader::nodes() const
{
    std::vector<std::uint32_t> result;
    for (const auto& value : bracketed(0)) {
        if (value.kind != TokenKind::dictionary) refuse({&value, 1}, "");
        result.push_back(value.node);
    }
    return result;
}

const Token& ValueReader::single() const
{
    if (entry_->values.size() != 1) refuse();
    return entry_->values[0];
}

/// What stands between the brackets of the one list that follows `skipped` values.
std::span<const Token> ValueReader::bracketed(std::size_t skipped) const
{
    const std::span<const Token> values(entry_->values);
    if (values.size() < skipped + 2 || values[skipped].kind != TokenKind::openBracket) refuse();

    int depth = 0;
    std::size_t end = skipped;
    do {
        depth += values[end].kind == TokenKind::openBracket;
        depth -= values[end].kind == TokenKind::closeBracket;
        ++end;
    } while (depth > 0 && end < values.size());
    if (end != values.size()) refuse(values.subspan(end), "is a ';' missing?");
    return values.subspan(skipped + 1, end - skipped - 2);
}

double ValueReader::toNumber(const Token& token) const
{
    const auto text = node_.document->text(token);
    const auto value = token.kind == TokenKind::number ? readNumber(text) : std::nullopt;
    if (!value || !sizeAdvice(text).empty())
        refuse({&token, 1}, typeAdvice(*node_.document, {&token, 1}));
    return *value;
}

void ValueReader::refuse() const
{
    refuse(entry_->values, typeAdvice(*node_.document, entry_->values));
}

void ValueReader::refuse(std::span<const Token> values, const std::string& advice) const
{
    const auto& document = *node_.document;
    const auto message =
        format("'{}' must be {}, found {}", key_, expected_, foundText(document, values));
    auto notes = advice;
    if (entry_->expansion == Entry::Expansion::done)
        notes += (notes.empty() ? "" : "; ")
                 + format("'{}' uses a macro at {}", key_, document.place(entry_->keyword));
    const auto at = values.empty() ? entry_->keyword : stretch(values);
    throw InputError(report(document, at, node_.path(), message, notes));
}

} // namespace fpm
