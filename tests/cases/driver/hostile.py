"""Cases from a stranger who means harm: whatever stands in them, a program answers soon, with a documented
code, in little memory, prints no control character, and touches nothing outside the case.

The cases stand in driver/hostileText.py (dictionaries) and driver/hostileFiles.py (everything else)."""

import os
import pathlib
import re
import resource
import shutil
import signal
import subprocess
import time

from driver.hostileFiles import FILES
from driver.hostileText import TEXTS
from driver.results import fastFolder, fresh, snapshot
from driver.scene import Scene, elastic

SECONDS = 20  # of the processor
HANGS = 120
MOST_BYTES = 1 << 30  # resident
ADDRESSES = 16 << 30  # of all mappings: stacks of threads and reserves of libraries are no memory
DOCUMENTED = (0, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 75)
# Line ends alone; also those that UTF-8 can write in two bytes.
CONTROL = re.compile(rb"[\x00-\x08\x0b-\x1f\x7f]|\xc2[\x80-\x9f]")
ALL = {**TEXTS, **FILES}


def scene(binaries):
    """Two blocks in contact, with everything a case can have."""
    return Scene(
        binaries, end=1e-6, frames=2, rows=5,
        bodies="a { type box; origin (0 0 0); size (4 4 2); cells (2 2 1); }\n"
               "b { type box; origin (1 1 2.01); size (2 2 2); cells (1 1 1); }",
        parts=elastic("a", 210000, 0.3, 7.85e-9) + elastic("b", 210000, 0.3, 7.85e-9),
        conditions="foot { type fixed; set a.zMin; }",
        initial="v { type velocity; part b; value (0 0 -10000); }",
        pairs="p { contactor b; target a; }",
        tables="tip { type extrema; field U; component z; }")


class Answer:
    """What came of a program: its code (None: it hangs), output, peak of memory, processor seconds."""

    def __init__(self, command, folder, home, limited):
        environment = {**os.environ, "HOME": str(home), "TMPDIR": str(home), "OMP_NUM_THREADS": "2"}
        output = home.parent / "output"
        with output.open("wb") as file:
            process = subprocess.Popen(command, cwd=folder, stdin=subprocess.DEVNULL, stdout=file,
                                       stderr=subprocess.STDOUT, env=environment, preexec_fn=limited)
        self.code, self.bytes, self.seconds = waited(process.pid)
        process.returncode = 0  # waited for
        self.output = output.read_bytes()


def limits(program):
    """What a process does first. A program with the address sanitizer needs all addresses there are."""
    sanitized = b"libasan" in program.read_bytes()

    def limit():
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        if not sanitized:
            resource.setrlimit(resource.RLIMIT_AS, (ADDRESSES, ADDRESSES))
    return limit


def waited(process):
    end = time.monotonic() + HANGS
    while True:
        done, status, usage = os.wait4(process, os.WNOHANG)
        if done:
            return (os.waitstatus_to_exitcode(status), usage.ru_maxrss * 1024,
                    usage.ru_utime + usage.ru_stime)
        if time.monotonic() > end:
            os.kill(process, signal.SIGKILL)
            os.wait4(process, 0)
            return None, 0, 0
        time.sleep(0.002)


class Bench:
    """A sound case, meshed and run, beside which somebody has a file of his own."""

    def __init__(self, binaries, folder):
        self.binaries = pathlib.Path(binaries).resolve()
        self.world = folder / "world"
        self.root = self.world / "case"
        self.home = folder / "home"
        self.home.mkdir()
        self.world.mkdir()
        (self.world / "secret").write_text("endTime 1;\nsecret word;\n")
        with scene(binaries) as case:
            case.mesh()
            case.solve()
            case.run("fpmProbe")
            fresh(case.root, folder / "pristine")
        self.pristine = folder / "pristine"
        self.limit = limits(self.binaries / "fpmExplicit")
        self.most, self.longest = 0, 0.0

    def judge(self, name, row):
        """What is wrong, as texts."""
        fresh(self.pristine, self.root)
        before = snapshot(self.world, self.root)
        command, codes, prepare = row
        prepare(self.root)
        words = command.split()
        answer = Answer([self.binaries / words[0], *words[1:]], self.root, self.home, self.limit)
        self.most = max(self.most, answer.bytes)
        self.longest = max(self.longest, answer.seconds)
        wrong = []
        if answer.code is None:
            wrong.append(f"no answer in {HANGS} s")
        elif answer.code not in codes:
            wrong.append(f"status {answer.code}, expected {codes}\n{answer.output[-600:]!r}")
        if answer.seconds > SECONDS:
            wrong.append(f"{answer.seconds:.0f} s of the processor")
        if answer.bytes > MOST_BYTES:
            wrong.append(f"{answer.bytes >> 20} MiB of memory")
        for where, text in (("terminal", answer.output), *logs(self.root)):
            if found := CONTROL.search(text):
                wrong.append(f"control character on the {where}: {text[found.start() - 60:][:90]!r}")
        if b"secret word" in answer.output:
            wrong.append("it prints what stands outside the case")
        after = snapshot(self.world, self.root)
        strange = sorted(name for name in before.keys() | after.keys()
                         if before.get(name) != after.get(name)) + [
            str(path) for path in self.home.rglob("*")]
        if strange:
            wrong.append(f"outside the case: {', '.join(strange)}")
        shutil.rmtree(self.home)
        self.home.mkdir()
        return wrong


def logs(root):
    return [(path.name, path.read_bytes()) for path in root.glob("log.*") if path.is_file()
            and not path.is_symlink()]


def judged(binaries, marks, names):
    with fastFolder() as folder:
        bench = Bench(binaries, pathlib.Path(folder).resolve())
        for name in names:
            for wrong in bench.judge(name, ALL[name]):
                marks.failures.append(f"{name}: {wrong}")
    assert all(set(codes) <= set(DOCUMENTED) for _, codes, _ in ALL.values())
    marks.note(f"{len(names)} cases, at most {bench.most >> 20} MiB and "
               f"{bench.longest:.1f} s of the processor")
    marks.true("each answered in time, with its code, nothing outside touched, no control character",
               not marks.failures)


def check(binaries, marks):
    judged(binaries, marks, list(ALL))
