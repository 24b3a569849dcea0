"""Rod on a plate of three layers (tutorials/plateImpact) against other programs.

Lowest displacement of the rod's centre: elastic -6.36 (OpenRadioss) and -6.45 mm (B-bar, rigid rod);
elastoplastic -7.32 to -8.14 mm, -8.0 the middle of the programs that let the layers yield in bending."""

from driver.caseRun import PROJECT, CaseRun
from driver.curves import lowest, readTable, relativeL2

FORMS = {
    "physical coupled": None,  # the default
    "physical elastic": "hourglass { form physical; coefficient 1; plastic elastic; }",
    "stiffness 0.05": "hourglass { form stiffness; coefficient 0.05; }",
    "viscous 0.1": "hourglass { form viscous; coefficient 0.1; }",
}


def reference(name):
    return readTable(PROJECT / f"tests/reference/plateImpact/{name}.csv")


def prepared(binaries, model="elastoplastic", form="physical coupled", elementsPerLayer=1):
    """A meshed copy of the tutorial."""
    case = CaseRun("tutorials/plateImpact", binaries)
    case.replace("constant/partProperties", r"^plateModel +\w+;", f"plateModel {model};")
    if form != "physical coupled":
        case.replace("constant/partProperties", r"^(?= *bulkViscosity )", f"{FORMS[form]}\n")
    if elementsPerLayer != 1:
        case.replace("system/meshDict", r"cells +\(50 50 1\)", f"cells (50 50 {elementsPerLayer})")
    case.mesh()
    return case


def swapRod(case):
    """Makes the struck face the contactor and the rod the target."""
    case.replace("system/contactDict", r"contactor +rod\.bottom;", "contactor plate3.zMax;")
    case.replace("system/contactDict", r"target +plate3\.zMax;", "target rod.bottom;")


class Result:
    """What a finished run tells."""

    def __init__(self, case, curve):
        table = case.table("rodCentre/0/displacement.dat")
        self.lowest, self.time = lowest(table["time"], table["uz"])
        against = reference(curve)
        self.distance = relativeL2(table["time"], table["uz"], against["t"],
                                   against["rodcentre_uz"], 4e-4)
        self.balance = case.worstBalance()
        self.plastic = case.table("energies/0/energies.dat")["plastic"][-1]
        self.released = "were released" in (case.root / "log.fpmExplicit").read_text()
        self.steps = case.performance()["steps"]
        self.seconds = case.performance()["wallSeconds"]


def common(result, marks):
    marks.below("energy balance", result.balance, 0.01)
    marks.true("no contactor released", not result.released)
    marks.note(f"{result.steps} steps, {result.seconds:.3g} s")


def elastic(binaries, marks):
    with prepared(binaries, "elastic") as case:
        case.solve("-backend", "serial")
        result = Result(case, "elastic")
        marks.within("lowest u_z", result.lowest, -6.45 * 1.03, -6.36 * 0.97, " mm")
        marks.below("curve to OpenRadioss", result.distance, 0.04)
        common(result, marks)


def elastoplastic(binaries, marks):
    with prepared(binaries) as case:
        case.solve("-backend", "serial")
        result = Result(case, "elastoplasticBbar")
        marks.within("lowest u_z", result.lowest, -8.2, -8.0 * 0.96, " mm")
        marks.below("curve to OpenRadioss, 8 points", result.distance, 0.04)
        common(result, marks)


def swapped(binaries, marks):
    """The finer side as contactor of a target it reaches beyond."""
    with prepared(binaries) as case:
        swapRod(case)
        case.mesh()
        case.solve("-backend", "serial")
        result = Result(case, "elastoplasticBbar")
        marks.within("lowest u_z", result.lowest, -8.6, -7.4, " mm")
        common(result, marks)
