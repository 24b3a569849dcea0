"""Sick runs find fault with themselves, each with its own finding and no other; sound ones do not."""

from driver.record import readRecord
from driver.scene import Scene, elastic, plastic

STEEL = ("210000", "0.3", "7.85e-9")
UNHEALTHY = 11  # exit code of fpmExplicit -strict
STOPPED = 10    # of a run that stops by itself


def box(name, origin, size, cells):
    text = " ".join
    return (f"{name} {{ type box; origin ({text(map(repr, origin))}); "
            f"size ({text(map(repr, size))}); cells ({text(map(str, cells))}); }}\n")


def steel(*names, more=""):
    return "".join(elastic(name, *STEEL, more=more) for name in names)


def rowsOf(case):
    """The figures of postProcessing/health/0/health."""
    return readRecord(case.root / "postProcessing/health/0/health")["figures"]


def findings(case):
    return [row["figure"] for row in rowsOf(case) if row["verdict"] == "finding"]


# Findings on a run as a whole; all others have a time.
TIMELESS = ("mass added by scaling / own mass", "bodies that nothing moves, loads or touches")


def judged(marks, name, scene, expected):
    """Runs a scene; its findings are those expected and no others. Returns its log."""
    with scene as case:
        case.mesh()
        done = case.start("fpmExplicit", "-strict", "-threads", "1")
        found = findings(case)
        marks.true(f"{name}: {', '.join(expected) or 'healthy'}", found == expected)
        if found != expected:
            marks.failures.append(f"{name}: found {found}\n{done.stdout[-3000:]}")
        for row in rowsOf(case):
            if row["verdict"] == "finding" and not (
                    row["advice"] and ("time" in row or row["figure"] in TIMELESS)):
                marks.failures.append(f"{name}: no time or no advice: {row}")
        code = UNHEALTHY if expected else 0
        marks.true(f"exit {code}", done.returncode == code)
        if done.returncode != code:
            marks.failures.append(f"{name}: exit {done.returncode}\n{done.stdout[-1500:]}")
        return done.stdout


def cantilever(binaries, form):
    """One element thick under a load at its tip; beam theory -1.90 mm, `stiffness` -3.18 mm."""
    return Scene(binaries, bodies=box("a", (0, 0, 0), (100, 10, 10), (10, 1, 1)),
                 parts=steel("a", more=f"hourglass {{ form {form}; }}"), end=4e-3, rows=200,
                 sets="tip { type point; position (100 10 10); }",
                 conditions="f { type fixed; set a.xMin; } l { type force; set tip; "
                 "value (0 0 -1000); amplitude smooth ((0 0) (3e-3 1)); }",
                 control="massDamping 2e3;")


def hourglass(binaries, marks):
    """Energy of spurious modes is a finding; that of real bending is internal energy."""
    name = "hourglass / internal energy"
    judged(marks, "cantilever, stiffness", cantilever(binaries, "stiffness"), [name])
    judged(marks, "cantilever, viscous", cantilever(binaries, "viscous"), [name])
    judged(marks, "cantilever, physical", cantilever(binaries, "physical"), [])

    def corner(cells, more="", rotation="midSurface"):
        return Scene(binaries, bodies=box("a", (0, 0, 0), (10, 10, 10), (cells, cells, cells)),
                     parts=elastic("a", *STEEL, more=more, rotation=rotation), end=4e-5, rows=100,
                     sets="tip { type point; position (10 10 10); }",
                     conditions="f { type fixed; set a.zMin; } l { type force; set tip; "
                     "value (0 0 -1000); amplitude smooth ((0 0) (1e-5 1)); }")
    judged(marks, "corner of one element", corner(1), [name])
    judged(marks, "cured by eight points", corner(1, "hexahedron selective;", "hughesWinget"), [])
    judged(marks, "cured by more elements", corner(2), [])


def ledger(binaries, marks):
    """A strip bent beyond yield: plastic work of bending is a part of the internal energy."""
    strip = Scene(binaries, bodies=box("a", (0, 0, 0), (100, 10, 2), (20, 2, 1)),
                  parts=plastic("a", 70000, 0.3, "2.7e-9", 285, 900), end=2e-3,
                  rows=100, control="massDamping 500;",
                  conditions="f { type fixed; set a.xMin; } d { type displacement; set a.xMax; "
                  "value (0 0 -40); components (z); amplitude smooth ((0 0) (2e-3 1)); }")
    with strip as case:
        case.all()
        energies = case.energies()
        rows = range(len(energies["time"]))
        marks.true("plastic work is never more than internal energy", all(
            energies["plastic"][i] <= energies["internal"][i] * (1 + 1e-9) + 1e-12 for i in rows))
        marks.within("plastic / internal", energies["plastic"][-1] / energies["internal"][-1],
                     0.7, 1)
        marks.below("hourglass / internal", case.hourglassShare(), 0.01)
        marks.true("healthy", findings(case) == [])


def wires(binaries, contact, cells=12):
    """Two wires, one of which falls on the other between its nodes: edges cross, no node enters."""
    return Scene(binaries, bodies=box("low", (0, 0, 0), (60, 1, 1), (cells, 1, 1))
                 + box("high", (32, -28, 1.2), (1, 60, 1), (1, cells, 1)),
                 parts=steel("low", "high"), end=3e-4, rows=100,
                 conditions="f { type fixed; part low; }",
                 initial="v { type velocity; part high; value (0 0 -5000); }",
                 files={"system/contactDict": contact})


def edges(binaries, marks):
    name = ["edges that pass through the other surface / width of a face"]
    log = judged(marks, "wires, general", wires(binaries, "general { edges no; }\n"), name)
    marks.true("told before a frame is written", "parts low and high: at time" in log
               and float(log.split("parts low and high: at time")[1].split()[0]) < 2.9e-4)
    pair = "pairs {{ p {{ contactor high; target low; passes two; {} }} }}\n"
    judged(marks, "wires, pair", wires(binaries, pair.format("")), name)
    judged(marks, "cured by contact of edges", wires(binaries, pair.format("edges yes;")), [])
    judged(marks, "cured by general contact", wires(binaries, "general;\n"), [])
    judged(marks, "cured by elements as small as the other wire",
           wires(binaries, "general { edges no; }\n", cells=60), [])


BLOCK = box("a", (0, 0, 0), (20, 10, 10), (4, 2, 2))
PULL = "pull { type force; set a.xMax; value (100 0 0); amplitude smooth ((0 0) (2e-4 1)); }"
HOLD = "f { type fixed; set a.xMin; } "
GENERAL = {"system/contactDict": "general;\n"}


def rest(binaries, marks):
    """What has to come to rest or to move slowly, and does not."""
    def relaxed(conditions, end, tolerance):
        return Scene(binaries, bodies=BLOCK, parts=steel("a"), end=end, rows=100,
                     conditions=conditions,
                     control=f"dynamicRelaxation {{ tolerance {tolerance}; }}")
    judged(marks, "unsupported", relaxed(PULL, 2e-3, 1e-3),
           ["rigid motion / kinetic energy, nothing holds it"])
    judged(marks, "cured by a support", relaxed(HOLD + PULL, 2e-3, 1e-3), [])
    judged(marks, "not at rest", relaxed(HOLD + PULL, 2e-5, 1e-6),
           ["dynamic relaxation: force out of balance"])
    judged(marks, "cured by a later end", relaxed(HOLD + PULL, 2e-3, 1e-6), [])

    def stretched(ramp, end, control):
        return Scene(binaries, bodies=BLOCK, parts=steel("a"), end=end, rows=100, control=control,
                     conditions=HOLD + "d { type displacement; set a.xMax; value (0.1 0 0); "
                     f"components (x); amplitude smooth ((0 0) ({ramp} 1)); }}")
    judged(marks, "too fast for quasi-static", stretched(5e-6, 2e-5, "quasiStatic { }"),
           ["kinetic energy / energy of the elements"])
    judged(marks, "cured by a slower load", stretched(5e-4, 5e-4, "quasiStatic { }"), [])


def bodies(binaries, marks):
    """Bodies that are left out of everything, or of contact."""
    def idle(files):
        return Scene(binaries, bodies=BLOCK + box("b", (0, 0, 50), (5, 5, 5), (1, 1, 1)),
                     parts=steel("a", "b"), end=2e-5, rows=20, conditions=HOLD + PULL, files=files)
    judged(marks, "nothing moves it", idle({}), ["bodies that nothing moves, loads or touches"])
    judged(marks, "cured by contact", idle(GENERAL), [])

    def through(files):
        return Scene(binaries, bodies=BLOCK + box("b", (21, 1, 1), (8, 8, 8), (3, 3, 3)),
                     parts=steel("a", "b"), end=1e-4, rows=20, conditions=HOLD, files=files,
                     initial="v { type velocity; part b; value (-50000 0 0); }")
    # One row for the nodes of each body inside the other.
    judged(marks, "no pair between", through({}),
           ["nodes inside a body with which there is no contact"] * 2)
    judged(marks, "cured by general contact", through(GENERAL), [])


def mass(binaries, marks):
    """A free impact of scaled mass: a hundred times the energy and momentum."""
    def impact(control):
        return Scene(binaries, bodies=box("a", (0, 0, 0), (10, 10, 10), (3, 3, 3))
                     + box("b", (0, 0, 10.1), (10, 10, 10), (3, 3, 3)), parts=steel("a", "b"),
                     end=6e-5, rows=60, control=control, conditions="f { type fixed; set a.zMin; }",
                     initial="v { type velocity; part b; value (0 0 -5000); }",
                     pairs="p { contactor b.zMin; target a.zMax; }")
    judged(marks, "scaled impact", impact("massScaling { factor 100; }"),
           ["mass added by scaling / own mass"])
    judged(marks, "impact", impact(""), [])


def pressed(binaries, law, way, end=4e-4, control="massDamping 2e4;"):
    """A block driven into another."""
    return Scene(binaries, bodies=box("a", (0, 0, 0), (10, 10, 10), (3, 3, 3))
                 + box("b", (2, 2, 10), (6, 6, 6), (3, 3, 3)), parts=steel("a", "b"), end=end,
                 rows=80, control=control,
                 conditions="f { type fixed; set a.zMin; } d { type displacement; set b.zMax; "
                 f"value (0 0 {-way}); components (x y z); amplitude smooth ((0 0) ({end} 1)); }}",
                 pairs=f"p {{ contactor b.zMin; target a.zMax; {law} }}")


def balance(binaries, marks):
    """A block bounces on springs for which the step is too long."""
    def bounce(limit):
        return Scene(binaries, bodies=box("a", (0, 0, 0), (10, 10, 10), (3, 3, 3)),
                     parts=steel("a"), end=2e-5, rows=100,
                     control=f"timeStep {{ contactLimit {limit}; }}",
                     initial="v { type velocity; part a; value (0 0 -1000); }",
                     pairs="p { contactor a.zMin; target f; enforcement penalty; "
                           "normalScale 4; }",
                     surfaces="f { type plane; point (0 0 -0.01); normal (0 0 1); }")
    judged(marks, "step too long for contact", bounce(1.5), ["energy balance error"])
    judged(marks, "cured by a smaller contactLimit", bounce(0.5), [])


def falseAlarms(binaries, marks):
    """What is sound ends healthy and without a warning."""
    log = judged(marks, "far apart", Scene(
        binaries, bodies=box("a", (0, 0, 0), (1, 1, 1), (2, 2, 2))
        + box("b", (1e6, 0, 0), (1, 1, 1), (2, 2, 2)), parts=steel("a", "b"), end=1e-5, rows=50,
        initial="v { type velocity; part b; value (1000 0 0); }",
        files={"system/contactDict": "general;\n"}), [])
    marks.true("no warning", "warning" not in log)

    # Nodes of the support bear the beam; its edges are no deeper between theirs than the springs are.
    judged(marks, "beam across a support", Scene(
        binaries, bodies=box("s", (0, 0, 0), (4, 1, 1), (8, 2, 2))
        + box("b", (1, -10, 1), (2, 21, 1), (4, 3, 1)), parts=steel("s", "b"), end=1e-4, rows=50,
        conditions="f { type fixed; set s.zMin; } g { type force; set b.zMax; value (0 0 -20); "
        "distribution area; amplitude smooth ((0 0) (1e-4 1)); }", control="massDamping 2e4;",
        files=GENERAL), [])

    def punch(passes):
        return Scene(binaries, bodies=box("a", (0, 0, 0), (12, 12, 6), (3, 3, 3))
                     + box("b", (4.5, 4.5, 6.05), (3, 3, 6), (6, 6, 12)), parts=steel("a", "b"),
                     end=3e-5, rows=50, conditions="f { type fixed; set a.zMin; }",
                     initial="v { type velocity; part b; value (0 0 -5000); }",
                     pairs=f"p {{ contactor a; target b; passes {passes}; }}")
    with punch("two") as case:
        case.run("fpmMesh")
        marks.true("two passes meet: no warning", "warning" not in case.run("fpmSetContact"))
        case.solve()
        marks.true("and touch", max(case.contact("p")["active"]) > 0)
        marks.true("healthy", findings(case) == [])
    with punch("one") as case:
        case.run("fpmMesh")
        marks.true("one pass: the cure is named",
                   "swap contactor and target, or set passes two" in case.run("fpmSetContact"))


def friction(binaries, marks):
    """A block dragged over a plane without damping of its friction: it chatters and delivers 0.85
    of Coulomb's; by default 1.00. See also frictionArrives."""
    judged(marks, "chatter", dragged(binaries, "friction { static 0.3; damping 0; }"),
           ["friction while sliding / friction of Coulomb"])
    judged(marks, "by default", dragged(binaries, "friction 0.3;"), [])


def dragged(binaries, friction, fine=1, onMesh=False):
    """A steel block under 1000 N, led by one end at 0.2 m/s over a rigid plane or a steel plate."""
    plate = box("t", (-5, -5, -5), (35, 20, 5), (13, 7, 2)) if onMesh else ""
    return Scene(binaries, bodies=box("a", (0, 0, 0), (20, 10, 10), (8 * fine, 4 * fine, 4 * fine))
                 + plate, parts=steel("a", "t") if onMesh else steel("a"), end=2.5e-3 / fine,
                 rows=2000, conditions="n { type force; set a.zMax; value (0 0 -1000); distribution"
                 " area; amplitude smooth ((0 0) (3e-4 1)); } drag { type velocity; set a.xMin; "
                 "value (200 0 0); components (x); amplitude smooth ((0 0) (5e-4 0) (8e-4 1)); }"
                 + ("h { type fixed; set t.zMin; }" if onMesh else ""),
                 pairs=f"p {{ contactor a.zMin; target {'t.zMax' if onMesh else 'f'}; "
                       f"{'' if onMesh else 'enforcement penalty; '}{friction} }}",
                 surfaces="" if onMesh else "f { type plane; point (0 0 0); normal (0 0 1); }")


def frictionArrives(binaries, marks):
    """Steady sliding of an elastic body delivers Coulomb's friction: on two meshes, over a plane
    and over a mesh."""
    for name, fine, onMesh in (("2.5 mm", 1, False), ("1.25 mm", 2, False), ("on a mesh", 1, True)):
        with dragged(binaries, "friction 0.3;", fine, onMesh) as case:
            case.mesh()
            case.solve()
            f = case.contact("p")
            rows = [row for row, time in enumerate(f["time"]) if time > 1e-3]
            along, normal = (sum(abs(f[c][row]) for row in rows) for c in ("fx", "fz"))
            marks.against(f"{name}: friction / normal force", along / normal, 0.3, 0.02)
            marks.below(f"{name}: energy balance", case.worstBalance(), 1e-3)


def stops(binaries, marks):
    """A run that stops: the series ends with the last good state, the lost one lies in failed/."""
    crushed = Scene(binaries, bodies=box("a", (0, 0, 0), (10, 10, 10), (2, 2, 2)),
                    parts=steel("a"), end=1e-3, rows=100, frames=100,
                    conditions="f { type fixed; set a.zMin; } d { type displacement; set a.zMax; "
                    "value (0 0 -15); components (z); amplitude smooth ((0 0) (1e-3 1)); }")
    with crushed as case:
        case.mesh()
        done = case.start("fpmExplicit", "-threads", "1")
        marks.true("it stops by itself", done.returncode == STOPPED)
        status = case.status()
        marks.true("status failed", status["state"] == "failed")
        series = (case.root / "case.vtkhdf.series").read_text()
        last = max(float(p.parent.name) for p in case.root.glob("*/fields.vtkhdf")
                   if p.parent.name != "failed")
        marks.true("the last frame is before the stop", 0 < last < float(status["time"]))
        marks.true("failed/ is no frame", "failed" not in series
                   and (case.root / "failed/fields.vtkhdf").exists())
        marks.true("the cause is kept",
                   (case.root / "why.txt").read_text().strip() in done.stdout)
        marks.true("the health of a stopped run is reported", bool(rowsOf(case)))


def ramp(binaries, marks):
    """A smooth ramp begins with energies of 1e-16, which are rounded to a few per cent."""
    with pressed(binaries, "normalDamping 0.1;", 0.02, end=1e-2, control="") as case:
        case.replace("system/controlDict", r"^historyInterval .*;", "historyInterval 0;")
        case.mesh()
        log = case.run("fpmExplicit", "-maxSteps", "400")
        energies = case.energies()
        error = [abs(t - x) for t, x in zip(energies["total"], energies["external"])]
        most, worst = 0.0, 0.0
        for row, of in enumerate(error):
            most = max(most, energies["kinetic"][row], energies["internal"][row],
                       abs(energies["external"][row]))
            worst = max(worst, of / most if row > 10 else 0)
        marks.within("worst error over the energies so far", worst, 0.01, 10)
        marks.below("balance", case.worstBalance(), 1e-3)
        marks.true("no warning, healthy", "warning" not in log and findings(case) == [])


def histories(binaries, marks):
    """Energies are kept without being asked for, every table names its units."""
    with pressed(binaries, "", 0.02) as case:
        case.replace("system/controlDict", r"^energies \{ type energies; \}$", "")
        case.mesh()
        case.solve()
        energies = case.root / "postProcessing/energies/0/energies.dat"
        lines = energies.read_text().splitlines()
        marks.true("units of the energies", lines[1].startswith("# unit s mJ mJ"))
        marks.true("names of the energies", lines[2].startswith("# time kinetic internal"))
        force = case.contact("p")
        marks.true("depths", max(force["maxDepth"]) >= max(force["meanDepth"]) > 0)
        marks.true("units of the force", (case.root / "postProcessing/contactForces/0/p.dat")
                   .read_text().splitlines()[1] == "# unit s N N N - mm mm")
