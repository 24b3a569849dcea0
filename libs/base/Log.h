#pragma once

#include <cstdio>
#include <map>
#include <memory>
#include <string>
#include <string_view>

namespace fpm {

/// Writes lines to the terminal and, where a file is given, to log.<application> of the case.
/// A closed terminal or a full disk never stops the run. Colour only on a terminal without
/// NO_COLOR.
class Log
{
public:
    Log() = default;                    ///< terminal only
    explicit Log(int file);             ///< terminal and an open file, which it closes; -1: none
    static Log quiet();                 ///< neither; for tests
    static Log into(std::string& text); ///< neither; adds its lines to `text`, which outlives it

    void line(std::string_view text = "");
    /// "warning: ..."; the same text is printed at most 10 times, then counted.
    void warning(std::string_view text);
    /// A progress line: rewritten in place on a terminal, an ordinary line in the file.
    void progress(std::string_view text);
    /// "error: ..." on the error stream and in the file.
    void error(std::string_view text);
    /// Ends an open progress line and says what was held back: repeated warnings, lost lines.
    void finish();

private:
    void write(std::string_view label, std::string_view text);
    void writeToFile(std::string_view text);
    void writeToTerminal(std::string_view label, std::string_view text);
    void endProgress();

    struct Closer {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };
    std::unique_ptr<std::FILE, Closer> file_;
    std::string* text_ = nullptr;
    int lostLines_ = 0;
    bool terminal_ = true;
    bool progressOpen_ = false;
    std::map<std::string, int, std::less<>> warnings_;
};

} // namespace fpm
