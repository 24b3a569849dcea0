#include "study/Expression.h"

#include "base/Format.h"
#include "dictionary/Suggestion.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace fpm {

namespace {

using Function = std::function<double(double)>;

/// The smooth step of amplitudes: 0 below 0, 1 above 1, smooth up to the second derivative.
double smoothStep(double x)
{
    const double s = std::min(std::max(x, 0.0), 1.0);
    return s * s * s * (10 - 15 * s + 6 * s * s);
}

const std::map<std::string, Function, std::less<>>& functions()
{
    static const std::map<std::string, Function, std::less<>> all{
        {"smooth", smoothStep},
        {"sin", [](double x) { return std::sin(x); }},
        {"cos", [](double x) { return std::cos(x); }},
        {"tan", [](double x) { return std::tan(x); }},
        {"exp", [](double x) { return std::exp(x); }},
        {"log", [](double x) { return std::log(x); }},
        {"sqrt", [](double x) { return std::sqrt(x); }},
        {"abs", [](double x) { return std::abs(x); }}};
    return all;
}

/// Reads a formula and computes it on the way; formulas are short and evaluated a few thousand
/// times, so there is no need for a tree.
class Reader
{
public:
    Reader(std::string_view text, double t) : text_(text), t_(t) {}

    double value()
    {
        const double result = sum();
        if (at_ < text_.size()) fail("expected an operator");
        return result;
    }

private:
    static constexpr int deepest = 100; ///< brackets and signs within one another

    struct Level {
        explicit Level(Reader& reader) : reader_(reader)
        {
            if (++reader_.depth_ > deepest) reader_.fail("too many brackets");
        }
        Level(const Level&) = delete;
        ~Level() { --reader_.depth_; }
        Reader& reader_;
    };

    [[noreturn]] void fail(const std::string& message) const
    {
        const auto rest = text_.substr(at_);
        throw std::invalid_argument(
            message + (rest.empty() ? " at the end" : format(" at '{}'", rest.substr(0, 20))));
    }

    void skipBlanks()
    {
        while (at_ < text_.size()
               && (text_[at_] == ' ' || text_[at_] == '\t' || text_[at_] == '\n'))
            ++at_;
    }

    bool take(char character)
    {
        skipBlanks();
        if (at_ == text_.size() || text_[at_] != character) return false;
        ++at_;
        skipBlanks();
        return true;
    }

    void require(char character)
    {
        if (!take(character)) fail(format("expected '{}'", std::string(1, character)));
    }

    double sum()
    {
        double result = product();
        for (;;) {
            if (take('+'))
                result += product();
            else if (take('-'))
                result -= product();
            else
                return result;
        }
    }

    double product()
    {
        double result = signedPower();
        for (;;) {
            if (take('*'))
                result *= signedPower();
            else if (take('/'))
                result /= signedPower();
            else
                return result;
        }
    }

    double signedPower()
    {
        const Level level(*this);
        if (take('-')) return -signedPower();
        if (take('+')) return signedPower();
        const double base = primary();
        return take('^') ? std::pow(base, signedPower()) : base;
    }

    double primary()
    {
        const Level level(*this);
        if (take('(')) {
            const double result = sum();
            require(')');
            return result;
        }
        skipBlanks();
        const char* begin = text_.data() + at_;
        const char* end = text_.data() + text_.size();
        if (begin != end && ((*begin >= '0' && *begin <= '9') || *begin == '.')) {
            double number = 0;
            const auto [stop, error] = std::from_chars(begin, end, number);
            if (error != std::errc()) fail("no number this machine can hold");
            at_ = std::size_t(stop - text_.data());
            return number;
        }
        return named();
    }

    double named()
    {
        std::size_t end = at_;
        while (end < text_.size() && std::isalnum(static_cast<unsigned char>(text_[end]))) ++end;
        const std::string name(text_.substr(at_, end - at_));
        if (name.empty()) fail("expected a number, t, a function or '('");
        const auto known = [&] { at_ = end; };
        if (name == "t") return known(), t_;
        if (name == "pi") return known(), std::numbers::pi;
        if (name == "min" || name == "max") {
            known();
            require('(');
            const double first = sum();
            require(',');
            const double second = sum();
            require(')');
            return name == "min" ? std::min(first, second) : std::max(first, second);
        }
        const auto found = functions().find(name);
        if (found == functions().end()) unknown(name);
        known();
        require('(');
        const double argument = sum();
        require(')');
        return found->second(argument);
    }

    [[noreturn]] void unknown(const std::string& name) const
    {
        std::vector<std::string> names{"t", "pi", "min", "max"};
        for (const auto& function : functions()) names.push_back(function.first);
        throw std::invalid_argument(
            format("unknown name '{}' ({})", name, suggestion(name, names)));
    }

    std::string_view text_;
    double t_;
    std::size_t at_ = 0;
    int depth_ = 0;
};

} // namespace

Expression::Expression(std::string text) : text_(std::move(text))
{
    (*this)(1);
}

double Expression::operator()(double t) const
{
    return Reader(text_, t).value();
}

} // namespace fpm
