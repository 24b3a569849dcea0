"""Hexahedra as Gmsh files of format 2.2, for bodies of type `file`."""

import math


class Hexahedra:
    """Nodes joined where their places agree to 1e-9 of the unit; one part."""

    def __init__(self, name):
        self.name, self.nodes, self.elements, self.numbers = name, [], [], {}

    def node(self, place):
        key = tuple(round(x, 9) + 0.0 for x in place)
        if key not in self.numbers:
            self.numbers[key] = len(self.nodes)
            self.nodes.append(tuple(place))
        return self.numbers[key]

    def add(self, corners):
        """Eight places, the lower four counter-clockwise seen from the upper ones."""
        self.elements.append([self.node(corner) for corner in corners])

    def block(self, cells, place):
        """A box of cells; place(u, v, w) maps the unit cube, right-handed."""
        counts = cells
        unit = [[i / n for i in range(n + 1)] for n in counts]
        for i in range(counts[0]):
            for j in range(counts[1]):
                for k in range(counts[2]):
                    self.add([place(unit[0][i + a], unit[1][j + b], unit[2][k + c])
                              for a, b, c in ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0),
                                              (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))])

    def text(self):
        lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames", "1",
                 f'3 1 "{self.name}"', "$EndPhysicalNames", "$Nodes", str(len(self.nodes))]
        lines += [f"{i + 1} {x!r} {y!r} {z!r}" for i, (x, y, z) in enumerate(self.nodes)]
        lines += ["$EndNodes", "$Elements", str(len(self.elements))]
        lines += [f"{i + 1} 5 2 1 1 " + " ".join(str(n + 1) for n in element)
                  for i, element in enumerate(self.elements)]
        return "\n".join(lines + ["$EndElements", ""])


# Inner hexahedron of the patch in the unit cube after MacNeal and Harder 1985; their fifth node has
# y = 0.186, where a corner of the element below it turns inside out, which fpmMesh refuses.
PATCH_INNER = [
    (0.249, 0.342, 0.192), (0.826, 0.288, 0.288), (0.850, 0.649, 0.263), (0.273, 0.750, 0.230),
    (0.320, 0.286, 0.643), (0.677, 0.305, 0.683), (0.788, 0.693, 0.644), (0.165, 0.745, 0.702)]
PATCH_OUTER = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1),
               (0, 1, 1)]


def patch(name):
    """Seven hexahedra: the inner one and one for each of its faces."""
    mesh = Hexahedra(name)
    mesh.add(PATCH_INNER)
    for face in ((3, 2, 1, 0), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6),
                 (3, 0, 4, 7)):
        # Seen from outside counter-clockwise: the outer face lies above the inner one.
        mesh.add([PATCH_INNER[i] for i in face] + [PATCH_OUTER[i] for i in face])
    return mesh


def quarterSphere(name, radius, core, rings, lowerHalf=False, inner=0.5):
    """x >= 0, y >= 0 of a ball about the origin (z <= 0 alone with lowerHalf): an inner cube of
    `core` cells a half edge, bulging outwards, and `rings` cells from it to the surface."""
    mesh = Hexahedra(name)

    def unitBall(p):
        """Of a cube's surface point: the point of the unit sphere at equal angles."""
        q = [math.tan(math.pi / 4 * x) if abs(x) < 1 else x for x in p]
        length = math.sqrt(sum(x * x for x in q))
        return [x / length for x in q]

    def cubePoint(p):
        """Inside the bulging cube: between the flat cube and the sphere, half way at its surface."""
        m = max(abs(x) for x in p)
        if m == 0:
            return (0.0, 0.0, 0.0)
        ball = unitBall([x / m for x in p])
        flat = [x / math.sqrt(2) for x in p]
        bulge = 0.5 * m
        return tuple(inner * radius * ((1 - bulge) * f + bulge * m * b)
                     for f, b in zip(flat, ball))

    def shell(p, w):
        """From the cube's surface (w = 0) to the sphere (w = 1)."""
        start, end = cubePoint(p), [radius * x for x in unitBall(p)]
        return tuple((1 - w) * a + w * b for a, b in zip(start, end))

    bottom, high = -1.0, (0 if lowerHalf else 1)
    tall = core if lowerHalf else 2 * core

    def z(w):
        return bottom + (high - bottom) * w
    mesh.block((core, core, tall), lambda u, v, w: cubePoint((u, v, z(w))))
    mesh.block((rings, core, tall), lambda u, v, w: shell((1, v, z(w)), u))
    mesh.block((core, rings, tall), lambda u, v, w: shell((u, 1, z(w)), v))
    mesh.block((core, core, rings), lambda u, v, w: shell((u, v, -1), 1 - w))
    if not lowerHalf:
        mesh.block((core, core, rings), lambda u, v, w: shell((u, v, 1), w))
    return mesh


def graded(length, first, growth):
    """Ends of cells from 0 to `length`, the first about `first`, each longer by `growth`."""
    count = max(1, round(math.log(1 + length * (growth - 1) / first) / math.log(growth)))
    ends = [(growth**i - 1) / (growth**count - 1) * length for i in range(count + 1)]
    return ends
