"""Free bodies that turn: a spinning cube, and a brick about its intermediate axis."""

import math

from driver.scene import NO_VISCOSITY, Scene, elastic


def lattice(size, cells):
    """Nodes of a box about the origin with the masses of their cells, as shares of the whole."""
    nodes = []
    for i in range(cells[0] + 1):
        for j in range(cells[1] + 1):
            for k in range(cells[2] + 1):
                place = tuple(s * (n / c - 0.5) for s, n, c in zip(size, (i, j, k), cells))
                share = 1.0
                for n, c in zip((i, j, k), cells):
                    share *= (0.5 if n in (0, c) else 1.0) / c
                nodes.append((place, share))
    return nodes


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def plus(a, b, factor=1.0):
    return tuple(x + factor * y for x, y in zip(a, b))


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def spinning(binaries, size, cells, part, omega, end, rows, watched):
    """The box with the velocity field omega x r; the nodes `watched` are recorded."""
    nodes = lattice(size, cells)
    origin = " ".join(repr(-s / 2) for s in size)
    functions = []
    for n in watched:
        position = " ".join(repr(x) for x in nodes[n][0])
        functions.append(f"p{n} {{ type point; part body; position ({position}); "
                         "fields (displacement velocity); }")
    axis = " ".join(repr(w) for w in omega)
    spin = math.sqrt(dot(omega, omega))
    return Scene(
        binaries, units="m", end=end, rows=rows, parts=part,
        bodies=f"body {{ type box; origin ({origin}); size ({size[0]} {size[1]} {size[2]}); "
               f"cells ({cells[0]} {cells[1]} {cells[2]}); }}",
        initial=f"spin {{ type rotation; part body; axis ({axis}); centre (0 0 0); "
                f"angularVelocity {spin!r}; }}",
        functions="\n".join(functions)).all(), nodes


class Watched:
    """Positions and velocities of the recorded nodes."""

    def __init__(self, case, nodes, watched):
        self.shares = [nodes[n][1] for n in watched]
        self.places = [nodes[n][0] for n in watched]
        self.u = [case.point(f"p{n}") for n in watched]
        self.v = [case.point(f"p{n}", "velocity") for n in watched]
        self.times = self.u[0]["time"]

    def state(self, row):
        """(share, position, velocity) of each."""
        return [(s, plus(p, (u["ux"][row], u["uy"][row], u["uz"][row])),
                 (v["vx"][row], v["vy"][row], v["vz"][row]))
                for s, p, u, v in zip(self.shares, self.places, self.u, self.v)]


def cube(binaries, marks):
    """Steel cube 0.1 m, 200 rad/s, 20 turns."""
    nodes = range(27)
    part = elastic("body", 210e9, 0.3, 7850, NO_VISCOSITY)
    case, lat = spinning(binaries, (0.1, 0.1, 0.1), (2, 2, 2), part, (0, 0, 200.0),
                         20 * 2 * math.pi / 200, 400, nodes)
    with case:
        watched = Watched(case, lat, nodes)

        def momentum(row):
            total = (0.0, 0.0, 0.0)
            for share, x, v in watched.state(row):
                total = plus(total, cross(x, v), share)
            return total
        first = momentum(0)
        length = math.sqrt(dot(first, first))
        worst = max(math.sqrt(dot(d, d)) for d in (
            plus(momentum(row), first, -1) for row in range(0, len(watched.times), 10)))
        marks.below("A2 cube, 20 turns: angular momentum", worst / length, 1e-3)
        e = case.energies()
        start = e["kinetic"][0] + e["internal"][0]
        drift = max(abs(k + i + h - start)
                    for k, i, h in zip(e["kinetic"], e["internal"], e["hourglass"]))
        marks.below("kinetic + internal energy", drift / start, 1e-3)
        marks.below("hourglass / kinetic", max(e["hourglass"]) / start, 1e-5)


def eulerEquations(inertia, omega, end, step):
    """Torque-free motion in body axes (Runge-Kutta): times and omega."""
    a, b, c = inertia

    def rate(w):
        return ((b - c) / a * w[1] * w[2], (c - a) / b * w[2] * w[0], (a - b) / c * w[0] * w[1])
    times, path, w = [0.0], [omega], omega
    while times[-1] < end:
        k1 = rate(w)
        k2 = rate(plus(w, k1, step / 2))
        k3 = rate(plus(w, k2, step / 2))
        k4 = rate(plus(w, k3, step))
        w = tuple(w[i] + step / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]) for i in range(3))
        times.append(times[-1] + step)
        path.append(w)
    return times, path


def solve3(m, r):
    """Cramer's rule."""
    def det(a):
        return dot(a[0], cross(a[1], a[2]))
    columns = list(zip(*m))
    d = det(columns)
    return tuple(det([r if i == k else columns[i] for i in range(3)]) / d for k in range(3))


def bodyOmega(state, axis):
    """Of equal masses at corners: inertia^-1 H, along the body axis between two corners."""
    inertia, momentum = [[0.0] * 3 for _ in range(3)], (0.0, 0.0, 0.0)
    for _, x, v in state:
        momentum = plus(momentum, cross(x, v))
        for i in range(3):
            for j in range(3):
                inertia[i][j] += (dot(x, x) if i == j else 0.0) - x[i] * x[j]
    omega = solve3(inertia, momentum)
    along = plus(state[axis[1]][1], state[axis[0]][1], -1)
    return dot(omega, along) / math.sqrt(dot(along, along))


def brick(binaries, marks):
    """0.3 x 0.2 x 0.1 m, omega (0.1, 100, 0.1): the middle axis flips over again and again.

    The masses sit in the nodes, so the moments of inertia are those of the lattice; Euler's equations
    with them are the reference. The continuous brick flips at 0.19860, 0.54999 and 0.90138 s."""
    size, cells, mass = (0.3, 0.2, 0.1), (6, 4, 2), 47.1
    omega, end = (0.1, 100.0, 0.1), 0.8
    corners = [n for n, (p, _) in enumerate(lattice(size, cells))
               if all(abs(abs(x) - s / 2) < 1e-12 for x, s in zip(p, size))]
    # A tenth of steel's modulus: it stretches by a ten-thousandth.
    part = elastic("body", 21e9, 0.3, 7850, NO_VISCOSITY)
    case, nodes = spinning(binaries, size, cells, part, omega, end, 4000, corners)
    squares = [mass * sum(s * p[i] ** 2 for p, s in nodes) for i in range(3)]
    inertia = [sum(squares) - x for x in squares]
    times, path = eulerEquations(inertia, omega, end, 1e-5)
    exact = flips(times, [w[1] for w in path])
    with case:
        watched = Watched(case, nodes, corners)
        # Corners in the order of the lattice: the third is one edge in y from the first.
        wy = [bodyOmega(watched.state(row), (0, 2)) for row in range(len(watched.times))]
        found = flips(watched.times, wy)
        marks.true(f"D1 {len(found)} flips", len(found) == len(exact) == 2)
        for number, (ours, theirs) in enumerate(zip(found, exact)):
            marks.against(f"D1 brick: flip {number + 1}", ours, theirs, 0.005, "s")
        e = case.energies()
        start = e["kinetic"][0]
        drift = max(abs(k + i + h - start)
                    for k, i, h in zip(e["kinetic"], e["internal"], e["hourglass"]))
        marks.below("energy", drift / start, 1e-3)


def rigidBrick(binaries, marks):
    """The same brick as a rigidFree part, with the inertia of the continuous body."""
    with Scene(binaries, units="m", end=1.0, rows=4000,
               bodies="body { type box; origin (-0.15 -0.1 -0.05); size (0.3 0.2 0.1); "
                      "cells (2 2 2); }",
               parts="body { model rigidFree; density 7850; }",
               initial="spin { type rotation; part body; axis (0.1 100 0.1); centre (0 0 0); "
                       f"angularVelocity {math.sqrt(100**2 + 0.02)!r}; }}",
               control="timeStep { fixed 1e-5; }",
               functions="spin { type rigidBody; part body; }") as case:
        case.all()
        body = case.table("spin/0/rigidBody.dat")
        found = flips(body["time"], body["bodyWy"])
        marks.true(f"D1 rigid brick, {len(found)} flips", len(found) == 3)
        for ours, theirs in zip(found, (0.19860, 0.54999, 0.90138)):
            marks.against("D1 rigid brick: flip", ours, theirs, 0.005, "s")
        marks.against("largest omega_x", max(abs(w) for w in body["bodyWx"]), 86.603, 0.001, "1/s")
        e = case.energies()
        marks.against("kinetic energy", e["kinetic"][0], 1962.5035, 1e-3, "J")
        marks.below("its drift", max(abs(k / e["kinetic"][0] - 1) for k in e["kinetic"]), 1e-3)


def flips(times, values):
    found = []
    for i in range(1, len(times)):
        if (values[i - 1] < 0) != (values[i] < 0):
            found.append(times[i - 1] + (times[i] - times[i - 1]) * values[i - 1]
                         / (values[i - 1] - values[i]))
    return found


def check(binaries, marks):
    cube(binaries, marks)
    brick(binaries, marks)
    rigidBrick(binaries, marks)
