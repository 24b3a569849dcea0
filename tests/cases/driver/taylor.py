"""Taylor bar: a copper cylinder strikes a rigid wall at 227 m/s (tutorials/taylorBar)."""

from driver.caseRun import PROJECT, CaseRun
from driver.curves import readTable, relativeL2

# Independent axisymmetric program (B-bar), converged: length 21.475, radius of the foot 7.358 mm.
LENGTH, RADIUS = 21.475, 7.358


def run(binaries, core, rings, axial, selective=False, friction=0):
    case = CaseRun("tutorials/taylorBar", binaries)
    if selective:
        case.replace("constant/partProperties", r"^(?= *bulkViscosity )", "hexahedron selective;\n")
    if friction:
        case.replace("system/contactDict", r"friction +0;", f"friction {friction};")
    case.replace("system/meshDict", r"core +\d+;", f"core {core};")
    case.replace("system/meshDict", r"rings +\d+;", f"rings {rings};")
    case.replace("system/meshDict", r"axial +\d+;", f"axial {axial};")
    case.mesh()
    case.solve("-backend", "serial")
    return case


def measure(case):
    """Length, radius of the foot, the largest plastic strain comes from fpmProbe."""
    top, foot = case.table("top/0/displacement.dat"), case.table("foot/0/displacement.dat")
    return 32.4 + top["uz"][-1], 3.2 + foot["ux"][-1]


PROGRAMS = {1: "OpenRadioss, 1 point, viscous", 18: "OpenRadioss, 8 points"}


def others(n):
    """Length and radius of the same mesh in other programs."""
    table = readTable(PROJECT / "tests/reference/taylorBar/openRadioss.csv")
    return {PROGRAMS[int(kind)]: (length, radius) for kind, size, length, radius in zip(
        table["isolid"], table["n"], table["length"], table["radius"])
        if size == n and kind in PROGRAMS}


def judge(binaries, marks, core, rings, axial, programs=None, selective=False):
    with run(binaries, core, rings, axial, selective) as case:
        length, radius = measure(case)
        name = f"E1 {core + rings} elements on the radius" + (", eight points" if selective else "")
        marks.against(f"{name}: length", length, LENGTH, 0.015, "mm")
        marks.within("length", length, 21.2, 21.8, " mm")
        marks.against("radius", radius, RADIUS, 0.02, "mm")
        for program, (theirLength, theirRadius) in (programs or {}).items():
            marks.against(f"length, {program}", length, theirLength, 0.01, "mm")
            # The same mesh in another program: no further from the converged radius.
            off = abs(theirRadius - RADIUS)
            marks.within(f"radius, {program} {theirRadius:.4g}", radius, RADIUS - off, RADIUS + off,
                         " mm")
        marks.below("energy balance", case.worstBalance(), 0.01)
        energies = case.table("energies/0/energies.dat")
        marks.below("hourglass / internal energy",
                    max(abs(h) for h in energies["hourglass"]) / max(energies["internal"]), 0.05)
        marks.within("plastic work / kinetic energy", energies["plastic"][-1]
                     / energies["kinetic"][0], 0.96, 1.0)
        theirs = readTable(PROJECT / "tutorials/taylorBar/reference/axisymmetric.csv")
        top = case.table("top/0/displacement.dat")
        marks.below("history of the length", relativeL2(
            top["time"], [32.4 + u for u in top["uz"]], theirs["t"], theirs["length"]), 0.01)


def quick(binaries, marks):
    judge(binaries, marks, 4, 4, 64, others(4))


def friction(binaries, marks):
    """On a rough wall: the default element beside that with eight points, which no hourglass control
    holds back, on the same mesh."""
    with run(binaries, 3, 3, 48, True, 0.2) as case:
        theirs = measure(case)
    with run(binaries, 3, 3, 48, False, 0.2) as case:
        ours = measure(case)
    for name, value, other in zip(("length", "radius"), ours, theirs):
        marks.against(f"E1 friction 0.2, 6 elements on the radius: {name}", value, other, 0.01, "mm")


def tutorial(binaries, marks):
    judge(binaries, marks, 5, 5, 50)


def selective(binaries, marks):
    """Eight points, twice as many elements along the axis."""
    judge(binaries, marks, 5, 5, 100, selective=True)
