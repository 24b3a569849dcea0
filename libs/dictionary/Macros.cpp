#include "dictionary/Macros.h"

#include "base/Format.h"
#include "dictionary/Limits.h"
#include "dictionary/Suggestion.h"

#include <algorithm>

namespace fpm {

namespace {

std::string adviceFor(std::string_view name, const DictionaryNode& node)
{
    std::vector<std::string> names;
    for (const auto* scope = &node; scope != nullptr; scope = scope->parent)
        for (const auto& [key, number] : scope->numbers)
            if (!scope->entries[number].isDictionary()) names.emplace_back(key);
    std::sort(names.begin(), names.end());
    if (const auto close = nearest(name, names)) return format("did you mean '${}'?", *close);
    return "an entry of another dictionary is written $:dictionary.name; "
           "environment variables are not read";
}

} // namespace

MacroExpander::MacroExpander(Document& document)
    : document_(document),
      current_(&document.nodes.front())
{
    std::uint64_t input = 0;
    for (const auto& file : document.files) input += file.text.size();
    // However long the input: the result is held in memory, as a file is.
    mostBytes_ =
        std::clamp(limits::expansionFactor * input, limits::expandedBytes, limits::fileBytes);
}

void MacroExpander::expandAll()
{
    for (auto& node : document_.nodes)
        for (auto& entry : node.entries) expand(node, entry, 0);
}

void MacroExpander::expand(DictionaryNode& node, Entry& entry, int depth)
{
    if (entry.expansion == Entry::Expansion::none || entry.expansion == Entry::Expansion::done)
        return;
    entry.expansion = Entry::Expansion::underWay;

    std::vector<Token> values;
    for (const auto& value : entry.values) {
        if (value.kind != TokenKind::macro) {
            values.push_back(value);
            continue;
        }
        current_ = &node;
        const auto [owner, used] = target(value, node, entry);
        const auto refuse = [&](const std::string& message, const std::string& advice) {
            current_ = &node;
            throw Fault{value, message, advice};
        };
        if (used->expansion == Entry::Expansion::underWay)
            refuse(format("'{}' leads back to itself", document_.text(value)),
                   format("'{}' at {} needs this entry", document_.text(used->keyword),
                          document_.place(used->keyword)));
        if (depth < limits::macroDepth) expand(*owner, *used, depth + 1);
        if (depth >= limits::macroDepth || used->macroDepth >= limits::macroDepth)
            refuse(format("macros refer to one another more than {} deep", limits::macroDepth), "");

        current_ = &node;
        countBytes(value, *used);
        entry.macroDepth = std::max<std::uint8_t>(entry.macroDepth, used->macroDepth + 1);
        used->referenced = true;
        values.insert(values.end(), used->values.begin(), used->values.end());
    }
    entry.values = std::move(values);
    entry.expansion = Entry::Expansion::done;
}

MacroExpander::Target
MacroExpander::target(const Token& macro, DictionaryNode& node, const Entry& user)
{
    const auto name = document_.text(macro).substr(1);
    if (name.starts_with(':')) return targetFromTop(macro, name.substr(1));

    for (auto* scope = &node; scope != nullptr; scope = scope->parent) {
        auto* entry = scope->find(name);
        // `friction $friction;` means the friction of an enclosing dictionary.
        if (entry == nullptr || entry == &user) continue;
        requirePlain(macro, *entry);
        return {scope, entry};
    }
    throw Fault{macro, format("there is no entry '{}' here or in an enclosing dictionary", name),
                adviceFor(name, node)};
}

MacroExpander::Target MacroExpander::targetFromTop(const Token& macro, std::string_view path)
{
    auto* node = &document_.nodes.front();
    for (auto rest = path;;) {
        const auto point = rest.find('.');
        auto* entry = node->find(rest.substr(0, point));
        if (entry != nullptr && point == rest.npos) {
            requirePlain(macro, *entry);
            return {node, entry};
        }
        if (entry == nullptr || !entry->isDictionary())
            throw Fault{macro, format("there is no entry '{}'", path),
                        "the path starts at the top of the file: $:dictionary.name"};
        entry->referenced = true;
        node = &document_.nodes[entry->node];
        rest.remove_prefix(point + 1);
    }
}

void MacroExpander::requirePlain(const Token& macro, const Entry& entry) const
{
    const bool holdsDictionary =
        std::any_of(entry.values.begin(), entry.values.end(),
                    [](const Token& value) { return value.kind == TokenKind::dictionary; });
    if (entry.isDictionary() || holdsDictionary)
        throw Fault{macro, format("'{}' names a dictionary", document_.text(macro)),
                    "only an entry of values can be used in another"};
}

void MacroExpander::countBytes(const Token& macro, const Entry& entry)
{
    for (const auto& value : entry.values) bytes_ += value.length + 1;
    if (bytes_ > mostBytes_)
        throw Fault{macro, format("macros expand to more than {} bytes", mostBytes_),
                    "write the values out, or fewer of them"};
}

} // namespace fpm
