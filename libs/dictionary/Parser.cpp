#include "dictionary/Parser.h"

#include "base/Format.h"
#include "base/Utf8.h"
#include "dictionary/Dictionary.h"
#include "dictionary/EntryParser.h"
#include "dictionary/Limits.h"
#include "dictionary/Macros.h"
#include "dictionary/Report.h"

namespace fpm {

namespace {

/// Runs a stage and gives its Faults the place in the dictionary.
template <class Stage, class Action>
void reportFaults(const Document& document, const Stage& stage, Action action)
{
    try {
        action();
    } catch (const Fault& fault) {
        throw InputError(
            report(document, fault.at, stage.current().path(), fault.message, fault.advice));
    }
}

template <class Action>
std::shared_ptr<Document> parse(const std::filesystem::path& root, Macros macros, Action action)
{
    auto document = std::make_shared<Document>();
    document->addNode(nullptr, "");

    EntryParser parser(*document, root);
    reportFaults(*document, parser, [&] { action(parser); });
    if (macros == Macros::keep) return document;
    MacroExpander expander(*document);
    reportFaults(*document, expander, [&] { expander.expandAll(); });
    return document;
}

FileContent readMain(const std::filesystem::path& file, const std::filesystem::path& root)
{
    try {
        return readConfined(file, root, limits::fileBytes);
    } catch (const ReadFailure& failure) {
        throw Error(failure.isRefused ? ExitCode::dictionary : ExitCode::fileIo,
                    format("cannot read {}: {}", printable(file.string()), failure.reason),
                    failure.advice);
    }
}

} // namespace

std::shared_ptr<Document>
parseFile(const std::filesystem::path& file, const std::filesystem::path& root, Macros macros)
{
    auto content = readMain(file, root);
    return parse(root, macros, [&](EntryParser& parser) { parser.parse(std::move(content)); });
}

std::shared_ptr<Document> parseText(std::string text, const std::string& name)
{
    if (text.size() > limits::fileBytes)
        throw Error(ExitCode::dictionary,
                    format("{} has more than {} MiB", name, limits::fileBytes >> 20));
    return parse({}, Macros::expand,
                 [&](EntryParser& parser) { parser.parse(std::move(text), name); });
}

} // namespace fpm
