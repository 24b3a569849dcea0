"""Shallow ironing (Fischer and Wriggers 2006): a stiff punch is pressed into a soft block and dragged
along it with friction, in plane strain. The published forces of five programs span wide bands.

Bands at the end of pressing and half way of the drag: solids4foam (shallowIroning tutorial), which
quotes Fischer and Wriggers, Hartmann et al. 2009, Poulios and Renard 2015, Code_Aster SSNP153. They
use a neo-Hookean law, the toolkit a hypoelastic one."""

import math

from driver.gmshFile import Hexahedra
from driver.scene import Scene, elastic

PRESS, END = 1.2e-3, 4e-3  # s: 1 mm down, then 10 mm along; slow against the waves (1e6 mm/s)
MIDDLE = (PRESS + END) / 2
BANDS = {"pressed, vertical": (267.9, 332.0), "pressed, horizontal": (55.0, 71.0),
         "dragged, vertical": (337.4, 421.0), "dragged, horizontal": (102.1, 188.8)}


def punch(cells):
    """1.2 mm wide; its lower side an arc of radius 0.75 mm, 0.2 mm above the block at the lowest."""
    mesh = Hexahedra("punch")

    def place(u, v, w):
        low = 0.95 - math.sqrt(0.75**2 - (1.2 * u - 0.6)**2)
        return (0.2 + 1.2 * u, low + (1.4 - low) * v, w)
    mesh.block((*cells, 1), place)
    return mesh.text()


def ironed(binaries, block, cells, end=END, friction=0.3, scale=1):
    held = "type fixed; components (z);"
    return Scene(
        binaries,
        bodies=f"block {{ type box; origin (0 -4 0); size (12 4 1); cells ({block[0]} {block[1]} 1);"
               " }\npunch { type file; file \"punch.msh\"; }",
        files={"punch.msh": punch(cells)},
        sets="under { type box; min (0.1 0.1 0.1); max (1.5 1.35 0.9); bodies (punch); }\n"
             "top { type plane; point (0 1.4 0); normal (0 1 0); bodies (punch); }",
        parts=elastic("block", 689.6, 0.32, 1e-9, rotation="polar")
        + elastic("punch", 6896, 0.32, 1e-9, rotation="polar"),
        conditions="base { type fixed; set block.yMin; }\n"
                   f"plane1 {{ {held} part block; }}\nplane2 {{ {held} part punch; }}\n"
                   "press { type displacement; set top; value (0 -1 0); components (y); "
                   f"amplitude smooth ((0 0) ({PRESS} 1)); }}\n"
                   "drag { type displacement; set top; value (10 0 0); components (x); "
                   f"amplitude smooth ((0 0) ({PRESS} 0) ({END} 1)); }}",
        # The finer side is the contactor: nodes of a coarse block would let the punch's corners sink
        # in between them. It must be finer: nodes of the block that are no further apart than the
        # punch's sink into the front corner, and the surface folds.
        pairs=f"ironing {{ contactor under; target block.yMax; friction {friction}; "
              f"normalScale {scale}; }}",
        end=end, rows=3000, frames=3,
        control="massDamping 3e3;").all()


def mean(times, values, start, end):
    chosen = [v for t, v in zip(times, values) if start <= t <= end]
    return sum(chosen) / len(chosen)


def forces(case):
    """Forces on the punch, N, where the literature has them: upwards and against the drag."""
    f = case.contact("ironing")
    return {"pressed, vertical": mean(f["time"], f["fy"], 0.98 * PRESS, PRESS),
            "pressed, horizontal": mean(f["time"], [abs(x) for x in f["fx"]], 0.98 * PRESS, PRESS),
            "dragged, vertical": mean(f["time"], f["fy"], MIDDLE - 5e-5, MIDDLE + 5e-5),
            "dragged, horizontal": -mean(f["time"], f["fx"], MIDDLE - 5e-5, MIDDLE + 5e-5)}


def run(binaries, marks, block, cells, end=END):
    with ironed(binaries, block, cells, end) as case:
        found = forces(case)
        for name, band in BANDS.items():
            marks.within(f"{block[0]} x {block[1]} {name}", found[name], *band, " N")
        marks.below("energy balance", case.worstBalance(), 0.01)
        energies = case.energies()
        least = min(energies["hourglass"])
        marks.true(f"hourglass energy never negative ({least:.2g})",
                   least > -1e-9 * max(energies["internal"]))


def coarse(binaries, marks):
    run(binaries, marks, (60, 15), (12, 6))


def check(binaries, marks):
    """Both sides twice as fine. Behind the punch the block unloads at finite strain: a hourglass
    stiffness that makes energy in closed paths turns an element inside out at 3 ms."""
    run(binaries, marks, (120, 30), (24, 12))
