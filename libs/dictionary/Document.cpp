#include "dictionary/Document.h"

#include "dictionary/Report.h"

namespace fpm {

Entry* DictionaryNode::find(std::string_view key)
{
    const auto found = numbers.find(key);
    return found == numbers.end() ? nullptr : &entries[found->second];
}

Entry* DictionaryNode::ask(std::string_view key)
{
    Entry* entry = find(key);
    const bool isNew = entry != nullptr ? !entry->asked : askedInVain.emplace(key).second;
    if (isNew) asked.emplace_back(key);
    if (entry != nullptr) entry->asked = true;
    return entry;
}

std::string DictionaryNode::path() const
{
    if (parent == nullptr) return name;
    const auto above = parent->path();
    return above.empty() ? name : above + '.' + name;
}

std::string_view Document::text(const Token& token) const
{
    return std::string_view(files[token.file].text).substr(token.offset, token.length);
}

std::string_view Document::unquoted(const Token& token) const
{
    const auto whole = text(token);
    return token.kind == TokenKind::string ? whole.substr(1, whole.size() - 2) : whole;
}

DictionaryNode& Document::addNode(DictionaryNode* parent, std::string name)
{
    auto& node = nodes.emplace_back();
    node.document = this;
    node.parent = parent;
    node.name = std::move(name);
    return node;
}

std::string Document::place(const Token& token) const
{
    const auto& source = files[token.file];
    const auto at = lineAndColumn(source.text, token.offset);
    return source.name + ':' + std::to_string(at.line) + ':' + std::to_string(at.column);
}

} // namespace fpm
