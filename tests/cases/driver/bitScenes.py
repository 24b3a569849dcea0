"""Scenes of every element form, material, load and kind of motion, for driver/bits.py.

Small parts stand side by side, each with an option of its own and a history of its own, so that a
difference names the option."""

from driver.bitTutorials import setEntry
from driver.health import box
from driver.scene import NO_VISCOSITY, Scene

STEP = 3e-8  # about that of a millimetre of steel in contact [s]
STEEL = "density 7.85e-9; youngsModulus 210000; poissonsRatio 0.3;"
YIELD = "yieldStress 400; plasticModulus 1000;"
# What is wrong on purpose (rotation arcsin, penalty of mass) loses energy.
LOSES = "energyBalance { warning 1e3; stop 1e4; }\n"


class BitScene(Scene):
    """A row of the histories about every seven steps, a frame where the run ends."""

    def __init__(self, binaries, control="", **options):
        super().__init__(binaries, end=1e4 * STEP, rows=10000 / 7, control=LOSES + control, **options)

    def setEntry(self, name, value):
        setEntry(self, name, value)


def elastic(name, more=""):
    return f"{name} {{ model elastic; {STEEL} {more} }}\n"


def plastic(name, more="", curve=YIELD):
    return f"{name} {{ model elastoplastic; {STEEL} {curve} {more} }}\n"


def partHistories(names):
    return "".join(f"part_{name} {{ type part; part {name}; }}\n" for name in names)


def dropped(parts, speed=-1e5):
    """A row of blocks that strike a plane with friction while they spin; `parts`: text by name."""
    names = list(parts)
    place = {name: (6.0 * (i % 8), 6.0 * (i // 8)) for i, name in enumerate(names)}
    spins = "".join(
        f"v_{name} {{ type velocity; part {name}; value ({-0.3 * speed} {0.1 * speed} {speed}); }}\n"
        f"w_{name} {{ type rotation; part {name}; axis (1 2 3); centre ({x + 1.5} {y + 1.5} 3); "
        "angularVelocity 2e4; }\n" for name, (x, y) in place.items())
    return lambda binaries: BitScene(
        binaries, parts="".join(parts.values()), initial=spins,
        bodies="".join(box(name, (x, y, 0.02), (3, 3, 4), (3, 3, 4))
                       for name, (x, y) in place.items()),
        pairs="".join(f"p_{name} {{ contactor {name}; target floor; friction 0.2; }}\n"
                      for name in names),
        surfaces="floor { type plane; point (0 0 0); normal (0 0 1); }",
        functions=partHistories(names))


FORMS = {
    "physical": "", "stiffness": "hourglass { form stiffness; }",
    "viscous": "hourglass { form viscous; }", "half": "hourglass { coefficient 0.5; }",
    "floatPhysical": "hourglass { storage float; }",
    "floatStiffness": "hourglass { form stiffness; storage float; }",
    "uncoupled": "hourglass { plastic elastic; }",
    "selective": "hexahedron selective;", "selectiveSpin":
    "hexahedron selective; rotation hughesWinget;", "polar": "rotation polar;",
    "hughesWinget": "rotation hughesWinget;", "arcsin": "rotation arcsin;", "inviscid": NO_VISCOSITY,
    "viscousPolar": "rotation polar; hourglass { form viscous; }",
}
TABLE = "hardening table ((0 400) (0.02 450) (0.1 520));"
POWERS = "rate { law cowperSymonds; D 6500; p 4; }"
LOGARITHM = "rate { law johnsonCook; C 0.015; rate0 1; }"
HEATING = "heating { fraction 0.9; specificHeat 4.5e8; temperature 300; }"
COOK = ("johnsonCook { A 400; B 510; n 0.26; C 0.014; rate0 1; m 1.03; melt 1793; } "
        "heating { specificHeat 4.5e8; }")
MATERIALS = {
    "line": YIELD, "perfect": "yieldStress 400;", "tangent": "yieldStress 400; tangentModulus 2000;",
    "table": TABLE, "powers": f"{YIELD} {POWERS}", "logarithm": f"{TABLE} {LOGARITHM}",
    "heated": f"{TABLE} {HEATING}", "kinematic": "yieldStress 400; kinematic { modulus 900; }",
    "mixed": f"{YIELD} kinematic {{ fraction 0.5; }}", "cook": COOK,
    "cookCold": "johnsonCook { A 400; B 510; n 0.3; }",
    "kinematicRate": f"{YIELD} kinematic {{ modulus 300; }} {POWERS} {HEATING}",
}


def materials(more=""):
    return dropped({name: plastic(name, more, curve) for name, curve in MATERIALS.items()})


# Loads ------------------------------------------------------------------------------------------

RAMP = "amplitude smooth ((0 0) (1e-5 1) (1e-3 1));"
LOADS = {
    "equal": "{ type force; set equal.zMax; value (900 0 -500); }",
    "area": f"{{ type force; set area.zMax; value (0 0 -900); distribution area; {RAMP} }}",
    "traction": f"{{ type traction; set traction.zMax; value (90 0 30); {RAMP} }}",
    "pressure": "{ type pressure; set pressure.zMax; value 300; "
                "amplitude table ((0 1) (1e-5 0.2) (2e-5 0.7)); }",
    "gravity": "{ type gravity; parts (gravity); value (1e9 0 -1e9); }",
    "velocity": f"{{ type velocity; set velocity.zMax; value (0 2e4 0); components (y); {RAMP} }}",
    "axes": "{ type displacement; set axes.zMax; value (0.2 -0.1 0); components (x y); "
            f"axes ((1 1 0) (-1 1 0)); {RAMP} }}",
    "turn": "{ type rotation; set turn.zMax; axis (0 1 3); centre (43.5 1.5 4); angle 20; "
            "amplitude smooth ((0 0) (2e-5 1)); }",
    "mirror": "{ type symmetry; set mirror.yMin; normal (0 1 0); }",
    "oblique": "{ type symmetry; set oblique.xMin; normal (1 1 0); }",
}
FREE = ("mirror", "oblique")
DRIVEN = ("velocity", "axes", "turn")


def loads(control=""):
    """Columns held at the lower end, each under a load of its own."""
    names = list(LOADS)
    return lambda binaries: BitScene(
        binaries, control=control, parts="".join(elastic(name) for name in names),
        bodies="".join(box(name, (6.0 * i, 0, 0), (3, 3, 4), (3, 3, 4))
                       for i, name in enumerate(names)),
        conditions="".join(
            f"foot_{name} {{ type fixed; set {name}.zMin; {'components (z);' if name in FREE else ''} }}\n"
            f"load_{name} {LOADS[name]}\n" for name in names),
        initial="".join(f"v_{name} {{ type velocity; set {name}.zMax; value (1e4 0 2e4); }}\n"
                        for name in FREE),
        functions=partHistories(names) + "".join(
            f"{kind}Force_{name} {{ type reaction; condition {kind}_{name}; }}\n"
            for name in names for kind in ("foot", "load") if kind == "foot" or name in DRIVEN)
        + "corner { type point; part turn; position (42 0 4); "
          "fields (displacement velocity acceleration); }\n")


# Bodies and control -----------------------------------------------------------------------------


def bodies(binaries):
    """Free, guided and driven rigid bodies strike and scrape blocks."""
    place = {name: 12.0 * i for i, name in enumerate(("free", "given", "guided", "driven"))}
    rigid = {
        "free": f"free {{ model rigidFree; {STEEL} }}\n",
        "given": "given { model rigidFree; mass 3e-7; centre (14 2.1 3.3); "
                 "inertia (6e-7 5e-7 4e-7 1e-8 -2e-8 1e-8); }\n",
        "guided": f"guided {{ model rigidFree; {STEEL} }}\n",
        "driven": "driven { model rigidPrescribed; }\n"}
    return BitScene(
        binaries, parts="".join(rigid[name] + plastic(f"{name}Base") for name in place),
        bodies="".join(box(name, (x + 0.5, 0.5, 2.05), (3, 3, 3), (2, 2, 2))
                       + box(f"{name}Base", (x, 0, 0), (6, 4, 2), (6, 4, 2))
                       for name, x in place.items()),
        conditions="".join(f"foot_{name} {{ type fixed; set {name}Base.zMin; }}\n" for name in place)
        + "guide { type fixed; part guided; components (x y); rotations (x y); }\n"
          "weight { type gravity; value (0 0 -1e8); }\n"
          "gear { type rotation; part driven; axis (0 1 0); centre (36 0 1); angle 30; "
          "amplitude smooth ((0 0) (3e-5 1)); }\n",
        initial="".join(f"v_{name} {{ type velocity; part {name}; value (2e4 1e4 -5e4); }}\n"
                        f"w_{name} {{ type rotation; part {name}; axis (1 1 2); centre ({x + 2} 2 3.5);"
                        " angularVelocity 5e3; }\n" for name, x in place.items() if name != "driven"),
        pairs="".join(f"p_{name} {{ contactor {name}Base; target {name}; friction 0.3; }}\n"
                      for name in place),
        functions="".join(f"body_{name} {{ type rigidBody; part {name}; }}\n"
                          for name in ("free", "given", "guided"))
        + "gearForce { type reaction; condition gear; }\n" + partHistories(["freeBase"]))


def struck(control, more=""):
    """A plastic block strikes an elastic one with friction."""
    return lambda binaries: BitScene(
        binaries, control=control, parts=elastic("low", more) + plastic("high", more),
        bodies=box("low", (0, 0, 0), (8, 7, 3), (8, 7, 3))
        + box("high", (1.3, 1.2, 3.02), (4, 4, 4), (4, 3, 4)),
        conditions="foot { type fixed; set low.zMin; }",
        initial="v { type velocity; part high; value (2e4 -1e4 -6e4); }",
        pairs="p { contactor high.zMin; target low.zMax; friction 0.3; }",
        functions=partHistories(("low", "high")) + "foot { type reaction; condition foot; }\n")


SCENES = {
    "elastic": (dropped({name: elastic(name, more) for name, more in FORMS.items()
                         if name != "uncoupled"}), 400),
    "plastic": (dropped({name: plastic(name, more) for name, more in FORMS.items()}), 400),
    "materials": (materials(), 400),
    "materials.selective": (materials("hexahedron selective;"), 250),
    "materials.uncoupled": (materials("hourglass { plastic elastic; }"), 250),
    "materials.viscous": (materials("hourglass { form viscous; } rotation polar;"), 250),
    "loads": (loads(), 400),
    "loads.relaxed": (loads("dynamicRelaxation { tolerance 1e-6; }"), 400),
    "bodies": (bodies, 500),
    "struck": (struck(""), 500),
    "struck.selective": (struck("", "hexahedron selective;"), 500),
    "struck.damped": (struck("massDamping 2e4;\nquasiStatic { }"), 500),
    "struck.scaled": (struck("massScaling { factor 4; }"), 500),
    "struck.scaledStep": (struck("massScaling { targetStep 2.5e-7; parts (high); }"), 500),
    "struck.fixedStep": (struck("timeStep { fixed 5e-8; }"), 500),
    "struck.startGeometry": (struck("strainGeometry start;"), 500),
    "struck.searchInterval": (struck("searchInterval 3;"), 500),
    "struck.paper": (struck("algorithm paper;"), 500),
}
