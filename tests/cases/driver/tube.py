"""Plastic tube squeezed by two rigid cylinders (tutorials/squeezedTube) against other programs.

Force of a whole die from 3 mm of travel on: within 5 % of the band that the programs with eight points
or incompatible modes span (tests/reference/squeezedTube). Positions at 29.7 mm of travel: B-bar program,
4 x 32 x 50 elements in an eighth."""

import shutil

from driver.caseRun import PROJECT, CaseRun
from driver.curves import at, readTable

TRAVEL = [3.5 + 0.5 * i for i in range(53)]
SIDE, END_X, END_Z = 16.07, -2.15, 1.16  # displacements of the outer points (mm)


def band(travel):
    """Smallest and largest force of the references at a travel of the die."""
    folder = PROJECT / "tests/reference/squeezedTube"
    bbar, others = readTable(folder / "bbarExplicit.csv"), readTable(folder / "otherPrograms.csv")
    curves = [(bbar["travel"], bbar[name]) for name in ("e4x32x50", "e3x24x37", "e2x16x25")]
    curves += [(others["travel"], others[name]) for name in ("calculix", "openRadiossBbar")]
    forces = [at(travel, *curve) for curve in curves]
    return min(forces), max(forces)


def prepared(binaries, cells=(4, 16, 40), die=(16, 10), swapped=False):
    """The eighth of the tutorial's variant paper, meshed; cells through the wall, around the quarter,
    along the half; of the die around the quarter and along the half."""
    case = CaseRun("tutorials/squeezedTube", binaries)
    shutil.copytree(case.root / "variants/paper", case.root, dirs_exist_ok=True)
    names = ("wallCells", "quarterCells", "halfCells", "dieQuarterCells", "dieHalfCells")
    for name, number in zip(names, cells + die):
        case.replace("system/meshDict", rf"^({name} +)\d+;", rf"\g<1>{number};")
    if swapped:
        case.replace("system/contactDict", r"contactor +tube\.outer;", "contactor upperDie.outer;")
        case.replace("system/contactDict", r"target +upperDie\.outer;", "target tube.outer;")
    case.mesh()
    return case


class Result:
    """What a finished run tells."""

    def __init__(self, case):
        die = case.table("upperDie/0/reaction.dat")
        self.travel, self.die = die["travel"], [-force for force in die["fz"]]
        self.outside = max(self.distance(travel) for travel in TRAVEL)
        self.side = self.moved(case, "side", "uy")
        self.endX, self.endZ = self.moved(case, "endTop", "ux"), self.moved(case, "endTop", "uz")
        energies = case.table("energies/0/energies.dat")
        late = [i for i, travel in enumerate(self.travel) if travel > 3]
        share = [energies["kinetic"][i] / energies["internal"][i] for i in late]
        self.kinetic = max(share)
        self.hourglass = energies["hourglass"][-1] / energies["internal"][-1]
        self.balance = case.worstBalance()
        self.released = "were released" in (case.root / "log.fpmExplicit").read_text()
        self.steps = case.performance()["steps"]
        self.seconds = case.performance()["wallSeconds"]

    def force(self, travel):
        """Mean over half a millimetre of travel."""
        near = [f for t, f in zip(self.travel, self.die) if abs(t - travel) <= 0.25]
        return sum(near) / len(near)

    def distance(self, travel):
        """How far the force is outside of the band, as a share; 0 within."""
        low, high = band(travel)
        force = self.force(travel)
        return max(force / high - 1, 1 - force / low, 0)

    def moved(self, case, point, component):
        table = case.table(f"{point}/0/displacement.dat")
        return at(29.7, self.travel, table[component])


def judge(result, marks):
    forces = " ".join(f"{result.force(travel):.0f}" for travel in (5, 10, 15, 20, 25, 29))
    marks.figure("H1 force at 5 10 15 20 25 29 mm of travel", f"{forces} N")
    marks.below("force outside of the band", result.outside, 0.05)
    marks.within("side u_y", result.side, SIDE * 0.98, SIDE * 1.02, " mm")
    marks.within("end u_x", result.endX, END_X - 0.25, END_X + 0.25, " mm")
    marks.within("end u_z", result.endZ, END_Z - 0.15, END_Z + 0.15, " mm")
    marks.below("hourglass / internal", result.hourglass, 0.05)
    marks.below("kinetic / internal", result.kinetic, 0.01)
    marks.below("energy balance", result.balance, 0.01)
    marks.true("no contactor released", not result.released)
    marks.note(f"{result.steps} steps, {result.seconds:.3g} s")


def measure(binaries, **options):
    with prepared(binaries, **options) as case:
        case.solve("-backend", "serial")
        return Result(case)


def coarse(binaries, marks):
    """The tutorial as shipped: a quarter of the scene between both dies, whose forces are equal."""
    with CaseRun("tutorials/squeezedTube", binaries) as case:
        case.mesh()
        case.solve("-backend", "serial")
        judge(Result(case), marks)
        upper, lower = (case.table(f"contactForces/0/tube{die}.dat") for die in ("Upper", "Lower"))
        most = max(map(abs, upper["fz"]))
        apart = max(abs(a + b) for a, b in zip(upper["fz"], lower["fz"])) / most
        marks.below("difference of the two dies' forces", apart, 0.001)


def finer(binaries, marks):
    """The mesh of the B-bar program."""
    judge(measure(binaries, cells=(4, 32, 50)), marks)


def paper(binaries, marks):
    """An eighth of the paper's mesh."""
    judge(measure(binaries, cells=(4, 28, 80)), marks)


def swapped(binaries, marks):
    """Nodes of a die as fine as the tube as contactors of the tube: the same force within 2 %."""
    one, other = measure(binaries), measure(binaries, die=(32, 40), swapped=True)
    apart = max(abs(other.force(travel) / one.force(travel) - 1) for travel in TRAVEL)
    marks.below("force, contactor and target swapped", apart, 0.02)
    judge(other, marks)
