"""Slender beams: large deflection and vibration."""

import math

from driver.scene import NO_VISCOSITY, Scene, elastic
from driver.waves import crossing

# Inextensible elastica under a dead load at its tip (elliptic integrals; Mattiasson 1981):
# P L^2 / E I: shortening and deflection over the length.
ELASTICA = {1: (0.05643, 0.30172), 4: (0.32894, 0.66996)}


def elastica(binaries, alpha, cells, height, width, hourglass):
    """Tip load ramped in two periods of the first mode, damped critically, to rest."""
    length, youngs, density = 500.0, 200000.0, 8e-9
    inertia = width * height**3 / 12
    load = alpha * youngs * inertia / length**2
    omega = 1.8751**2 * math.sqrt(youngs * inertia / (density * width * height)) / length**2
    period = 2 * math.pi / omega
    return Scene(
        binaries,
        bodies=f"beam {{ type box; origin (0 0 0); size ({length} {width} {height}); "
               f"cells ({cells[0]} {cells[1]} {cells[2]}); }}",
        parts=elastic("beam", youngs, 0, density, NO_VISCOSITY + hourglass, "polar"),
        conditions="clamp { type fixed; set beam.xMin; }\n"
                   "plane { type fixed; part beam; components (y); }\n"
                   f"load {{ type force; set beam.xMax; value (0 0 {-load!r}); components (z); "
                   f"amplitude smooth ((0 0) ({1.0 * period!r} 1)); }}",
        control=f"massDamping {1.6 * omega!r};", end=2.5 * period, rows=200,
        functions=f"tip {{ type point; part beam; position ({length} 0 {height / 2}); "
                  "fields (displacement); }").all()


def checkElastica(binaries, marks, name, cells, height, width, hourglass="", mark=0.02):
    for alpha, (shortening, deflection) in ELASTICA.items():
        with elastica(binaries, alpha, cells, height, width, hourglass) as case:
            tip = case.point("tip")
            for word, column, exact in (("u/L", "ux", shortening), ("w/L", "uz", deflection)):
                marks.against(f"C1 {name}, alpha {alpha}: {word}", -tip[column][-1] / 500, exact,
                              mark)
            rest = [u for u in tip["uz"][-10:]]
            marks.below("unrest", (max(rest) - min(rest)) / abs(rest[-1]), 0.005)
            marks.figure("hourglass / internal energy", f"{100 * case.hourglassShare():.2g} %")


def largeDeflection(binaries, marks):
    checkElastica(binaries, marks, "50 x 1 x 4, L/h 25", (50, 1, 4), 20.0, 10.0)


def largeDeflectionFine(binaries, marks):
    checkElastica(binaries, marks, "100 x 1 x 4, L/h 50", (100, 1, 4), 10.0, 5.0)


def vibrating(binaries, height, poisson, youngs, density, cells, periods, frequency):
    """Cantilever 100 x 10 x height mm, 100 N at once on its tip."""
    return Scene(
        binaries,
        bodies=f"beam {{ type box; origin (0 0 0); size (100 10 {height}); "
               f"cells ({cells[0]} {cells[1]} {cells[2]}); }}",
        parts=elastic("beam", youngs, poisson, density, NO_VISCOSITY),
        conditions="clamp { type fixed; set beam.xMin; }\n"
                   "load { type force; set beam.xMax; value (0 0 -100); components (z); }",
        end=(periods + 0.6) / frequency, rows=200 * periods,
        functions=f"tip {{ type point; part beam; position (100 5 {height / 2}); "
                  "fields (displacement); }").all()


def checkVibration(binaries, marks, name, height, poisson, youngs, density, cells, periods,
                   frequency, deflection, mark):
    with vibrating(binaries, height, poisson, youngs, density, cells, periods, frequency) as case:
        tip = case.point("tip")
        times, down = tip["time"], [-u for u in tip["uz"]]
        passes = crossing(times, down, deflection)
        # Falling passes are one period apart.
        count = (len(passes) - 1) // 2
        found = count / (passes[2 * count] - passes[0])
        marks.against(f"C2 {name}: first frequency", found, frequency, mark, "Hz")

        def peak(number):
            start, end = (number - 0.25) / frequency, (number + 1.25) / frequency
            return max(d for t, d in zip(times, down) if start <= t <= end)
        whole = [d for t, d in zip(times, down) if t <= periods / found]
        marks.against("mean deflection", sum(whole) / len(whole), deflection, mark, "mm")
        marks.within("largest / static deflection", max(down) / deflection, 1.9, 2.02)
        # Higher modes come and go in single peaks: the mean of five.
        first = sum(peak(i) for i in range(5)) / 5
        last = sum(peak(periods - 5 + i) for i in range(5)) / 5
        marks.below(f"amplitude lost over {periods} periods", abs(1 - last / first), 0.01)
        marks.below("energy balance", case.worstBalance(), 0.005)


def vibration(binaries, marks):
    checkVibration(binaries, marks, "20 x 2 x 2, nu 0.3", 10, 0.3, 210000, 7.85e-9, (20, 2, 2), 20,
                   829.0, 0.1919, 0.02)


def vibrationFine(binaries, marks):
    checkVibration(binaries, marks, "40 x 4 x 4, nu 0.3", 10, 0.3, 210000, 7.85e-9, (40, 4, 4), 20,
                   829.0, 0.1919, 0.01)


def tipLoaded(binaries, cells, hourglass):
    """Cantilever 40 x 4 x 4 mm, loaded slowly and damped critically: deflection over theory."""
    youngs, density, load = 70000.0, 2.7e-9, 4.0
    omega = 1.8751**2 * math.sqrt(youngs * 16 / 12 / density) / 40**2
    period = 2 * math.pi / omega
    theory = load * 40**3 / (3 * youngs * 4**4 / 12) + load * 40 / (5 / 6 * youngs / 2.6 * 16)
    with Scene(
            binaries,
            bodies="beam { type box; origin (0 0 0); size (40 4 4); "
                   f"cells ({cells[0]} {cells[1]} {cells[2]}); }}",
            parts=elastic("beam", youngs, 0.3, density, NO_VISCOSITY + hourglass),
            conditions="clamp { type fixed; set beam.xMin; }\n"
                       f"load {{ type force; set beam.xMax; value (0 0 {-load}); components (z); "
                       f"amplitude smooth ((0 0) ({period!r} 1)); }}",
            control=f"massDamping {1.6 * omega!r};", end=2.5 * period, rows=200,
            functions="tip { type point; part beam; position (40 2 2); fields (displacement); }"
            ).all() as case:
        return -case.point("tip")["uz"][-1] / theory


def hourglassRule(binaries, marks):
    """A5: within 10 % with one element in the height, within 3 % with four."""
    stiffness = "hourglass { form stiffness; coefficient 0.05; }"
    for name, cells, form, mark in (
            ("10 x 1 x 1, physical", (10, 1, 1), "", 0.1),
            ("40 x 4 x 4, physical", (40, 4, 4), "", 0.03),
            ("40 x 4 x 4, stiffness 0.05", (40, 4, 4), stiffness, 0.03)):
        marks.against(f"A5 {name}: deflection / theory", tipLoaded(binaries, cells, form), 1, mark)
    marks.figure("A5 10 x 1 x 1, stiffness 0.05: deflection / theory",
                 f"{tipLoaded(binaries, (10, 1, 1), stiffness):.3f}", "1")
