"""What is said of a run before it is made, against what it then does."""

import os
import re
import subprocess

from driver.scene import Scene, elastic

STEEL = elastic("a", 210000, 0.3, 7.85e-9) + elastic("b", 210000, 0.3, 7.85e-9)
FORECAST = re.compile(
    r"^forecast: (?:at least )?(?P<steps>\S+) steps of up to (?P<step>\S+), (?P<frames>\d+) frames of (?P<frame>.+), "
    r"histories (?P<rows>.+), checkpoints (?P<state>.+): (?P<disk>.+) on a disk with (?P<free>.+) free; "
    r"memory at the peak (?P<memory>.+)$", re.M)


def number(text):
    """Bytes of "31.4 MB"."""
    value, unit = text.split()
    return float(value) * {"kB": 1e3, "MB": 1e6, "GB": 1e9, "TB": 1e12}[unit]


def told(output):
    return FORECAST.search(output).groupdict()


def blocks(binaries, cells=4, end=1e-6, frames=2, control="", grading="", gap=0.1):
    """A block over another one."""
    return Scene(
        binaries, end=end, frames=frames, rows=10, parts=STEEL, control=control,
        bodies=f"a {{ type box; origin (0 0 0); size (20 10 10); "
               f"cells ({2 * cells} {cells} {cells}); }}"
               f"b {{ type box; origin (0 0 {10 + gap}); size (10 10 10); "
               f"cells ({cells} {cells} {2 * cells}); {grading} }}",
        pairs="p { contactor b; target a; }")


def peak(case, *options):
    """Largest memory of fpmExplicit, and its output."""
    run = subprocess.Popen([case.binaries / "fpmExplicit", *options], cwd=case.root, text=True,
                           stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    output = run.stdout.read()
    _, _, usage = os.wait4(run.pid, 0)
    run.returncode = 0  # waited for already
    return 1024 * usage.ru_maxrss, output


def size(folder):
    """Bytes on the disk."""
    return sum(512 * os.lstat(os.path.join(path, name)).st_blocks
               for path, folders, names in os.walk(folder) for name in [*folders, *names])


def check(binaries, marks):
    """Frames, disk and memory of a tiny and a medium case; endless runs; disks."""
    for cells, name in ((4, "tiny"), (24, "medium")):
        with blocks(binaries, cells, frames=8) as case:
            case.mesh()
            _, dry = peak(case, "-dryRun")
            before = size(case.root)
            most, output = peak(case, "-threads", "1")
            at, start = told(dry), told(output)
            frames = len(re.findall(r"^Time = ", output, re.M))
            marks.true(f"{name}: {frames} frames", frames == int(at["frames"]) == int(start["frames"]))
            # Status, log and performance are not counted; a dozen blocks of the disk.
            marks.within(f"{name} disk told over written",
                         number(at["disk"]) / (size(case.root) - before), 0.75, 1.15)
            marks.within(f"{name} memory -dryRun tells over used", number(at["memory"]) / most,
                         0.85, 1.15)
            marks.within(f"{name} memory told at the start over used",
                         number(start["memory"]) / most, 0.9, 1.15)
            marks.true("no warning", "warning" not in dry + output)


def frames(binaries, marks):
    """Frames that lie closer than steps: told before, and counted."""
    with blocks(binaries, end=2e-7, frames=200) as case:
        case.mesh()
        dry = case.run("fpmExplicit", "-dryRun")
        output = case.run("fpmExplicit", "-threads", "1")
        marks.true("201 frames cost more than steps: -dryRun",
                   "warning: 201 frames cost more than the " in dry)
        marks.true("and the run say so", "warning: 201 frames cost more than the " in output)
        marks.true("200 steps told", told(dry)["steps"] == "200")
        marks.true("and made", int(case.status()["steps"]) == 200)


def endless(binaries, marks):
    """No run goes on for ever without a word."""
    with blocks(binaries, end=1e18, control="energyBalance { stop 1e9; }") as case:
        case.mesh()
        done = case.start("fpmExplicit", "-maxSteps", "20")
        marks.true("endTime 1e18 with -maxSteps 20: status 0", done.returncode == 0)
        marks.true("20 steps", int(case.status()["steps"]) == 20)
        done = case.start("fpmExplicit")
        marks.true("without: status 10", done.returncode == 10)
        marks.true("and why", "would take" in (case.root / "why.txt").read_text())
    with blocks(binaries, control="timeStep { maximum 1e-100; }") as case:
        case.mesh()
        done = case.start("fpmExplicit")
        marks.true(f"a step of 1e-100: status {done.returncode}",
                   done.returncode == 10 and "1e-100" in done.stdout)
        marks.true("-dryRun warns", "would take" in case.run("fpmExplicit", "-dryRun"))


def setters(binaries, marks):
    """One row of thin elements: mesh, -dryRun and run say what they cost; mass scaling as told."""
    with blocks(binaries, end=1e-6, grading="grading (1 1 2000);", gap=0.5) as case:
        meshed = case.run("fpmMesh")
        case.run("fpmSetContact")
        dry = case.run("fpmExplicit", "-dryRun")
        marks.true("fpmMesh tells the row", "16 of 256 elements (part b, between" in meshed)
        marks.true("-dryRun tells the row", "16 of 256 elements (part b, between" in dry)
        marks.true("and what contact needs beside them is not blamed",
                   "contact needs" not in dry)
        target, saves, mass = re.findall(
            r"targetStep (\S+); \}: (\S+) times fewer steps for (\S+) % more mass", dry)[-1]
        marks.within("mass told", float(mass), 4.9, 5.1, " %")
        plain = float(re.search(r"elements alone (\S+),", dry).group(1))
        case.replace("system/controlDict", "^backend serial;",
                     f"backend serial; massScaling {{ targetStep {target}; }}")
        scaled = case.run("fpmExplicit", "-dryRun")
        added = float(re.search(r"^mass scaling: .* \((\S+) %\)", scaled, re.M).group(1))
        marks.against("mass added", added, float(mass), 0.02, "%")
        ratio = float(re.search(r"elements alone (\S+),", scaled).group(1)) / plain
        marks.against("step gained", ratio, float(saves), 0.02)
