"""A ball on a rigid plane: a bounce (Hertz) and a slow squeeze."""

import math

from driver.gmshFile import quarterSphere
from driver.scene import Scene, elastic
from driver.waves import crossing, impulse

SETS = ("planeX { type plane; point (0 0 0); normal (1 0 0); }\n"
        "planeY { type plane; point (0 0 0); normal (0 1 0); }\n")
SYMMETRIES = ("symX { type symmetry; set planeX; normal x; }\n"
              "symY { type symmetry; set planeY; normal y; }\n")


def bounce(binaries, core, rings):
    """Quarter of a ball of radius 50 mm, E 10 MPa, density 1e-9, at 1 m/s onto the plane z = -50.1."""
    return Scene(
        binaries,
        bodies='ball { type file; file "ball.msh"; }',
        files={"ball.msh": quarterSphere("ball", 50.0, core, rings).text()},
        sets=SETS, parts=elastic("ball", 10, 0.3, 1e-9), conditions=SYMMETRIES,
        initial="v { type velocity; part ball; value (0 0 -1000); }",
        surfaces="low { part ball; within box ((-1 -1 -51) (30 30 -35)); }\n"
                 "floor { type plane; point (0 0 -50.1); normal (0 0 1); }",
        pairs="ballFloor { contactor low; target floor; enforcement penalty; }",
        functions="centre { type point; part ball; position (0 0 0); "
                  "fields (displacement velocity); }",
        end=8e-3, rows=2000).all()


def checkBounce(binaries, marks, core, rings):
    mass = 4 / 3 * math.pi * 50**3 * 1e-9
    star = 10 / (1 - 0.3**2)
    stiffness = 4 / 3 * star * math.sqrt(50)
    speed = 1000.0
    depth = (5 * mass * speed**2 / (4 * stiffness)) ** 0.4
    force = stiffness * depth**1.5
    with bounce(binaries, core, rings) as case:
        contact = case.contact("ballFloor")
        times, f = contact["time"], [4 * abs(x) for x in contact["fz"]]
        name = f"D4 ball, {2 * (core + rings)} elements across"
        marks.against(f"{name}: force", max(f), force, 0.05, "N")
        touched = [t for t, x in zip(times, f) if x > 0]
        marks.against("contact time", 1e3 * (touched[-1] - touched[0]), 2943.3 * depth / speed,
                      0.05, "ms")
        centre = case.point("centre")
        marks.against("depth", -min(centre["uz"]) - 0.1, depth, 0.05, "mm")
        # The mass of the mesh is a little less than the ball's: its momentum as it came.
        energies = case.energies()
        meshMass = 8 * energies["kinetic"][0] / speed**2
        rebound = impulse(times, f) / meshMass - speed
        marks.within("rebound", rebound / 1e3, 0.97, 1.0, " m/s")
        marks.below("energy balance", case.worstBalance(), 0.01)
        marks.below("hourglass / internal", case.hourglassShare(), 0.05)


def bounces(binaries, marks):
    checkBounce(binaries, marks, 12, 12)
