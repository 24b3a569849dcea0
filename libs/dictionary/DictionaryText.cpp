#include "dictionary/DictionaryText.h"

#include "base/Format.h"
#include "dictionary/Limits.h"

#include <algorithm>
#include <cmath>

namespace fpm {

namespace {

constexpr std::size_t indentWidth = 4;

std::string held(std::string_view value)
{
    std::string text(value);
    std::replace(text.begin(), text.end(), '"', '\'');
    std::replace_if(
        text.begin(), text.end(),
        [](char c) { return c == '\\' || (c >= 0 && c < ' ') || c == '\x7f'; }, ' ');
    return text;
}

} // namespace

DictionaryText::DictionaryText(std::string_view comment)
{
    line(format("// {}", comment));
}

DictionaryText& DictionaryText::line(const std::string& content)
{
    text_ += indent_ + content + "\n";
    return *this;
}

DictionaryText&
DictionaryText::number(std::string_view key, const std::optional<double>& value, int digits)
{
    if (!value || !(std::abs(*value) <= limits::largestNumber)) return *this;
    const double x = std::abs(*value) < limits::smallestNumber ? 0 : *value;
    return line(format("{} {};", key, digits > 0 ? toText(x, digits) : toText(x)));
}

DictionaryText& DictionaryText::integer(std::string_view key, std::int64_t value)
{
    return line(format("{} {};", key, value));
}

DictionaryText& DictionaryText::string(std::string_view key, std::string_view value)
{
    return line(format("{} \"{}\";", key, held(value)));
}

DictionaryText& DictionaryText::openList(std::string_view key)
{
    line(std::string(key));
    line("(");
    indent_.append(indentWidth, ' ');
    return *this;
}

DictionaryText& DictionaryText::openItem()
{
    line("{");
    indent_.append(indentWidth, ' ');
    return *this;
}

DictionaryText& DictionaryText::closeItem()
{
    indent_.resize(indent_.size() - indentWidth);
    return line("}");
}

DictionaryText& DictionaryText::closeList()
{
    indent_.resize(indent_.size() - indentWidth);
    return line(");");
}

} // namespace fpm
