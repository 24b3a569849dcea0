#include "dictionary/Dictionary.h"

#include "base/Format.h"
#include "dictionary/Parser.h"
#include "dictionary/Report.h"
#include "dictionary/Suggestion.h"
#include "dictionary/ValueReader.h"

namespace fpm {

namespace {

std::shared_ptr<DictionaryNode> rootOf(std::shared_ptr<Document> document)
{
    auto& root = document->nodes.front();
    root.isOpened = true;
    return {std::move(document), &root};
}

void requireUsed(const DictionaryNode& node);

/// Dictionaries in the list of an entry.
void requireItemsUsed(const DictionaryNode& node, const Entry& entry)
{
    for (const auto& value : entry.values)
        if (value.kind == TokenKind::dictionary) requireUsed(node.document->nodes[value.node]);
}

void requireUsed(const DictionaryNode& node)
{
    if (!node.isOpened) return;
    const auto& document = *node.document;
    for (const auto& entry : node.entries) {
        if (entry.isDictionary() && document.nodes[entry.node].isFree) continue;
        if (!entry.asked && !entry.referenced) {
            const auto key = std::string(document.unquoted(entry.keyword));
            const auto advice =
                node.asked.empty() ? "no entry is read here" : suggestion(key, node.asked);
            throw InputError(report(document, entry.keyword, node.path(),
                                    format("unknown keyword '{}'", key), advice));
        }
        if (entry.isDictionary())
            requireUsed(document.nodes[entry.node]);
        else
            requireItemsUsed(node, entry);
    }
}

void collectPaths(const DictionaryNode& node,
                  const std::string& above,
                  std::vector<std::string>& paths)
{
    for (const auto& entry : node.entries) {
        const auto path = above + std::string(node.document->unquoted(entry.keyword));
        if (!entry.isDictionary())
            paths.push_back(path);
        else if (const auto& child = node.document->nodes[entry.node]; !child.isFree)
            collectPaths(child, path + '.', paths);
    }
}

void addText(const DictionaryNode& node, std::string& text)
{
    const auto& document = *node.document;
    for (const auto& entry : node.entries) {
        if (entry.isDictionary() && document.nodes[entry.node].isFree) continue;
        text += document.unquoted(entry.keyword);
        const auto addNested = [&](std::uint32_t number) {
            text += " {\n";
            addText(document.nodes[number], text);
            text += "}";
        };
        if (entry.isDictionary()) addNested(entry.node);
        for (const auto& value : entry.values) {
            if (value.kind == TokenKind::dictionary)
                addNested(value.node);
            else
                text.append(" ").append(document.text(value));
        }
        text += ";\n";
    }
}

} // namespace

Dictionary Dictionary::read(const std::filesystem::path& file, const std::filesystem::path& root)
{
    return Dictionary(rootOf(parseFile(file, root)));
}

Dictionary Dictionary::parse(const std::string& text, const std::string& name)
{
    return Dictionary(rootOf(parseText(text, name)));
}

bool Dictionary::has(std::string_view key) const
{
    return node_->ask(key) != nullptr;
}

bool Dictionary::isDictionary(std::string_view key) const
{
    const auto* entry = node_->ask(key);
    return entry != nullptr && entry->isDictionary();
}

bool Dictionary::isList(std::string_view key) const
{
    const auto* entry = node_->ask(key);
    return entry != nullptr && !entry->values.empty()
           && entry->values.front().kind == TokenKind::openBracket;
}

bool Dictionary::isBare(std::string_view key) const
{
    const auto* entry = node_->ask(key);
    return entry != nullptr && !entry->isDictionary() && entry->values.empty();
}

std::vector<std::string> Dictionary::keys() const
{
    std::vector<std::string> result;
    for (const auto& entry : node_->entries)
        if (!entry.isDictionary() || !node_->document->nodes[entry.node].isFree)
            result.emplace_back(node_->document->unquoted(entry.keyword));
    return result;
}

std::vector<std::string> Dictionary::keyPaths() const
{
    std::vector<std::string> paths;
    collectPaths(*node_, "", paths);
    return paths;
}

Dictionary Dictionary::sub(std::string_view key) const
{
    auto* entry = node_->ask(key);
    if (entry == nullptr) failMissing(*node_, key, "dictionary");
    if (!entry->isDictionary()) fail(key, format("'{}' must be a dictionary { ... }", key), "");
    auto& child = node_->document->nodes[entry->node];
    child.isOpened = true;
    return Dictionary({node_, &child});
}

Dictionary Dictionary::subOrEmpty(std::string_view key) const
{
    if (node_->ask(key) != nullptr) return sub(key);
    return Dictionary({node_, &node_->document->addNode(node_.get(), std::string(key))});
}

std::vector<Dictionary> Dictionary::subList(std::string_view key) const
{
    std::vector<Dictionary> result;
    for (const auto number : ValueReader(*node_, key, "a list of dictionaries").nodes()) {
        auto& item = node_->document->nodes[number];
        item.isOpened = true;
        result.push_back(Dictionary({node_, &item}));
    }
    return result;
}

std::string Dictionary::canonicalText() const
{
    std::string text;
    addText(*node_, text);
    return text;
}

void Dictionary::requireAllUsed() const
{
    requireUsed(*node_);
}

std::string Dictionary::name() const
{
    const auto path = node_->path();
    return node_->document->files.front().name + (path.empty() ? "" : ", in " + path);
}

void Dictionary::fail(std::string_view key,
                      const std::string& message,
                      const std::string& advice) const
{
    failAt(*node_, key, message, advice);
}

} // namespace fpm
