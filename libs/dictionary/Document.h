#pragma once

#include <cstdint>
#include <deque>
#include <filesystem>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace fpm {

enum class TokenKind : std::uint8_t {
    word,
    number,
    string,
    macro,
    directive,
    openBrace,
    closeBrace,
    openBracket,
    closeBracket,
    semicolon,
    dictionary, ///< a `{ ... }` inside a list, already parsed: see Token::node
    end
};

/// A piece of text and its place: bytes [offset, offset + length) of file number `file`.
struct Token {
    TokenKind kind = TokenKind::end;
    std::uint16_t file = 0;
    std::uint32_t offset = 0;
    std::uint32_t length = 0;
    std::uint32_t node = 0;
};

/// The text of one file: '\n' line ends, no byte order mark.
struct Source {
    std::string name;
    std::string text;
    std::filesystem::path folder;      ///< empty for text that came from no file
    std::optional<Token> includedFrom; ///< the #include that led here
};

/// One `keyword values;` or `keyword { ... }`. Values are a flat run of tokens, brackets included:
/// no depth of nesting costs stack.
struct Entry {
    static constexpr std::uint32_t noNode = std::numeric_limits<std::uint32_t>::max();
    enum class Expansion : std::uint8_t { none, pending, underWay, done };

    Token keyword;
    std::vector<Token> values;
    std::uint32_t node = noNode; ///< the sub-dictionary, if it is one
    Expansion expansion = Expansion::none;
    std::uint8_t macroDepth = 0;
    bool asked = false;      ///< a reader has requested this key
    bool referenced = false; ///< a $macro uses it

    bool isDictionary() const { return node != noNode; }
};

struct Document;

/// One `{ ... }`: its entries, and the keys that were requested.
struct DictionaryNode {
    Document* document = nullptr;
    DictionaryNode* parent = nullptr;
    std::string name;          ///< key, or key[number] in a list; empty for the root
    std::optional<Token> open; ///< the opening brace; none for the root and for absent ones
    std::vector<Entry> entries;
    std::unordered_map<std::string_view, std::size_t> numbers; ///< key to entry
    std::vector<std::string> asked;                            ///< in the order of asking
    std::set<std::string, std::less<>> askedInVain;            ///< those that are absent
    bool isFree = false;   ///< `user`, `FoamFile`: entries that need no reader
    bool isOpened = false; ///< a reader took this dictionary

    Entry* find(std::string_view key);
    /// As find; records that a reader requested this key.
    Entry* ask(std::string_view key);
    std::string path() const; ///< "pairs.rodPlate"; empty for the root
};

/// A dictionary file with all it includes. Nodes and texts stay where they are, so that tokens,
/// keys and nodes can point at them.
struct Document {
    std::deque<Source> files;
    std::deque<DictionaryNode> nodes; ///< the first is the root

    std::string_view text(const Token& token) const;
    std::string_view unquoted(const Token& token) const; ///< a string without its quotes
    DictionaryNode& addNode(DictionaryNode* parent, std::string name);
    std::string place(const Token& token) const; ///< "system/contactDict:14:9"
};

/// What a lexer or parser found wrong; becomes an InputError where the dictionary's path is known.
struct Fault {
    Token at;
    std::string message;
    std::string advice = {};
};

} // namespace fpm
