#include "dictionary/EntryEdit.h"

#include "base/Format.h"
#include "dictionary/Dictionary.h"
#include "dictionary/Lexer.h"
#include "dictionary/Parser.h"
#include "dictionary/Report.h"

namespace fpm {

namespace {

/// How far a path leads: the innermost dictionary, the entry if it is there, what of the path is
/// left.
struct Reach {
    DictionaryNode* node;
    Entry* entry;
    std::string_view rest;
};

/// Keywords may hold dots themselves, so every split of the path is tried.
Reach follow(DictionaryNode& node, std::string_view path)
{
    Reach best{&node, nullptr, path};
    for (auto end = path.find('.');; end = path.find('.', end + 1)) {
        Entry* entry = node.find(path.substr(0, end));
        if (end == path.npos) return entry == nullptr ? best : Reach{&node, entry, ""};
        if (entry == nullptr || !entry->isDictionary()) continue;
        const auto deeper = follow(node.document->nodes[entry->node], path.substr(end + 1));
        if (deeper.entry != nullptr) return deeper;
        if (deeper.rest.size() < best.rest.size()) best = deeper;
    }
}

[[noreturn]] void refuse(const DictionaryNode& node, const Entry& entry, const std::string& message)
{
    throw InputError(report(*node.document, entry.keyword, node.path(), message, ""));
}

/// "a { b { key value; } }" for the path a.b.key
std::string newEntry(std::string_view path, std::string_view value)
{
    const auto end = path.find('.');
    if (end == path.npos) return format("{} {};", path, value);
    return format("{} { ", path.substr(0, end)) + newEntry(path.substr(end + 1), value) + " }";
}

EntryEdit
edited(const Source& source, std::size_t begin, std::size_t length, const std::string& text)
{
    std::string whole = source.text;
    whole.replace(begin, length, text);
    return {source.name, std::move(whole)};
}

EntryEdit replaced(const Document& document, const Entry& entry, std::string_view value)
{
    const Token& key = entry.keyword;
    const auto& source = document.files[key.file];
    if (entry.values.empty())
        return edited(source, key.offset + key.length, 0, format(" {}", value));
    const Token &first = entry.values.front(), &last = entry.values.back();
    return edited(source, first.offset, last.offset + last.length - first.offset,
                  std::string(value));
}

/// Where the entry that begins at `offset` ends, its semicolon or closing brace included.
std::size_t entryEnd(const Source& source, std::size_t offset)
{
    Document rest;
    rest.files.push_back({source.name, source.text.substr(offset), {}, {}});
    Lexer lexer(rest, 0);
    int depth = 0;
    for (;;) {
        const Token token = lexer.take();
        depth += token.kind == TokenKind::openBrace;
        depth -= token.kind == TokenKind::closeBrace;
        const bool ends = token.kind == TokenKind::closeBrace || token.kind == TokenKind::semicolon;
        if (depth > 0 || !ends) continue;
        const Token& last = lexer.peek().kind == TokenKind::semicolon ? lexer.peek() : token;
        return offset + last.offset + last.length;
    }
}

} // namespace

EntryEdit removeEntry(const std::filesystem::path& file,
                      const std::filesystem::path& root,
                      std::string_view path,
                      std::string_view note)
{
    const auto document = parseFile(file, root, Macros::keep);
    const auto reach = follow(document->nodes.front(), path);
    if (reach.entry == nullptr)
        throw InputError(
            format("{}: there is no entry '{}' to take out", document->files.front().name, path));
    const Token& key = reach.entry->keyword;
    const auto& source = document->files[key.file];
    return edited(source, key.offset, entryEnd(source, key.offset) - key.offset,
                  format("/* {} */", note));
}

EntryEdit setEntry(const std::filesystem::path& file,
                   const std::filesystem::path& root,
                   std::string_view path,
                   std::string_view value)
{
    const auto document = parseFile(file, root, Macros::keep);
    const auto reach = follow(document->nodes.front(), path);
    if (reach.entry != nullptr && reach.entry->isDictionary())
        refuse(*reach.node, *reach.entry, format("'{}' is a dictionary, not an entry", path));
    if (reach.entry != nullptr) return replaced(*document, *reach.entry, value);

    const auto next = reach.rest.substr(0, reach.rest.find('.'));
    if (Entry* inTheWay = reach.node->find(next))
        refuse(*reach.node, *inTheWay,
               format("'{}' is no dictionary: there is no '{}'", next, path));
    const auto text = newEntry(reach.rest, value);
    if (reach.node->open) {
        const Token& open = *reach.node->open;
        return edited(document->files[open.file], open.offset + open.length, 0, " " + text);
    }
    const auto& source = document->files.front();
    return edited(source, source.text.size(), 0, "\n" + text + "\n");
}

std::string existingPath(const std::filesystem::path& file,
                         const std::filesystem::path& root,
                         std::string_view path)
{
    const auto document = parseFile(file, root, Macros::keep);
    const auto reach = follow(document->nodes.front(), path);
    if (reach.rest.empty()) return std::string(path);
    if (reach.rest.size() == path.size()) return "";
    return std::string(path.substr(0, path.size() - reach.rest.size() - 1));
}

} // namespace fpm
