#include "run/ControlWatch.h"

#include "base/Error.h"
#include "base/Format.h"
#include "model/ControlReader.h"

namespace fpm {

ControlWatch::ControlWatch(ControlSource source) : source_(std::move(source)), last_(timeOfFile())
{
}

std::filesystem::file_time_type ControlWatch::timeOfFile() const
{
    std::error_code error;
    const auto time = std::filesystem::last_write_time(source_.file, error);
    return error ? std::filesystem::file_time_type() : time;
}

bool ControlWatch::follow(Control& control, Log& log)
{
    if (source_.file.empty() || !control.runTimeModifiable) return false;
    const auto time = timeOfFile();
    // An editor that writes it anew may have removed it for a moment.
    if (time == last_ || time == std::filesystem::file_time_type()) return false;
    last_ = time;
    try {
        const Dictionary dictionary = source_.read();
        rereadControl(dictionary, control);
        log.line(format("{} has changed: read again", dictionary.name()));
        return true;
    } catch (const Error& error) {
        log.warning(std::string("the run goes on as before, though its control dictionary has "
                                "changed:\n")
                    + error.what());
        return false;
    }
}

} // namespace fpm
