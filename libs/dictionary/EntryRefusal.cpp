#include "base/Format.h"
#include "base/Utf8.h"
#include "dictionary/EntryParser.h"
#include "dictionary/Limits.h"

#include <algorithm>
#include <array>

namespace fpm {

namespace {

/// OpenFOAM keywords behind which code is compiled or loaded.
constexpr std::array codeKeywords{"libs",        "codeInclude", "codeOptions", "codeLibs",
                                  "codeExecute", "localCode",   "systemCall"};

bool isNamePart(char character)
{
    return isWordPart(character) || character == '+';
}

std::string kindInWords(const Token& token, std::string_view text)
{
    if (token.kind == TokenKind::number) return format("the number {}", excerpt(text));
    return format("'{}'", excerpt(text));
}

} // namespace

std::string_view EntryParser::keyword(const Token& token, DictionaryNode& node) const
{
    const auto key = document_.unquoted(token);
    if (token.kind != TokenKind::word && token.kind != TokenKind::string)
        throw Fault{
            token,
            format("expected a keyword, found {}", kindInWords(token, document_.text(token))),
            "an entry is written 'keyword value;' or 'keyword { ... }'"};
    if (!std::all_of(key.begin(), key.end(), isNamePart) || key.empty() || key.front() == '.')
        throw Fault{token, format("\"{}\" cannot be a keyword", excerpt(key)),
                    "a keyword in quotes may hold letters, digits and _ . : + -; "
                    "patterns are not read"};
    if (key.size() > limits::keywordBytes)
        throw Fault{token, format("this keyword has {} characters", key.size()),
                    format("a keyword has at most {}", limits::keywordBytes)};
    if (std::find(codeKeywords.begin(), codeKeywords.end(), key) != codeKeywords.end())
        throw Fault{token, format("'{}' is refused", key),
                    "a case loads no libraries and runs no code; delete the entry"};
    if (const auto* first = node.find(key))
        throw Fault{
            token, format("duplicate keyword '{}'", key),
            format("first given at {}; delete one of the two", document_.place(first->keyword))};
    return key;
}

FileContent EntryParser::openIncluded(const Token& token) const
{
    const std::filesystem::path name = document_.unquoted(token);
    const auto refuse = [&](const std::string& reason, const std::string& advice) {
        throw Fault{token, format("cannot include {}: {}", excerpt(document_.text(token)), reason),
                    advice};
    };
    const std::string_view inside = "an included file is named relative to the including one "
                                    "and lies inside the case";
    if (root_.empty()) refuse("this text is in no folder", "");
    if (name.empty() || name.is_absolute() || name.native().find_first_of("$~") == 0)
        refuse("it is not a relative path", std::string(inside));
    if (openFiles_.size() > limits::includeDepth)
        refuse("files include one another too deeply",
               format("at most {} deep", limits::includeDepth));
    if (document_.files.size() >= limits::files)
        refuse("too many files", format("a dictionary consists of at most {}", limits::files));

    try {
        auto content = readConfined(document_.files[token.file].folder / name, root_,
                                    limits::fileBytes - bytes_);
        const FileIdentity identity{content.device, content.number};
        if (std::find(openFiles_.begin(), openFiles_.end(), identity) != openFiles_.end())
            refuse("it is the file being read, or includes it", "break the cycle");
        return content;
    } catch (const ReadFailure& failure) {
        throw Fault{token,
                    format("cannot include {}: {}", excerpt(document_.text(token)), failure.reason),
                    !failure.advice.empty() ? failure.advice
                    : failure.isRefused     ? std::string(inside)
                                            : ""};
    }
}

void EntryParser::requireNesting(const Token& at, int depth) const
{
    if (depth > limits::nesting)
        throw Fault{at, format("brackets are nested more than {} deep", limits::nesting),
                    "is one of those before it not closed?"};
}

void EntryParser::countRecord(const Token& at)
{
    if (++records_ > limits::entries)
        throw Fault{at, format("there are more than {} entries", limits::entries),
                    "bulk data belongs in the mesh file"};
}

bool EntryParser::startsLaterLine(const Token& token, const Token& previous) const
{
    const std::size_t end = previous.offset + previous.length;
    const std::string_view text = document_.files[token.file].text;
    return text.substr(end, token.offset - end).find('\n') != std::string_view::npos;
}

void EntryParser::refuseValue(const Token& token, const Entry& entry) const
{
    switch (token.kind) {
    case TokenKind::closeBracket:
        throw Fault{token, "this ')' closes nothing", "delete it, or open its list"};
    case TokenKind::openBrace:
        throw Fault{token, "a '{' cannot follow a value",
                    "a dictionary is written 'keyword { ... }'; is a ';' missing before it?"};
    case TokenKind::directive:
        refuseDirective(token);
    default:
        refuseMissingSemicolon(entry);
    }
}

void EntryParser::refuseMissingSemicolon(const Entry& entry) const
{
    const auto& last = entry.values.empty() ? entry.keyword : entry.values.back();
    const Token after{TokenKind::semicolon, last.file, last.offset + last.length, 1};
    throw Fault{after, format("missing ';' after {}", kindInWords(Token{}, document_.text(last))),
                "every entry ends with ';'; values over several lines go in brackets"};
}

void EntryParser::refuseDirective(const Token& token) const
{
    throw Fault{token, format("'{}' is refused", excerpt(document_.text(token))),
                "the only directive is #include \"file\", in place of an entry; "
                "a case runs no code and computes no values"};
}

} // namespace fpm
