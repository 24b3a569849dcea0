"""Hertz: a cylinder on a block (tutorials/hertz), a half ball on a rigid plane."""

import math
import subprocess

from driver.caseRun import CaseRun
from driver.chart import rows
from driver.curves import readTable
from driver.gmshFile import quarterSphere
from driver.scene import Scene, elastic
from driver.spheres import SETS, SYMMETRIES

HALF_WIDTH, PRESSURE = 6.2146, 3585.4


def run(binaries, size, blockSize=None):
    """The tutorial with elements of the given size in the contact."""
    case = CaseRun("tutorials/hertz", binaries)
    mesh = subprocess.run([case.root / "makeMesh", str(size), str(blockSize or size)], text=True,
                          capture_output=True, check=True)
    (case.root / "slab.msh").write_text(mesh.stdout)
    case.mesh()
    case.solve("-backend", "serial")
    case.run("fpmProbe", "-tables")
    return case


def pressures(case, size):
    """(x, pressure) of the front row of nodes: its force over 0.25 x size, half of that at x = 0."""
    path = next((case.root / "postProcessing/pressure").iterdir()) / "FCONT.dat"
    table = readTable(path)
    return [(x, f / (0.25 * size * (0.5 if x == 0 else 1)))
            for x, f in zip(table["x"], table["FCONT_z"]) if x < 9 - size / 2]


def fitted(points):
    """p^2 = p0^2 (1 - x^2 / a^2), least squares over the inner nodes: p0 and a."""
    data = [(x * x, p * p) for x, p in points if x < 0.9 * HALF_WIDTH]
    n, sx, sy = len(data), sum(x for x, _ in data), sum(y for _, y in data)
    slope = ((n * sum(x * y for x, y in data) - sx * sy)
             / (n * sum(x * x for x, _ in data) - sx * sx))
    top = (sy - slope * sx) / n
    return math.sqrt(top), math.sqrt(-top / slope)


def judge(binaries, marks, name, size, blockSize=None, nodes=0.05):
    with run(binaries, size, blockSize) as case:
        points = pressures(case, size)
        p0, a = fitted(points)
        marks.against(f"F2 cylinder, {name}: p0", p0, PRESSURE, 0.05, "MPa")
        marks.against("half width", a, HALF_WIDTH, size / HALF_WIDTH, "mm")
        last = max(x for x, p in points if p > 0)
        marks.within("outermost node in contact", last, HALF_WIDTH - size, HALF_WIDTH + size, " mm")
        worst = max(abs(p - PRESSURE * math.sqrt(1 - (x / HALF_WIDTH) ** 2)) / PRESSURE
                    for x, p in points if x < HALF_WIDTH - size)
        marks.below("largest deviation of a node", worst, nodes)
        force = case.table("contactForces/0/cylinderBlock.dat")
        rest = [abs(f) for f in force["fz"][-20:]]
        marks.below("unrest of the force", (max(rest) - min(rest)) / rest[-1], 0.005)
        marks.against("force", rest[-1], 8750, 0.005, "N")


def cylinder(binaries, marks):
    judge(binaries, marks, "0.6 mm", 0.6)


def cylinderFine(binaries, marks):
    judge(binaries, marks, "0.5 mm", 0.5)
    judge(binaries, marks, "0.4 on 0.5 mm", 0.4, 0.5, 0.15)


def order(binaries, marks):
    """Chart `order` of the tutorial: observed order of the pressure between 1, that of the edge of the
    contact where it falls like a root, and 2, that of the inside."""
    with CaseRun("tutorials/hertz", binaries) as case:
        subprocess.run([case.root / "makeMeshes"], check=True)
        case.run("fpmChart", "-chart", "order")
        found = rows(case, "order")
        marks.true("no run failed", [row["state"] for row in found] == ["ok"] * 3)
        for coarse, fine, size in zip(found, found[1:], ("1 to 0.5 mm", "0.5 to 0.25 mm")):
            marks.within(f"F2 order of the pressure, {size}", float(fine["pressure.order"]), 0.9, 2.2)
            marks.true("finer is better", float(fine["pressure.L2"]) < float(coarse["pressure.L2"]))
        marks.below("error of the pressure, 0.25 mm", float(found[-1]["pressure.L2"]), 0.01)


# Code_Aster SSNV104: ball of radius 50 mm, E 20 GPa, nu 0.3, its far plane moved by 2 mm.

def squeezed(binaries, core, rings):
    """A quarter of the lower half ball on a rigid plane."""
    return Scene(
        binaries,
        bodies='ball { type file; file "ball.msh"; }',
        files={"ball.msh": quarterSphere("ball", 50.0, core, rings, True).text()},
        sets=SETS + "far { type plane; point (0 0 0); normal (0 0 1); }",
        parts=elastic("ball", 20000, 0.3, 8e-9),
        conditions=SYMMETRIES
                   + "press { type displacement; set far; value (0 0 -2); components (z); "
                   "amplitude smooth ((0 0) (4e-4 1)); }",
        surfaces="low { part ball; within box ((-1 -1 -51) (20 20 -44)); }\n"
                 "floor { type plane; point (0 0 -50); normal (0 0 1); }",
        pairs="ballFloor { contactor low; target floor; enforcement penalty; normalScale 5; }",
        control="massDamping 2e4; timeStep { contactLimit 0.8; }",
        end=6e-4, rows=300,
        tables="s { type extrema; field S; component ZZ; part ball; }").all()


def ball(binaries, marks):
    # E / (1 - nu^2), a = sqrt(R d), F = 4/3 E* sqrt(R) d^1.5, p0 = 3 F / (2 pi a^2).
    star = 20000 / (1 - 0.09)
    force = 4 / 3 * star * math.sqrt(50) * 2**1.5
    pressure = 3 * force / (2 * math.pi * 100)
    core, rings = 10, 8
    with squeezed(binaries, core, rings) as case:
        f = [4 * abs(x) for x in case.contact("ballFloor")["fz"]]
        marks.against("F2 half ball: force", f[-1] / 1e3, force / 1e3, 0.05, "kN")
        rest = f[-20:]
        marks.below("unrest", (max(rest) - min(rest)) / rest[-1], 0.005)
        # Stress of the lowest element on the axis, in its middle: less than at the surface.
        marks.against("largest pressure in an element", -case.probed("s", "S")["min"][-1], pressure,
                      0.14, "MPa")
        marks.below("hourglass / internal", case.hourglassShare(), 0.05)
