"""Several runs in one folder: results, status and what is moved aside belong to one of them."""

import json
import os
import signal
import subprocess
import time

from driver.scene import Scene, elastic

PROBES = """
tables { tip { type extrema; field U; component x; } }
pictures { u { field U; component x; } }
plots { tip { series { now { file "postProcessing/tip/0/displacement.dat"; x time; y ux; } } } }
"""


def scene(binaries, **changes):
    """A block in free flight: 1000 mm/s along x, five frames."""
    entries = {
        "bodies": "a { type box; origin (0 0 0); size (20 10 10); cells (4 2 2); }",
        "parts": elastic("a", 210000, 0.3, 7.85e-9), "end": 1e-5, "frames": 5, "rows": 20,
        "initial": "v { type velocity; part a; value (1000 0 0); }",
        "functions": "tip { type point; part a; position (20 5 5); }",
        "files": {"system/probeDict": PROBES, "0.5/notes.txt": "mine",
                  "postProcessing/mine.csv": "t,u\n0,1\n"},
        **changes}
    return Scene(binaries, **entries)


def state(case):
    return {key: value.strip('"') for key, value in case.status().items()}


def frames(folder):
    return sorted(float(file.parent.name) for file in folder.glob("*/fields.vtkhdf"))


def series(folder):
    return json.loads((folder / "case.vtkhdf.series").read_text())


def pictures(folder):
    return sorted(file.name for file in (folder / "postProcessing/pictures").glob("*"))


def own(case):
    """What a person wrote beside the results is still there."""
    return ((case.root / "0.5/notes.txt").read_text() == "mine"
            and (case.root / "0/initialConditions").exists()
            and (case.root / "postProcessing/mine.csv").exists())


def runOf(table):
    """The run that the head of a table names."""
    return table.read_text().split("\n")[0].split()[3]


def shorter(case):
    """The other way, half as far, with other output times."""
    case.replace("0/initialConditions", "1000", "-1000")
    case.replace("system/controlDict", "endTime 1e-05", "endTime 5e-6")
    case.replace("system/controlDict", "writeInterval .*;", "writeInterval 2.5e-6;")


def check(binaries, marks):
    with scene(binaries) as case:
        case.mesh()
        case.solve()
        case.run("fpmProbe")
        first = state(case)
        marks.true("status names run, process and host",
                   first["state"] == "finished" and len(first["runId"]) == 24
                   and int(first["pid"]) > 0 and first["host"] and first["started"])
        shorter(case)
        output = case.run("fpmExplicit")
        told = (f"moved into previous/ what run {first['runId']} left: 6 frames, 3 tables, "
                "3 pictures")
        marks.true(told, told in output)
        probed = case.run("fpmProbe")
        second = state(case)["runId"]
        marks.true("another run", second != first["runId"] and f"run {second}" in output)
        marks.true("frames of the second run alone", frames(case.root) == [0, 2.5e-6, 5e-6])
        listed = series(case.root)
        marks.true("so is the series", listed["runId"] == second
                   and [entry["time"] for entry in listed["files"]] == [0, 2.5e-6, 5e-6])
        tip = case.table("tip/0/U.dat")
        marks.true("so are tables", tip["time"] == [0, 2.5e-6, 5e-6] and max(tip["max"][1:]) < 0)
        marks.true("so are pictures", pictures(case.root) == ["u_5e-06.png", "u_5e-06.svg"])
        marks.true("nothing is left out", "left out" not in probed)
        folder = case.root / "postProcessing"
        marks.true("every table names it", {second} == {runOf(file) for file in folder.rglob("*.dat")}
                   and case.performance()["runId"] == second)
        previous = case.root / "previous"
        marks.true("the first run is whole in previous", len(frames(previous)) == 6
                   and len(series(previous)["files"]) == 6 and (previous / "status").exists()
                   and pictures(previous) == ["u_1e-05.png", "u_1e-05.svg"]
                   and (previous / "constant/mesh.vtkhdf").exists())
        marks.true("what a person wrote stays", own(case))
        newMesh(case, marks)


def newMesh(case, marks):
    """fpmProbe draws nothing of an old run on a new mesh, and fpmAdvise takes nothing of it."""
    before = pictures(case.root)
    case.replace("system/meshDict", r"cells \(4 2 2\)", "cells (5 2 2)")
    case.run("fpmMesh")
    left = "left out: 3 frames of another mesh than constant/mesh.vtkhdf"
    marks.true("frames of the old mesh are left out by fpmProbe", left in case.run("fpmProbe"))
    marks.true("and by fpmAdvise", left in case.run("fpmAdvise"))
    marks.true("no picture is made of them", pictures(case.root) == before)
    old = (case.root / ".mesh.vtkhdf").read_bytes()
    case.run("fpmExplicit")
    marks.true("the old mesh goes with its frames",
               (case.root / "previous/constant/mesh.vtkhdf").read_bytes() == old
               and not (case.root / ".mesh.vtkhdf").exists())
    marks.true("a run on the new mesh is drawn", "left out" not in case.run("fpmProbe"))
    file = case.root / "5e-06/fields.vtkhdf"
    file.write_bytes(file.read_bytes()[:-100])
    done = case.start("fpmProbe")
    marks.true(f"a frame cut short is an error by its name: status {done.returncode}",
               done.returncode == 4 and f"frame '{file}' is cut short" in done.stdout)


def ends(binaries, marks):
    """A run that fails, one that is killed, and a good one after them."""
    with scene(binaries, control="timeStep { fixed 1e-5; }") as case:
        case.mesh()
        done = case.start("fpmExplicit")
        marks.true("a step too long fails", done.returncode == 10)
        failed = state(case)
        probed = case.run("fpmProbe")
        marks.true("fpmProbe says so and why",
                   f"warning: run {failed['runId']} failed at time" in probed
                   and "timeStep.fixed" in probed)
        control = case.root / "system/controlDict"
        text = control.read_text().replace("timeStep { fixed 1e-5; }", "")
        control.write_text("endTime 100;\nwriteInterval 100;\nhistoryInterval 100;\n"
                           + text[text.index("backend"):])
        killed(case, marks)
        control.write_text(text)
        case.run("fpmExplicit")
        probed = case.run("fpmProbe")
        marks.true("a good run after them is all there is", "warning" not in probed
                   and not (case.root / "why.txt").exists() and not (case.root / "failed").exists()
                   and len(frames(case.root)) == 6
                   and case.table("tip/0/displacement.dat")["time"][-1] == 1e-5)
        modes(case, marks)


def killed(case, marks):
    """A run with no row for hours tells how far it is; killed, it has died."""
    process = subprocess.Popen([case.binaries / "fpmExplicit"], cwd=case.root,
                               stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    seen = set()
    end = time.monotonic() + 60
    while len(seen) < 2 and time.monotonic() < end and process.poll() is None:
        time.sleep(0.05)
        try:
            now = state(case)
        except FileNotFoundError:  # moved aside with the run before
            continue
        if now["pid"] == str(process.pid) and int(now["steps"]) > 0:
            seen.add(int(now["steps"]))
    marks.true("status is renewed while it runs", len(seen) == 2
               and now["state"] == "running" and now["host"] == os.uname().nodename)
    process.send_signal(signal.SIGKILL)
    process.wait()
    left = [case.root / f".status.{process.pid}.tmp",
            case.root / f"5e-06/.fields.vtkhdf.{process.pid}.tmp"]
    left[1].parent.mkdir(exist_ok=True)
    for file in left:
        file.write_text("half")
    probed = case.run("fpmProbe")
    marks.true("killed, it has died", f"warning: run {now['runId']} died after time" in probed)
    case.run("fpmMesh")
    marks.true("its temporaries are swept", not any(file.exists() for file in left))


def modes(case, marks):
    """controlDict.previousRun."""
    before = state(case)
    control = case.root / "system/controlDict"
    text = control.read_text()
    case.run("fpmExplicit", "-dryRun")
    control.write_text(text + "previousRun often;\n")
    done = case.start("fpmExplicit")
    marks.true("neither a dry run nor a wrong word moves anything",
               done.returncode == 3 and state(case) == before and len(frames(case.root)) == 6)
    control.write_text(text + "previousRun refuse;\n")
    done = case.start("fpmExplicit")
    marks.true(f"refuse: status {done.returncode}", done.returncode == 6 and state(case) == before
               and f"the case holds results of run {before['runId']}" in done.stdout)
    control.write_text(text + "previousRun remove;\n")
    kept = frames(case.root / "previous")
    marks.true("remove", f"removed what run {before['runId']} left" in case.run("fpmExplicit")
               and frames(case.root / "previous") == kept and own(case))
    (case.root / "previous/.fpmPrevious").unlink()
    control.write_text(text)
    done = case.start("fpmExplicit")
    marks.true("a folder previous of somebody else is not touched", done.returncode == 6
               and "was not made by fpmExplicit" in done.stdout
               and frames(case.root / "previous") == kept)
