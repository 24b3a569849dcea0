"""A pin slides over two flush plates with a slit between them, as over one (after OpenRadioss #5079)."""

from driver.scene import Scene, elastic


def pin(binaries, slit):
    """Steel pin of 4 mm pressed by 2 kN, without friction, at 20 m/s; it is over the slit at 0.3 ms."""
    steel = (210000, 0.3, 7.85e-9)
    return Scene(
        binaries,
        bodies="left { type box; origin (0 0 0); size (20 10 4); cells (10 5 2); }\n"
               f"right {{ type box; origin ({20 + slit!r} 0 0); size (20 10 4); cells (10 5 2); }}\n"
               "pin { type box; origin (10 4 4.02); size (4 2 4); cells (4 2 4); }",
        parts="".join(elastic(name, *steel) for name in ("left", "right", "pin")),
        conditions="f1 { type fixed; part left; }\nf2 { type fixed; part right; }\n"
                   "press { type force; set pin.zMax; value (0 0 -2000); distribution area; "
                   "amplitude smooth ((0 0) (1e-4 1)); }",
        initial="v { type velocity; part pin; value (20000 0 0); }",
        pairs="a { contactor pin; target left; }\nb { contactor pin; target right; }",
        functions="pin { type part; part pin; }", end=1e-3, rows=100).all()


def check(binaries, marks):
    for slit in (0.3, 0.05, 0.0):
        with pin(binaries, slit) as case:
            momentum = case.table("pin/0/part.dat")["px"]
            marks.against(f"slit {slit} mm: momentum after it", momentum[-1] / momentum[0], 1, 0.01)
            marks.within("least and", min(momentum) / momentum[0], 0.97, 1.01)
            marks.within("largest on the way", max(momentum) / momentum[0], 0.99, 1.01)
