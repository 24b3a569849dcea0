#include "base/Log.h"

#include "base/Format.h"
#include "base/Utf8.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>

namespace fpm {

namespace {

constexpr int mostRepeats = 10;
constexpr std::string_view yellow = "\033[33m";
constexpr std::string_view red = "\033[1;31m";
constexpr std::string_view plain = "\033[0m";

/// Whether escape sequences are understood where `descriptor` leads.
bool isScreen(int descriptor)
{
    const char* kind = std::getenv("TERM");
    return isatty(descriptor) == 1 && kind != nullptr && std::string_view(kind) != "dumb";
}

bool isColoured(int descriptor)
{
    const char* refusal = std::getenv("NO_COLOR");
    return isScreen(descriptor) && (refusal == nullptr || *refusal == '\0');
}

/// A line that wraps cannot be rewritten in place.
std::size_t screenWidth()
{
    winsize size{};
    const bool known = ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 1;
    return known ? size.ws_col - 1u : 79u;
}

/// False when the text went nowhere; a reader that left must not stop the run.
bool send(std::FILE* stream, const std::string& text)
{
    const bool written = std::fwrite(text.data(), 1, text.size(), stream) == text.size();
    const bool flushed = std::fflush(stream) == 0;
    std::clearerr(stream);
    return written && flushed;
}

/// Label and text of a line; the label stands out where the screen can show it.
std::string labelled(std::string_view label, std::string_view text, std::string_view colour, int to)
{
    std::string result;
    if (!label.empty() && isColoured(to))
        result.append(colour).append(label).append(plain);
    else
        result.append(label);
    return result.append(text).append("\n");
}

} // namespace

Log::Log(int file) : file_(file < 0 ? nullptr : ::fdopen(file, "a")) {}

Log Log::quiet()
{
    Log log;
    log.terminal_ = false;
    return log;
}

Log Log::into(std::string& text)
{
    Log log = quiet();
    log.text_ = &text;
    return log;
}

void Log::line(std::string_view text)
{
    write({}, text);
}

void Log::warning(std::string_view text)
{
    const auto found = warnings_.try_emplace(std::string(text), 0).first;
    if (++found->second > mostRepeats) return;

    write("warning: ", text);
    if (found->second == mostRepeats) line("         (from here on this warning is only counted)");
}

void Log::progress(std::string_view given)
{
    const std::string text = printableLines(given);
    writeToFile(text);
    if (!terminal_) return;
    if (!isScreen(STDOUT_FILENO)) return writeToTerminal({}, text);

    const auto shown = text.substr(0, screenWidth());
    if (!send(stdout, std::string("\r").append(shown).append("\033[K"))) ++lostLines_;
    progressOpen_ = true;
}

void Log::error(std::string_view given)
{
    constexpr std::string_view label = "error: ";
    const std::string text = printableLines(given);
    endProgress();
    writeToFile(std::string(label).append(text));
    if (terminal_) send(stderr, labelled(label, text, red, STDERR_FILENO));
}

void Log::finish()
{
    endProgress();
    for (const auto& [text, count] : warnings_)
        if (count > mostRepeats) line(format("warning ({} times): {}", count, text));
    warnings_.clear();
    if (lostLines_ > 0 && terminal_)
        send(stderr, format("warning: {} log lines could not be written\n", lostLines_));
    lostLines_ = 0;
}

void Log::write(std::string_view label, std::string_view given)
{
    const std::string text = printableLines(given);
    writeToFile(std::string(label).append(text));
    if (terminal_) writeToTerminal(label, text);
}

void Log::writeToFile(std::string_view text)
{
    if (text_) text_->append(text).append("\n");
    if (file_ && !send(file_.get(), std::string(text).append("\n"))) ++lostLines_;
}

void Log::writeToTerminal(std::string_view label, std::string_view text)
{
    endProgress();
    if (!send(stdout, labelled(label, text, yellow, STDOUT_FILENO))) ++lostLines_;
}

void Log::endProgress()
{
    if (progressOpen_) send(stdout, "\n");
    progressOpen_ = false;
}

} // namespace fpm
