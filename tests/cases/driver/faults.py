"""Every call of fpmExplicit on a file of its case fails once, or from there on, or is its last.

tests/support/ioFaults counts the calls and makes one of them fail. Whatever it is: the run ends by
itself, with code 6 or as if nothing had happened, `status` does not call it finished unless it is, what
stands in the case is whole, and the next start needs no cleaning up."""

import os
import pathlib
import random
import re
import signal
import subprocess

from driver.caseRun import Failed
from driver.results import damaged, different, fastFolder, fresh, results, statusOf, temporaries
from driver.scene import Scene, elastic

FILE_IO = 6
HANGS = 60  # seconds after which a run of milliseconds hangs
WRITES = ("write", "pwrite")
MENDED = ("short", "EINTR")  # what a program has to try again
INTERRUPTIBLE = (*WRITES, "fsync", "fdatasync")


def scene(binaries):
    """A bar of four elements: three frames, two histories, checkpoints."""
    return Scene(
        binaries, bodies="a { type box; origin (0 0 0); size (8 2 2); cells (4 1 1); }",
        parts=elastic("a", 210000, 0.3, 7.85e-9), end=6e-6, frames=2, rows=4,
        initial="v { type velocity; part a; value (1000 0 0); }",

        control="checkpoint { wallInterval 0; steps 16; }",
        conditions="foot { type fixed; set a.xMax; }",
        functions="tip { type point; part a; position (8 2 2); }")


class Bench:
    """One case that is run again and again from its beginning, with faults."""

    def __init__(self, binaries, folder):
        self.binaries = pathlib.Path(binaries).resolve()
        self.library = self.binaries / "libioFaults.so"
        if not self.library.exists():
            raise Failed(f"no {self.library}: build with FPM_TESTS")
        self.folder = pathlib.Path(folder).resolve()
        self.pristine, self.root = self.folder / "pristine", self.folder / "case"
        self.log = self.folder / "calls"
        with scene(binaries) as case:
            case.mesh()
            fresh(case.root, self.pristine)

    def start(self, application="fpmExplicit", *options, kind="", at=0, lasts=False):
        """An application in the case, its call `at` failing; status None where it hangs."""
        self.log.unlink(missing_ok=True)
        environment = {
            **os.environ, "LD_PRELOAD": str(self.library), "FAULT_ROOT": str(self.root),
            "FAULT_LOG": str(self.log), "FAULT_KIND": kind, "FAULT_AT": str(at),
            "FAULT_LASTS": "1" if lasts else "",
            "ASAN_OPTIONS": "verify_asan_link_order=0:" + os.environ.get("ASAN_OPTIONS", "")}
        process = subprocess.Popen(
            [self.binaries / application, *options], cwd=self.root, text=True,
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, env=environment)
        try:
            output = process.communicate(timeout=HANGS)[0]
        except subprocess.TimeoutExpired:
            process.kill()
            return None, process.communicate()[0]
        return process.returncode, output

    def calls(self):
        """(call, file) of those the last start made; numbers begin with 1."""
        return [tuple(line.split(" ", 2)[1:]) for line in self.log.read_text().splitlines()]

    def clean(self):
        fresh(self.pristine, self.root)


def kindsOf(call, long):
    """(kind, lasts) of the faults that can meet a call."""
    faults = [("EIO", False), ("ENOSPC", True), ("kill", False)]
    if call in WRITES:
        faults += [("short", False), ("tear", False)]
    if call in INTERRUPTIBLE:
        faults += [("EINTR", False)]
    if long:
        faults += [("EIO", True), ("ENOSPC", False), ("EDQUOT", True)]
    return faults


def isLog(file):
    return file.startswith("log.")


def everything(calls):
    return [(number, *fault) for number, (call, _) in enumerate(calls, 1)
            for fault in kindsOf(call, True)]


def sample(calls, seed):
    """Of calls alike the first and the last, each with some of its faults, so that every fault meets
    every call on every file."""
    alike, draw = {}, random.Random(seed)
    for number, (call, file) in enumerate(calls, 1):
        name = "log" if isLog(file) else re.sub(r"\d+", "#", file)
        alike.setdefault((call, name), []).append(number)
    plan = []
    for (call, name), numbers in alike.items():
        for kind, lasts in kindsOf(call, False):
            if name != "log" or kind in ("ENOSPC", "kill"):
                plan.append((draw.choice((numbers[0], numbers[-1])), kind, lasts))
    return sorted(plan)


def unordered(calls):
    """Files that a loss of power may leave empty or old, whatever was said of them: those renamed without
    a sync between their last write and the rename, or without one of their folder before anything else is
    done with files. `status` is renewed so every second while a run goes on."""
    wrong, dirty = set(), {}
    for at, (call, file) in enumerate(calls):
        folder, _, name = file.rpartition("/")
        target = re.sub(r"^\.(.*)\.\d+\.tmp$", r"\1", name)
        if call in WRITES and name != target:
            dirty[folder, target] = True
        elif call in ("fsync", "fdatasync"):
            dirty.pop((folder, target), None)
        elif call == "rename" and not isLog(file):
            after = next(((c, f) for c, f in calls[at + 1:] if c != "rename"), None)
            if (folder, name) in dirty or after != ("fsync", folder or "."):
                wrong.add(file)
    return sorted(wrong)


class Judge:
    """Runs a plan of faults and names what is not as promised."""

    def __init__(self, bench, marks):
        self.bench, self.marks = bench, marks
        self.ends = {}  # runs by the code they ended with
        bench.clean()
        code, output = bench.start()
        if code != 0:
            raise Failed(f"without a fault: status {code}\n{output}")
        self.expected, self.calls = results(bench.root), bench.calls()
        if late := unordered(self.calls):
            marks.failures.append(f"renamed before it was synced, or its folder not after: {late}")

    def run(self, plan, second=None):
        for number, kind, lasts in plan:
            call, file = self.calls[number - 1]
            what = f"{kind}{' from' if lasts else ' at'} call {number}, {call} of {file}"
            self.bench.clean()
            code, output = self.bench.start(kind=kind, at=number, lasts=lasts)
            self.ends[code] = self.ends.get(code, 0) + 1
            wrong = self.judge(code, output, kind, lasts, file)
            if code != 0 or second is not None or temporaries(self.bench.root):
                wrong += [f"then a start: {one}" for one in self.restarted(second)]
            if wrong:
                self.marks.failures.append(f"{what}: {'; '.join(wrong)}")

    def judge(self, code, output, kind, lasts, file):
        """What is wrong with how the run ended and with what it left, as texts."""
        if code is None:
            return ["it hangs"]
        dies = kind in ("kill", "tear")
        if dies != (code == -signal.SIGKILL) or code not in (0, FILE_IO, -signal.SIGKILL):
            return [f"status {code}\n{output}"]
        found = results(self.bench.root)
        wrong = [f"{name} is damaged" for name in damaged(found, self.expected)]
        if code == 0:
            return wrong + [f"status 0, but {name} is not as without the fault"
                            for name in different(found, self.expected)]
        if dies:
            return wrong
        if kind in MENDED:
            wrong.append(f"it gives up\n{output}")
        if "error: " not in output:
            wrong.append(f"it does not say why\n{output}")
        status = self.bench.root / "status"
        state = statusOf(status)["state"] if status.exists() else "none"
        allowed = ("none", "failed", "running") if lasts or file == "." or "status" in file \
            else ("none", "failed")
        if state not in allowed:
            wrong.append(f"status {code}, but its state is {state}")
        return wrong + self.probed(found)

    def probed(self, found):
        """fpmProbe reads the frames that are there."""
        if not any(name.endswith("fields.vtkhdf") for name in found):
            return []
        (self.bench.root / "system/probeDict").write_text(
            "tables { drawn { type extrema; field U; } }\n")
        code, output = self.bench.start("fpmProbe")
        return [] if code == 0 else [f"fpmProbe: status {code}\n{output}"]

    def restarted(self, second):
        """The next start, itself with a fault where `second` draws one, and then one without."""
        if second is not None:
            self.bench.start("fpmExplicit", "-continue", kind=second.choice(("EIO", "ENOSPC", "kill")),
                             at=second.randint(1, len(self.calls)), lasts=second.random() < 0.5)
        code, output = self.bench.start("fpmExplicit", "-continue")
        if code != 0:
            return [f"status {code}\n{output}"]
        found = {name: here for name, here in results(self.bench.root).items()
                 if not name.startswith("postProcessing/drawn/")}
        return [f"{name} is not as in one run" for name in different(found, self.expected)] \
            + [f"{name} is left" for name in temporaries(self.bench.root)]

    def conclude(self, runs):
        self.marks.note(f"{len(self.calls)} calls, {runs} faults: " + ", ".join(
            f"{count} {'killed' if code == -signal.SIGKILL else f'status {code}'}"
            for code, count in sorted(self.ends.items(), key=str)))
        self.marks.true("no other end, nothing damaged, nothing lost without a word",
                        not self.marks.failures)


def judged(binaries, marks, planned, second=None):
    with fastFolder() as folder:
        judge = Judge(Bench(binaries, folder), marks)
        plan = planned(judge.calls)
        judge.run(plan, second)
        judge.conclude(len(plan))
    return judge


def check(binaries, marks):
    judged(binaries, marks, lambda calls: sample(calls, 1))


def long(binaries, marks):
    """Every call with every fault, and a second fault in the start after it."""
    judged(binaries, marks, everything, random.Random(2))
