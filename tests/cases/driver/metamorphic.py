"""The same impact elsewhere, turned, mirrored, renumbered and in other units: the same results.

A block strikes a plate with friction and slides. No reference is needed: what a change of the case must
do to its results is known. Factors that are powers of two change no digit of a number, so they must not
change one of a result either; everything else may differ by rounding."""

import random

from driver.gmshFile import Hexahedra
from driver.scene import Scene

AXES = range(3)
IDENTITY = ((1, 0, 0), (0, 1, 0), (0, 0, 1))
QUARTER = ((0, 0, 1), (1, 0, 0), (0, 1, 0))  # x to y, y to z, z to x
TURN = ((0, -1, 0), (1, 0, 0), (0, 0, 1))  # by 90 degrees about z
MIRROR = ((-1, 0, 0), (0, 1, 0), (0, 0, 1))
# Half an ulp at each of some hundred operations a step in which a node is in contact, 1500 steps, and a
# gap that is a thousandth of the coordinates it is the difference of: 1e-16 sqrt(1.5e5) 1e3, and as much
# again for what grows from it.
ROUNDING = 1e-10
# Friction turns its stored force with the xi edges of the face, which shear off eta's by a strain: what
# differs is of second order. Strain: speed of impact over speed of waves.
STRAIN = 20000 / 5.1e6
XI_REVERSED, ETA_FOR_XI = (1, 0, 3, 2, 5, 4, 7, 6), (1, 2, 3, 0, 5, 6, 7, 4)


class Variant:
    """Places x to `matrix` x `length` + shift; units scaled; nodes and elements in another order, and
    those of an element."""

    def __init__(self, matrix=IDENTITY, shift=(0.0, 0.0, 0.0), length=1.0, mass=1.0, time=1.0,
                 shuffled=0, corners=tuple(range(8))):
        self.matrix, self.shift, self.shuffled, self.corners = matrix, shift, shuffled, corners
        self.length, self.mass, self.time = length, mass, time

    def turned(self, vector, factor=1.0):
        return tuple(factor * sum(self.matrix[i][j] * vector[j] for j in AXES) for i in AXES)

    def place(self, x):
        return tuple(a + b for a, b in zip(self.turned(x, self.length), self.shift))

    def mesh(self, name, origin, size, cells):
        mesh = Hexahedra(name)
        mesh.block(cells, lambda u, v, w: tuple(
            o + s * x for o, s, x in zip(origin, size, (u, v, w))))
        mesh.nodes = [self.place(node) for node in mesh.nodes]
        mesh.elements = [[element[i] for i in self.corners] for element in mesh.elements]
        if self.shuffled:
            renumber(mesh, random.Random(self.shuffled))
        return mesh.text()


def renumber(mesh, draw):
    order = list(range(len(mesh.nodes)))
    draw.shuffle(order)
    new = {old: number for number, old in enumerate(order)}
    mesh.nodes = [mesh.nodes[old] for old in order]
    mesh.elements = [[new[node] for node in element] for element in mesh.elements]
    draw.shuffle(mesh.elements)


def text(vector):
    return "(" + " ".join(repr(x) for x in vector) + ")"


PLACES = {"corner": ("b", (2.1, 2.2, 2.02)), "far": ("b", (5.1, 5.2, 5.02)), "plate": ("a", (4, 4, 2))}


def scene(binaries, v):
    """Some 1500 steps, in contact for most of them."""
    stress, density = v.mass / v.length / v.time**2, v.mass / v.length**3

    def part(name, youngs, rho):
        return (f"{name} {{ model elastic; density {rho * density!r}; "
                f"youngsModulus {youngs * stress!r}; poissonsRatio 0.3; }}\n")
    end = 3e-5 * v.time
    return Scene(
        binaries, end=end, rows=20,
        bodies='a { type file; file "a.msh"; }\nb { type file; file "b.msh"; }',
        parts=part("a", 210000.0, 7.85e-9) + part("b", 70000.0, 2.7e-9),
        sets=f"foot {{ type plane; point {text(v.place((0, 0, 0)))}; "
             f"normal {text(v.turned((0, 0, 1.0)))}; bodies (a); }}",
        conditions="foot { type fixed; set foot; }",
        initial="v { type velocity; part b; value "
                f"{text(v.turned((9000.0, -4000.0, -20000.0), v.length / v.time))}; }}",
        pairs="p { contactor b; target a; friction 0.3; }",
        functions="".join(
            f"{name} {{ type point; part {part}; position {text(v.place(place))}; "
            "fields (displacement velocity); }\n" for name, (part, place) in PLACES.items()),
        files={"a.msh": v.mesh("a", (0, 0, 0), (8, 8, 2), (4, 4, 1)),
               "b.msh": v.mesh("b", (2.1, 2.2, 2.02), (3, 3, 3), (2, 2, 2))})


def measured(binaries, v):
    """Histories in the axes and units of the first case: curves by name."""
    with scene(binaries, v).all() as case:
        back = [[v.matrix[j][i] for j in AXES] for i in AXES]
        out = {}

        def vectors(name, table, columns, unit):
            rows = list(zip(*(table[c] for c in columns)))
            for i in AXES:
                # A factor of 1 or -1 in every row: no sum rounds.
                out[f"{name} {'xyz'[i]}"] = [sum(back[i][j] * row[j] for j in AXES) / unit
                                             for row in rows]
        for name in PLACES:
            table = case.point(name)
            out[f"{name} time"] = [t / v.time for t in table["time"]]
            vectors(f"{name} displacement", table, ("ux", "uy", "uz"), v.length)
            vectors(f"{name} velocity", case.point(name, "velocity"), ("vx", "vy", "vz"),
                    v.length / v.time)
        energy = v.mass * v.length**2 / v.time**2
        for name, values in case.energies().items():
            if name not in ("time", "balance", "kineticShare"):
                out[f"energy {name}"] = [e / energy for e in values]
        table = case.contact("p")
        force = v.mass * v.length / v.time**2
        vectors("force", table, ("fx", "fy", "fz"), force)
        out["active"] = table["active"]
        steps = int(case.status()["steps"])
    return out, steps


def scaleOf(name, curves):
    """Largest value of what is of the same kind: a component may be zero."""
    kind = name.rsplit(" ", 1)[0]
    return max(abs(x) for other, values in curves.items() if other.rsplit(" ", 1)[0] == kind
               for x in values)


def distance(ours, first):
    """Largest difference over the largest value of its kind, and the curve that has it."""
    worst = (0.0, "-")
    for name, values in first.items():
        scale = scaleOf(name, first)
        if len(values) != len(ours[name]):
            return float("inf"), f"rows of {name}"
        if scale > 0:
            worst = max(worst, (max(abs(a - b) for a, b in zip(ours[name], values)) / scale, name))
    return worst


POWERS = Variant(length=2.0**3, mass=2.0**-5, time=2.0**4)
VARIANTS = {
    "moved by 2^10 lengths": (Variant(shift=(8192.0, -8192.0, 8192.0)), 8192 / 8 * ROUNDING),
    "turned by 90 degrees about z": (Variant(matrix=TURN), ROUNDING),
    "axes exchanged": (Variant(matrix=QUARTER), ROUNDING),
    "mirrored": (Variant(matrix=MIRROR, corners=XI_REVERSED), ROUNDING),
    "elements numbered from another corner": (Variant(corners=ETA_FOR_XI), STRAIN**2),
    "nodes and elements renumbered": (Variant(shuffled=3), ROUNDING),
    "in m and kg": (Variant(length=1e-3, mass=1e3), ROUNDING),
}


def check(binaries, marks):
    first, steps = measured(binaries, Variant())
    marks.note(f"{steps} steps")
    marks.true("they touch and slide", max(first["active"]) >= 4
               and max(first["energy friction"]) > 0)
    for name, (variant, most) in VARIANTS.items():
        ours, _ = measured(binaries, variant)
        far, where = distance(ours, first)
        marks.within(f"{name}, {where}", far, 0, most)
    ours, _ = measured(binaries, POWERS)
    other = [name for name in first if ours[name] != first[name]]
    marks.note(f"units times powers of two, {len(other)} of {len(first)} curves differ in a bit")
    if other:
        marks.failures.append(f"powers of two: {', '.join(other)}")
