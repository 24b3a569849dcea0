"""fpmChart on a short wave in a bar (tutorials/bar): order, front, failing run, resume after a kill."""

import re
import shutil
import signal
import subprocess
import time

from driver.caseRun import PROJECT, CaseRun, Failed
from driver.results import different, results

# The pulse passes the middle of the bar twice: on its way and back from the free end.
EXACT = ("1000 * (smooth((t - 5e-6) / 4e-6) - smooth((t - 9e-6) / 4e-6)"
         " + smooth((t - 15e-6) / 4e-6) - smooth((t - 19e-6) / 4e-6))")
CHART = """charts
{
    speed
    {
        combine product;
        cost elementSteps;
        tolerance 0.005;
        ladders
        {
            refinement { entry meshDict.refinement; values (1 2 4); }
            precision { entry controlDict.precision; values (double single); }
        }
        probes
        {
            exact { file "postProcessing/middle/0/velocity.dat"; y vx;
                    reference { expression "%s"; } }
            estimate { file "postProcessing/middle/0/velocity.dat"; y vx;
                       reference { finest refinement; } }
        }
    }
    steps
    {
        cost elementSteps;
        ladders { step { entry controlDict.timeStep.fixed; values (5e-8 1e-6); } }
        probes { middle { file "postProcessing/table/0/V.dat"; y V_x; reference { finest step; } } }
    }
}
"""


def bar(binaries):
    """A bar of 50 x 1 x 1 cells of 1 mm, probed at its middle."""
    case = CaseRun("tutorials/bar", binaries)
    case.replace("system/meshDict", r"size \(100 2 2\); cells \(100 2 2\)",
                 "size (50 1 1); cells (50 1 1)")
    case.replace("system/controlDict", r"position \(50 1 1\)", "position (25 0 0)")
    case.replace("system/controlDict", r"position \(100 1 1\)", "position (50 0 0)")
    case.replace("system/controlDict", r"^endTime +8e-5", "endTime 2.4e-5")
    case.replace("system/controlDict", r"^historyInterval 2.5e-7", "historyInterval 1e-7")
    case.replace("system/probeDict", r"^pictures", "tables\n{\n    table { type point; field V; "
                 "position (25 0 0); }\n}\npictures")
    (case.root / "system/chartDict").write_text(CHART % EXACT)
    return case


def rows(case, name="speed", file="chart.dat"):
    """The rows of a table of words, by the names of its columns."""
    names, found = [], []
    for line in (case.root / f"postProcessing/chart/{name}" / file).read_text().splitlines():
        words = line.lstrip("# ").split()
        if line.startswith("# run"):
            names = words
        elif not line.startswith("#"):
            found.append(dict(zip(names, words)))
    return found


def front(case):
    return [row["run"] for row in rows(case) if row["exact.front"] == "yes"]


def runsOf(output):
    return len(re.findall(r"^  \d+ of \d+: ", output, re.M))


def killed(case):
    """Starts the chart and kills it without warning after its second row."""
    process = subprocess.Popen([case.binaries / "fpmChart", "-chart", "speed"], cwd=case.root,
                               stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    table = case.root / "postProcessing/chart/speed/runs.dat"
    while process.poll() is None:
        if table.exists() and len(table.read_text().splitlines()) > 2:
            process.send_signal(signal.SIGKILL)
            break
        time.sleep(0.002)
    process.wait()
    return process.returncode == -signal.SIGKILL


# One run that takes a while, with many checkpoints.
LONG = """charts
{
    one
    {
        keepFields yes;
        ladders { refinement { entry meshDict.refinement; values (4); } }
        probes
        {
            middle { file "postProcessing/middle/0/velocity.dat"; y vx; reference { table ((0 0) (1 1000)); } }
        }
    }
}
"""
RUN = "postProcessing/chart/one/runs/refinement_4"


def longer(binaries):
    case = bar(binaries)
    (case.root / "system/chartDict").write_text(LONG)
    control = case.root / "system/controlDict"
    control.write_text(control.read_text() + "checkpoint { wallInterval 0; steps 50; keep 3; }\n")
    return case


def endAt(case, time):
    case.replace("system/controlDict", r"^endTime +[0-9.e-]+", f"endTime {time}")


def stoppedIn(case, number):
    """Starts the chart and sends it a signal once its run has written checkpoints; its code."""
    process = subprocess.Popen([case.binaries / "fpmChart"], cwd=case.root,
                               stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    while process.poll() is None:
        if (case.root / RUN / "checkpoint/state.2.h5").exists():
            process.send_signal(number)
            break
        time.sleep(0.002)
    return process.wait()


def continued(binaries, marks):
    """Runs go on from their checkpoints, to the bits of a run from the start, or it is said why not."""
    with longer(binaries) as whole:
        def expectedTo(end):
            endAt(whole, end)
            output = whole.run("fpmChart", "-retry")
            if "goes on" in output:
                shutil.rmtree(whole.root / "postProcessing/chart")
                whole.run("fpmChart")
            return results(whole.root / RUN)
        short, long = expectedTo("2.4e-5"), expectedTo("4e-5")

        def judge(case, what, expected, words):
            output = case.run("fpmChart")
            told = re.search(r"^ +refinement_4 (goes on|begins again).*$", output, re.M)
            marks.true(f"{what}: {told.group(0).strip() if told else 'nothing said'}",
                       told is not None and words in told.group(0))
            if wrong := different(results(case.root / RUN), expected):
                marks.failures.append(f"{what}: not as from the start: {wrong}")
            if runsOf(case.run("fpmChart")) != 0:
                marks.failures.append(f"{what}: it is run once more")

        for number, code in ((signal.SIGKILL, -signal.SIGKILL), (signal.SIGTERM, 75)):
            with longer(binaries) as case:
                endAt(case, "2.4e-5")
                if (found := stoppedIn(case, number)) != code:
                    raise Failed(f"{number.name}: status {found}, too late")
                judge(case, number.name, short, "goes on from its checkpoint")
        with longer(binaries) as case:
            endAt(case, "2.4e-5")
            case.run("fpmChart")
            endAt(case, "4e-5")
            judge(case, "a later end", long, "goes on from its checkpoint")
            endAt(case, "2.4e-5")
            judge(case, "an earlier end", short, "no checkpoint before endTime 2.4e-05 is left")
            case.replace("system/controlDict", r"^historyInterval [0-9.e-]+;", "")
            endAt(case, "4e-5")
            case.run("fpmChart")
            endAt(case, "5e-5")
            told = case.run("fpmChart")
            marks.true("rows that follow from the end: begins again, says so",
                       "begins again: historyInterval is not given and follows from endTime" in told)


def check(binaries, marks):
    with bar(binaries) as case, bar(binaries) as other:
        marks.true("killed in the middle", killed(case))
        kept = len(rows(case, file="runs.dat"))
        output = case.run("fpmChart", "-chart", "speed")
        marks.true(f"{kept} rows kept, {runsOf(output)} runs left of 6",
                   2 <= kept < 6 and kept + runsOf(output) == 6)
        marks.true("it says so", f"{kept} of 6 runs are finished already" in output)

        double = {row["run"].split(".")[0][-1]: row for row in rows(case) if "double" in row["run"]}
        # Dispersion of linear elements and of central differences: second order.
        marks.within("order, refinement 1 to 2", float(double["2"]["exact.order"]), 1.85, 2.15)
        marks.within("2 to 4", float(double["4"]["exact.order"]), 1.85, 2.15)
        marks.below("error, refinement 4", float(double["4"]["exact.L2"]), 0.01)
        told = float(re.search(r"observed order (\S+)", output).group(1))
        marks.within("order seen without the solution", told, 1.8, 2.2)
        marks.within("estimated / true error, refinement 2",
                     float(double["2"]["estimate.L2"]) / float(double["2"]["exact.L2"]), 0.85, 1.15)
        marks.true("advice: " + re.search(r"^for .*? on exact.*$", output, re.M).group(0),
                   "for 0.5 % on exact (L2 over time) use refinement 2" in output)

        other.run("fpmChart", "-chart", "speed")
        marks.true("the same front twice: " + " ".join(front(case)), front(case) == front(other))
        steps = case.run("fpmChart", "-chart", "steps")
        failed = [row["state"] for row in rows(case, "steps")]
        marks.true(f"a step too long is a result: {failed}", failed == ["ok", "fpmExplicit:10"])
        picture = (case.root / "postProcessing/chart/steps/middle.svg").read_text()
        marks.true("drawn with its cause", "numerical stop" in picture and "End" in steps)
        marks.true("nothing is run twice", runsOf(case.run("fpmChart")) == 0)

        text = case.root / "constant/partProperties"
        text.write_text(text.read_text().replace("density         8e-9", "density         7e-9"))
        listed = case.run("fpmChart", "-dryRun")
        marks.true("another density makes all runs due", "6 to do" in listed and "2 to do" in listed)
        case.replace("system/chartDict", "meshDict.refinement", "meshDict.refinemnt")
        wrong = case.start("fpmChart")
        marks.true(f"a misspelt entry: status {wrong.returncode}, suggestion",
                   wrong.returncode == 3 and "did you mean 'refinement'?" in wrong.stdout)


def tutorials(binaries, marks):
    """Every chartDict that is shipped names entries, folders, histories and references of its case."""
    for name in sorted(p.parts[-3] for p in PROJECT.glob("tutorials/*/system/chartDict")):
        with CaseRun(f"tutorials/{name}", binaries) as case:
            if (case.root / "makeMeshes").exists():
                subprocess.run([case.root / "makeMeshes"], check=True)
            told = case.run("fpmChart", "-dryRun")
            due = [int(count) for count in re.findall(r"repeats each\), (\d+) to do", told)]
            marks.true(f"{name}: {sum(due)} runs in {len(due)} charts", due and min(due) > 0)


def proposed(binaries, marks):
    """What fpmChart -writeDefaults proposes for a case can be run as it is."""
    for name in sorted(p.parts[-3] for p in PROJECT.glob("tutorials/*/system/controlDict")):
        with CaseRun(f"tutorials/{name}", binaries) as case:
            if (case.root / "makeLayers").exists():
                subprocess.run([case.root / "makeLayers"], check=True, stdout=subprocess.DEVNULL)
            chart = case.root / "system/chartDict"
            chart.unlink(missing_ok=True)
            case.run("fpmChart", "-writeDefaults")
            listed = case.run("fpmChart", "-dryRun")
            runs = sum(int(count) for count in re.findall(r"repeats each\), (\d+) to do", listed))
            marks.true(f"{name}: {runs} runs proposed", runs > 4)
    with bar(binaries) as case:
        case.replace("system/meshDict", r"cells \(50 1 1\)", "cells (24 1 1)")
        (case.root / "system/chartDict").unlink()
        case.run("fpmChart", "-writeDefaults")
        text = (case.root / "system/chartDict").read_text()
        marks.true("sizes of this case, coarse to fine", "steps   (4.17 2.08 1.04)" in text)
        marks.true("its own history and direction", "y           vx;" in text)
        output = case.run("fpmChart", "-chart", "mesh")
        marks.true("the proposal runs", output.count("errors against") >= 1 and "End" in output)
        case.replace("system/controlDict", r"^functions\s*\{[^}]*\}[^}]*\}[^}]*\}[^}]*\}", "")
        (case.root / "system/chartDict").unlink()
        wrong = case.start("fpmChart", "-writeDefaults")
        marks.true("without a history there is nothing to chart",
                   wrong.returncode == 3 and "no history whose error" in wrong.stdout)
