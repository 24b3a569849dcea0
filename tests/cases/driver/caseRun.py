"""A case in a temporary copy, run with the applications of one build."""

import os
import pathlib
import re
import shutil
import subprocess
import tempfile

from driver.curves import readTable
from driver.record import readRecord

PROJECT = pathlib.Path(__file__).resolve().parents[3]
DEVICE = 8  # exit code where the wanted device is missing


class Failed(Exception):
    """A run or a check did not end as it should."""


class CaseRun:
    """Copies `source` (relative to the project), changes entries, runs applications, reads results."""

    timeout = 900  # seconds of one application

    def __init__(self, source, binaries, meshed=False):
        self.binaries = pathlib.Path(binaries).resolve()
        self.folder = tempfile.TemporaryDirectory(prefix="fpmCase.")
        self.root = pathlib.Path(self.folder.name) / pathlib.Path(source).name
        made = () if meshed else ("mesh.vtkhdf",)
        left = shutil.ignore_patterns(
            "postProcessing", *made, "fields.vtkhdf", "log.*", "status", "*.series", ".lock",
            "*e-*", "0.*", "previous")
        shutil.copytree(PROJECT / source, self.root, ignore=left)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.folder.cleanup()

    def replace(self, file, pattern, text, count=1):
        """Puts `text` where the regular expression stands in the file, `count` times exactly."""
        path = self.root / file
        changed, found = re.subn(pattern, text, path.read_text(), flags=re.M)
        if found != count:
            raise Failed(f"{file}: '{pattern}' stands {found} times, expected {count}")
        path.write_text(changed)

    def start(self, application, *options, **environment):
        """Runs an application and returns what came of it, whatever that is."""
        return subprocess.run(
            [self.binaries / application, *options], cwd=self.root, text=True, timeout=self.timeout,
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, env={**os.environ, **environment})

    def run(self, application, *options):
        """Runs an application that must succeed; returns its output."""
        done = self.start(application, *options)
        if done.returncode != 0:
            tail = "\n".join(done.stdout.splitlines()[-12:])
            raise Failed(f"{application} {' '.join(options)}: status {done.returncode}\n{tail}")
        return done.stdout

    def mesh(self):
        self.run("fpmMesh")
        if (self.root / "system/contactDict").exists():
            self.run("fpmSetContact")

    def solve(self, *options):
        """fpmExplicit; its state checksum."""
        return self.checksum(self.run("fpmExplicit", *options))

    @staticmethod
    def checksum(output):
        return re.search(r"^stateChecksum = (\w+)$", output, re.M).group(1)

    def table(self, path):
        return readTable(self.root / "postProcessing" / path)

    def status(self):
        return dict(re.findall(r"^(\w+) (\S+);$", (self.root / "status").read_text(), re.M))

    def performance(self):
        return readRecord(self.root / "postProcessing/performance/0/performance")

    def worstBalance(self):
        """Largest energy balance error of the run, a share of the largest energy."""
        return max(abs(value) for value in self.table("energies/0/energies.dat")["balance"])


class Marks:
    """Measured values beside their pass marks."""

    def __init__(self):
        self.words, self.failures = [], []
        self.rows = []  # name, reference, ours, error, pass mark: for doc/accuracy.md

    def note(self, text):
        self.words.append(text)

    def figure(self, name, value, reference="-"):
        """Told, not judged."""
        self.words.append(f"{name} {value}")
        self.rows.append((name, reference, value, "-", "-"))

    def within(self, name, value, low, high, unit=""):
        self.words.append(f"{name} {value:.4g}{unit} [{low:g}, {high:g}]")
        self.rows.append((name, "-", f"{value:.4g}{unit}", "-", f"{low:g} to {high:g}"))
        if not low <= value <= high:
            self.failures.append(f"{name} {value:.6g}{unit} is outside [{low:g}, {high:g}]")

    def against(self, name, value, reference, tolerance, unit="", scale=None):
        """A value beside its reference; the error is a share of it, or of `scale` where given."""
        error = (value - reference) / abs(scale if scale is not None else reference)
        unit = f" {unit}" if unit else ""
        told, allowed = f"{100 * error:+.2g} %", f"{100 * tolerance:g} %"
        self.words.append(f"{name} {value:.5g} ({reference:.5g}{unit}) {told} (< {allowed})")
        self.rows.append((name, f"{reference:.5g}{unit}", f"{value:.5g}", told, allowed))
        if not abs(error) < tolerance:
            self.failures.append(f"{name} {value:.6g}{unit}: {told} off {reference:.6g}, "
                                 f"more than {allowed}")

    def below(self, name, value, most):
        """A share, told in percent."""
        self.words.append(f"{name} {100 * value:.3g} % (< {100 * most:g} %)")
        self.rows.append((name, "0", f"{100 * value:.2g} %", "-", f"< {100 * most:g} %"))
        if not value < most:
            self.failures.append(f"{name} {100 * value:.4g} % is not below {100 * most:g} %")

    def true(self, name, holds):
        self.words.append(name)
        if not holds:
            self.failures.append(f"not so: {name}")
