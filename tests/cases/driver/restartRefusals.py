"""What a checkpoint does not go on with, what it does, and what becomes of a damaged one."""

import pathlib
import random
import re
import shutil

from driver.bitTutorials import setEntry
from driver.caseRun import Failed
from driver.kills import scene
from driver.results import Copied, different, fastFolder, fresh, results, snapshot

CHECKPOINT = 5
STOP, END = 70, 110  # steps; a checkpoint at every fiftieth
NEWEST, BEFORE = "checkpoint/state.h5", "checkpoint/state.1.h5"
NO_STATE = ("log.", ".lock")


class Stopped(Copied):
    """A run that stopped at step 70, with checkpoints of that and of step 50, to be continued to 110."""

    def __init__(self, binaries, folder):
        with scene(binaries) as case:
            case.mesh()
            fresh(case.root, folder / "meshed")
        super().__init__(binaries, folder / "meshed", folder / "case")
        self.run("fpmExplicit", "-maxSteps", str(END))
        self.expected = results(self.root)
        self.fresh()
        self.run("fpmExplicit", "-maxSteps", str(STOP))
        fresh(self.root, folder / "stopped")
        self.pristine = folder / "stopped"

    def go(self, *options):
        return self.start("fpmExplicit", "-continue", "-maxSteps", str(END), *options)

    def state(self):
        """Of all files but logs and the lock."""
        return {name: here for name, here in snapshot(self.root, self.root / "nothing").items()
                if not name.startswith(NO_STATE)}

    def asInOneRun(self):
        return different(results(self.root), self.expected)


def change(file, pattern, text):
    return lambda case: case.replace(file, pattern, text)


def mesh(case):
    case.replace("system/meshDict", r"cells \(2 2 2\)", "cells (2 2 3)")
    case.run("fpmMesh")
    case.run("fpmSetContact")


# Change, options, and words that name what the checkpoint has and what the case has.
OTHERS = {
    "mesh": (mesh, (), ("mesh", "mesh")),
    "density": (change("constant/partProperties", "2.7e-09", "2.8e-09"), (), ("2.7e-09", "2.8e-09")),
    "modulus": (change("constant/partProperties", "70000", "71000"), (), ("70000", "71000")),
    "friction": (change("system/contactDict", "friction 0.3", "friction 0.2"), (), ("0.3", "0.2")),
    "precision": (lambda case: None, ("-precision", "single"), ("double", "single")),
}
ALLOWED = {
    "later end": lambda case: setEntry(case, "endTime", "1e-4"),
    "other frames": lambda case: setEntry(case, "writeInterval", "7e-7"),
    "other rows": lambda case: setEntry(case, "historyInterval", "3e-7"),
    "one more function": change("system/controlDict", r"^functions\n\{",
                                "functions\n{\nmore { type point; part a; position (0 0 0); }"),
}


def others(case, marks):
    """Another mesh, material, contact or precision is another case."""
    for name, (prepare, options, words) in OTHERS.items():
        case.fresh()
        prepare(case)
        before = case.state()
        done = case.go(*options)
        marks.true(f"other {name}: status {done.returncode}", done.returncode == CHECKPOINT)
        for word in words:
            if word not in done.stdout:
                marks.failures.append(f"other {name}: it does not name {word}\n{done.stdout[-500:]}")
        if case.state() != before:
            marks.failures.append(f"other {name}: it changes the case")
    for name, prepare in ALLOWED.items():
        case.fresh()
        prepare(case)
        done = case.go()
        marks.true(f"{name}: status {done.returncode}", done.returncode == 0)


def fallsBack(case, marks):
    """To the checkpoint before, with a warning that names the time lost; else it refuses."""
    case.fresh()
    damage(case.root / NEWEST, lambda content: content[:-1])
    done = case.go()
    warned = re.search(r"^warning: .*state\.h5.*\n?.*", done.stdout, re.M)
    marks.true("newest damaged: goes on from the one before, says so", done.returncode == 0
               and warned is not None)
    if different_ := case.asInOneRun():
        marks.failures.append(f"from the one before: {different_} not as in one run\n{done.stdout[-800:]}")
    case.fresh()
    (case.root / NEWEST).unlink()
    done = case.go()
    marks.true("newest deleted: goes on from the one before",
               done.returncode == 0 and not case.asInOneRun())
    case.fresh()
    for name in (NEWEST, BEFORE):
        damage(case.root / name, lambda content: content[:len(content) // 2])
    before = case.state()
    done = case.go()
    marks.true(f"both damaged: status {done.returncode}, nothing modified",
               done.returncode == CHECKPOINT and case.state() == before)
    case.fresh()
    shutil.rmtree(case.root / "checkpoint")
    done = case.go()
    marks.true("none: begins at 0", done.returncode == 0 and not case.asInOneRun())


def damage(path, change):
    path.write_bytes(change(path.read_bytes()))


def damages(size, draw, flips, cuts):
    """(name, change) of damages to a file."""
    # The end of the file, where its label and its checksum stand, is met as often as all the rest.
    def flip(at, bit):
        return lambda content: content[:at] + bytes([content[at] ^ 1 << bit]) + content[at + 1:]

    def cut(at):
        return lambda content: content[:at]
    for _ in range(flips):
        at, bit = draw.randrange(draw.choice((0, size - 200)), size), draw.randrange(8)
        yield f"bit {bit} of byte {at} flipped", flip(at, bit)
    for at in sorted({0, 1, 7, 8, size - 1, size - 8, size - 16, *(
            draw.randrange(size) for _ in range(cuts))}):
        yield f"cut to {at} bytes", cut(at)


def neverWrong(case, marks, flips, cuts):
    """Whatever is damaged: refused, or the right bits."""
    (case.pristine / BEFORE).unlink()
    size = (case.pristine / NEWEST).stat().st_size
    ends = {}
    for name, change in damages(size, random.Random(5), flips, cuts):
        case.fresh()
        damage(case.root / NEWEST, change)
        done = case.go()
        ends[done.returncode] = ends.get(done.returncode, 0) + 1
        if done.returncode not in (0, CHECKPOINT):
            marks.failures.append(f"{name}: status {done.returncode}\n{done.stdout[-500:]}")
        elif done.returncode == 0 and case.asInOneRun():
            marks.failures.append(f"{name}: a wrong restart")
        elif done.returncode == 0 and "going on from the checkpoint" not in done.stdout:
            marks.failures.append(f"{name}: it begins anew without a word")
    marks.note(f"{sum(ends.values())} damages of {size} bytes: " + ", ".join(
        f"{count} status {code}" for code, count in sorted(ends.items())))


def judged(binaries, marks, flips, cuts):
    with fastFolder() as folder:
        case = Stopped(binaries, pathlib.Path(folder).resolve())
        if not (case.pristine / NEWEST).exists():
            raise Failed(f"no {NEWEST}")
        others(case, marks)
        fallsBack(case, marks)
        neverWrong(case, marks, flips, cuts)


def check(binaries, marks):
    judged(binaries, marks, 40, 10)


def long(binaries, marks):
    judged(binaries, marks, 2000, 500)
