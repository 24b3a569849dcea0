"""Coulomb friction of one block: braking, inclines, and a pad on a spring."""

import math

from driver.scene import NO_VISCOSITY, Scene, elastic

GRAVITY = 9.81
RAMP = 5e-3  # over which the weight comes, so that nothing swings


def way(time):
    """Of a unit of acceleration times the smooth ramp, after it."""
    return (time - RAMP)**2 / 2 + RAMP / 2 * (time - RAMP) + RAMP**2 / 7


DAMPED = ("hourglass { form viscous; coefficient 0.1; } "
          "bulkViscosity { linear 0.5; quadratic 1.2; }")


def sliding(binaries, velocity, friction, end, slope=0.0, more=DAMPED):
    """Block 0.1 x 0.1 x 0.05 m on a rigid plane under its weight, the plane turned by `slope`.
    Undamped it chatters as it comes to rest."""
    down = (GRAVITY * math.sin(slope), -GRAVITY * math.cos(slope))
    return Scene(
        binaries, units="m",
        bodies="block { type box; origin (0 0 0); size (0.1 0.1 0.05); cells (2 2 1); }",
        # A softer block than steel: the same rigid motion in longer steps.
        parts=elastic("block", 2e9, 0.3, 7850, more),
        conditions=f"weight {{ type gravity; value ({down[0]!r} 0 {down[1]!r}); "
                   f"amplitude smooth ((0 0) ({RAMP} 1)); }}",
        initial=f"v {{ type velocity; part block; value ({velocity[0]!r} {velocity[1]!r} 0); }}",
        surfaces="floor { type plane; point (0 0 0); normal (0 0 1); }",
        pairs=f"blockFloor {{ contactor block.zMin; target floor; friction {friction}; }}",
        functions="centre { type point; part block; position (0.05 0.05 0.05); "
                  "fields (displacement); }\nall { type part; part block; }",
        end=end, rows=2000).all()


def brake(binaries, marks, speed, friction, angle=0.0):
    """Stops after v / mu g, half the ramp later; the heat is the kinetic energy."""
    time = speed / (friction * GRAVITY) + RAMP / 2
    stop = speed * time - friction * GRAVITY * way(time)
    velocity = (speed * math.cos(angle), speed * math.sin(angle))
    with sliding(binaries, velocity, friction, time + 0.2) as case:
        u, p = case.point("centre"), case.table("all/0/part.dat")
        along = [(x * velocity[0] + y * velocity[1]) / speed for x, y in zip(u["ux"], u["uy"])]
        name = f"G1 {speed:g} m/s, mu {friction}" + (", 45 degrees" if angle else "")
        marks.against(f"{name}: way", along[-1], stop, 0.005, "m")
        momentum = [x * velocity[0] + y * velocity[1] for x, y in zip(p["px"], p["py"])]
        stopped = next(t for t, now in zip(p["time"], momentum) if now < 1e-3 * momentum[0])
        marks.against("time", stopped, time, 0.005, "s")
        e = case.energies()
        marks.against("heat / kinetic energy", e["friction"][-1] / e["kinetic"][0], 1, 0.005)
        late = [x for t, x in zip(u["time"], along) if t > time + 0.01]
        marks.within("drift after the stop", 1e6 * (max(late) - min(late)), 0, 1, " um")
        if angle:
            marks.below("sideways", abs(u["ux"][-1] - u["uy"][-1]) / stop, 1e-3)


def incline(binaries, marks, degrees, friction):
    slope = math.radians(degrees)
    acceleration = GRAVITY * (math.sin(slope) - friction * math.cos(slope))
    # Viscous control resists no load that lasts.
    more = DAMPED if acceleration > 0 else ""
    with sliding(binaries, (0.0, 0.0), friction, 0.5, slope, more) as case:
        u = case.point("centre")
        name = f"G1 incline {degrees} degrees, mu {friction}"
        if acceleration > 0:
            marks.against(f"{name}: way", u["ux"][-1], acceleration * way(0.5), 0.005, "m")
        else:
            # The first elastic slip is no creep.
            late = [x for t, x in zip(u["time"], u["ux"]) if t > 0.1]
            marks.within(f"{name}: creep", 1e6 * (max(late) - min(late)), 0, 1, " um")


def pad(binaries, marks):
    """Pad of 7000 kg on a spring (Code_Aster SDNV104 with lengths and forces by a thousandth).

    The spring is a bar of 10 m with k = E A / L = 24 kN/m and a thousandth of the pad's mass."""
    spring, mass, push, normal, friction = 24e3, 7000.0, 200.0, 70.0, 0.3
    case = Scene(
        binaries, units="m",
        bodies='pad { type file; file "pad.msh"; }',
        files={"pad.msh": padMesh()},
        sets="end { type plane; point (-10 0 0); normal (1 0 0); bodies (spring); }",
        parts=elastic("block", 2.4e7, 0, 7000, NO_VISCOSITY)
        + elastic("spring", spring * 10, 0, 0.7, NO_VISCOSITY),
        conditions="wall { type fixed; set end; }\n"
                   "lane { type fixed; part spring; components (y); }\n"
                   f"push {{ type force; part block; value ({push} 0 0); components (x); }}\n"
                   f"press {{ type force; part block; value (0 0 {-normal}); components (z); }}",
        pairs=f"padFloor {{ contactor under; target floor; friction {friction}; }}",
        surfaces="under { part block; facing (0 0 -1); }\n"
                 "floor { type plane; point (0 0 -0.5); normal (0 0 1); }",
        functions="pad { type point; part block; position (1 0.5 0.5); fields (displacement); }",
        end=10.0, rows=5000)
    with case:
        case.all()
        u = case.point("pad")
        half = math.pi / math.sqrt(spring / mass)
        centre, slip = push / spring, friction * normal / spring
        # Sliding forth about centre - slip, back about centre + slip, until a half swing ends where
        # the spring cannot overcome friction.
        extremes, x, direction = [], 0.0, 1
        while abs(centre - x) > slip:
            x = 2 * (centre - direction * slip) - x
            extremes.append(x)
            direction = -direction
        for number, x in enumerate(extremes):
            time = half * (number + 1)
            near = [(t, d) for t, d in zip(u["time"], u["ux"]) if abs(t - time) < 0.4 * half]
            best = (max if number % 2 == 0 else min)(near, key=lambda pair: pair[1])
            marks.against(f"G2 extreme {number + 1}", 1e3 * best[1], 1e3 * x, 0.005, "mm")
        marks.against("G2 sticks at", 1e3 * u["ux"][-1], 1e3 * extremes[-1], 0.005, "mm")
        marks.true(f"{len(extremes)} half swings", len(extremes) == 5)


def padMesh():
    """Spring of five cells along x < 0 and the pad of one cell, sharing four nodes."""
    nodes, lines = {}, []
    for i, x in enumerate((-10.0, -8.0, -6.0, -4.0, -2.0, 0.0, 1.0)):
        for j, (y, z) in enumerate(((0, 0), (1, 0), (1, 1), (0, 1))):
            nodes[(i, j)] = len(nodes) + 1
            lines.append(f"{nodes[(i, j)]} {x} {y} {z - 0.5}")
    text = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames", "2", '3 1 "spring"',
            '3 2 "block"', "$EndPhysicalNames", "$Nodes", str(len(lines)), *lines, "$EndNodes",
            "$Elements", "6"]
    for i in range(6):
        a, b = [nodes[(i, j)] for j in range(4)], [nodes[(i + 1, j)] for j in range(4)]
        corners = [a[0], b[0], b[1], a[1], a[3], b[3], b[2], a[2]]
        part = 1 if i < 5 else 2
        text.append(f"{i + 1} 5 2 {part} {part} " + " ".join(map(str, corners)))
    return "\n".join(text + ["$EndElements", ""])


def check(binaries, marks):
    brake(binaries, marks, 1.0, 0.3)
    brake(binaries, marks, 2.0, 0.25)
    brake(binaries, marks, 1.0, 0.3, math.pi / 4)
    for degrees, friction in ((20, 0.3), (30, 0.4), (30, 0.2), (15, 0.3)):
        incline(binaries, marks, degrees, friction)
    pad(binaries, marks)
