"""A case written by its check: the scene stands where its numbers are judged."""

import pathlib
import tempfile

from driver.caseRun import CaseRun

UNITS = {"mm": "length mm; mass tonne; time s;", "m": "length m; mass kg; time s;"}


def elastic(name, youngs, poisson, density, more="", rotation="midSurface"):
    """A part of constant/partProperties; `more` holds further entries."""
    return (f"{name} {{ model elastic; density {density}; youngsModulus {youngs}; "
            f"poissonsRatio {poisson}; rotation {rotation}; {more} }}\n")


def plastic(name, youngs, poisson, density, yieldStress, modulus, more="", rotation="midSurface"):
    return (f"{name} {{ model elastoplastic; density {density}; youngsModulus {youngs}; "
            f"poissonsRatio {poisson}; yieldStress {yieldStress}; plasticModulus {modulus}; "
            f"rotation {rotation}; {more} }}\n")


def table(rows):
    """Amplitude straight between the rows (time, factor)."""
    return "table (" + " ".join(f"({t!r} {f!r})" for t, f in rows) + ")"


NO_VISCOSITY = "bulkViscosity { linear 0; quadratic 0; }"


class Scene(CaseRun):
    """Dictionaries from texts; `files` are further files of the case by name."""

    def __init__(self, binaries, *, bodies, parts, end, sets="", conditions="", initial="",
                 pairs="", surfaces="", control="", functions="", tables="", units="mm", rows=1000,
                 frames=1, files=None):
        self.binaries = pathlib.Path(binaries).resolve()
        self.folder = tempfile.TemporaryDirectory(prefix="fpmCase.")
        self.root = pathlib.Path(self.folder.name) / "case"
        functions = f"energies {{ type energies; }}\n{functions}"
        if pairs:
            functions += "\ncontactForces { type contactForces; }"
        texts = {
            "system/meshDict": f"bodies\n{{\n{bodies}\n}}\nsets\n{{\n{sets}\n}}\n",
            "constant/caseProperties": f"title \"check\";\nunits {{ {UNITS[units]} }}\n",
            "constant/partProperties": f"parts\n{{\n{parts}\n}}\n",
            "constant/boundaryConditions": conditions + "\n",
            "0/initialConditions": initial + "\n",
            "system/controlDict":
                f"application fpmExplicit;\nendTime {end!r};\nwriteInterval {end / frames!r};\n"
                f"historyInterval {end / rows!r};\nbackend serial;\n{control}\n"
                f"functions\n{{\n{functions}\n}}\n",
            "system/probeDict": f"tables\n{{\n{tables}\n}}\n",
            **(files or {}),
        }
        if pairs:
            texts["system/contactDict"] = \
                f"pairs\n{{\n{pairs}\n}}\nsurfaces\n{{\n{surfaces}\n}}\n"
        for name, text in texts.items():
            path = self.root / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
        self.hasTables = bool(tables)

    def all(self):
        """Mesh, contact surfaces, run, tables; returns itself for `with`."""
        self.mesh()
        self.solve()
        if self.hasTables:
            self.run("fpmProbe")
        return self

    def energies(self):
        return self.table("energies/0/energies.dat")

    def contact(self, pair):
        return self.table(f"contactForces/0/{pair}.dat")

    def point(self, name, field="displacement"):
        return self.table(f"{name}/0/{field}.dat")

    def probed(self, name, field):
        """Columns by component: XX, x, min; of a scalar, the name of the field."""
        table = self.table(f"{name}/0/{field}.dat")
        return {column.removeprefix(f"{field}_"): values for column, values in table.items()}

    def worstBalance(self):
        """Largest error of the balance over the largest energy of the whole run."""
        e = self.energies()
        most = max(max(abs(x) for x in e[name]) for name in ("kinetic", "internal", "external"))
        start = e["total"][0] - e["external"][0]
        return max(abs(t - x - start) for t, x in zip(e["total"], e["external"])) / most

    def hourglassShare(self):
        """Of the largest internal energy."""
        energies = self.energies()
        most = max(abs(e) for e in energies["internal"])
        return max(abs(e) for e in energies["hourglass"]) / most if most else 0.0
