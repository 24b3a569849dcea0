"""Elastic wave in a bar against d'Alembert's solution (tutorials/bar)."""

from driver.caseRun import CaseRun
from driver.curves import readTable, relativeL2

# Measured with 100 and 200 cells: 3.0 and 0.83 %, a 3.6th for half the cell size (the dispersion of
# second order, on its way to a quarter). The marks lie a third and a fifth above.
MARKS = {100: 0.04, 200: 0.01}


def measure(binaries, cells):
    """Relative L2 of the velocity at the middle and the free end over four passages; balance."""
    with CaseRun("tutorials/bar", binaries) as case:
        across = max(1, cells // 50)
        case.replace("system/meshDict", r"cells \(100 2 2\)", f"cells ({cells} {across} {across})")
        case.mesh()
        case.solve()
        exact = readTable(case.root / "reference/exact.csv")
        errors = []
        for name in ("middle", "freeEnd"):
            ours = case.table(f"{name}/0/velocity.dat")
            errors.append(relativeL2(ours["time"], ours["vx"], exact["t"], exact[f"v_{name}"]))
        return (*errors, case.worstBalance())


def check(binaries, marks):
    errors = {cells: measure(binaries, cells) for cells in MARKS}
    for cells in MARKS:
        marks.below(f"{cells} cells: middle L2", errors[cells][0], MARKS[cells])
        marks.below("end", errors[cells][1], MARKS[cells])
    marks.within("error ratio of half the cell size", errors[100][0] / errors[200][0], 3.2, 4.8)
    marks.below("energy balance", errors[100][2], 0.01)
