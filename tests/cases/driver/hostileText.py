"""Dictionaries that mean harm, for driver/hostile.py: command, codes allowed, what is done to the case."""

import os
import re

CONTROL = "system/controlDict"
RUN, MESH, PROBE = "fpmExplicit -maxSteps 20", "fpmMesh", "fpmProbe"


def whole(file, text):
    """Instead of the file."""
    def prepare(root):
        (root / file).write_bytes(text.encode() if isinstance(text, str) else text)
    return prepare


def entry(file, name, value):
    """One entry of the top of a dictionary, in place of what it was."""
    def prepare(root):
        lines = [line for line in (root / file).read_text().splitlines()
                 if not line.startswith(f"{name} ")]
        (root / file).write_text("\n".join([*lines, f"{name} {value};", ""]))
    return prepare


def added(file, text):
    def prepare(root):
        with (root / file).open("ab") as stream:
            stream.write(text.encode() if isinstance(text, str) else text)
    return prepare


def swapped(file, pattern, text):
    """In place of what matches, once at least."""
    def prepare(root):
        before = (root / file).read_text()
        changed = re.sub(pattern, lambda _: text, before, flags=re.S)
        assert changed != before, (file, pattern)
        (root / file).write_text(changed)
    return prepare


def both(*steps):
    def prepare(root):
        for step in steps:
            step(root)
    return prepare


def function(name, text="type energies;"):
    return swapped(CONTROL, r"functions\n\{", f"functions\n{{\n{name} {{ {text} }}\n")


def control(name, value):
    return entry(CONTROL, name, value)


def fifo(file):
    def prepare(root):
        path = root / file
        path.parent.mkdir(parents=True, exist_ok=True)
        path.unlink(missing_ok=True)
        os.mkfifo(path)
    return prepare


def bomb(deep):
    lines = ["w0 (lol lol lol lol lol lol lol lol lol lol);"]
    lines += [f"w{i + 1} ({' '.join([f'$w{i}'] * 10)});" for i in range(deep)]
    return "\n".join([*lines, f"startFrom $w{deep};", ""])


def body(text):
    return swapped("system/meshDict", r"bodies\n\{.*?\n\}\n", f"bodies\n{{\n{text}\n}}\n")


def box(cells="(1 1 1)", size="(1 1 1)", name="a", more=""):
    return body(f"{name} {{ type box; origin (0 0 0); size {size}; cells {cells}; {more} }}")


ESCAPE = "\x1b]0;owned\x07\x1b[2J\x9b31m"
NUMBERS = ("1e999", "-1e999", "nan", "inf", "-1", "0x1p3", "1e-400", "1,5", "--1", "1e", "9" * 400,
           "\u0967", "(1)", '"1"', "1e151", "")

TEXTS = {
    "nested braces": (RUN, (3,), added(CONTROL, "a {" * 100_000)),
    "nested brackets": (RUN, (3,), added(CONTROL, "a " + "(" * 100_000)),
    "closed braces": (RUN, (3,), added(CONTROL, "}" * 100_000)),
    "macro bomb": (RUN, (3,), added(CONTROL, bomb(9))),
    "macro of itself": (RUN, (3,), added(CONTROL, "p $p;\nbackend $p;\n")),
    "macros of each other": (RUN, (3,), added(CONTROL, "p $q;\nq $p;\nbackend $p;\n")),
    "macros in a row": (RUN, (3,), added(CONTROL, "".join(
        f"m{i} $m{i + 1};\n" for i in range(100_000)) + "m100000 1;\n")),
    "environment": (RUN, (3,), control("backend", "$HOME")),
    "environment in braces": (RUN, (3,), control("backend", "${HOME}")),
    "unterminated comment": (RUN, (3,), added(CONTROL, "/*" + "x" * 100_000)),
    "unterminated string": (RUN, (3,), added(CONTROL, 'a "' + "x" * 100_000)),
    "no text": (RUN, (3,), whole(CONTROL, "")),
    "NUL": (RUN, (3,), added(CONTROL, "a b\0c;\n")),
    "not UTF-8": (RUN, (3,), added(CONTROL, b"a \xff\xfe\xc0\x80;\n")),
    "escape sequences as keyword": (RUN, (3,), added(CONTROL, f"{ESCAPE} 1;\n")),
    "escape sequences as word": (RUN, (3,), control("backend", ESCAPE)),
    "escape sequences in a string": (RUN, (3,), control("backend", f'"{ESCAPE}"')),
    "escape sequences in a comment": (RUN, (3,), added(CONTROL, f"/* {ESCAPE} */ wrong 1;\n")),
    "writing from right to left": (RUN, (3,), control("backend", '"\u202elaires"')),
    "a token of 60 MiB": (RUN, (3,), added(CONTROL, "a " + "x" * (60 << 20) + ";\n")),
    "a file of 65 MiB": (RUN, (3,), added(CONTROL, " " * (65 << 20))),
    "a line of two million numbers": (RUN, (3,), added(CONTROL, "a (" + "1 " * 2_000_000 + ");\n")),
    "two million entries": (RUN, (3,), added(CONTROL, "".join(f"a{i} 1;" for i in range(2_000_000)))),
    "entry twice": (RUN, (3,), added(CONTROL, "endTime 1;\nendTime 2;\n")),
    "includes itself": (RUN, (3,), added(CONTROL, '#include "system/controlDict"\n')),
    "includes in a circle": (RUN, (3,), both(
        added(CONTROL, '#include "b"\n'), whole("system/b", '#include "c"\n'),
        whole("system/c", '#include "b"\n'))),
    "includes twice as much each": (RUN, (3,), both(
        added(CONTROL, '#include "i0"\n'),
        *(whole(f"system/i{i}", f'#include "i{i + 1}"\n#include "i{i + 1}"\n') for i in range(40)))),
    "includes upwards": (RUN, (3,), added(CONTROL, '#include "../../secret"\n')),
    "includes from the root": (RUN, (3,), added(CONTROL, '#include "/etc/passwd"\n')),
    "includes a device": (RUN, (3,), added(CONTROL, '#include "/dev/zero"\n')),
    "includes a folder": (RUN, (3,), added(CONTROL, '#include "../constant"\n')),
    "includes a pipe": (RUN, (3,), both(fifo("system/pipe"), added(CONTROL, '#include "pipe"\n'))),
    "code": (RUN, (3,), added(CONTROL, 'a #codeStream { code #{ system("id"); #}; };\n')),
    "calculated": (RUN, (3,), added(CONTROL, 'a #calc "1/0";\n')),
    "libraries": (RUN, (3,), added(CONTROL, 'libs ("libevil.so");\n')),
    "system call": (RUN, (3,), function(
        "evil", 'type systemCall; writeCalls ("touch ../evil");')),
    "unknown table": (RUN, (3,), added(CONTROL, "evil { a { b (1 2 3); } }\n")),
    "unknown function": (RUN, (3,), function("evil", "type evil;")),
    **{f"endTime {value[:9] or 'without value'}": (RUN, (3,), control("endTime", value))
       for value in NUMBERS},
    "end never reached": ("fpmExplicit", (3, 10), both(
        control("endTime", "1e30"), control("writeInterval", "1e30"),
        control("historyInterval", "1e30"))),
    "a million frames": (RUN, (0,), control("writeInterval", "1e-12")),
    "too many frames": (RUN, (3,), control("writeInterval", "1e-140")),
    "too many rows": (RUN, (3,), control("historyInterval", "1e-140")),
    "step of nothing": ("fpmExplicit", (3, 10), control("timeStep", "{ fixed 1e-140; }")),
    "a checkpoint a nanosecond": (RUN, (0, 3), control("checkpoint", "{ wallInterval 1e-9; }")),
    "a checkpoint every -1 steps": (RUN, (3,), control("checkpoint", "{ steps -1; }")),
    "10^9 checkpoints kept": (RUN, (0, 3), control("checkpoint", "{ steps 1; keep 1000000000; }")),
    "no checkpoint kept": (RUN, (0, 3), control("checkpoint", "{ steps 1; keep 0; }")),
    "checkpoints in another place": (RUN, (3,), control("checkpoint", '{ folder "../evil"; }')),
    "start from a file": (RUN, (3,), control("startFrom", '"../secret"')),
    "start from a number that is none": (RUN, (3,), control("startFrom", "nan")),
    "start from a time of nobody": (RUN, (3, 5), control("startFrom", "1e-7")),
    "stop at a word of nobody": (RUN, (3,), control("stopAt", "never")),
    "time of the clock below 0": (RUN, (3,), control("maxWallTime", "-1")),
    "-1 frames kept": (RUN, (3,), control("purgeWrite", "-1")),
    "10^12 frames kept": (RUN, (0, 3), control("purgeWrite", "1000000000000")),
    "frames by a clock of nobody": (RUN, (3,), control("writeControl", "sunTime")),
    "a frame a nanosecond": (RUN, (0, 3), both(
        control("writeControl", "clockTime"), control("writeInterval", "1e-9"))),
    "half a step between frames": (RUN, (3,), both(
        control("writeControl", "timeStep"), control("writeInterval", "0.5"))),
    "a hundred thousand threads": (RUN, (3,), control("threads", "100000")),
    "name upwards": (RUN, (3,), function("../../evil")),
    "name with a slash": (RUN, (3,), function("a/b")),
    "name of dots": (RUN, (3,), function("..")),
    "name of 300 letters": (RUN, (3,), function("x" * 300)),
    "name like an option": (RUN, (0, 3), function("-case")),
    "name with a line end": (RUN, (3,), function('"a\nb"')),
    "name with a percent sign": (RUN, (0, 3), function("a%s%n")),
    "two thousand histories": (RUN, (0, 6), function("".join(
        f"f{i} {{ type point; part a; position (0 0 0); }}\n" for i in range(2000)) + "g")),
    "body with a name upwards": (MESH, (3,), box(name="../../evil")),
    "body with escape sequences": (MESH, (3,), box(name=f'"{ESCAPE}"')),
    "10^9 cells": (MESH, (3, 4), box("(1000 1000 1000)")),
    "10^15 cells": (MESH, (3, 4), box("(100000 100000 100000)")),
    "10^24 cells": (MESH, (3, 4), both(
        box("(100000 100000 100000)"), added("system/meshDict", "refinement 1000;\n"))),
    "10^9 cells in layers": (MESH, (3, 4), body(
        "a { type layers; origin (0 0 0); size (1 1 1); cells (1000 1000 1); count 1000; }")),
    "10^9 cells of a cylinder": (MESH, (3, 4), body(
        "a { type cylinder; base (0 0 0); radius 1; height 1; core 100; rings 100; axial 100000; }")),
    "10^11 cells of a tube": (MESH, (3, 4), body(
        "a { type hollowCylinder; base (0 0 0); innerRadius 1; outerRadius 2; height 1; "
        "circumferential 100000; radial 100; axial 100000; }")),
    "negative cells": (MESH, (3,), box("(-1 1 1)")),
    "half a cell": (MESH, (3,), box("(0.5 1 1)")),
    "a size of nothing": (MESH, (3, 4), box(size="(0 1 1)")),
    "a size of 1e150": (MESH, (0, 3, 4), box(size="(1e150 1 1)")),
    "a size of 1e-150": (MESH, (0, 3, 4), box(size="(1e-150 1e-150 1e-150)")),
    "a size that is no number": (MESH, (3,), box(size="(nan 1 1)")),
    "a set of itself": (MESH, (3,), swapped(
        "system/meshDict", r"sets\n\{", "sets\n{\ns { type union; sets (s); }\n")),
    "sets of each other": (MESH, (3,), swapped(
        "system/meshDict", r"sets\n\{",
        "sets\n{\ns { type union; sets (t); }\nt { type union; sets (s); }\n")),
    "parts like each other": (RUN, (3,), whole(
        "constant/partProperties", "parts { a { like b; } b { like a; } }")),
    "a plane without direction": (MESH, (3,), swapped(
        "system/meshDict", r"sets\n\{",
        "sets\n{\ns { type plane; point (0 0 0); normal (0 0 0); }\n")),
    "density of 1e-150": (RUN, (0, 3, 10), swapped(
        "constant/partProperties", "density 7.85e-09", "density 1e-150")),
    "modulus of 1e150": (RUN, (0, 3, 10), swapped(
        "constant/partProperties", "youngsModulus 210000", "youngsModulus 1e150")),
    "Poisson's ratio nearly one half": (RUN, (0, 3, 10), swapped(
        "constant/partProperties", "poissonsRatio 0.3", "poissonsRatio 0.49999999999999994")),
    "speed of 1e150": (RUN, (3, 10), whole(
        "0/initialConditions", "v { type velocity; part b; value (0 0 -1e150); }\n")),
    "amplitude of a million rows": (RUN, (0, 3, 12), added(
        "constant/boundaryConditions", "f { type force; set b.zMax; value (0 0 -1); amplitude table ("
        + " ".join(f"({i} 1)" for i in range(1_000_000)) + "); }\n")),
    "amplitude that goes back": (RUN, (3,), added(
        "constant/boundaryConditions",
        "f { type force; set b.zMax; value (0 0 -1); amplitude table ((0 1) (1 2) (0.5 1)); }\n")),
    "plot of a file upwards": (PROBE, (3, 6), added(
        "system/probeDict", 'plots { p { series { s { file "../secret"; x a; y b; } } } }\n')),
    "plot of a file of the system": (PROBE, (3, 6), added(
        "system/probeDict", 'plots { p { series { s { file "/etc/passwd"; x a; y b; } } } }\n')),
    "plot of a device": (PROBE, (3, 6), added(
        "system/probeDict", 'plots { p { series { s { file "/dev/zero"; x a; y b; } } } }\n')),
    "picture with a title of escape sequences": (PROBE, (0, 3), added(
        "system/probeDict", f'pictures {{ p {{ field U; title "{ESCAPE}"; }} }}\n')),
    "picture of a million bands": (PROBE, (0, 3), added(
        "system/probeDict", "pictures { p { field U; bands 1000000000; } }\n")),
    "picture seen from nowhere": (PROBE, (0, 3), added(
        "system/probeDict", "pictures { p { field U; view (0 0 0); } }\n")),
    "picture warped by 1e150": (PROBE, (0, 3), added(
        "system/probeDict", "pictures { p { field U; warp 1e150; } }\n")),
    "picture at a million times": (PROBE, (0, 3), added(
        "system/probeDict", "pictures { p { field U; times (" + "1e-6 " * 1_000_000 + "); } }\n")),
    "table with a name upwards": (PROBE, (3,), swapped(
        "system/probeDict", "tip", "../../evil")),
}
