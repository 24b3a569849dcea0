"""What stops a run, or is reported before it, with the words that help."""

from driver.scene import Scene, elastic

STEEL = elastic("a", 210000, 0.3, 7.85e-9) + elastic("b", 210000, 0.3, 7.85e-9)


def deepStart(binaries, marks):
    """A block in a plate one element thick: held down to half the plate, refused beyond it."""
    for depth, holds in ((0.3, True), (0.45, True), (0.6, False), (0.9, False)):
        with Scene(binaries, end=1e-6, parts=STEEL,
                   bodies="a { type box; origin (0 0 0); size (10 10 1); cells (5 5 1); }"
                          f"b {{ type box; origin (2.5 2.5 {1 - depth}); size (4 4 4); "
                          "cells (3 3 3); }",
                   pairs="p { contactor b; target a; initialOverlap ramp; rampTime 1e-6; }",
                   initial="v { type velocity; part b; value (0 0 -5000); }") as case:
            case.run("fpmMesh")
            done = {name: case.start(name) for name in ("fpmSetContact", "fpmExplicit")}
            for name, run in done.items():
                told = f"lies {depth} deep, and contact finds a node down to 0.5" in run.stdout
                marks.true(f"{depth} deep: {name} {run.returncode}",
                           run.returncode == (0 if holds else 3) and told == (not holds))
            if holds:
                marks.true("and it is held", max(case.contact("p")["active"]) == 16)


def overlap(binaries, marks):
    """Bodies that overlap by an error of the mesh stay at rest; a wall inside a body is refused."""
    bodies = ("a { type box; origin (0 0 0); size (10 10 2); cells (5 5 1); }"
              "b { type box; origin (2.5 2.5 1.5); size (4 4 4); cells (3 3 3); }")
    for option, rests in (("", True), ("initialOverlap report;", False)):
        with Scene(binaries, end=1e-5, parts=STEEL, bodies=bodies,
                   pairs=f"p {{ contactor b; target a; {option} }}") as case:
            case.mesh()
            output = case.run("fpmExplicit")
            most = max(case.energies()["kinetic"])
            marks.true(f"{option or 'default'}: kinetic energy {most:.3g}", (most == 0) == rests)
            marks.true("how deep", "deepest 0.5" in output)
    wall = "wall { type plane; point (0 0 0.5); normal (0 0 1); }"
    for option, code in (("", 3), ("initialOverlap report;", 0)):
        with Scene(binaries, end=1e-7, parts=elastic("a", 210000, 0.3, 7.85e-9),
                   bodies="a { type box; origin (0 0 0); size (10 10 2); cells (5 5 1); }",
                   pairs=f"p {{ contactor a; target wall; {option} }}", surfaces=wall) as case:
            case.run("fpmMesh")
            done = case.start("fpmSetContact")
            marks.true(f"wall, {option or 'default'}: status {done.returncode}",
                       done.returncode == code)
            marks.true("says what and what to do", code == 0 or (
                "36 contactor nodes begin inside the surface wall, deepest 0.5" in done.stdout
                and "initialOverlap report;" in done.stdout))


PLANES = """bot { type plane; point (0 0 0); normal (0 0 1); }
top { type plane; point (0 0 40); normal (0 0 -1);
      motion { displacement (0 0 -36); amplitude smooth ((0 0) (2e-2 1)); } }"""
# Nodes of the top face, led through the bottom: no element of any form keeps its volume.
LED = """held { type fixed; set a.zMin; }
led { type displacement; set a.zMax; value (0 0 -44); amplitude smooth ((0 0) (2e-2 1)); }"""


def crushed(binaries, marks):
    """Foam crushed to a tenth, and to less than nothing: where, how much, and what helps then."""
    contact = {"pairs": "".join(f"{name} {{ contactor a; target {name}; friction 0.3; }}"
                                for name in ("top", "bot")),
               "surfaces": PLANES}
    for form, load, more in (
            ("selective", contact, "hexahedron reduced and erosion { inverted yes; }"),
            ("reduced", {"conditions": LED}, "let part a have erosion { inverted yes; }"),
            ("reduced; erosion { inverted yes; }", {"conditions": LED}, "")):
        with Scene(binaries, end=2e-2,
                   parts="a { model elastic; density 1e-10; youngsModulus 1; poissonsRatio 0.1; "
                         f"hexahedron {form}; }}",
                   bodies="a { type box; origin (0 0 0); size (40 40 40); cells (4 4 4); }",
                   control="energyBalance { stop 1e3; warning 1e3; }", **load) as case:
            case.mesh()
            done = case.start("fpmExplicit", "-threads", "1")
            if not more:
                marks.true(f"erosion helps: status {done.returncode}", done.returncode == 0
                           and "no positive volume any more" not in done.stdout)
                continue
            marks.true(f"{form}: status {done.returncode}", done.returncode == 10)
            marks.true("where and how much", "no positive volume any more: at (" in done.stdout
                       and "times as long as at the start" in done.stdout)
            marks.true("erosion, elements, material", more in done.stdout
                       and "coarser or pre-shaped elements" in done.stdout)
            marks.true("no smaller step", "smaller timeStep.safety" not in done.stdout)


def huge(binaries, marks):
    """Values that the arithmetic does not hold are no silent zeros."""
    for size, precision, code, why in (
            ("1e160", "double", 3, "must be a vector (x y z), found 1e160"),
            ("1e60", "double", 10, "check the sizes and units of initial velocities"),
            ("1e60", "single", 10, "check the sizes and units of initial velocities")):
        with Scene(binaries, end=1e-6, parts=elastic("a", 210000, 0.3, 7.85e-9),
                   bodies="a { type box; origin (0 0 0); size (4 4 4); cells (2 2 2); }",
                   initial=f"v {{ type velocity; part a; value ({size} 0 0); }}") as case:
            case.mesh()
            done = case.start("fpmExplicit", "-precision", precision)
            marks.true(f"velocity {size}, {precision}: status {done.returncode}",
                       done.returncode == code and why in done.stdout)


def misspelt(binaries, marks):
    """A load in a file of nearly the right name is not left out without a word."""
    with Scene(binaries, end=1e-7, parts=elastic("a", 210000, 0.3, 7.85e-9),
               bodies="a { type box; origin (0 0 0); size (1 1 1); cells (1 1 1); }",
               conditions="g { type gravity; value (0 0 -9.81); }") as case:
        case.mesh()
        marks.true("gravity in mm is asked about", "its acceleration would be 0.00981 m/s2"
                   in case.run("fpmExplicit"))
        (case.root / "constant/boundaryConditions").rename(
            case.root / "constant/boundaryCondition")
        output = case.run("fpmExplicit")
        marks.true("boundaryCondition is reported", "warning: constant/boundaryCondition is not read"
                   in output)
