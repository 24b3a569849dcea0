"""Rigid walls that are met exactly: soft, pushed and struck blocks, beside the springs of a penalty.

The soft block is the question of contact manuals and user forums, why a foam or rubber sinks into a rigid
wall (springs as stiff as the step allows yield by the pressure over the bulk modulus, in elements)."""

import math

from driver.health import findings
from driver.scene import NO_VISCOSITY, Scene, elastic
from driver.waves import impulse

PLANES = """bot { type plane; point (0 0 0); normal (0 0 1); }
top { type plane; point (0 0 40); normal (0 0 -1);
      motion { displacement (0 0 -20); amplitude smooth ((0 0) (3e-2 1)); } }"""


def softBlock(binaries, law):
    """40 mm, E 1 MPa, nu 0, squeezed to half its height between two planes."""
    return Scene(
        binaries, bodies="a { type box; origin (0 0 0); size (40 40 40); cells (4 4 4); }",
        parts=elastic("a", 1, 0, 1e-9), surfaces=PLANES,
        pairs="".join(f"{name} {{ contactor a; target {name}; {law} }} " for name in ("top", "bot")),
        functions="upper { type point; part a; position (20 20 40); fields (displacement); }",
        control="massDamping 200;", end=4e-2, rows=400)


def steps(case):
    return int(case.performance()["steps"])


def squeezed(binaries, marks):
    exact = math.log(2) * 1600  # E ln 2 A, logarithmic strain
    with softBlock(binaries, "") as case, softBlock(binaries, "enforcement penalty;") as soft, \
            softBlock(binaries, "enforcement penalty; normalScale 50;") as stiff:
        for one in (case, soft, stiff):
            one.all()
        for wall, sign in (("top", -1), ("bot", 1)):
            force = sign * case.contact(wall)["fz"][-1]
            marks.against(f"soft block, wall {wall}: force", force, exact, 0.01, "N")
        marks.within("way into the wall", abs(case.point("upper")["uz"][-1] + 20), 0, 1e-12, " mm")
        marks.below("energy balance", case.worstBalance(), 1e-3)
        marks.true("healthy", findings(case) == [])
        force = -soft.contact("top")["fz"][-1]
        marks.true(f"springs: {force:.0f} N, deep", force < 0.5 * exact)
        marks.true(f"steps {steps(case)}, springs {steps(soft)}, stiff springs "
                   f"{steps(stiff)}", steps(case) <= steps(soft) and
                   5 * steps(case) < steps(stiff))


def dropped(binaries, marks):
    """A block at 1 m/s onto a plane: it loses the energy of its lowest nodes, half a layer of mass."""
    speed, layers = 1000.0, 10
    with Scene(binaries,
               bodies=f"a {{ type box; origin (0 0 0.1); size (10 10 10); cells (4 4 {layers}); }}",
               parts=elastic("a", 200, 0.3, 8e-9, NO_VISCOSITY), surfaces=PLANES.split("top")[0],
               initial=f"v {{ type velocity; part a; value (0 0 {-speed}); }}",
               pairs="p { contactor a; target bot; }", control="timeStep { fixed 2e-6; }",
               functions="all { type part; part a; }", end=8e-4, rows=4000) as case:
        case.all()
        contact = case.contact("p")
        given = impulse(contact["time"], contact["fz"])
        momentum = case.table("all/0/part.dat")["pz"]
        marks.against("dropped block: impulse", given, momentum[-1] - momentum[0], 0.002, "N s")
        e = case.energies()
        marks.against("lost in the impact", e["contactDamping"][-1] / e["kinetic"][0],
                      1 / (2 * layers), 0.05)
        marks.below("energy balance", case.worstBalance(), 1e-4)


def pushed(binaries, marks):
    """A plane that gains 1 m/s in 2 ms pushes a block: its impulse is m v, its work m v^2 / 2."""
    mass = 8e-9 * 1000
    ram = ("bot { type plane; point (0 0 0); normal (0 0 1); motion { velocity (0 0 1000); "
           "amplitude smooth ((0 0) (2e-3 1)); } }")
    with Scene(binaries, bodies="a { type box; origin (0 0 0); size (10 10 10); cells (4 4 4); }",
               parts=elastic("a", 200, 0.3, 8e-9), surfaces=ram,
               pairs="p { contactor a; target bot; }", end=2e-3, rows=4000) as case:
        case.all()
        contact, e = case.contact("p"), case.energies()
        marks.against("pushed block: impulse", impulse(contact["time"], contact["fz"]),
                      mass * 1000, 0.01, "N s")
        marks.against("work", e["external"][-1], 0.5 * mass * 1e6, 0.02, "mJ")
        marks.below("energy balance", case.worstBalance(), 1e-3)


def check(binaries, marks):
    squeezed(binaries, marks)
    dropped(binaries, marks)
    pushed(binaries, marks)
