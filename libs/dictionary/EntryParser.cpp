#include "dictionary/EntryParser.h"

#include "base/Format.h"
#include "base/Utf8.h"
#include "dictionary/Limits.h"
#include "dictionary/Number.h"

namespace fpm {

void EntryParser::parse(FileContent content)
{
    openFiles_.push_back({content.device, content.number});
    parseSource({content.name, std::move(content.bytes), content.path.parent_path(), {}},
                document_.nodes.front(), 0);
}

void EntryParser::parse(std::string text, const std::string& name)
{
    parseSource({name, std::move(text), {}, {}}, document_.nodes.front(), 0);
}

void EntryParser::parseSource(Source source, DictionaryNode& node, int depth)
{
    bytes_ += source.text.size();
    normaliseText(source.text);
    const auto number = static_cast<std::uint16_t>(document_.files.size());
    document_.files.push_back(std::move(source));
    requireText(document_.files.back(), number);

    Lexer lexer(document_, number);
    parseEntries(lexer, node, nullptr, depth);
}

void EntryParser::parseEntries(Lexer& lexer, DictionaryNode& node, const Token* open, int depth)
{
    for (;;) {
        const Token next = lexer.peek();
        if (next.kind == TokenKind::end && open != nullptr)
            throw Fault{*open, "this '{' is never closed",
                        "the end of the file was reached at " + document_.place(next)};
        if (next.kind == TokenKind::closeBrace && open == nullptr)
            throw Fault{next, "this '}' closes nothing", "delete it, or open its dictionary"};
        if (next.kind == TokenKind::end) return;

        if (next.kind == TokenKind::closeBrace) {
            lexer.take();
            return;
        }
        if (next.kind == TokenKind::directive)
            parseInclude(lexer, node, depth);
        else
            parseEntry(lexer, node, depth);
    }
}

void EntryParser::parseEntry(Lexer& lexer, DictionaryNode& node, int depth)
{
    Entry entry;
    entry.keyword = lexer.take();
    const auto key = keyword(entry.keyword, node);
    countRecord(entry.keyword);

    if (lexer.peek().kind == TokenKind::openBrace) {
        entry.node = parseDictionary(lexer, node, std::string(key), depth + 1);
        const bool isTop = node.parent == nullptr;
        document_.nodes[entry.node].isFree = isTop && (key == "user" || key == "FoamFile");
        if (lexer.peek().kind == TokenKind::semicolon) lexer.take();
    } else {
        parseValues(lexer, entry, node, depth);
    }
    node.numbers.emplace(key, node.entries.size());
    node.entries.push_back(std::move(entry));
}

std::uint32_t
EntryParser::parseDictionary(Lexer& lexer, DictionaryNode& above, std::string name, int depth)
{
    const Token open = lexer.take();
    requireNesting(open, depth);
    countRecord(open);

    const auto number = static_cast<std::uint32_t>(document_.nodes.size());
    auto& node = document_.addNode(&above, std::move(name));
    node.open = open;
    current_ = &node;
    parseEntries(lexer, node, &open, depth);
    current_ = &above;
    return number;
}

void EntryParser::parseValues(Lexer& lexer, Entry& entry, DictionaryNode& node, int depth)
{
    while (lexer.peek().kind != TokenKind::semicolon) {
        const Token previous = entry.values.empty() ? entry.keyword : entry.values.back();
        const Token value = lexer.peek();
        const bool isNewLine = startsLaterLine(value, previous);
        if (value.kind == TokenKind::directive && isNewLine) refuseMissingSemicolon(entry);
        parseValue(lexer, entry, node, depth);

        // A word that opens a line is the next keyword, unless it is all there is to this entry.
        const bool isOnly =
            previous.offset == entry.keyword.offset && lexer.peek().kind == TokenKind::semicolon;
        if (value.kind == TokenKind::word && isNewLine && !isOnly) {
            entry.values.pop_back();
            refuseMissingSemicolon(entry);
        }
    }
    lexer.take();
}

void EntryParser::parseValue(Lexer& lexer, Entry& entry, DictionaryNode& node, int depth)
{
    const Token value = lexer.peek();
    switch (value.kind) {
    case TokenKind::openBracket:
        parseList(lexer, entry, node, depth + 1);
        return;
    case TokenKind::macro:
        entry.expansion = Entry::Expansion::pending;
        [[fallthrough]];
    case TokenKind::word:
    case TokenKind::string:
        entry.values.push_back(lexer.take());
        return;
    case TokenKind::number:
        break;
    default:
        refuseValue(value, entry);
    }

    lexer.take();
    const Token next = lexer.peek();
    const bool isTouching = next.offset == value.offset + value.length;
    if (isTouching && next.kind == TokenKind::openBrace)
        throw Fault{value, "uniform lists such as 4{0.5} are not read",
                    "write out (0.5 0.5 0.5 0.5)"};
    if (!isTouching || next.kind != TokenKind::openBracket) {
        entry.values.push_back(value);
        return;
    }
    const auto announced = readInteger(document_.text(value));
    const auto found = parseList(lexer, entry, node, depth + 1);
    if (!announced || (found && *announced != *found))
        throw Fault{value, format("this list announces {} items", document_.text(value)),
                    found ? format("it has {}; the count may be left out", *found)
                          : "the count may be left out"};
}

std::optional<std::int64_t>
EntryParser::parseList(Lexer& lexer, Entry& entry, DictionaryNode& node, int depth)
{
    const Token open = lexer.take();
    requireNesting(open, depth);
    entry.values.push_back(open);

    bool isCounted = true;
    for (std::int64_t items = 0;; ++items) {
        const Token next = lexer.peek();
        switch (next.kind) {
        case TokenKind::closeBracket:
            entry.values.push_back(lexer.take());
            return isCounted ? std::optional(items) : std::nullopt;
        case TokenKind::semicolon:
        case TokenKind::closeBrace:
        case TokenKind::end:
            throw Fault{
                open, "this '(' is never closed",
                next.kind == TokenKind::end
                    ? "the end of the file was reached at " + document_.place(next)
                    : format("'{}' was found at {}", document_.text(next), document_.place(next))};
        case TokenKind::openBrace:
            parseListDictionary(lexer, entry, node, depth + 1, items);
            break;
        case TokenKind::macro:
            isCounted = false;
            [[fallthrough]];
        default:
            parseValue(lexer, entry, node, depth);
            if (next.kind == TokenKind::word && lexer.peek().kind == TokenKind::openBrace) {
                entry.values.pop_back();
                parseListDictionary(lexer, entry, node, depth + 1, items);
            }
        }
    }
}

void EntryParser::parseListDictionary(
    Lexer& lexer, Entry& entry, DictionaryNode& node, int depth, std::int64_t number)
{
    const Token open = lexer.peek();
    const auto name = format("{}[{}]", document_.unquoted(entry.keyword), number);
    Token item{TokenKind::dictionary, open.file, open.offset, open.length};
    item.node = parseDictionary(lexer, node, name, depth);
    entry.values.push_back(item);
}

void EntryParser::parseInclude(Lexer& lexer, DictionaryNode& node, int depth)
{
    const Token directive = lexer.take();
    if (document_.text(directive) != "#include") refuseDirective(directive);
    if (lexer.peek().kind != TokenKind::string)
        throw Fault{directive, "#include needs a file", "write #include \"file\""};

    const Token name = lexer.take();
    auto content = openIncluded(name);
    openFiles_.push_back({content.device, content.number});
    parseSource({content.name, std::move(content.bytes), content.path.parent_path(), name}, node,
                depth);
    openFiles_.pop_back();
}

} // namespace fpm
