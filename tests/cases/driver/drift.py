"""Energy and momentum of a spinning body over a million steps: free, and bouncing about in a box.

Nothing is lost on purpose: no viscosity, no friction, elastic. Free, momenta may change by rounding
alone, and the energy by the error of the leapfrog, a quarter of the square of frequency x step of the
energy of vibration, which comes and goes. A spring of contact that opens and closes takes or gives an
energy of second order in its frequency x step, so what bouncing loses falls by four or more when the
step is halved."""

import math

from driver.scene import NO_VISCOSITY, Scene, elastic

SPIN = (30.0, 20.0, 70.0)  # 1/s
SPEED = (3.0, -2.0, 1.1)  # m/s
WALLS = {"xLow": ((-0.2, 0, 0), (1, 0, 0)), "xHigh": ((0.2, 0, 0), (-1, 0, 0)),
         "yLow": ((0, -0.2, 0), (0, 1, 0)), "yHigh": ((0, 0.2, 0), (0, -1, 0)),
         "zLow": ((0, 0, -0.2), (0, 0, 1)), "zHigh": ((0, 0, 0.2), (0, 0, -1))}


def text(vector):
    return "(" + " ".join(repr(x) for x in vector) + ")"


STEP = 5e-6  # free [s]
HALF = "timeStep { safety 0.45; contactLimit 0.4; }"  # of the default

TENTH = "timeStep { safety 0.2; contactLimit 0.1; }"
ON = "energyBalance { warning 1e3; stop 1e3; }"  # whatever becomes of the energy


def scene(binaries, steps, boxed, control=""):
    """A steel cube of eight elements, 0.1 m, in a box of 0.4 m."""
    return Scene(
        binaries, units="m", end=steps * STEP, rows=1000, control=control,
        bodies="body { type box; origin (-0.05 -0.05 -0.05); size (0.1 0.1 0.1); cells (2 2 2); }",
        parts=elastic("body", 210e9, 0.3, 7850, NO_VISCOSITY),
        initial=f"v {{ type velocity; part body; value {text(SPEED if boxed else (0.0, 0.0, 0.0))}; }}\n"
                f"w {{ type rotation; part body; axis {text(SPIN)}; centre (0 0 0); "
                f"angularVelocity {math.sqrt(sum(w * w for w in SPIN))!r}; }}",
        pairs="".join(f"{name} {{ contactor body; target {name}; enforcement penalty; }}\n"
                      for name in WALLS) if boxed else "",
        surfaces="".join(f"{name} {{ type plane; point {text(point)}; normal {text(normal)}; }}\n"
                         for name, (point, normal) in WALLS.items()),
        functions="motion { type part; part body; }")


def vectors(table, letter):
    return list(zip(*(table[letter + axis] for axis in "xyz")))


def length(vector):
    return math.sqrt(sum(x * x for x in vector))


def worst(rows):
    return max(length([a - b for a, b in zip(row, rows[0])]) for row in rows)


def energyOf(case):
    e = case.energies()
    return [sum(e[name][row] for name in ("kinetic", "internal", "hourglass", "contact"))
            for row in range(len(e["time"]))]


def slope(values):
    """Of the straight line through all of them, over the whole length."""
    n = len(values)
    mean, middle = sum(values) / n, (n - 1) / 2
    return n * sum((i - middle) * (v - mean) for i, v in enumerate(values)) / sum(
        (i - middle) ** 2 for i in range(n))


def turns(values):
    """How often a component of the momentum has changed its sign: bounces at the walls across it."""
    return sum((a < 0) != (b < 0) for a, b in zip(values, values[1:]))


def free(binaries, marks, steps):
    with scene(binaries, steps, False) as case:
        case.mesh()
        case.run("fpmExplicit")
        motion, energies = case.table("motion/0/part.dat"), case.energies()
        linear, angular = vectors(motion, "p"), vectors(motion, "l")
        total, done = energyOf(case), int(case.status()["steps"])
    start, mass = total[0], 7.85
    marks.note(f"{done} steps free")
    # Sums of eight elements at 27 nodes, half an ulp each, a step: they add up like a random walk.
    rounding = 1.1e-16 * math.sqrt(8 * 27 * done)
    marks.within("linear momentum / (mass x speed of spin)",
                 worst(linear) / (mass * length(SPIN) * 0.05), 0, rounding)
    marks.within("angular momentum, change", worst(angular) / length(angular[0]), 0, rounding)
    vibration = max(energies["internal"]) / start
    marks.within("energy, largest change", max(abs(e - start) for e in total) / start, 0, vibration)
    # What the straight line through values that swing so far may be off by, of 1000 rows.
    marks.within("energy, drift", abs(slope(total)) / start, 0,
                 2 * vibration * math.sqrt(12 / len(total)))


def bouncing(binaries, marks, steps):
    lost, counts = [], []
    for control in ("", HALF):
        with scene(binaries, steps, True, control) as case:
            case.mesh()
            case.run("fpmExplicit")
            total = energyOf(case)
            lost.append(abs(slope(total)) / total[0])
            counts.append(int(case.status()["steps"]))
    marks.note(f"{counts[0]} and {counts[1]} steps bouncing")
    marks.figure("energy lost by bouncing, default step", f"{100 * lost[0]:.2g} %")
    marks.figure("half of it", f"{100 * lost[1]:.2g} %")
    marks.within("ratio", lost[1] / lost[0], 0, 0.25)


def endless(binaries, marks, steps):
    """What bouncing makes of the energy in the end, with the default step; no limit is promised."""
    with scene(binaries, steps, True, ON) as case:
        case.mesh()
        case.run("fpmExplicit")
        total, done = energyOf(case), int(case.status()["steps"])
    share = [100 * (e / total[0] - 1) for e in total]
    marks.figure(f"energy over {done} steps of bouncing", f"{min(share):+.2g} to {max(share):+.2g} %")


def check(binaries, marks):
    free(binaries, marks, 100_000)
    bouncing(binaries, marks, 50_000)


def long(binaries, marks):
    free(binaries, marks, 1_000_000)
    bouncing(binaries, marks, 50_000)
    endless(binaries, marks, 558_000)
    with scene(binaries, 120_000, True, TENTH) as case:
        case.mesh()
        case.run("fpmExplicit")
        total, done = energyOf(case), int(case.status()["steps"])
        bounces = sum(turns(case.table("motion/0/part.dat")["p" + axis]) for axis in "xyz")
    marks.true(f"{done} steps, {bounces} bounces", done > 1_000_000 and bounces >= 10)
    # A spring in contact holds up to all of the energy, and is opened and closed a few times a bounce.
    marks.below(f"energy over {bounces} bounces with contactLimit 0.1",
                max(abs(e - total[0]) for e in total) / total[0], bounces * 0.1**2 / 4)
