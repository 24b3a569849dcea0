"""kill -9 at random instants of a run, then `fpmExplicit -continue`: as if it had never been killed.

A run is killed and continued again and again until it comes to its end. Judged are: the state and all
results of the end are those of a run that was not killed, byte by byte; what stands in the case after
every kill is whole; no checkpoint that the log acknowledged is lost; nothing outside the case is
touched."""

import pathlib
import random
import re
import signal
import subprocess
import time

from driver.caseRun import Failed
from driver.results import damaged, different, fastFolder, fresh, results, snapshot, temporaries
from driver.scene import Scene, elastic

SEED = 20231
MOST_KILLS = 12  # of one run, then it may come to its end
HANGS = 120  # seconds
ACKNOWLEDGED = re.compile(r"^checkpoint at time \S+, step (\d+)$", re.M)
BEGAN = re.compile(r"^going on from the checkpoint at time \S+, step (\d+)$", re.M)
BEGINS = re.compile(r"^Time = 0$", re.M)


def scene(binaries):
    """Two blocks that strike and slide, five frames, many checkpoints."""
    return Scene(
        binaries, end=3e-5, frames=5, rows=100,
        bodies="a { type box; origin (0 0 0); size (8 8 2); cells (4 4 1); }"
               "b { type box; origin (2.1 2.2 2.02); size (3 3 3); cells (2 2 2); }",
        parts=elastic("a", 210000, 0.3, 7.85e-9) + elastic("b", 70000, 0.3, 2.7e-9),
        conditions="foot { type fixed; set a.zMin; }",
        initial="v { type velocity; part b; value (9000 -4000 -20000); }",
        pairs="p { contactor b; target a; friction 0.3; }",
        functions="tip { type point; part b; position (2.1 2.2 5); fields (displacement velocity); }",
        control="checkpoint { wallInterval 0; steps 50; }")


class Killer:
    def __init__(self, binaries, marks, folder):
        self.binaries, self.marks = binaries, marks
        self.folder = folder
        self.pristine, self.root = folder / "pristine", folder / "case"
        with scene(binaries) as case:
            case.mesh()
            self.program = case.binaries / "fpmExplicit"
            fresh(case.root, self.pristine)
        fresh(self.pristine, self.root)
        begin = time.monotonic()
        self.finish("fpmExplicit")
        self.seconds = time.monotonic() - begin
        self.expected = results(self.root)
        fresh(self.pristine, self.root)
        self.outside = snapshot(folder, self.root)
        self.kills = self.runs = self.acknowledged = 0

    def started(self, *options):
        return subprocess.Popen([self.program, *options], cwd=self.root, text=True,
                                stdout=subprocess.PIPE, stderr=subprocess.STDOUT)

    def finish(self, what, *options):
        process = self.started(*options)
        try:
            output = process.communicate(timeout=HANGS)[0]
        except subprocess.TimeoutExpired:
            process.kill()
            process.communicate()
            raise Failed(f"{what} hangs") from None
        if process.returncode != 0:
            raise Failed(f"{what}: status {process.returncode}\n{output[-1500:]}")
        return output

    def killed(self, delay):
        """Starts or continues the run and kills it after some seconds; whether that met it, and its
        output."""
        process = self.started("-continue")
        time.sleep(delay)
        process.send_signal(signal.SIGKILL)
        output = process.communicate()[0]
        if process.returncode not in (0, -signal.SIGKILL):
            raise Failed(f"continued: status {process.returncode}\n{output[-1500:]}")
        return process.returncode != 0, output

    def complain(self, what):
        self.marks.failures.append(f"run {self.runs}, kill {self.kills}: {what}")

    def one(self, draw, most):
        """One run with up to so many kills, judged after each of them and at its end."""
        fresh(self.pristine, self.root)
        self.runs += 1
        last = 0
        for _ in range(draw.randint(1, most)):
            met, output = self.killed(draw.uniform(0, self.seconds))
            self.began(output, last)
            if not met:
                break
            self.kills += 1
            promised = [int(step) for step in ACKNOWLEDGED.findall(output)]
            self.acknowledged += len(promised)
            last = max([last, *promised])
            for name in damaged(results(self.root), self.expected):
                self.complain(f"{name} is damaged")
        self.began(self.finish("continued", "-continue"), last)
        for name in different(results(self.root), self.expected):
            self.complain(f"at its end {name} is not as in one run")
        for name in temporaries(self.root):
            self.complain(f"{name} is left")
        if snapshot(self.folder, self.root) != self.outside:
            self.complain("something outside the case has changed")

    def began(self, output, last):
        """It goes on from the last checkpoint that was acknowledged, or a later one."""
        found = BEGAN.search(output)
        if found and int(found[1]) < last:
            self.complain(f"it goes on at step {found[1]}, a checkpoint at {last} was acknowledged")
        if not found and last > 0 and BEGINS.search(output):
            self.complain(f"it begins anew, a checkpoint at step {last} was acknowledged")


def judged(binaries, marks, count):
    draw = random.Random(SEED)
    with fastFolder() as name:
        killer = Killer(binaries, marks, pathlib.Path(name).resolve())
        while killer.kills < count and not marks.failures:
            killer.one(draw, min(MOST_KILLS, max(1, count - killer.kills)))
    marks.note(f"{killer.kills} kills in {killer.runs} runs of {killer.seconds:.2f} s, "
               f"{killer.acknowledged} checkpoints acknowledged")
    marks.true("none lost, all files whole, the end of every run byte by byte", not marks.failures)
    return killer


def check(binaries, marks):
    judged(binaries, marks, 30)


def long(binaries, marks):
    judged(binaries, marks, 2000)
