"""Scenes with contact, from the tutorials, meshed here or before (`--cases`)."""

import contextlib
import pathlib
import re
import shutil
import subprocess
import sys

from benches.results import Row
from driver.caseRun import CaseRun, Failed

PAIR = r"(?<=target)( +[\w.]+;)"


class Scene(CaseRun):
    """A meshed copy of a tutorial, or of a case that was prepared."""

    timeout = 7200

    def __init__(self, tutorial, name, options, edits=(), before=None):
        self.name = name
        prepared = options.cases and pathlib.Path(options.cases).resolve() / name
        if prepared and prepared.exists():
            super().__init__(prepared, options.binaries, meshed=True)
            return
        super().__init__(f"tutorials/{tutorial}", options.binaries)
        for file, pattern, text in edits:
            self.replace(file, pattern, text)
        if before:
            before(self)
        self.mesh()

    def keep(self, folder):
        shutil.copytree(self.root, pathlib.Path(folder) / self.name, dirs_exist_ok=True)


def plate(options, name="plate"):
    cells = options.plateCells
    return Scene("plateImpact", name, options,
                 [("system/meshDict", r"cells +\(50 50 1\)", f"cells ({cells} {cells} 1)")])


def tube(options):
    return Scene("squeezedTube", "tube", options)


def layers(options, count):
    """`count` layers of cells x cells; the layered plate of the paper has 250 x 250."""
    end = options.layerSteps * options.dt
    return Scene("layeredPlate", f"layers.{count}", options, [
        ("system/meshDict", r"^layers +\d+;", f"layers {count};"),
        ("system/meshDict", r"^cells +\([0-9 ]+\);", f"cells ({options.cells} {options.cells} 1);"),
        ("system/controlDict", r"maximum [0-9.e-]+;", f"maximum {options.dt!r};"),
        ("system/controlDict", r"^endTime +\S+;", f"endTime {end!r};"),
        ("system/controlDict", r"^writeInterval +\S+;", f"writeInterval {end!r};"),
    ], before=lambda scene: scene.run(scene.root / "makeLayers"))


class Variant:
    """One way to run a scene: machine, precision, algorithm; changes of its dictionaries and of the
    environment."""

    def __init__(self, backend, threads, simd, precision, algorithm="default", edits=(),
                 contact=True, environment=None):
        self.backend, self.threads, self.simd, self.precision = backend, threads, simd, precision
        self.algorithm, self.edits, self.contact = algorithm, edits, contact
        self.environment = environment or {}

    def start(self, scene, steps):
        """Runs the scene and returns its performance record; the dictionaries are put back."""
        files = {file: (scene.root / file).read_text()
                 for file in ("system/controlDict", "system/contactDict", "constant/partProperties")}
        try:
            if self.algorithm == "paper":
                with open(scene.root / "system/controlDict", "a") as control:
                    control.write("\nalgorithm paper;\n")
            for file, pattern, text, count in self.edits:
                scene.replace(file, pattern, text,
                              count or len(re.findall(pattern, files[file], re.M)))
            if not self.contact:
                (scene.root / "system/contactDict").unlink()
                scene.replace("system/controlDict", r"^ +contactForces +\{ type contactForces; \}",
                              "")
            options = ["-backend", self.backend, "-precision", self.precision]
            if self.backend != "cuda":
                options += ["-simd", self.simd]
            if self.backend == "openmp":
                options += ["-threads", str(self.threads)]
            if steps:
                options += ["-maxSteps", str(steps)]
            done = scene.start("fpmExplicit", *options, **self.environment)
            if done.returncode != 0:
                raise Failed(f"fpmExplicit: status {done.returncode}\n{done.stdout}")
            return scene.performance()
        finally:
            for file, text in files.items():
                (scene.root / file).write_text(text)


def measure(scene, variants, repeats, steps, notes):
    """Variants in turn, `repeats` times; a row of each, or a note why there is none."""
    told, failed = [[] for _ in variants], set()
    for _ in range(repeats):
        for variant, runs in zip(variants, told):
            if variant in failed:
                continue
            try:
                runs.append(variant.start(scene, steps))
            except Failed as failure:  # an algorithm may be unable to; the others go on
                failed.add(variant)
                first, *_, last = str(failure).splitlines()
                notes.append(f"{scene.name}, {variant.backend} {variant.precision} "
                             f"{variant.algorithm}, left out: {first} {last}")
    rows = []
    for variant, runs in zip(variants, told):
        if variant in failed:
            continue
        runs.sort(key=lambda run: run["wallSeconds"])
        found = runs[len(runs) // 2]  # the share is that of the median
        simd = "" if variant.backend == "cuda" else found["description"].split(", ")[2]
        name = scene.name if variant.contact else f"{scene.name}.noContact"
        rows.append(Row(name, variant.backend, variant.threads, simd, variant.precision,
                        variant.algorithm, found["elements"], found["contactors"], found["steps"],
                        [run["wallSeconds"] for run in runs], found.get("contactShare"),
                        None if found["contactors"] else found.get("bytesPerElementStep"),
                        found["deviceBytes"], found["checksum"]))
    shareContact(rows)
    return rows


def shareContact(rows):
    """A GPU tells no shares: that of contact is what the same run costs more than without."""
    for row in rows:
        if row.backend != "cuda" or row.contactShare is not None or not row.contactors:
            continue
        for bare in rows:
            if (bare.case == f"{row.case}.noContact" and bare.precision == row.precision):
                row.contactShare = max(0.0, 1 - bare.nanoseconds(bare.wall)
                                       / row.nanoseconds(row.wall))


def ways(machine, options):
    """What every scene is run with."""
    chosen = []
    if "cpu" in options.on:
        chosen += [Variant("serial", 1, "auto", "double"),
                   Variant("serial", 1, "auto", "double", "paper"),
                   Variant("openmp", machine.cores, "auto", "double"),
                   Variant("openmp", machine.cores, "auto", "mixed")]
    if machine.gpu and "gpu" in options.on:
        for precision in ("double", "mixed", "single"):
            chosen += [Variant("cuda", 0, "", precision),
                       Variant("cuda", 0, "", precision, contact=False)]
        chosen.append(Variant("cuda", 0, "", "double", "paper"))
    return [variant for variant in chosen if variant.algorithm in options.algorithms]


def ladder(machine, options):
    """From the paper's algorithm to ours, one improvement after the other."""
    def pairs(text):
        return ("system/contactDict", PAIR, rf"\1 {text}", 0)

    cold = "search closestParticle; projection cold;"
    start = ("system/controlDict", r"\A", "strainGeometry start;\n", 1)
    steps = [("paper", ()),
             ("+ rotation of the middle surface", (start, pairs(cold))),
             ("+ strain at mid-step", (pairs(cold),)),
             ("+ search by faces", (pairs("projection cold;"),)),
             ("+ tracked projection = default", ())]
    rungs = []
    if "cpu" in options.on:
        rungs.append(Variant("serial", 1, "scalar", "double", "paper"))
        rungs += [Variant("serial", 1, "auto", "double", name, edits) for name, edits in steps]
        rungs += [Variant("serial", 1, "auto", "mixed", "+ mixed precision"),
                  Variant("openmp", machine.cores, "auto", "mixed", "+ all cores")]
    if machine.gpu and "gpu" in options.on:
        rungs += [Variant("cuda", 0, "", "double", name, edits) for name, edits in steps]
        rungs.append(Variant("cuda", 0, "", "mixed", "+ mixed precision"))
    return rungs


@contextlib.contextmanager
def busyPrograms(count):
    """So many programs that do nothing but compute, for a while."""
    programs = [subprocess.Popen([sys.executable, "-c", "while True: pass"]) for _ in range(count)]
    try:
        yield
    finally:
        for program in programs:
            program.kill()
            program.wait()


def busy(machine, options, notes):
    """Rows of the plate beside none, one and as many busy programs as there are cores, and the
    times of every way over that of one thread."""
    variants = [Variant("serial", 1, "auto", "double"),
                Variant("openmp", 0, "auto", "double"),
                Variant("openmp", machine.cores, "auto", "double"),
                Variant("openmp", machine.cores, "auto", "double", "spinning",
                        environment={"OMP_WAIT_POLICY": "active"})]
    rows = []
    with plate(options) as scene:
        for count in sorted({0, 1, machine.cores}):
            scene.name = f"plate.busy{count}"
            with busyPrograms(count):
                found = measure(scene, variants, options.repeats, options.sceneSteps or 400, notes)
            notes.append(f"{scene.name}: over one thread " + ", ".join(
                f"{row.way()} {row.algorithm} {row.wall / found[0].wall:.2f}" for row in found[1:]))
            rows += found
    return rows


def prepared(options):
    """Every scene there is, for a machine without gmsh: name and how to make it."""
    scenes = {f"layers.{count}": (lambda c=count: layers(options, c)) for count in options.layers}
    return {"plate": lambda: plate(options), "tube": lambda: tube(options), **scenes}
