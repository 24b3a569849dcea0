#include "application/Application.h"
#include "model/ContactSetup.h"
#include "model/readModel.h"
#include "run/KernelReport.h"
#include "run/TimeLoop.h"
#include "run/WaitPolicy.h"
#include "solver/backend/IdleCores.h"

#include <limits>

namespace {

/// The command line beats controlDict.
void applyOptions(const fpm::Run& run, fpm::Control& control)
{
    const auto choice = [&](const char* name, std::string& value,
                            const std::vector<std::string>& allowed) {
        if (const auto given = run.choice(name, allowed)) value = *given;
    };
    choice("backend", control.backend, {"serial", "openmp", "cuda"});
    choice("simd", control.simd, {"auto", "scalar", "avx2", "avx512"});
    std::string precision;
    choice("precision", precision, {"double", "mixed", "single"});
    if (!precision.empty())
        control.precision = precision == "double"  ? fpm::Precision::double_
                            : precision == "mixed" ? fpm::Precision::mixed
                                                   : fpm::Precision::single;
    if (const auto threads = run.integer("threads", 0, 4096)) control.threads = int(*threads);
}

} // namespace

/// Runs the explicit time integration of a case: mesh and dictionaries -> time folders, histories.
int main(int argc, char** argv)
{
    fpm::shortenSpin(argv);
    const fpm::ApplicationInfo info{
        "fpmExplicit",
        "Explicit dynamics of solids in contact (finite particle method).",
        "system/controlDict",
        {{"backend", "<word>", "serial, openmp or cuda"},
         {"threads", "<n>", "threads of openmp; 0: as many as cores are idle"},
         {"simd", "<word>", "auto, scalar, avx2 or avx512"},
         {"precision", "<word>", "double, mixed or single"},
         {"maxSteps", "<n>", "end after n steps"},
         {"strict", "", "end with code 11 where the run finds fault with itself"},
         {"dryRun", "", "say what would run and how long, then end"}},
        true};
    return fpm::runApplication(info, argc, argv, [](fpm::Run& run) {
        fpm::updateContact(run.theCase, run.log);
        fpm::Model model = fpm::readModel(run.theCase, run.dictionary(), run.log);
        applyOptions(run, model.control);
        const auto solver = fpm::makeSolver(model);
        run.log.line("running on " + solver->description());
        const std::string busy = fpm::busyCoresNote(model.control);
        if (!busy.empty()) run.log.line(busy);
        for (const std::string& line : fpm::kernelLines(*solver, model)) run.log.line(line);
        solver->start();
        if (run.has("dryRun"))
            return fpm::reportDryRun(*solver, model, run.theCase.root(), run.log);
        const auto steps = run.integer("maxSteps", 0, std::numeric_limits<std::int64_t>::max());
        fpm::runTimeLoop(*solver, model, run.theCase.root(),
                         {steps.value_or(-1), run.has("strict")}, run.log);
    });
}
