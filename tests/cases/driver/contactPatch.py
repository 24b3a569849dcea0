"""Pressure through an interface of unequal meshes (patch test), and two cubes."""

from driver.scene import NO_VISCOSITY, Scene, elastic


def blocks(binaries, faces, depths, swap, scale, passes="one"):
    """Two blocks 1 x 0.25 x 0.5 m on one another, E = 1e6, nu = 0; the top moves down by 0.001 m."""
    lower, upper = faces
    tables = ("low { type extrema; field S; component ZZ; part lower; }\n"
              "high { type extrema; field S; component ZZ; part upper; }\n"
              "meanLow { type section; field S; set lower.zMin; }\n"
              "gapLow { type section; field U; set lower.zMax; }\n"
              "gapHigh { type section; field U; set upper.zMin; }")
    pair = ("contactor lower.zMax; target upper.zMin;" if swap
            else "contactor upper.zMin; target lower.zMax;")
    omega = 3.14159 / 2 / 1.0 * (1e6 / 1000) ** 0.5  # of the column of 1 m held at one end
    return Scene(
        binaries, units="m",
        bodies=f"lower {{ type box; origin (0 0 0); size (1 0.25 0.5); "
               f"cells ({lower} {depths[0]} 4); }}\n"
               f"upper {{ type box; origin (0 0 0.5); size (1 0.25 0.5); "
               f"cells ({upper} {depths[1]} 5); }}",
        parts=elastic("lower", 1e6, 0, 1000, NO_VISCOSITY) + elastic("upper", 1e6, 0, 1000,
                                                                     NO_VISCOSITY),
        conditions="base { type fixed; set lower.zMin; components (z); }\n"
                   "sideX { type fixed; set lower.xMin; components (x); }\n"
                   "sideX2 { type fixed; set upper.xMin; components (x); }\n"
                   "sideY { type fixed; set lower.yMin; components (y); }\n"
                   "sideY2 { type fixed; set upper.yMin; components (y); }\n"
                   "press { type displacement; set upper.zMax; value (0 0 -0.001); "
                   "components (z); amplitude smooth ((0 0) (0.1 1)); }",
        pairs=f"blocks {{ {pair} normalScale {scale}; passes {passes}; }}",
        control=f"massDamping {omega!r};", end=0.3, rows=100,
        functions="base { type reaction; condition base; }", tables=tables).all()


def judge(binaries, marks, name, faces, depths, swap, scale, most, mark=0.005, passes="one"):
    """The exact stress is -1000 Pa everywhere; the largest deviation is a figure of the method: nodes
    of one side press into faces of the other."""
    with blocks(binaries, faces, depths, swap, scale, passes) as case:
        force = case.table("base/0/reaction.dat")["fz"][-1] / 0.25
        sinks = (case.probed("gapLow", "U")["z"][-1] - case.probed("gapHigh", "U")["z"][-1])
        marks.against(f"F1 {name}: mean stress", -force, -1e3, mark, "Pa")
        marks.below("penetration / element", sinks / 0.1, 0.01)
        worst = max(abs(x / -1e3 - 1) for part in ("low", "high") for side in ("min", "max")
                    for x in [case.probed(part, "S")[side][-1]])
        marks.below("largest deviation", worst, most)
        return force


def check(binaries, marks):
    judge(binaries, marks, "5 on 5 faces", (5, 5), (1, 1), False, 100, 0.005)
    force = judge(binaries, marks, "7 on 5 faces", (5, 7), (1, 1), False, 100, 0.1)
    # The coarser side as contactor: nodes of the finer one sink in between.
    swapped = judge(binaries, marks, "7 on 5, swapped", (5, 7), (1, 1), True, 100, 0.3, 0.01)
    marks.below("change of the force", abs(swapped / force - 1), 0.01)
    judge(binaries, marks, "7 on 5, two passes", (5, 7), (1, 1), False, 100, 0.01, passes="two")
    judge(binaries, marks, "14 on 10, swapped", (10, 14), (1, 1), True, 100, 0.3)
    judge(binaries, marks, "7 x 3 on 5 x 2 faces", (5, 7), (2, 3), False, 100, 0.2)
