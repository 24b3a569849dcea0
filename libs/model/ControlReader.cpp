#include "model/ControlReader.h"

#include "base/Format.h"
#include "dictionary/Number.h"
#include "dictionary/Suggestion.h"
#include "model/Names.h"

#include <algorithm>
#include <array>

namespace fpm {

namespace {

/// From the beginning, from the latest checkpoint, or from that of a time, as startTime or in place
/// of the word.
void readStart(const Dictionary& dictionary, Control& control)
{
    dictionary.wordOr("application", "fpmExplicit");
    control.startTime = dictionary.numberOr("startTime", 0.0, nonNegative());
    const std::vector<std::string> from =
        dictionary.has("startFrom") && !dictionary.isDictionary("startFrom")
            ? dictionary.items("startFrom")
            : std::vector<std::string>{};
    if (from.size() == 1 && readNumber(from.front())) {
        control.startTime = dictionary.number("startFrom", nonNegative());
        return;
    }
    control.latest =
        dictionary.choiceOr("startFrom", "startTime", {"startTime", "latestTime"}) == "latestTime";
}

/// OpenFOAM's keys about the time step: whoever writes them expects something of them.
void refuseOtherTimeSteps(const Dictionary& dictionary)
{
    static constexpr std::array<std::array<const char*, 2>, 4> others{
        {{"deltaT", "'timeStep { fixed <step>; }' gives one, 'timeStep { maximum <step>; }' bounds "
                    "it"},
         {"maxDeltaT", "'timeStep { maximum <step>; }' bounds it"},
         {"adjustTimeStep", "it is so without an entry; 'timeStep { fixed <step>; }' ends it"},
         {"maxCo", "'timeStep { safety 0.9; }' is the share of the stable step that is taken"}}};
    const std::vector<std::string> keys = dictionary.keys();
    for (const auto& [key, advice] : others)
        if (std::find(keys.begin(), keys.end(), key) != keys.end())
            dictionary.fail(key,
                            format("'{}' is no key here: the time step follows from stability, at "
                                   "every step",
                                   key),
                            std::string(advice) + "; or remove the entry");
}

/// OpenFOAM's keys about the format of files mean nothing to this solver.
void readWithoutEffect(const Dictionary& dictionary, Log& log)
{
    std::vector<std::string> given;
    for (const char* key :
         {"writeFormat", "writePrecision", "writeCompression", "timeFormat", "timePrecision"})
        if (dictionary.has(key)) given.push_back(key);
    dictionary.choiceOr("writeFormat", "binary", {"ascii", "binary"});
    dictionary.integerOr("writePrecision", 16, 1, 64);
    dictionary.switchOr("writeCompression", false);
    dictionary.choiceOr("timeFormat", "general", {"general", "fixed", "scientific"});
    dictionary.integerOr("timePrecision", 8, 1, 64);
    if (!given.empty())
        log.line(format("{}: accepted without effect: {} (results are HDF5)", dictionary.name(),
                        listed(given)));
}

void readTimeStep(const Dictionary& timeStep, Control& control)
{
    control.timeStepSafety = timeStep.numberOr("safety", 0.9, {0, 1, true, false});
    control.contactStepLimit =
        timeStep.numberOr("contactLimit", control.contactStepLimit, {0, 2, true, false});
    control.maximumTimeStep = timeStep.numberOr("maximum", 0.0, nonNegative());
    control.fixedTimeStep = timeStep.numberOr("fixed", 0.0, nonNegative());
    if (control.maximumTimeStep > 0 && control.fixedTimeStep > 0)
        timeStep.fail("maximum", "a step that is fixed has no maximum", "leave one of the two out");
    control.beyondBound = timeStep.choiceOr("beyondBound", "stop", {"stop", "go"}) == "go";
    if (control.beyondBound && !(control.fixedTimeStep > 0))
        timeStep.fail("beyondBound", "only a step that is given can be beyond the bound",
                      "add, for example: fixed 2e-8;");
}

void readEnergyBalance(const Dictionary& balance, Control& control)
{
    control.energyWarning = balance.numberOr("warning", 0.01, positive());
    control.energyStop = balance.numberOr("stop", 0.05, positive());
    if (control.energyStop < control.energyWarning)
        balance.fail(balance.has("stop") ? "stop" : "warning",
                     "the run would stop before it warns: stop " + toText(control.energyStop, 6)
                         + " is less than warning " + toText(control.energyWarning, 6));
}

/// Both are off unless they are given.
void readQuasiStatic(const Dictionary& dictionary, Control& control)
{
    const Dictionary rest = dictionary.subOrEmpty("quasiStatic"),
                     relaxation = dictionary.subOrEmpty("dynamicRelaxation");
    const double share = rest.numberOr("kineticShare", 0.05, positive());
    control.quasiStaticAfter = rest.numberOr("after", control.endTime / 10, nonNegative());
    if (dictionary.has("quasiStatic")) control.kineticShare = share;
    const double tolerance = relaxation.numberOr("tolerance", 1e-3, {0, 1, true, true});
    if (dictionary.has("dynamicRelaxation")) control.relaxationTolerance = tolerance;
}

void readMachine(const Dictionary& dictionary, Control& control)
{
    control.backend = dictionary.choiceOr("backend", "openmp", {"serial", "openmp", "cuda"});
    control.threads = int(dictionary.integerOr("threads", 0, 0, 4096));
    control.device = int(dictionary.integerOr("device", 0, 0, 1023));
    control.simd = dictionary.choiceOr("simd", "auto", {"auto", "scalar", "avx2", "avx512"});
    const std::string precision =
        dictionary.choiceOr("precision", "double", {"double", "mixed", "single"});
    control.precision = precision == "double"  ? Precision::double_
                        : precision == "mixed" ? Precision::mixed
                                               : Precision::single;
    control.assembly = dictionary.choiceOr("assembly", "patch", {"patch", "gather"}) == "patch"
                           ? Assembly::patch
                           : Assembly::gather;
}

/// Intervals so short that a run would never come to its end for frames, or rows.
void refuseTinyIntervals(const Dictionary& dictionary, const Control& control)
{
    constexpr double mostFrames = 1e7, mostRows = 1e9;
    const bool byTime = control.writeControl == WriteControl::runTime;
    const double frames = byTime ? control.endTime / control.writeInterval : 0;
    if (frames > mostFrames)
        dictionary.fail("writeInterval",
                        format("{} frames would be written until endTime, each a folder; at most "
                               "{} are",
                               toText(frames, 3), toText(mostFrames, 3)),
                        "such as: writeInterval " + toText(control.endTime / 10, 3) + ";");
    const double rows = control.historyInterval > 0 ? control.endTime / control.historyInterval : 0;
    if (rows > mostRows)
        dictionary.fail("historyInterval",
                        format("{} rows would be due until endTime; at most {} are",
                               toText(rows, 3), toText(mostRows, 3)),
                        "write: historyInterval 0; for one row at every step");
}

void readWriting(const Dictionary& dictionary, Control& control)
{
    const std::string word = dictionary.choiceOr(
        "writeControl", "runTime", {"runTime", "adjustableRunTime", "timeStep", "clockTime"});
    control.writeControl = word == "timeStep"    ? WriteControl::timeStep
                           : word == "clockTime" ? WriteControl::clockTime
                                                 : WriteControl::runTime;
    if (control.writeControl == WriteControl::timeStep)
        control.writeInterval =
            double(dictionary.integer("writeInterval", 1, std::int64_t(1) << 52));
    else if (control.writeControl == WriteControl::clockTime)
        control.writeInterval = dictionary.number("writeInterval", positive());
    else
        control.writeInterval =
            dictionary.numberOr("writeInterval", control.endTime / 10, positive());
    control.purgeWrite = int(dictionary.integerOr("purgeWrite", 0, 0, 1000000));
}

CheckpointControl readCheckpoint(const Dictionary& dictionary)
{
    CheckpointControl out;
    out.wallInterval = dictionary.numberOr("wallInterval", out.wallInterval, nonNegative());
    out.steps = dictionary.integerOr("steps", out.steps, 0, std::int64_t(1) << 52);
    out.keep = int(dictionary.integerOr("keep", out.keep, 0, 100));
    return out;
}

/// What may change while a run goes on, and is read again then.
void readModifiable(const Dictionary& dictionary, Control& control)
{
    control.endTime = dictionary.number("endTime", positive());
    const std::string stop = dictionary.choiceOr(
        "stopAt", "endTime", {"endTime", "writeNow", "noWriteNow", "nextWrite"});
    control.stopAt = stop == "writeNow"     ? StopAt::writeNow
                     : stop == "noWriteNow" ? StopAt::noWriteNow
                     : stop == "nextWrite"  ? StopAt::nextWrite
                                            : StopAt::endTime;
    control.maxWallTime = dictionary.numberOr("maxWallTime", 0.0, nonNegative());
    readWriting(dictionary, control);
    control.historyInterval =
        dictionary.numberOr("historyInterval", control.endTime / 1000, nonNegative());
    control.checkpoint = readCheckpoint(dictionary.subOrEmpty("checkpoint"));
    refuseTinyIntervals(dictionary, control);
}

} // namespace

Control readControl(const Dictionary& dictionary, Log& log)
{
    Control control;
    refuseOtherTimeSteps(dictionary);
    readStart(dictionary, control);
    readWithoutEffect(dictionary, log);
    control.runTimeModifiable = dictionary.switchOr("runTimeModifiable", false);
    readModifiable(dictionary, control);
    readTimeStep(dictionary.subOrEmpty("timeStep"), control);
    control.massDamping = dictionary.numberOr("massDamping", 0.0, nonNegative());
    readQuasiStatic(dictionary, control);
    readEnergyBalance(dictionary.subOrEmpty("energyBalance"), control);
    readMachine(dictionary, control);
    control.searchInterval = int(dictionary.integerOr("searchInterval", 0, 0, 1000000));
    control.paperAlgorithm =
        dictionary.choiceOr("algorithm", "default", {"default", "paper"}) == "paper";
    control.midStepStrain =
        dictionary.choiceOr("strainGeometry", "midStep", {"midStep", "start"}) == "midStep";
    control.previousRun = dictionary.choiceOr("previousRun", "keep", {"keep", "remove", "refuse"});
    return control;
}

void rereadControl(const Dictionary& dictionary, Control& control)
{
    Control changed = control;
    readModifiable(dictionary, changed);
    control = std::move(changed);
}

void readMassScaling(const Dictionary& dictionary, std::vector<Part>& parts)
{
    const Dictionary scaling = dictionary.subOrEmpty("massScaling");
    const double factor = scaling.numberOr("factor", 1.0, {1, 1e12, false, false}),
                 targetStep = scaling.numberOr("targetStep", 0.0, nonNegative());
    std::vector<std::string> names;
    for (const Part& part : parts)
        if (!isRigid(part.kind)) names.push_back(part.name);
    const std::vector<std::string> chosen = scaling.has("parts") ? scaling.words("parts") : names;
    for (const std::string& name : chosen)
        if (std::find(names.begin(), names.end(), name) == names.end())
            scaling.fail("parts", "no part '" + name + "' with elements that take part",
                         nameAdvice(name, names, "parts that are not rigid"));
    for (Part& part : parts) {
        if (std::find(chosen.begin(), chosen.end(), part.name) == chosen.end()) continue;
        part.massFactor = factor;
        part.targetStep = targetStep;
    }
}

} // namespace fpm
