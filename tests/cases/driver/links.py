"""Links in a case, at every place where a program writes or removes something: none of them lets it
touch what lies outside, and the message names the link."""

import shutil

from driver.scene import Scene, elastic

FILE_ERROR = 6  # exit code
CHART = """charts { c { cost elementSteps;
    ladders { step { entry controlDict.timeStep.safety; values (0.3 0.4); } }
    probes { p { file "postProcessing/energies/0/energies.dat"; y total;
                 reference { finest step; } } } } }
"""
MAP = """maps { m { scene twoBars; steps 20; eigenvalue no;
    x { parameter timeStepFactor; values (0.5 0.9); }
    y { parameter speed; values (1 2); } } }
"""
PLOT = """plots { p { title "p"; xLabel "t"; yLabel "e";
    series { s { file "postProcessing/energies/0/energies.dat"; x time; y total; } } } }
tables { t { type extrema; field U; } }
pictures { q { field Mises; } }
"""


def scene(binaries):
    """Two cubes that touch: a run of some steps, with every kind of output."""
    return Scene(binaries, end=2e-7, rows=4, frames=2,
                 parts=elastic("a", 210000, 0.3, 7.85e-9) + elastic("b", 210000, 0.3, 7.85e-9),
                 bodies="a { type box; origin (0 0 0); size (1 1 1); cells (2 2 1); }"
                        "b { type box; origin (0 0 1); size (1 1 1); cells (2 2 1); }",
                 pairs="p { contactor a; target b; }",
                 initial="v { type velocity; part a; value (0 0 1000); }",
                 files={"system/chartDict": CHART, "system/stabilityDict": MAP,
                        "system/probeDict": PLOT})


class Canary:
    """A folder beside the case that must stay as it is."""

    def __init__(self, case):
        self.root = case.root.parent / "outside"
        self.number = 0

    def plant(self, link, isFolder, aside=None):
        """A link of this name in the case, to something outside that looks like what is written."""
        self.number += 1
        target = self.root / str(self.number)
        if isFolder:
            if aside and not aside.is_symlink():
                shutil.copytree(aside, target)
            for name in ("0", "runs/c", "chart/c/runs", "energies/0"):
                (target / name).mkdir(parents=True, exist_ok=True)
                (target / name / "canary").write_text("kept")
        else:
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_text("kept")
        link.parent.mkdir(parents=True, exist_ok=True)
        link.symlink_to(target)
        self.before = self.content()

    def content(self):
        return {str(p.relative_to(self.root)): p.read_bytes() if p.is_file() else None
                for p in sorted(self.root.rglob("*"))}

    def isUntouched(self):
        return self.content() == self.before


def moved(path):
    """What lies where a link is to be planted, under another name."""
    if path.is_symlink() or path.exists():
        aside = path.with_name(path.name + ".aside")
        path.rename(aside)
        return aside
    return None


def tried(case, marks, canary, place, isFolder, command):
    """Runs a program with a link at `place`, which is put back afterwards."""
    link = case.root / place
    aside = moved(link)
    canary.plant(link, isFolder, aside)
    done = case.start(*command)
    what = f"{command[0]}, {place}"
    if not canary.isUntouched():
        marks.failures.append(f"{what}: wrote or removed outside of the case")
    if link.is_symlink():
        named = any(words in done.stdout for words in (
            f"'{link}' is a link", f"the link '{link}', which leads out of the case"))
        if done.returncode != FILE_ERROR or not named:
            marks.failures.append(f"{what}: status {done.returncode}, the link is "
                                  f"{'named' if named else 'not named'}: {done.stdout[-600:]}")
    elif isFolder or done.returncode != 0:  # a file written whole replaces a link
        marks.failures.append(f"{what}: status {done.returncode}, the link is gone")
    if link.is_symlink() or link.is_file():
        link.unlink()
    if aside:
        aside.rename(link)


FOLDERS = (
    ("constant", ("fpmMesh",)),
    ("postProcessing", ("fpmExplicit",)), ("postProcessing/energies", ("fpmExplicit",)),
    ("postProcessing/energies/0", ("fpmExplicit",)),
    ("postProcessing/performance", ("fpmExplicit",)), ("postProcessing/health/0", ("fpmExplicit",)),
    ("previous", ("fpmExplicit",)), ("1e-07", ("fpmExplicit",)),
    ("checkpoint", ("fpmExplicit",)),
    ("postProcessing", ("fpmProbe",)), ("postProcessing/plots", ("fpmProbe",)),
    ("postProcessing/t", ("fpmProbe",)), ("postProcessing/pictures", ("fpmProbe",)),
    ("postProcessing", ("fpmStability",)), ("postProcessing/stability", ("fpmStability",)),
    ("postProcessing/chart", ("fpmChart",)), ("postProcessing/chart/c", ("fpmChart",)),
    ("postProcessing/chart/c/runs", ("fpmChart",)),
    ("postProcessing/chart/c/runs/.trial", ("fpmChart",)),
    ("postProcessing/chart/c/runs/step_0.3", ("fpmChart",)),
)
FILES = (
    ("postProcessing/energies/0/energies.dat", ("fpmExplicit",)),
    ("postProcessing/contactForces/0/p.dat", ("fpmExplicit",)),
    ("postProcessing/performance/0/performance", ("fpmExplicit",)),
    ("status", ("fpmExplicit",)), ("case.vtkhdf.series", ("fpmExplicit",)),
    ("case.hdf.series", ("fpmExplicit",)), ("1e-07/fields.vtkhdf", ("fpmExplicit",)),
    ("checkpoint/state.h5", ("fpmExplicit",)), ("checkpoint/next.h5", ("fpmExplicit",)),
    ("log.fpmExplicit", ("fpmExplicit",)), ("log.fpmExplicit.1", ("fpmExplicit",)),
    ("postProcessing/plots/p.svg", ("fpmProbe", "-plots")),
    ("postProcessing/t/0/U.dat", ("fpmProbe", "-tables")),
    ("postProcessing/stability/m.svg", ("fpmStability",)),
    ("postProcessing/chart/c/runs.dat", ("fpmChart",)),
    ("postProcessing/chart/c/chart.dat", ("fpmChart",)),
    ("constant/mesh.vtkhdf", ("fpmMesh",)),
)


def check(binaries, marks):
    with scene(binaries) as case:
        canary = Canary(case)
        case.mesh()
        for place, command in FOLDERS:
            if command[0] == "fpmProbe":
                case.run("fpmExplicit")
            tried(case, marks, canary, place, True, command)
        for place, command in FILES:
            if command[0] == "fpmProbe":
                case.run("fpmExplicit")
            tried(case, marks, canary, place, False, command)
        marks.note(f"{len(FOLDERS)} folders and {len(FILES)} files, each a link out of the case")
        defaults(case, marks, canary)
        advise(case, marks, canary)
        stranger(case, marks)
        overlay(case, marks)
        case.run("fpmMesh")
        case.run("fpmExplicit")
        marks.true("and without links all is written", case.status()["state"] == "finished")


def defaults(case, marks, canary):
    """-writeDefaults, into a folder that is a link."""
    dictionary = case.root / "system/chartDict"
    text = dictionary.read_text()
    dictionary.unlink()
    tried(case, marks, canary, "extra", True,
          ("fpmExplicit", "-dict", "extra/partProperties", "-writeDefaults"))
    dictionary.write_text(text)


def advise(case, marks, canary):
    """The folder of -to is the user's; what is made beside it first is not followed."""
    draft = case.root.parent / ".less.draft"
    canary.plant(draft, True)
    done = case.start("fpmAdvise", "-apply", "symmetry", "-to", str(case.root.parent / "less"))
    marks.true(f"fpmAdvise: status {done.returncode}", canary.isUntouched()
               and done.returncode == FILE_ERROR and f"'{draft}' is a link" in done.stdout)
    draft.unlink(missing_ok=True)


def stranger(case, marks):
    """A folder of a person where a copy of the case would go is not removed."""
    for name in (".trial", "step_0.3"):
        own = case.root / "postProcessing/chart/c/runs" / name / "notes"
        aside = moved(own.parent)
        own.parent.mkdir(parents=True)
        own.write_text("kept")
        runs = case.root / "postProcessing/chart/c/runs.dat"
        runs.unlink(missing_ok=True)
        done = case.start("fpmChart")
        marks.true(f"runs/{name} of a person stays: status {done.returncode}",
                   done.returncode == FILE_ERROR and own.read_text() == "kept"
                   and f"'{own.parent}' is in the way" in done.stdout)
        own.unlink()
        own.parent.rmdir()
        if aside:
            aside.rename(own.parent)


def overlay(case, marks):
    """A folder that holds the copies cannot be laid over them."""
    dictionary = case.root / "system/chartDict"
    text = dictionary.read_text()
    for folder in ("postProcessing", ".", "postProcessing/chart/c"):
        dictionary.write_text(CHART.replace(
            "entry controlDict.timeStep.safety; values (0.3 0.4);", f'overlay (none "{folder}");'))
        done = case.start("fpmChart")
        marks.true(f"overlay {folder}: status {done.returncode}",
                   done.returncode == 3 and "cannot be laid over copies of the case" in done.stdout)
    dictionary.write_text(text)
