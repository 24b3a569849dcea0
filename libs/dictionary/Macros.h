#pragma once

#include "dictionary/Document.h"

namespace fpm {

/// Replaces every $name by the values of the entry it names: an entry of the same or an enclosing
/// dictionary, or for $:a.b entry b of the top dictionary a. Order in the file does not matter.
/// Throws Fault for cycles, for depth and for more text than limits::expandedBytes.
class MacroExpander
{
public:
    explicit MacroExpander(Document& document);

    void expandAll();
    /// The dictionary in which a Fault was found.
    const DictionaryNode& current() const { return *current_; }

private:
    struct Target {
        DictionaryNode* node;
        Entry* entry;
    };

    void expand(DictionaryNode& node, Entry& entry, int depth);
    Target target(const Token& macro, DictionaryNode& node, const Entry& user);
    Target targetFromTop(const Token& macro, std::string_view path);
    void requirePlain(const Token& macro, const Entry& entry) const;
    void countBytes(const Token& macro, const Entry& entry);

    Document& document_;
    const DictionaryNode* current_;
    std::uint64_t mostBytes_;
    std::uint64_t bytes_ = 0;
};

} // namespace fpm
