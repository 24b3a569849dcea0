#pragma once

#include "base/Error.h"
#include "base/Types.h"

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace fpm {

/// An interval a number must lie in; an open end excludes the bound itself.
struct Range {
    double lower, upper;
    bool lowerOpen = false, upperOpen = false;
    std::string text() const; ///< "> 0", "between 0 and 1", ...; empty for any number
    bool holds(double value) const;
};
Range anyNumber();
Range positive();
Range nonNegative();
Range between(double lower, double upper);

/// A wrong dictionary: the message carries file:line:column, the line, a caret and advice.
class InputError : public Error
{
public:
    InputError(const std::string& report) : Error(ExitCode::dictionary, report) {}
};

struct DictionaryNode; // parsed tree, private to the library

/// One `{ ... }` of a case file: typed values with their position in it. Reading an entry marks it
/// used; requireAllUsed() refuses entries that were never read. Grammar: README.md of this library.
class Dictionary
{
public:
    /// Reads `file`; `#include "x"` is resolved beside it and must stay inside `root`.
    /// Throws InputError (grammar), Error(fileIo) (cannot be read).
    static Dictionary read(const std::filesystem::path& file, const std::filesystem::path& root);
    static Dictionary parse(const std::string& text, const std::string& name = "text");

    bool has(std::string_view key) const;
    bool isDictionary(std::string_view key) const; ///< present, and a `{ ... }`
    bool isList(std::string_view key) const;       ///< present, and its values begin with a bracket
    bool isBare(std::string_view key) const;       ///< present without a value: `general;`
    std::vector<std::string> keys() const; ///< in file order, without the top's FoamFile and user
    /// Every entry below, in file order: "pairs.rodLayer1.friction". Marks nothing as used.
    std::vector<std::string> keyPaths() const;

    double number(std::string_view key, const Range& range = anyNumber()) const;
    double numberOr(std::string_view key, double preset, const Range& range = anyNumber()) const;
    std::int64_t integer(std::string_view key, std::int64_t lower, std::int64_t upper) const;
    std::int64_t integerOr(std::string_view key,
                           std::int64_t preset,
                           std::int64_t lower,
                           std::int64_t upper) const;
    bool switchOr(std::string_view key, bool preset) const; ///< yes no on off true false
    std::string word(std::string_view key) const;           ///< a word or a "string"
    std::string wordOr(std::string_view key, std::string_view preset) const;
    /// A word out of `allowed`; a wrong one is answered with the list and the nearest.
    std::string choice(std::string_view key, const std::vector<std::string>& allowed) const;
    std::string choiceOr(std::string_view key,
                         std::string_view preset,
                         const std::vector<std::string>& allowed) const;
    Point vector(std::string_view key) const; ///< (x y z)
    Point vectorOr(std::string_view key, const Point& preset) const;
    std::vector<double> numbers(std::string_view key) const;    ///< (a b c ...), any length
    std::vector<std::string> words(std::string_view key) const; ///< (a b) or a single word
    /// The values of a list as they are written, lists within it in one piece; a single value is a
    /// list of one.
    std::vector<std::string> items(std::string_view key) const;
    /// ((a b) (c d) ...): rows of `columns` numbers each.
    std::vector<std::vector<double>> rows(std::string_view key, std::size_t columns) const;
    /// The words and lists of an entry as "word list" pairs: `amplitude table ((0 0) (1 1));`
    /// gives first word = "table"; rows/numbers of the rest by tailRows, tailNumbers.
    std::string leadingWord(std::string_view key) const;
    std::vector<std::vector<double>> tailRows(std::string_view key, std::size_t columns) const;
    std::vector<double> tailNumbers(std::string_view key) const;

    Dictionary sub(std::string_view key) const;                  ///< required sub-dictionary
    Dictionary subOrEmpty(std::string_view key) const;           ///< an absent one reads as empty
    std::vector<Dictionary> subList(std::string_view key) const; ///< ( { } { } )

    /// All entries in their order with macros expanded and neither comments nor layout: equal texts
    /// say the same. Without the top's FoamFile and user. Marks nothing as used.
    std::string canonicalText() const;

    /// Throws for the first entry that was never read, here and in every sub-dictionary that was
    /// opened: "unknown keyword", nearest valid key, the keys valid here (= those requested so
    /// far).
    void requireAllUsed() const;

    /// Name of this dictionary for messages: "system/contactDict, in pairs.rodPlate".
    std::string name() const;
    /// Throws InputError at the value of `key` (at the opening brace if the key is absent).
    [[noreturn]] void
    fail(std::string_view key, const std::string& message, const std::string& advice = "") const;

private:
    explicit Dictionary(std::shared_ptr<DictionaryNode> node) : node_(std::move(node)) {}
    std::shared_ptr<DictionaryNode> node_;
};

} // namespace fpm
