#include "application/CommandLine.h"

#include "base/Format.h"
#include "dictionary/Suggestion.h"

#include <boost/program_options.hpp>

#include <algorithm>

namespace fpm {

namespace {

namespace po = boost::program_options;
namespace style = po::command_line_style;

// One dash or two, value after a blank or '='. No guessing: -l must not become -listKeys.
constexpr int dashStyle = style::allow_long | style::long_allow_next | style::long_allow_adjacent
                          | style::allow_short | style::allow_dash_for_short
                          | style::short_allow_next | style::short_allow_adjacent
                          | style::allow_long_disguise;

constexpr const char* strayKey = "stray argument";

/// "--case=x" to "case".
std::string bareName(const std::string& given)
{
    const auto name = given.substr(std::min(given.find_first_not_of('-'), given.size()));
    return name.substr(0, name.find('='));
}

std::optional<Option> findOption(const ApplicationInfo& info, const std::string& name)
{
    for (const auto& option : allOptions(info))
        if (option.name == name) return option;
    return std::nullopt;
}

/// Declared to Boost as text only: numbers are read with our own rules.
po::options_description declared(const std::vector<Option>& options)
{
    po::options_description description;
    for (const auto& option : options) {
        const auto name = option.name == "help" ? "help,h" : option.name;
        if (option.value.empty())
            description.add_options()(name.c_str(), "");
        else
            description.add_options()(name.c_str(), po::value<std::string>(), "");
    }
    description.add_options()(strayKey, po::value<std::vector<std::string>>(), "");
    return description;
}

[[noreturn]] void refuse(const ApplicationInfo& info, const std::string& message)
{
    throw Error(ExitCode::commandLine, message, format("'{} -help' lists the options", info.name));
}

[[noreturn]] void refuseUnknown(const ApplicationInfo& info, const std::string& given)
{
    std::vector<std::string> names;
    for (const auto& option : allOptions(info)) names.push_back(option.name);
    const auto close = nearest(bareName(given), names);
    if (!close) refuse(info, format("unknown option {}", given));
    throw Error(ExitCode::commandLine, format("unknown option {}", given),
                format("did you mean -{}?", *close));
}

[[noreturn]] void refuseSyntax(const ApplicationInfo& info, const po::error_with_option_name& error)
{
    const auto name = bareName(error.get_option_name());
    const auto option = findOption(info, name);
    if (!option) refuseUnknown(info, error.get_option_name());
    if (option->value.empty()) refuse(info, format("option -{} takes no value", name));
    refuse(info, format("option -{} needs a value {}", name, option->value));
}

void addOption(const ApplicationInfo& info, const po::option& given, OptionValues& values)
{
    const auto& name = given.string_key;
    const auto text = given.value.empty() ? std::string() : given.value.front();
    if (name == strayKey) refuse(info, format("unexpected argument '{}'", text));

    const auto option = findOption(info, name);
    if (!option) refuseUnknown(info, name);
    const bool isDashed = text.starts_with('-');
    if (isDashed && findOption(info, bareName(text)))
        refuse(info,
               format("option -{} needs a value {}, found option {}", name, option->value, text));
    if (!option->value.empty() && text.empty())
        refuse(info, format("option -{} needs a value {}", name, option->value));
    const bool isRepeated = std::any_of(values.begin(), values.end(),
                                        [&](const auto& pair) { return pair.first == name; });
    if (isRepeated) refuse(info, format("option -{} is given twice", name));
    values.emplace_back(name, text);
}

} // namespace

std::vector<Option> allOptions(const ApplicationInfo& info)
{
    std::vector<Option> options{{"case", "<dir>", "Case folder (default: .)"}};
    if (!info.dictionary.empty()) {
        options.push_back(
            {"dict", "<file>",
             format("Dictionary, relative to the case (default: {})", info.dictionary)});
        options.push_back({"listKeys", "", "List every key of the dictionary"});
        options.push_back({"writeDefaults", "",
                           format("Write an annotated {}, or that of -dict", info.dictionary)});
    }
    options.push_back({"noLog", "", format("Write no file log.{}", info.name)});
    options.insert(options.end(), info.options.begin(), info.options.end());
    options.push_back({"version", "", "Print version and git revision"});
    options.push_back({"help", "", "Print this text"});
    return options;
}

OptionValues parseCommandLine(const ApplicationInfo& info, int argc, char** argv)
{
    const auto description = declared(allOptions(info));
    const auto strays = po::positional_options_description().add(strayKey, -1);
    OptionValues values;
    try {
        const auto parsed = po::command_line_parser(argc, argv)
                                .options(description)
                                .positional(strays)
                                .style(dashStyle)
                                .run();
        for (const auto& given : parsed.options) addOption(info, given, values);
    } catch (const po::unknown_option& error) {
        refuseUnknown(info, error.get_option_name());
    } catch (const po::error_with_option_name& error) {
        refuseSyntax(info, error);
    } catch (const po::error& error) {
        refuse(info, error.what());
    }
    return values;
}

std::string helpText(const ApplicationInfo& info)
{
    const auto options = allOptions(info);
    std::size_t width = 0;
    for (const auto& option : options)
        width = std::max(width, option.name.size() + option.value.size() + 1);

    auto text = format("Usage: {} [options]\n\n{}\n\nOptions:\n", info.name, info.purpose);
    for (const auto& option : options) {
        auto column = option.name + (option.value.empty() ? "" : " ") + option.value;
        column.resize(width + 2, ' ');
        text += format("  -{}{}\n", column, option.description);
    }
    return text;
}

} // namespace fpm
