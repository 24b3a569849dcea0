"""Tutorials with few cells against the numbers of their READMEs."""

import math

from driver.caseRun import CaseRun
from driver.curves import at, readTable
from driver.pipeline import allrun
from driver.waves import impulse


def slidingBlock(binaries, marks):
    with CaseRun("tutorials/slidingBlock", binaries) as case:
        case.mesh()
        case.solve()
        case.run("fpmProbe")
        way = case.table("block/0/displacement.dat")
        exact = readTable(case.root / "reference/exact.csv")
        worst = max(abs(at(t, way["time"], way["ux"]) - s) for t, s in zip(exact["t"], exact["s"]))
        marks.against("slidingBlock: way", way["ux"][-1], exact["s"][-1], 0.005, "m")
        marks.below("largest deviation on the way", worst / exact["s"][-1], 0.005)


def layeredPlate(binaries, marks):
    """Three layers of 25 x 25: momentum of the rod and impulse of its contact, energies."""
    with CaseRun("tutorials/layeredPlate", binaries) as case:
        case.replace("system/meshDict", r"^layers +\d+;", "layers 3;")
        case.replace("system/meshDict", r"^cells +\([0-9 ]+\);", "cells (25 25 1);")
        case.replace("system/controlDict", r"openmp;", "serial;")
        case.replace("system/probeDict", r"^pictures", "tables\n{\n    rod "
                     "{ type section; field V; set rod.top; }\n}\npictures")
        done = allrun(case)
        marks.true("layeredPlate: Allrun succeeds", done.returncode == 0)
        if done.returncode != 0:
            marks.failures.append(done.stdout)
            return
        marks.true("it tells the time of a step", "ns per element-step" in done.stdout)
        pairs = sorted(p.stem for p in (case.root / "postProcessing/contactForces/0").iterdir())
        marks.true("a pair for each interface", pairs == ["layer2", "layer3", "rodPlate"])
        force = case.table("contactForces/0/rodPlate.dat")
        kinetic = case.table("energies/0/energies.dat")["kinetic"]
        # The wave has run up and down the rod once: its mean velocity is what the impulse left.
        mass = 2 * kinetic[0] / 5e4**2
        left = 5e4 - impulse(force["time"], force["fz"]) / mass
        centre = case.table("rodCentre/0/displacement.dat")
        mean = -centre["uz"][-1] / centre["time"][-1]
        marks.within("velocity left / mean velocity of its lower face", left / mean, 0.97, 1.03)
        marks.below("energy balance", case.worstBalance(), 0.01)


def ringCrush(binaries, marks):
    """Mean force over windows of travel against the rigid-plastic ring (DeRuntz and Hodge 1963)."""
    with CaseRun("tutorials/ringCrush", binaries) as case:
        case.mesh()
        case.solve("-backend", "serial")
        case.run("fpmProbe")
        force, below = case.table("ram/0/reaction.dat"), case.table("table/0/reaction.dat")
        travel = [abs(u) for u in force["travel"]]
        first = 2 / math.sqrt(3) * 285 * 2.5**2 / 4 * 8 / 50 / 2
        for start, end in ((5, 15), (15, 25)):
            rows = [i for i, u in enumerate(travel) if start <= u < end]
            # Work over travel, the mean of both plates: the ring shakes between them.
            work = theory = 0.0
            for i in rows:
                step = travel[i] - travel[i - 1]
                work += step * (abs(force["fz"][i]) + abs(below["fz"][i])) / 2
                theory += step * first / math.sqrt(1 - (travel[i] / 50) ** 2)
            marks.against(f"ringCrush: mean force, travel {start} to {end} mm", work / (end - start),
                          theory / (end - start), 0.1, "N")
        energies = case.table("energies/0/energies.dat")
        late = [i for i, u in enumerate(travel) if u >= 5]
        marks.below("kinetic / internal energy from 5 mm on", max(
            energies["kinetic"][i] / energies["internal"][i] for i in late), 0.03)
        marks.below("upper plate beside the lower one", abs(sum(
            abs(force["fz"][i]) - abs(below["fz"][i]) for i in late) / sum(
            abs(below["fz"][i]) for i in late)), 0.03)
        marks.below("energy balance", case.worstBalance(), 0.01)
        # The crowns are 47.5 mm apart at first, meet, and stay outside of each other.
        above, below = (case.table(f"crown{side}/0/displacement.dat")["uz"]
                        for side in ("Above", "Below"))
        gaps = [47.5 + up - down for up, down in zip(above, below)]
        marks.true("the bore touches itself", case.table("contactForces/0/bore.dat")["active"][-1] > 0)
        marks.below("depth of the crowns / element", max(0.0, -min(gaps)) / 0.625, 0.01)
        marks.below("gap of the crowns at the end / element", abs(gaps[-1]) / 0.625, 0.01)
