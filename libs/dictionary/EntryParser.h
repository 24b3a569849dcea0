#pragma once

#include "dictionary/Lexer.h"
#include "dictionary/SourceFile.h"

#include <filesystem>
#include <optional>
#include <vector>

namespace fpm {

/// Builds the nodes of a document from its files. The grammar is in README.md; it is descended
/// recursively, which limits::nesting and limits::includeDepth keep shallow. Throws Fault.
class EntryParser
{
public:
    /// Files are included from beneath `root` only; an empty root means none can be.
    EntryParser(Document& document, std::filesystem::path root)
        : document_(document),
          root_(std::move(root)),
          current_(&document.nodes.front())
    {
    }

    void parse(FileContent content);
    void parse(std::string text, const std::string& name);
    /// The dictionary that was being read when a Fault was thrown.
    const DictionaryNode& current() const { return *current_; }

private:
    void parseSource(Source source, DictionaryNode& node, int depth);
    void parseEntries(Lexer& lexer, DictionaryNode& node, const Token* open, int depth);
    void parseEntry(Lexer& lexer, DictionaryNode& node, int depth);
    void parseInclude(Lexer& lexer, DictionaryNode& node, int depth);
    /// Returns the number of the node.
    std::uint32_t parseDictionary(Lexer& lexer, DictionaryNode& above, std::string name, int depth);
    void parseValues(Lexer& lexer, Entry& entry, DictionaryNode& node, int depth);
    void parseValue(Lexer& lexer, Entry& entry, DictionaryNode& node, int depth);
    /// Returns how many items the list has; nothing where a macro leaves that open.
    std::optional<std::int64_t>
    parseList(Lexer& lexer, Entry& entry, DictionaryNode& node, int depth);
    void parseListDictionary(
        Lexer& lexer, Entry& entry, DictionaryNode& node, int depth, std::int64_t number);

    FileContent openIncluded(const Token& name) const;
    std::string_view keyword(const Token& token, DictionaryNode& node) const;
    void requireNesting(const Token& at, int depth) const;
    void countRecord(const Token& at);
    bool startsLaterLine(const Token& token, const Token& previous) const;
    [[noreturn]] void refuseValue(const Token& token, const Entry& entry) const;
    [[noreturn]] void refuseDirective(const Token& token) const;
    [[noreturn]] void refuseMissingSemicolon(const Entry& entry) const;

    struct FileIdentity {
        dev_t device;
        ino_t number;
        bool operator==(const FileIdentity&) const = default;
    };

    Document& document_;
    std::filesystem::path root_;
    const DictionaryNode* current_;
    std::vector<FileIdentity> openFiles_;
    std::uint64_t bytes_ = 0;
    std::size_t records_ = 0;
};

} // namespace fpm
