"""fpmAdvise: what it finds in whole models, and reduced cases beside the whole ones."""

import hashlib
import math
import re
import shutil

from driver.caseRun import CaseRun
from driver.curves import readTable
from driver.scene import Scene, plastic

COMMAND_LINE = 2  # exit code


def wholePlate(binaries, cells, rod, axial, end, interval, friction, law=""):
    """tutorials/plateImpact with variants/full laid over it: before it was cut to a quarter."""
    case = CaseRun("tutorials/plateImpact", binaries)
    shutil.copytree(case.root / "variants/full", case.root, dirs_exist_ok=True)
    for pattern, text in (
            (r"cells +\(100 100 1\);", f"cells ({cells} {cells} 1);"),
            (r"core +2;", f"core {rod};"), (r"rings +2;", f"rings {rod};"),
            (r"axial +20;", f"axial {axial};")):
        case.replace("system/meshDict", pattern, text)
    case.replace("system/contactDict", r"friction +0.1;", f"friction {friction}; {law}", 3)
    for key, value in (("endTime", end), ("historyInterval", interval), ("writeInterval", end)):
        case.replace("system/controlDict", rf"^{key} .*", f"{key} {value!r};")
    case.replace("system/controlDict", r"openmp;", "serial;")
    case.mesh()
    return case


def inputs(case):
    """What a case is, without logs and locks: a checksum a file."""
    return {str(p.relative_to(case.root)): hashlib.sha256(p.read_bytes()).hexdigest()
            for p in case.root.rglob("*")
            if p.is_file() and not p.name.startswith(("log.", ".")) and p.name != "status"}


def reduced(case, kinds, *options):
    """The case that -apply writes, run; and what fpmAdvise said."""
    before = inputs(case)
    said = case.run("fpmAdvise", *options, "-apply", kinds, "-to", str(case.root.parent / "less"))
    other = CaseRun.__new__(CaseRun)
    other.binaries, other.root = case.binaries, case.root.parent / "less"
    if inputs(case) != before:
        raise AssertionError("fpmAdvise changed the case itself")
    other.solve()
    return other, said


def apart(whole, part, factor, skip):
    """Largest relative L2 of the columns of all histories: resultants times `factor`, of vectors
    measured by the largest component. `skip`: components across the planes. Not numbers of
    contactors, nor their depths: a mean over nodes, and that of one node.
    A row is taken at the first step at or after its time: where a step ends within rounding of that
    time, one of the runs takes the next. Such rows, one in a hundred at most, are left out."""
    worst = (0.0, "nothing")
    for file in sorted((whole.root / "postProcessing").rglob("*.dat")):
        if file.stem == "health":  # texts
            continue
        name = file.relative_to(whole.root / "postProcessing")
        a, b = readTable(file), readTable(part.root / "postProcessing" / name)
        if len(a["time"]) != len(b["time"]):
            return 1.0, f"{name}: {len(a['time'])} and {len(b['time'])} rows"
        spacing = (a["time"][-1] - a["time"][0]) / max(1, len(a["time"]) - 1)
        rows = [i for i, (s, t) in enumerate(zip(a["time"], b["time"])) if abs(s - t) < 1e-3 * spacing]
        if len(rows) < 0.99 * len(a["time"]):
            return 1.0, f"{name}: rows at other times"
        for column in a:
            if column in ("balance", "active", "maxDepth", "meanDepth", "travel"):
                continue
            if column[-1] in skip and len(column) == 2:
                continue
            times = factor if column in ("fx", "fy", "fz") and "reaction" not in str(name) else 1
            if name.parts[0] == "energies" and column not in ("time", "kineticShare"):
                times = factor
            kin = [c for c in a if c[:-1] == column[:-1]] if len(column) == 2 else [column]
            size = max(math.hypot(*a[c]) for c in kin)
            if size > 0:
                error = math.hypot(*(a[column][i] - times * b[column][i] for i in rows)) / size
                worst = max(worst, (error, f"{name} {column}"))
    return worst


def plate(binaries, marks):
    """A coarse plate over its first impacts: longer, and the roundings of its loose layers, a few
    contactors in contact at a time, grow to anything."""
    with wholePlate(binaries, 12, 1, 4, 1e-6, 0, 0.1) as case:
        quarter, said = reduced(case, "symmetry,elastic,friction", "-pilot", "1")
        marks.true("both planes are found", "mirror planes x = 0, y = 0: the quarter" in said)
        marks.true("its saving is stated", "75 % of the element-steps" in said)
        marks.true("the rod stays elastic", "part rod stays elastic" in said)
        pairs = re.findall(r"friction of pair (\w+) does no work", said)
        marks.true(f"friction without work: {' '.join(pairs)}",
                   "layer2Layer1" in pairs and "layer3Layer2" in pairs)
        marks.true("the README tells what to multiply",
                   "multiply energies by 4" in (quarter.root / "README.md").read_text())
        again = case.start("fpmAdvise", "-apply", "symmetry", "-to", str(quarter.root))
        marks.true("an existing folder is refused", again.returncode == COMMAND_LINE)
        again = case.start("fpmAdvise", "-apply", "damping", "-to", str(case.root.parent / "none"))
        marks.true("so is what nothing was found of", again.returncode == COMMAND_LINE)
    for friction in (0, 0.1):
        with wholePlate(binaries, 12, 1, 4, 5e-5, 5e-7, friction) as case:
            case.solve()
            quarter, _ = reduced(case, "symmetry,elastic")
            error, name = apart(case, quarter, 4, "xy")
            marks.true(f"friction {friction}: quarter plate beside the whole, worst {name}: "
                       f"{error:.2g} (< 1e-06)", error < 1e-6)


def block(binaries):
    """A block thrown askew along y onto a rough plane, pressed in equal shares on its top nodes and
    drawn to both sides: symmetric about x = 0 alone. Nodes of the plane meet no tie of two faces."""
    return Scene(
        binaries, bodies="block { type box; origin (-10 0 0); size (20 12 12); cells (8 5 5); }",
        parts=plastic("block", 70000, 0.3, 2.7e-9, 285, 900, rotation="polar"),
        conditions="press { type force; set block.zMax; value (0 0 -2e4); components (z); "
                   "amplitude table ((0 0) (1e-5 1)); }\n"
                   "left { type traction; set block.xMin; value (-20 0 0); }\n"
                   "right { type traction; set block.xMax; value (20 0 0); }",
        initial="fall { type velocity; part block; value (0 2e4 -6e4); }",
        pairs="floor { contactor block.zMin; target floor; friction 0.2; }",
        surfaces="floor { type plane; point (0 0 0); normal (0 0 1); }",
        functions="corner { type point; part block; position (-10 12 12); "
                  "fields (displacement velocity); }\n"
                  "floorForce { type reaction; surface floor; }",
        end=2e-5, rows=100)


def blocks(binaries, marks):
    with block(binaries) as case:
        case.all()
        half, said = reduced(case, "symmetry")
        marks.true("one plane is found", "mirror plane x = 0: the half" in said)
        conditions = (half.root / "constant/boundaryConditions").read_text()
        marks.true("nodes of the plane bear half", "press0" in conditions and "press1" in conditions)
        marks.true("what lay on the other side is gone", "/* right" in conditions)
        error, name = apart(case, half, 2, "x")
        marks.true(f"half block beside the whole, worst {name}: {error:.2g} (< 1e-06)", error < 1e-6)
    for what, file, pattern, text in (
            ("load", "constant/boundaryConditions", r"value \(20 0 0\)", "value (21 0 0)"),
            ("velocity", "0/initialConditions", r"\(0 2e4 -6e4\)", "(1 2e4 -6e4)")):
        with block(binaries) as case:
            case.replace(file, pattern, text)
            case.mesh()
            said = case.run("fpmAdvise")
            marks.true(f"an asymmetric {what}: no plane",
                       "no mirror plane x = 0" in said and "symmetry:" not in said)


def measured(binaries, marks):
    """-measure finds the same error as our comparison does, and leaves nothing behind."""
    with block(binaries) as case:
        case.replace("constant/partProperties", "rotation polar;",
                     "rotation polar; hourglass { form stiffness; coefficient 0.05; }")
        case.mesh()
        said = case.run("fpmAdvise", "-measure")
        half = re.search(r"^symmetry: .*?(?=^\w+: )", said, re.M | re.S).group(0)
        errors = [float(x) for x in re.findall(r"corner/displacement\.u[yz] differs by (\S+)", half)]
        marks.true("errors of the half block below 1e-06", errors and max(errors) < 1e-6)
        marks.true("no promise of equal results", "rounding only" not in said
                   and "friction that slips on one side first" in said)
        most = re.search(r"measured: no history differs by more than (\S+)", half)
        marks.true("the measured difference is given", most and float(most.group(1)) < 1e-6)
        marks.true("an elastic hourglass stiffness in a part that may yield",
                   "part block: hourglass form physical, plastic coupled" in said)
        marks.true("time before and after", re.search(r"time \S+ s -> \S+ s of the processors", said) is not None)
        marks.true("no results in the case", not (case.root / "postProcessing").exists())


def check(binaries, marks):
    plate(binaries, marks)
    blocks(binaries, marks)
    measured(binaries, marks)


def tutorial(binaries, marks):
    """The plate of variants/full, without friction and with it, and its quarter, over all of its
    0.4 ms."""
    for friction in (0, 0.1):
        with wholePlate(binaries, 100, 2, 20, 4e-4, 1e-6, friction, "tangentialScale 0.1;") as case:
            case.solve()
            seconds = case.performance()["wallSeconds"]
            quarter, said = reduced(case, "symmetry,elastic")
            marks.true("both planes are found",
                       "mirror planes x = 0, y = 0: the quarter" in said)
            error, name = apart(case, quarter, 4, "xy")
            told = f"friction {friction}: quarter plate beside the whole, worst {name}"
            marks.true(f"{told}: {error:.2g} (< 1e-06)", error < 1e-6)
            marks.figure("seconds", f"{seconds:.3g} -> {quarter.performance()['wallSeconds']:.3g}")
