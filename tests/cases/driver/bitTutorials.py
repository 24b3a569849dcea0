"""The tutorials and their variants with few elements, for driver/bits.py."""

import shutil

from driver.caseRun import CaseRun


class Tutorial(CaseRun):
    """A copy of a tutorial with a variant laid over it; `numbers` are entries of its meshDict."""

    def __init__(self, binaries, name, variant=None, script=None, **numbers):
        super().__init__(f"tutorials/{name}", binaries)
        if variant:
            shutil.copytree(self.root / "variants" / variant, self.root, dirs_exist_ok=True)
        for entry, value in numbers.items():
            self.replace("system/meshDict", rf"^( *){entry} +[^;$\n]+;", rf"\g<1>{entry} {value};")
        if script:
            script(self)

    def setEntry(self, name, value):
        setEntry(self, name, value)


def setEntry(case, name, value):
    """One entry of controlDict, added at its end where it is missing."""
    path = case.root / "system/controlDict"
    lines = [line for line in path.read_text().splitlines() if not line.startswith(f"{name} ")]
    path.write_text("\n".join([*lines, f"{name} {value};", ""]))


def makeLayers(case):
    case.run(case.root / "makeLayers")


def makeSlab(case):
    (case.root / "slab.msh").write_text(case.run(case.root / "makeMesh", "2"))


TUBE = {"wallCells": 2, "halfCells": 16}
DIE = {"dieQuarterCells": 12, "dieHalfCells": 6}


def tutorial(name, **options):
    return lambda binaries: Tutorial(binaries, name, **options)


# Scene and steps of the short form.
TUTORIALS = {
    "bar": (tutorial("bar"), 300),
    "slidingBlock": (tutorial("slidingBlock"), 600),
    "hertz": (tutorial("hertz", script=makeSlab), 800),
    "taylorBar": (tutorial("taylorBar", core=2, rings=2, axial=16), 600),
    "plateImpact": (tutorial("plateImpact", cells="(30 30 1)"), 120),
    "plateImpact.full": (tutorial("plateImpact", variant="full", cells="(36 36 1)"), 60),
    "squeezedTube": (tutorial("squeezedTube", halfCircleCells=24, **TUBE, **DIE), 400),
    "squeezedTube.paper": (tutorial("squeezedTube", variant="paper", quarterCells=12, **TUBE, **DIE),
                           400),
    "squeezedTube.analyticDie": (tutorial("squeezedTube", variant="analyticDie",
                                          halfCircleCells=24, **TUBE), 400),
    "ringCrush": (tutorial("ringCrush", circumferential=50, radial=2), 500),
    "layeredPlate": (tutorial("layeredPlate", script=makeLayers, layers=3, cells="(16 16 1)"), 150),
}
