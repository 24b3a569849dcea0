"""Bars and blocks that strike: elastic waves, contact forces, plastic fronts."""

import math

from driver.curves import at
from driver.scene import Scene, elastic, plastic


def impulse(times, forces, start=-math.inf, end=math.inf):
    """Trapezoids between start and end."""
    total = 0.0
    for i in range(1, len(times)):
        if start <= times[i - 1] and times[i] <= end:
            total += (times[i] - times[i - 1]) * (forces[i] + forces[i - 1]) / 2
    return total


def crossing(times, values, level):
    """Times where the values pass the level, rising or falling."""
    found = []
    for i in range(1, len(times)):
        a, b = values[i - 1] - level, values[i] - level
        if (a < 0) != (b < 0):
            found.append(times[i - 1] + (times[i] - times[i - 1]) * a / (a - b))
    return found


# B1 ---------------------------------------------------------------------------------------------

def barOnWall(binaries, speed, poisson, cells, held=True, across=1):
    """Bar 200 x 20 x 20 mm, 2 mm before a rigid wall at x < 0; speed in mm/s."""
    gap = 2.0 * speed / 1e5
    sides = "sides { type fixed; part bar; components (y z); }\n" if held else ""
    return Scene(
        binaries,
        bodies=f"bar {{ type box; origin ({gap} 0 0); size (200 20 20); "
               f"cells ({cells} {across} {across}); }}",
        parts=elastic("bar", 200000, poisson, 8e-9), conditions=sides,
        initial=f"v {{ type velocity; part bar; value ({-speed} 0 0); }}",
        surfaces="wall { type plane; point (0 0 0); normal (1 0 0); }",
        pairs="barWall { contactor bar.xMin; target wall; }",
        functions="struck { type point; part bar; position (0 10 10); fields (displacement); }\n"
                  "free { type point; part bar; position (202 10 10); fields (displacement); }",
        end=1.2e-4, rows=2400).all()


def onWall(binaries, marks, name, speed, poisson, cells, mark, held=True, across=1):
    mass = 8e-9 * 200 * 400
    wave = 5e6
    with barOnWall(binaries, speed, poisson, cells, held, across) as case:
        force = case.contact("barWall")
        times, f = force["time"], [abs(x) for x in force["fx"]]
        exact = 8e-9 * wave * speed * 400
        mean = impulse(times, f, 3e-5, 9e-5) / 6e-5
        marks.against(f"{name}: wall force", mean / 1e6, exact / 1e6, mark, "MN")
        edges = crossing(times, f, exact / 2)
        marks.against("contact lasts", 1e6 * (edges[-1] - edges[0]), 80, 2 * mark, "us")
        marks.below("overshoot", max(f) / exact - 1, 0.2)
        if not held:
            return
        rebound = impulse(times, f) / mass - speed
        marks.against("rebound", rebound / 1e3, speed / 1e3, 0.03, "m/s")
        gap = 2 * speed / 1e5
        for point, t, u in (("struck", 6e-5, -gap), ("free", 4e-5, -2 * gap),
                            ("free", 6e-5, -3 * gap), ("free", 1e-4, -gap)):
            d = case.point(point)
            marks.against(f"{point} end at {1e6 * t:.0f} us", at(t, d["time"], d["ux"]), u,
                          max(mark, 0.02), "mm", scale=3 * gap)
        marks.below("energy balance", case.worstBalance(), 0.01)


def wall(binaries, marks):
    onWall(binaries, marks, "B1 100 m/s, 200 cells", 1e5, 0, 200, 0.015)
    onWall(binaries, marks, "B1 10 m/s, 500 cells", 1e4, 0, 500, 0.003)
    onWall(binaries, marks, "B1 10 m/s, nu 0.3, free sides", 1e4, 0.3, 100, 0.02, held=False,
           across=4)


# B2 ---------------------------------------------------------------------------------------------

FACES = ("face1 { type point; part bar1; position (500 10 10); fields (velocity); }\n"
         "face2 { type point; part bar2; position (500 10 10); fields (velocity); }\n"
         "middle { type point; part bar1; position (250 10 10); fields (velocity); }")


def twoBars(binaries, first, second, cells, along, end, initial, conditions=""):
    """Two bars 500 x 20 x 20 mm, end to end at x = 500; the finer one is the contactor. Lateral
    motion is held."""
    fine = 1 if cells[0] >= cells[1] else 2
    contactor, target = ("bar1.xMax", "bar2.xMin") if fine == 1 else ("bar2.xMin", "bar1.xMax")
    return Scene(
        binaries,
        bodies="\n".join(
            f"bar{i + 1} {{ type box; origin ({500 * i} 0 0); size (500 20 20); "
            f"cells ({along} {n} {n}); }}" for i, n in enumerate(cells)),
        parts=first + second,
        conditions="s1 { type fixed; part bar1; components (y z); }\n"
                   "s2 { type fixed; part bar2; components (y z); }\n" + conditions,
        initial=initial,
        pairs=f"bars {{ contactor {contactor}; target {target}; normalScale 10; }}",
        functions=FACES, end=end, rows=1500).all()


def mean(times, values, start, end):
    return impulse(times, values, start, end) / (
        max(t for t in times if t <= end) - min(t for t in times if t >= start))


def bars(binaries, marks):
    steel = [elastic(f"bar{i}", 200000, 0, 8e-9) for i in (1, 2)]
    # A step gives its sharpest edge to bulk viscosity: 1.1 % of the energy at the default of 0.06.
    little = [elastic(f"bar{i}", 200000, 0, 8e-9, "bulkViscosity { linear 0.02; quadratic 1.2; }")
              for i in (1, 2)]
    one, other = elastic("bar1", 210000, 0, 7.85e-9), elastic("bar2", 70000, 0, 2.7e-9)
    strike = "v { type velocity; part bar1; value (10000 0 0); }"
    for name, parts, cells, along in (
            ("1 mm, viscosity 0.02", little, (1, 1), 500), ("7 x 7 on 5 x 5", steel, (7, 5), 80),
            ("5 x 5 on 7 x 7", steel, (5, 7), 80)):
        with twoBars(binaries, *parts, cells, along, 2.6e-4, strike) as case:
            force = case.contact("bars")
            stress = mean(force["time"], [abs(f) / 400 for f in force["fx"]], 3e-5, 1.8e-4)
            marks.against(f"B2 equal bars, {name}: stress", stress, 200, 0.01, "MPa")
            v = case.point("face2", "velocity")
            marks.against("interface", mean(v["time"], v["vx"], 3e-5, 1.8e-4) / 1e3, 5, 0.01, "m/s")
            # All momentum is handed over; what stays behind is the ringing of the step.
            share = impulse(force["time"], [abs(f) for f in force["fx"]]) / (8e-9 * 2e5 * 1e4)
            marks.against("momentum handed over", share, 1, 0.015)
            e = case.energies()
            marks.below("kinetic energy lost", 1 - e["kinetic"][-1] / e["kinetic"][0],
                        0.01 if along > 200 else 0.03)
            marks.below("energy balance", case.worstBalance(), 0.01)
    with twoBars(binaries, one, other, (1, 1), 250, 1.8e-4, strike) as case:
        force, v = case.contact("bars"), case.point("face2", "velocity")
        stress = mean(force["time"], [abs(f) / 400 for f in force["fx"]], 3e-5, 1.7e-4)
        marks.against("B2 steel on aluminium: stress", stress, 102.7023, 0.01, "MPa")
        marks.against("interface", mean(v["time"], v["vx"], 3e-5, 1.7e-4) / 1e3, 7.470494, 0.01,
                      "m/s")
    # A step of 100 MPa through an interface that only touches: 2.5 m/s driven at the far end.
    push = ("push { type velocity; set bar1.xMin; value (2500 0 0); components (x); "
            "amplitude smooth ((0 0) (2e-5 1)); }")
    for cells in ((1, 1), (7, 5)):
        with twoBars(binaries, *steel, cells, 80, 1.9e-4, "", push) as case:
            v = case.point("middle", "velocity")
            late = [abs(x / 2500 - 1) for t, x in zip(v["time"], v["vx"]) if 1e-4 < t]
            marks.below(f"B2 transparency, {cells[0]} on {cells[1]}: reflected", max(late), 0.03)


# B5 ---------------------------------------------------------------------------------------------

# E, nu, density, yield stress, H, longitudinal speed (m/s), elastic limit (MPa), plastic speed;
# piston speed: stress behind the plastic front, plastic strain. Closed forms of small strain.
PISTON = {
    "Al": ((70000, 0.3, 2.7e-9, 285, 900), 5907.65, 498.75, 4663.85, {50: (734.63, 0.002648)}),
    "Al, no hardening": ((68900, 0.33, 2.7e-9, 276, 0), 6148.93, 543.88, 5001.82,
                         {50: (776.71, 0.002298)}),
    "Cu": ((117000, 0.35, 8.93e-9, 400, 100), 4585.60, 866.67, 3816.10,
           {50: (1849.32, 0.005034), 100: (3553.21, 0.013762)}),
}


def piston(binaries, marks, name, speed):
    data, fast, limit, slow, states = PISTON[name]
    stress, peeq = states[speed]
    behind = 1e3 * speed
    # Until the fast wave has run through nine tenths; the plateau lies behind the slow one.
    end = 180 / (1e3 * fast)
    stations = (40.0, 120.0)
    with Scene(
            binaries, bodies="bar { type box; origin (0 0 0); size (200 1 1); cells (400 1 1); }",
            parts=plastic("bar", *data),
            conditions="sides { type fixed; part bar; components (y z); }\n"
                       f"piston {{ type velocity; set bar.xMin; value ({behind} 0 0); "
                       "components (x); amplitude smooth ((0 0) (4e-7 1)); }",
            end=end, rows=3000,
            functions="\n".join(
                f"x{int(x)} {{ type point; part bar; position ({x} 0 0); fields (velocity); }}"
                for x in stations),
            tables="\n".join(f"s{x} {{ type point; field S; position ({x}.25 0.5 0.5); }}\n"
                             f"e{x} {{ type point; field PEEQ; position ({x}.25 0.5 0.5); }}"
                             for x in (60, 70, 80))).all() as case:
        first = limit / (data[2] * 1e3 * fast)  # velocity behind the elastic front, mm/s
        marks.against(f"B5 {name}, {speed} m/s: stress",
                      -sum(case.probed(f"s{x}", "S")["XX"][-1] for x in (60, 70, 80)) / 3, stress,
                      0.02, "MPa")
        marks.against("PEEQ", sum(case.probed(f"e{x}", "PEEQ")["PEEQ"][-1] for x in (60, 70, 80)) / 3,
                      peeq, 0.03)
        v = [case.point(f"x{int(x)}", "velocity") for x in stations]
        for word, level, speedOf in (("elastic front", 0.5 * first, fast),
                                     ("plastic front", 0.5 * (first + behind), slow)):
            times = [crossing(c["time"], c["vx"], level)[0] for c in v]
            found = (stations[1] - stations[0]) / (times[1] - times[0]) / 1e3
            marks.against(word, found, speedOf, 0.02, "m/s")
        marks.below("energy balance", case.worstBalance(), 0.01)


def plasticBar(binaries, marks):
    """1 m at 30 m/s against a wall, uniaxial stress: 652.98 MPa, plastic strain 0.011384."""
    modulus = 200000 * 20000 / (200000 - 20000)
    with Scene(
            binaries, bodies="bar { type box; origin (0 0 0); size (1000 2.5 2.5); "
                             "cells (400 1 1); }",
            parts=plastic("bar", 200000, 0, 8e-9, 400, modulus),
            conditions="wall { type symmetry; set bar.xMin; normal x; }\n"
                       "symY { type symmetry; set bar.yMin; normal y; }\n"
                       "symZ { type symmetry; set bar.zMin; normal z; }",
            initial="v { type velocity; part bar; value (-30000 0 0); }", end=1.9e-4, rows=1900,
            functions="wallForce { type reaction; condition wall; }\n"
                      "far { type point; part bar; position (700 0 0); fields (velocity); }",
            tables="e { type point; field PEEQ; position (121.25 1.25 1.25); }\n"
                   "s { type point; field S; position (500 1.25 1.25); }").all() as case:
        force = case.table("wallForce/0/reaction.dat")
        stress = mean(force["time"], [f / 6.25 for f in force["fx"]], 5e-5, 1.9e-4)
        marks.against("B5 bar on wall: stress", stress, 652.98, 0.02, "MPa")
        peeq = case.probed("e", "PEEQ")["PEEQ"][-1]
        marks.against("plastic strain behind the slow wave", peeq, 0.011384, 0.03)
        marks.against("stress between the fronts", -case.probed("s", "S")["XX"][-1], 400, 0.02,
                      "MPa")
        v = case.point("far", "velocity")
        late = mean(v["time"], v["vx"], 1.6e-4, 1.9e-4)
        marks.against("velocity between the fronts", -late / 1e3, 20, 0.02, "m/s")


def plasticFronts(binaries, marks):
    for name in PISTON:
        for speed in PISTON[name][4]:
            piston(binaries, marks, name, speed)
    plasticBar(binaries, marks)
