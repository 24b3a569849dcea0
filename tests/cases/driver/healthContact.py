"""Sick contact finds fault with itself; what its advice says cures it."""

from driver.health import GENERAL, box, elastic, judged, pressed, steel
from driver.scene import Scene

DEEP, THROUGH = "penetration / width of a face", "penetration / thickness of the target"
LOST = "contactors that left over a free edge while inside"


def columns(binaries, low, cells, strain, scale):
    """Two columns of 1 x 1, of which only the height changes, pressed by a share of it. The springs
    are 4 K s_n, those of the elements E = 3 K: the soft ones sink by 3/4 of the strain / s_n."""
    return Scene(binaries, bodies=box("a", (0, 0, 0), (1, 1, low), (1, 1, cells))
                 + box("b", (0, 0, low), (1, 1, 10), (1, 1, 10)),
                 parts="".join(elastic(name, "210000", "0", "7.85e-9") for name in "ab"),
                 end=1e-4, rows=100, control="massDamping 2e5;",
                 conditions="f { type fixed; set a.zMin; } g { type fixed; part a; "
                 "components (x y); } h { type fixed; part b; components (x y); } "
                 f"d {{ type displacement; set b.zMax; value (0 0 {-strain * (low + 10)}); "
                 "components (z); amplitude smooth ((0 0) (9e-5 1)); }",
                 pairs=f"p {{ contactor b.zMin; target a.zMax; normalScale {scale}; }}")


def depth(binaries, marks):
    """Bodies sink into one another: much energy in springs, or deep beside face or thickness."""
    judged(marks, "pressed", pressed(binaries, "normalScale 3;", 0.02), [])
    judged(marks, "soft springs", pressed(binaries, "normalScale 0.1;", 0.1),
           ["energy in contact springs / internal energy"])
    judged(marks, "cured by normalScale 1", pressed(binaries, "normalScale 1;", 0.1), [])
    # Tall columns hold more energy than springs that are as deep.
    judged(marks, "deep beside the face", columns(binaries, 10, 10, 0.15, 0.3), [DEEP])
    judged(marks, "cured by normalScale 1", columns(binaries, 10, 10, 0.15, 1), [])
    judged(marks, "deep in a thin target", columns(binaries, 0.2, 1, 0.25, 0.3), [THROUGH])
    judged(marks, "cured by normalScale 1", columns(binaries, 0.2, 1, 0.25, 1), [])
    # Two figures: what sinks so far has both hardly any springs and a face's width of depth.
    judged(marks, "deep and soft", pressed(binaries, "normalScale 0.002;", 1.2),
           ["energy in contact springs / internal energy", DEEP])


def released(binaries, marks):
    """A block falls through a thin target."""
    def through(scale, rows):
        return Scene(binaries, bodies=box("a", (-3, -3, 0), (16, 16, 0.5), (4, 4, 1))
                     + box("b", (2, 2, 0.6), (6, 6, 6), (3, 3, 3)), parts=steel("a", "b"),
                     end=2e-5, rows=rows, conditions="f { type fixed; part a; }",
                     initial="v { type velocity; part b; value (0 0 -50000); }",
                     pairs=f"p {{ contactor b.zMin; target a.zMax; normalScale {scale}; }}")
    # Between two rows nobody measures the depth, but the solver counts.
    judged(marks, "through between two rows", through(1e-6, 1), ["contactors released"])
    # A released contactor was deeper than half the thickness before: a row saw it there.
    judged(marks, "through a thin target", through(1e-6, 80), [THROUGH, "contactors released"])
    judged(marks, "cured by a larger normalScale", through(1, 80), [])


def lists(binaries, marks):
    """A body that starts at 1000 m/s within a step, which no list of faces foresees."""
    def jump(control):
        return Scene(binaries, bodies=box("a", (0, 0, 0), (4, 4, 2), (4, 4, 2))
                     + box("b", (1, 1, 2.5), (2, 2, 2), (2, 2, 2)),
                     parts=steel("a") + "b { model rigidPrescribed; }", end=6e-6, rows=30,
                     conditions="f { type fixed; set a.zMin; } d { type velocity; part b; "
                     "value (0 0 1e6); amplitude table ((0 0) (3.5e-6 0) (3.51e-6 1)); }",
                     control=control, pairs="p { contactor b; target a; }")
    judged(marks, "outrun", jump(""), ["lists of faces that were outrun"])
    judged(marks, "cured by searchInterval", jump("searchInterval 1;"), [])
    judged(marks, "cured by timeStep.maximum", jump("timeStep { maximum 1e-8; }"), [])


def crowd(binaries, marks):
    """A node on the corner that four bodies have in common: it can be held by three."""
    def bricks(cases):
        """A block falls on bodies, each with its origin, size and cells."""
        names = [name for name, *_ in cases]
        return Scene(binaries, bodies="".join(box(*case) for case in cases)
                     + box("top", (1, 1, 2.3), (2, 2, 2), (2, 2, 2)), parts=steel("top", *names),
                     end=2e-5, rows=50, files=GENERAL, conditions="".join(
                         f"{name} {{ type fixed; set {name}.zMin; }} " for name in names),
                     initial="v { type velocity; part top; value (0 0 -20000); }")
    size, cells = (2, 2, 2), (1, 1, 2)
    front = [("b0", (0, 0, 0), size, cells), ("b1", (2, 0, 0), size, cells)]
    judged(marks, "four bricks at a corner", bricks(front + [
        ("b2", (0, 2, 0), size, cells), ("b3", (2, 2, 0), size, cells)]),
        ["searches with more than three bodies in reach of a node, or eight edges of an edge"])
    judged(marks, "cured by bricks that are staggered", bricks(front + [
        ("b2", (-1, 2, 0), size, cells), ("b3", (1, 2, 0), size, cells),
        ("b4", (3, 2, 0), size, cells)]), [])
    judged(marks, "cured by one body", bricks([("b", (0, 0, 0), (4, 4, 2), (2, 2, 2))]), [])
    # Of many thin layers the nearest holds a node; those behind it are none of its business.
    judged(marks, "on thin layers", Scene(
        binaries, bodies="".join(box(f"l{i}", (0, 0, 0.05 * i), (4, 4, 0.05), (2, 2, 1))
                                 for i in range(5))
        + box("top", (0.9, 0.9, 0.26), (2, 2, 1), (2, 2, 1)),
        parts=steel("l0", "l1", "l2", "l3", "l4", "top"), end=2e-6, rows=50, files=GENERAL,
        conditions="f { type fixed; set l0.zMin; } g { type force; set top.zMax; "
        "value (0 0 -10); distribution area; amplitude smooth ((0 0) (3e-6 1)); }"), [])


def snag(binaries, marks):
    """A pin slides over the gap between two flush plates and is thrown back: nodes of its front are
    released at the rim of the first plate and meet the side of the second."""
    def slides(plates):
        return Scene(binaries, bodies="".join(box(*plate) for plate in plates)
                     + box("p", (10, 4, 4.02), (4, 2, 4), (4, 2, 4)),
                     parts=steel("p", *(plate[0] for plate in plates)), end=3.3e-4, rows=100,
                     conditions="".join(f"{name} {{ type fixed; part {name}; }} "
                                        for name, *_ in plates)
                     + "g { type force; set p.zMax; value (0 0 -2000); distribution area; "
                     "amplitude smooth ((0 0) (1e-4 1)); }",
                     initial="v { type velocity; part p; value (20000 0 0); }",
                     pairs="".join(f"p{name} {{ contactor p; target {name}; normalScale 4; }} "
                                   for name, *_ in plates))
    judged(marks, "snag", slides([("l", (0, 0, 0), (20, 10, 4), (10, 5, 2)),
                                  ("r", (20.3, 0, 0), (20, 10, 4), (10, 5, 2))]), [LOST])
    judged(marks, "cured by plates that are joined",
           slides([("l", (0, 0, 0), (40, 10, 4), (20, 5, 2))]), [])
