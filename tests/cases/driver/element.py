"""Few elements with known answers: the patch, rigid turns, simple shear, paths of plasticity.

Where all nodes follow a deformation x = F(t) X, every node and component has a table of its own, one
row a step, so the run is that motion and nothing else."""

import math

from driver.curves import at
from driver.gmshFile import PATCH_INNER, PATCH_OUTER, patch
from driver.scene import NO_VISCOSITY, Scene, elastic, plastic, table

CUBE = PATCH_OUTER
STEP = 2e-8  # below the stable one of a 1 mm cube of the stiffest metal here
AXES = "xyz"
# All nodes driven, in microseconds: the driving force works against inertia alone.
NO_AUDIT = "energyBalance { warning 1e30; stop 1e30; }"
STRESSES = ("XX", "YY", "ZZ", "XY", "YZ", "XZ")


def pointSets(places):
    return "\n".join(f"n{i} {{ type point; position ({x!r} {y!r} {z!r}); }}"
                     for i, (x, y, z) in enumerate(places))


def motion(node, place, path):
    """Displacement of a node along `path`, a list of (time, F)."""
    text = ""
    for c in range(3):
        rows = [(t, sum(f[c][k] * place[k] for k in range(3)) - place[c]) for t, f in path]
        if any(u for _, u in rows):
            value = " ".join("1" if k == c else "0" for k in range(3))
            text += (f"m{node}{AXES[c]} {{ type displacement; set n{node}; value ({value}); "
                     f"components ({AXES[c]}); amplitude {table(rows)}; }}\n")
        else:
            text += f"m{node}{AXES[c]} {{ type fixed; set n{node}; components ({AXES[c]}); }}\n"
    return text


def prescribed(binaries, part, deformation, steps, frames):
    """Stresses at the frames of a unit cube under deformation(s), s from 0 to 1."""
    path = [(k * STEP, deformation(k / steps)) for k in range(steps + 1)]
    with Scene(binaries, bodies="cube { type box; origin (0 0 0); size (1 1 1); cells (1 1 1); }",
               parts=part, sets=pointSets(CUBE), end=steps * STEP, frames=frames, rows=10 * frames,
               conditions="".join(motion(i, p, path) for i, p in enumerate(CUBE)),
               control=f"timeStep {{ fixed {STEP}; }}\n{NO_AUDIT}",
               tables="s { type point; field S; position (0.5 0.5 0.5); }\n"
                      "e { type extrema; field PEEQ; }") as case:
        case.all()
        stress, peeq, e = case.probed("s", "S"), case.probed("e", "PEEQ"), case.energies()
        return [{**{c: stress[c][i] for c in STRESSES}, "PEEQ": peeq["max"][i],
                 "internal": at(stress["time"][i], e["time"], e["internal"])}
                for i in range(frames + 1)]


def rotation(axis, angle):
    """Rodrigues."""
    n = math.sqrt(sum(a * a for a in axis))
    x, y, z = (a / n for a in axis)
    c, s = math.cos(angle), math.sin(angle)
    d = 1 - c
    return [[c + x * x * d, x * y * d - z * s, x * z * d + y * s],
            [y * x * d + z * s, c + y * y * d, y * z * d - x * s],
            [z * x * d - y * s, z * y * d + x * s, c + z * z * d]]


def product(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(3)) for j in range(3)] for i in range(3)]


def tensor(s):
    return [[s["XX"], s["XY"], s["XZ"]], [s["XY"], s["YY"], s["YZ"]], [s["XZ"], s["YZ"], s["ZZ"]]]


def distance(a, b):
    return max(abs(a[i][j] - b[i][j]) for i in range(3) for j in range(3))


def transposed(a):
    return [list(row) for row in zip(*a)]


# A1 ---------------------------------------------------------------------------------------------

FINITE = [[1.2, 0.3, 0.0], [0.0, 0.9, 0.1], [0.05, 0.0, 1.1]]
SMALL = [[1.001, 0.0005, 0.0005], [0.0005, 1.001, 0.0005], [0.0005, 0.0005, 1.001]]


def smooth(s):
    return s**3 * (10 - 15 * s + 6 * s * s)


def between(end, s):
    return [[(i == j) + s * (end[i][j] - (i == j)) for j in range(3)] for i in range(3)]


def patchScene(binaries, places, deformation, steps, rule, step, **more):
    """The patch of seven hexahedra; `places` (the first of them) follow the deformation."""
    rows = min(steps, 200)
    path = [(k / rows * 0.9 * steps * step, deformation(k / rows)) for k in range(rows + 1)]
    nodes = PATCH_OUTER + PATCH_INNER
    tables = "\n".join(f"s{c} {{ type extrema; field S; component {c}; }}" for c in STRESSES)
    tables += "\n" + "\n".join(
        f"i{k} {{ type point; field U; position ({x} {y} {z}); }}"
        for k, (x, y, z) in enumerate(PATCH_INNER))
    return Scene(
        binaries, bodies='cube { type file; file "patch.msh"; }', sets=pointSets(nodes),
        files={"patch.msh": patch("cube").text()},
        parts=elastic("cube", 1.0, 0.25, 1.0, NO_VISCOSITY, rule), end=steps * step,
        conditions="".join(motion(i, p, path) for i, p in enumerate(places)), tables=tables,
        control=f"timeStep {{ fixed {step}; }}\n{NO_AUDIT}\n" + more.pop("control", ""), **more)


def checkPatch(binaries, marks):
    # Static: the eight corners follow; the inner nodes have to find the linear field themselves.
    ramp = 0.05
    steps = 12000
    with patchScene(binaries, PATCH_OUTER, lambda s: between(SMALL, smooth(s)), steps, "midSurface",
                    ramp * 0.2, control="massDamping 2;") as case:
        case.all()
        worst = 0.0
        for k, place in enumerate(PATCH_INNER):
            u = case.probed(f"i{k}", "U")
            exact = [sum(SMALL[c][j] * place[j] for j in range(3)) - place[c] for c in range(3)]
            worst = max(worst, max(abs(u[a][-1] - e) for a, e in zip("xyz", exact)) / 2e-3)
        marks.below("A1 corners driven: displacement of the inner nodes", worst, 1e-3)
        for c, exact in zip(STRESSES, (2e-3,) * 3 + (4e-4,) * 3):
            s = case.probed(f"s{c}", "S")
            far = max(abs(s["min"][-1] / exact - 1), abs(s["max"][-1] / exact - 1))
            marks.below(f"s{c.lower()}", far, 2e-3)
    # Finite: all sixteen nodes follow, 200 steps and some at rest.
    for rule, judged in (("polar", True), ("hughesWinget", True), ("midSurface", False)):
        with patchScene(binaries, PATCH_OUTER + PATCH_INNER, lambda s: between(FINITE, smooth(s)),
                        220, rule, 0.02) as case:
            case.all()
            tables = [case.probed(f"s{c}", "S") for c in STRESSES]
            scale = max(abs(t["max"][-1]) for t in tables)
            spread = max(t["max"][-1] - t["min"][-1] for t in tables) / scale
            if judged:
                marks.below(f"A1 finite, {rule}: spread of the stress", spread, 1e-6)
            else:
                marks.figure(f"A1 finite, {rule}: spread of the stress", f"{spread:.2g}")


# A2 ---------------------------------------------------------------------------------------------

def checkTurn(binaries, marks):
    """A stretched and sheared cube turned by 360 degrees in 36 and 360 steps: sigma = R sigma0 R^T.

    Frames hold numbers of seven digits; the internal energy of the histories has them all."""
    stretch = [[1.002, 0.0004, 0.0], [0.0004, 0.999, 0.0003], [0.0, 0.0003, 1.0005]]
    axis = (1, 1, 1)
    for rule in ("midSurface", "polar", "hughesWinget"):
        for turning in (36, 360):
            loading = turning // 4
            steps = loading + turning

            def path(s):
                k = round(s * steps)
                if k <= loading:
                    return between(stretch, k / loading)
                return product(rotation(axis, 2 * math.pi * (k - loading) / turning), stretch)
            frames = prescribed(binaries, elastic("cube", 70000, 0.3, 2.7e-9, NO_VISCOSITY, rule),
                                path, steps, 5)
            start = tensor(frames[1])
            scale = max(abs(x) for row in start for x in row)
            worst = max(distance(tensor(frames[1 + k]), product(product(r, start), transposed(r)))
                        for k in range(5) for r in [rotation(axis, math.pi / 2 * k)]) / scale
            marks.below(f"A2 turn in {turning}, {rule}: stress", worst, 1e-6)
            energies = [frame["internal"] for frame in frames[1:]]
            marks.below("internal energy", (max(energies) - min(energies)) / energies[0], 1e-9)


def checkStretchAndTurn(binaries, marks):
    """To 1.1 along the body's axis while it turns by 90 degrees; as stretched first."""
    steps = 2000
    for rule in ("midSurface", "polar", "hughesWinget"):
        part = elastic("cube", 70000, 0.3, 2.7e-9, NO_VISCOSITY, rule)

        def stretch(s):
            return [[1 + 0.1 * s, 0, 0], [0, 1, 0], [0, 0, 1]]

        def both(s):
            return product(rotation((1, 1, 1), math.pi / 2 * s), stretch(s))
        plain = tensor(prescribed(binaries, part, stretch, steps, 1)[-1])
        turned = tensor(prescribed(binaries, part, both, steps, 1)[-1])
        r = rotation((1, 1, 1), math.pi / 2)
        expected = product(product(r, plain), transposed(r))
        marks.below(f"A2 stretch and turn, {rule}: stress", distance(turned, expected) / plain[0][0], 1e-6)


# A3 ---------------------------------------------------------------------------------------------

def sheared(spin, end):
    """s12/G and s11/G of elastic simple shear with d(s11) = 2 spin(g) s12, d(s12) = G - 2 spin s11
    for d(g): the frame turns by spin(g) radians for each unit of shear (Runge-Kutta)."""
    steps = 400
    h, normal, shear, g = end / steps, 0.0, 0.0, 0.0

    def rate(g, n, t):
        return 2 * spin(g) * t, 1 - 2 * spin(g) * n
    for _ in range(steps):
        a = rate(g, normal, shear)
        b = rate(g + h / 2, normal + h / 2 * a[0], shear + h / 2 * a[1])
        c = rate(g + h / 2, normal + h / 2 * b[0], shear + h / 2 * b[1])
        d = rate(g + h, normal + h * c[0], shear + h * c[1])
        normal += h / 6 * (a[0] + 2 * b[0] + 2 * c[0] + d[0])
        shear += h / 6 * (a[1] + 2 * b[1] + 2 * c[1] + d[1])
        g += h
    return shear, normal


# How fast the frame turns: with the material's spin (Jaumann); with the mean of the middle surface's
# lines; not at all where that surface is the plane that slides; with the tilting planes.
SHEARS = (
    ("hughesWinget", 0, 1, "hughesWinget (Jaumann)", lambda g: 0.5),
    ("polar", 0, 1, "polar (Jaumann)", lambda g: 0.5),
    ("midSurface", 0, 1, "midSurface, in its plane", lambda g: 1 / (2 + g * g)),
    ("midSurface", 0, 2, "midSurface, plane sliding over plane", lambda g: 0.0),
    ("midSurface", 2, 0, "midSurface, planes tilting", lambda g: 1 / (1 + g * g)))


def checkShear(binaries, marks):
    """x = X + g Y and its two other orientations to the element; elastic, g up to 2."""
    modulus = 70000 / 2.6
    for rule, i, j, name, spin in SHEARS:
        def path(s):
            f = [[1.0, 0, 0], [0, 1.0, 0], [0, 0, 1.0]]
            f[i][j] = 2 * s
            return f
        frames = prescribed(binaries, elastic("cube", 70000, 0.3, 2.7e-9, NO_VISCOSITY, rule), path,
                            2000, 4)
        for frame, g in ((1, 0.5), (2, 1.0), (4, 2.0)):
            s = tensor(frames[frame])
            shear, normal = sheared(spin, g)
            marks.against(f"A3 {name}, shear {g:g}: s12/G", s[i][j] / modulus, shear, 1e-4)
            marks.against("s11/G", s[i][i] / modulus, normal, 1e-4, scale=max(normal, 0.1))


# A4 ---------------------------------------------------------------------------------------------

def checkPaths(binaries, marks):
    """J2 plasticity against closed forms."""
    copper = plastic("cube", 117000, 0.35, 8.93e-9, 400, 100, NO_VISCOSITY)
    aluminium = plastic("cube", 70000, 0.3, 2.7e-9, 285, 900, NO_VISCOSITY)
    faces = "\n".join(f"f{a} {{ type symmetry; set cube.{a}Min; normal {a}; }}" for a in AXES)
    pull = ("pull {{ type displacement; set cube.xMax; value ({} 0 0); components (x); "
            "amplitude smooth ({}); }}\n")

    def free(conditions, end, frames):
        return Scene(
            binaries, bodies="cube { type box; origin (0 0 0); size (1 1 1); cells (1 1 1); }",
            parts=copper, end=end, frames=frames, conditions=faces + "\n" + conditions,
            control="massDamping 1e5;",
            tables="s { type point; field S; position (0.5 0.5 0.5); }\n"
                   "e { type extrema; field PEEQ; }").all()

    with free(pull.format(1, "(0 0) (1e-3 0.05) (2e-3 0.2) (3e-3 0.5)"), 3e-3, 3) as case:
        s, e = case.probed("s", "S"), case.probed("e", "PEEQ")
        for k, stretch in enumerate((1.05, 1.2, 1.5)):
            stress = (400 + 100 * math.log(stretch)) / (1 + 100 / 117000)
            marks.against(f"A4 tension, stretch {stretch}: stress", s["XX"][k + 1], stress, 1e-3,
                          "MPa")
            marks.against("PEEQ", e["max"][k + 1], math.log(stretch) - stress / 117000, 1e-3)
    squeeze = "held { type symmetry; set cube.yMax; normal y; }\n"
    with free(squeeze + pull.format(-1, f"(0 0) (1e-3 {1 - math.exp(-0.05)!r}) "
                                    f"(3e-3 {1 - math.exp(-0.2)!r})"), 3e-3, 3) as case:
        s = case.probed("s", "S")
        for k, strain in ((1, 0.05), (3, 0.2)):
            stress = 2 / math.sqrt(3) * (400 + 100 * 2 * strain / math.sqrt(3))
            marks.against(f"A4 plane strain, {strain}", -s["XX"][k], stress, 2e-3, "MPa")

    def uniaxial(s):
        strain = 0.02 * (2 * s if s <= 0.5 else 2 - 2 * s)
        return [[math.exp(strain), 0, 0], [0, 1, 0], [0, 0, 1]]
    frames = prescribed(binaries, aluminium, uniaxial, 2000, 2)
    for name, value, exact in (
            ("A4 strain 0.02: sx", frames[1]["XX"], 1362.48), ("sy", frames[1]["YY"], 1068.76),
            ("PEEQ", frames[1]["PEEQ"], 0.0096967), ("A4 back at 0: sx", frames[2]["XX"], -199.41),
            ("PEEQ", frames[2]["PEEQ"], 0.0156900)):
        marks.against(name, value, exact, 1e-3)

    def hydrostatic(s):
        stretch = 1 - s * (1 - 0.9 ** (1 / 3))
        return [[stretch, 0, 0], [0, stretch, 0], [0, 0, stretch]]
    last = prescribed(binaries, aluminium, hydrostatic, 2000, 1)[-1]
    bulk = 70000 / (3 * 0.4)
    marks.against("A4 volume 0.9: pressure", -last["XX"], -bulk * math.log(0.9), 1e-6, "MPa")
    marks.true("no plastic strain", last["PEEQ"] == 0)


def check(binaries, marks):
    checkPatch(binaries, marks)
    checkTurn(binaries, marks)
    checkStretchAndTurn(binaries, marks)
    checkShear(binaries, marks)
    checkPaths(binaries, marks)
