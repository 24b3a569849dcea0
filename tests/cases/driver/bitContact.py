"""Scenes of every kind and option of contact, for driver/bits.py."""

from driver.bitScenes import BitScene, elastic, partHistories, plastic
from driver.health import box

# Options of a pair, its lower and upper part where they are not elastic, and the gap at the start.
LAWS = {
    "smooth": ("", 0.02), "rough": ("friction 0.3;", 0.02),
    "decaying": ("friction { static 0.4; dynamic 0.1; decay 2e-5; }", 0.02),
    "printed": ("friction { static 0.3; form paper; }", 0.02),
    "decayingPrinted": ("friction { static 0.4; dynamic 0.1; decay 2e-5; form paper; }", 0.02),
    "lesser": ("friction 0.3; penalty min;", 0.02), "series": ("friction 0.3; penalty series;", 0.02),
    "masses": ("friction 0.3; penalty mass; normalScale 0.5;", 0.02),
    "damped": ("friction 0.3; normalDamping 0.4;", 0.02),
    "closest": ("friction 0.3; search closestParticle;", 0.02),
    "cold": ("friction 0.3; projection cold;", 0.02),
    "closestCold": ("friction 0.3; search closestParticle; projection cold;", 0.02),
    "two": ("friction 0.3; passes two;", 0.02),
    "twoDamped": ("friction { static 0.4; dynamic 0.2; decay 1e-5; } passes two; normalDamping 0.2; "
                  "penalty series;", 0.02),
    "offset": ("friction 0.3;", -0.1),
    "ramp": ("friction 0.3; initialOverlap ramp; rampTime 5e-6;", -0.1),
    "report": ("friction 0.3; initialOverlap report;", -0.1),
    "moved": ("friction 0.3; initialOverlap move;", -0.1),
    "soft": ("friction 0.2; normalScale 0.2; tangentialScale 0.05;", 0.02),
}


def towers(binaries):
    """Blocks on blocks, a pair of its own law each; the faces do not match."""
    place = {name: (9.0 * (i % 5), 9.0 * (i // 5)) for i, name in enumerate(LAWS)}
    return BitScene(
        binaries,
        bodies="".join(box(f"{name}L", (x, y, 0), (6, 6, 2), (4, 4, 2))
                       + box(f"{name}U", (x + 1.1, y + 1.2, 2 + LAWS[name][1]), (3, 3, 3), (3, 3, 3))
                       for name, (x, y) in place.items()),
        parts="".join(elastic(f"{name}L") + plastic(f"{name}U") for name in LAWS),
        conditions="".join(f"foot_{name} {{ type fixed; set {name}L.zMin; }}\n" for name in LAWS),
        initial="".join(f"v_{name} {{ type velocity; part {name}U; value (3e4 -1e4 -5e4); }}\n"
                        for name in LAWS),
        pairs="".join(f"{name} {{ contactor {name}U; target {name}L; {LAWS[name][0]} }}\n"
                      for name in LAWS),
        functions=partHistories(f"{name}U" for name in LAWS))


# Rigid surfaces about blocks at places along x; speed of the block.
SURFACES = {
    "plane": "type plane; point (0 0 -0.02); normal (0 0.1 1); motion { velocity (0 0 1e4); }",
    "cylinder": "type cylinder; axis ((10 -9 -5.05) (10 12 -5.05)); radius 5; "
                "motion { displacement (0 0 1); amplitude smooth ((0 0) (3e-5 1)); }",
    "pipe": "type cylinder; axis ((20 0 1.9) (20 1 1.9)); infinite yes; radius 2.7; side inside;",
    "ball": "type sphere; centre (31.5 1.4 -4.02); radius 4; motion { velocity (1e4 0 1e4); }",
    "bowl": "type sphere; centre (41.6 1.5 1.6); radius 2.75; side inside;",
}
SHIFT = {"pipe": -1.5}
SPRINGS = "enforcement penalty; friction 0.3; normalDamping 0.1;"
EXACT = "friction { static 0.4; dynamic 0.2; decay 1e-5; }"


def surfaces(binaries, law, corners):
    """`corners`: blocks that lie in a corner of a round surface and a plane."""
    names = list(SURFACES)
    side = "side { type plane; point (0 3.05 0); normal (0 -1 0.2); }\n" if corners else ""
    return BitScene(
        binaries,
        bodies="".join(box(f"{name}Block", (10.0 * i + SHIFT.get(name, 0), 0, 0), (3, 3, 3), (4, 4, 4))
                       for i, name in enumerate(names)),
        parts="".join(plastic(f"{name}Block") for name in names),
        initial="".join(f"v_{name} {{ type velocity; part {name}Block; value (2e4 1e4 -4e4); }}\n"
                        for name in names),
        pairs="".join(f"{name} {{ contactor {name}Block; target {name}; {law} "
                      "initialOverlap report; }\n" for name in names)
        + "".join(f"{name}Side {{ contactor {name}Block; target side; {law} "
                  "initialOverlap report; }\n" for name in corners),
        surfaces="".join(f"{name} {{ {text} }}\n" for name, text in SURFACES.items())
        + side,
        functions=partHistories(f"{name}Block" for name in names)
        + "".join(f"force_{name} {{ type reaction; surface {name}; }}\n" for name in names))


SPEEDS = (("a", "(0 0 0)"), ("b", "(2e4 -1e4 -6e4)"), ("c", "(-9e4 0 -2e4)"))
THREE = (box("a", (0, 0, 0), (9, 9, 2), (6, 6, 2)) + box("b", (1.1, 1.2, 2.03), (4, 4, 3), (4, 4, 3))
         + box("c", (5.2, 1.7, 2.05), (3, 3, 4), (2, 2, 3)))


def threeBodies(contact, last=None, sets=""):
    """Three bodies that meet each other."""
    return lambda binaries: BitScene(
        binaries, bodies=THREE, sets=sets,
        parts=elastic("a") + plastic("b") + (last or elastic("c")),
        conditions="foot { type fixed; set a.zMin; }",
        initial="".join(f"v_{n} {{ type velocity; part {n}; value {v}; }}\n" for n, v in SPEEDS),
        functions="contactForces { type contactForces; }\n" + partHistories(("a", "b")),
        files={"system/contactDict": contact})


ALL = ("all { type union; sets (a.zMax b.xMin b.xMax b.yMin b.yMax b.zMin b.zMax c.xMin c.xMax c.yMin "
       "c.yMax c.zMin); }")
OWN = "pairs { own { contactor all; target all; friction 0.2; } }\n"


def eroding(contact):
    """A fast rod through two plates whose elements are deleted, under pressure from below."""
    return lambda binaries: BitScene(
        binaries,
        bodies=box("low", (0, 0, 0), (10, 10, 1), (10, 10, 2))
        + box("high", (0, 0, 1), (10, 10, 1), (10, 10, 2))
        + box("rod", (3.6, 3.7, 2.05), (3, 3, 5), (3, 3, 5)),
        parts=plastic("low", "erosion { plasticStrain 0.15; inverted yes; }")
        + plastic("high", "erosion { plasticStrain 0.1; } hourglass { form viscous; }")
        + plastic("rod", "erosion { inverted yes; }"),
        sets="rim { type union; sets (low.xMin low.xMax low.yMin low.yMax); }",
        conditions="foot { type fixed; set rim; }\n"
                   "blast { type pressure; set low.zMin; value 200; }\n"
                   "top { type pressure; set high.zMax; value 100; }\n",
        initial="v { type velocity; part rod; value (1e4 0 -6e5); }",
        functions="contactForces { type contactForces; }\n" + partHistories(("low", "high", "rod")),
        files={"system/contactDict": contact})


PLATES = """pairs
{
    rodHigh { contactor rod; target high; friction 0.2; }
    highLow { contactor high; target low; passes two; }
    rodLow  { contactor rod; target low; friction 0.2; }
}
"""

CONTACT = {
    "towers": (towers, 300),
    "surfaces": (lambda binaries: surfaces(binaries, SPRINGS, ()), 1000),
    "surfacesExact": (lambda binaries: surfaces(binaries, EXACT, ("ball", "bowl")), 1000),
    "general": (threeBodies("general { friction 0.3; }\n"), 500),
    "general.rigid": (threeBodies("general;\n", "c { model rigidFree; density 7.85e-9; }\n"), 500),
    "general.beside": (threeBodies(
        "general { friction 0.1; }\npairs { ab { contactor b; target a; passes two; } }\n"), 500),
    "self": (threeBodies(OWN, sets=ALL), 500),
    "eroding": (eroding(PLATES), 300),
    "eroding.general": (eroding("general { friction 0.2; }\n"), 400),
}
