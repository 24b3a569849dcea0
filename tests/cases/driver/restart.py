"""A run that is stopped and continued is the run that was never stopped, to the last bit.

Every scene of driver/bits.py, that is every element form, material, load, kind of motion and of contact,
and the tutorials: stopped at some steps by -maxSteps and continued with -continue, each part of the
run in another setting (backend, threads, vectors). State, histories and frames are those of one run,
byte by byte."""

import pathlib
import random

from driver.bitTutorials import setEntry
from driver.bits import PRECISIONS, SCENES
from driver.caseRun import DEVICE, Failed
from driver.results import Copied, different, fastFolder, fresh, results, statusOf

SEED = 7
STEPS = 60  # of the short form
FIRST, LONGER = 200, 400  # of the long one: each of the first, some of all
SETTINGS = {
    "serial scalar": ("-backend", "serial", "-simd", "scalar"),
    "openmp 2 avx2": ("-backend", "openmp", "-threads", "2", "-simd", "avx2"),
    "serial avx512": ("-backend", "serial", "-simd", "avx512"),
    "openmp 3 avx512": ("-backend", "openmp", "-threads", "3", "-simd", "avx512"),
}


class Trial(Copied):
    """One scene, meshed once, with three frames and a row of the histories at every seventh step."""

    def __init__(self, binaries, name, folder, precision, steps):
        self.name, self.precision, self.steps = name, precision, steps
        with SCENES[name][0](binaries) as case:
            case.mesh()
            fresh(case.root, folder / "pristine")
        super().__init__(binaries, folder / "pristine", folder / "case")
        self.to(steps, "serial scalar")
        end = float(statusOf(self.root / "status")["time"])
        self.fresh()
        setEntry(self, "writeInterval", repr(end / 2.3))
        setEntry(self, "historyInterval", repr(end * 7 / steps))
        fresh(self.root, self.pristine)
        self.to(steps, "serial scalar")
        self.expected = results(self.root)

    def to(self, step, setting, *options):
        done = self.start("fpmExplicit", "-precision", self.precision, "-maxSteps", str(step),
                          *SETTINGS[setting], *options)
        if done.returncode != 0:
            raise Failed(f"{self.name}, {self.precision}, {setting}, {' '.join(options)} to step "
                         f"{step}: status {done.returncode}\n{done.stdout[-1500:]}")

    def split(self, stops, settings):
        """Names of results that are not as in one run after a run with stops, and checkpoints besides."""
        self.fresh()
        setEntry(self, "checkpoint", "{ wallInterval 0; steps 17; }")
        for number, stop in enumerate([*stops, self.steps]):
            self.to(stop, settings[number % len(settings)], *(("-continue",) if number else ()))
        return different(results(self.root), self.expected)


def available(binaries):
    """Settings of this machine."""
    with SCENES["bar"][0](binaries) as case:
        case.mesh()
        return [name for name, options in SETTINGS.items()
                if case.start("fpmExplicit", "-maxSteps", "1", *options).returncode != DEVICE]


def judged(binaries, marks, names, steps, chains):
    """`chains`: of a draw and the number of a scene, (precision, stops) of the runs it is put to."""
    settings = available(binaries)
    stops = 0
    with fastFolder() as folder:
        for number, name in enumerate(names):
            draw = random.Random(SEED + number)
            trials = {}
            for precision, at in chains(draw, number):
                if precision not in trials:
                    trials[precision] = Trial(binaries, name, pathlib.Path(folder).resolve(),
                                              precision, steps)
                order = draw.sample(settings, len(settings))
                wrong = trials[precision].split(at, order)
                stops += len(at)
                if wrong:
                    marks.failures.append(f"{name}, {precision}, stopped at {at}, {order}: not as in "
                                          f"one run: {', '.join(wrong)}")
    marks.note(f"{len(names)} scenes, {stops} stops, settings {', '.join(settings)}")
    marks.true("all as in one run, byte by byte", not marks.failures)
    return stops


def check(binaries, marks):
    """Two stops a scene, in one of the precisions."""
    def chains(draw, number):
        return [(PRECISIONS[number % 3], sorted(draw.sample(range(1, STEPS), 2)))]
    judged(binaries, marks, list(SCENES), STEPS, chains)


def long(binaries, marks):
    """Every scene stopped at each of many steps, in one of the precisions, and at random ones in all."""
    def chains(draw, number):
        yield PRECISIONS[number % 3], list(range(1, FIRST + 1))
        for precision in PRECISIONS:
            for count in (1, 3, 9):
                yield precision, sorted(draw.sample(range(1, LONGER), count))
    judged(binaries, marks, list(SCENES), LONGER, chains)
