#!/usr/bin/env python3
"""Reads every dictionary the project ships with the Python package foamlib, installed into a virtual
environment that lives as long as the test. Exit status: 0 all read, 1 not, 77 no foamlib to be had.

    foamlibReads.py <project folder>
"""

import os
import subprocess
import sys
import tempfile
from pathlib import Path

PACKAGE = "foamlib==1.7.10"
PATTERNS = ("etc/caseDicts/*", "tutorials/*/system/*", "tutorials/*/constant/*", "tutorials/*/0/*")
GENERATED = {".vtkhdf", ".msh", ".geo", ".md"}


def skip(reason):
    print(f"skipped: {reason}")
    sys.exit(77)


def run_inside_environment(project):
    with tempfile.TemporaryDirectory() as folder:
        python = Path(folder) / "bin" / "python"
        steps = (
            [sys.executable, "-m", "venv", folder],
            [str(python), "-m", "pip", "install", "--quiet", "--timeout", "10", "--retries", "1", PACKAGE],
        )
        for step in steps:
            try:
                done = subprocess.run(step, capture_output=True, text=True, timeout=120)
            except subprocess.TimeoutExpired:
                skip(f"no answer within 120 s from {' '.join(step[1:4])}")
            if done.returncode != 0:
                lines = (done.stderr or done.stdout).strip().splitlines()
                skip(f"cannot install {PACKAGE}: {lines[-1] if lines else 'no output'}")
        return subprocess.run([str(python), __file__, "--inside", project]).returncode


def problems(value, place):
    """Places in a parsed tree where a value swallowed what should have been the next entry."""
    if hasattr(value, "items"):
        for key, inner in value.items():
            yield from problems(inner, f"{place}.{key}")
    elif isinstance(value, (list, tuple)):
        for inner in value:
            yield from problems(inner, place)
    elif isinstance(value, str) and not value.startswith('"') and any(c in value for c in "{};\n"):
        yield f"{place}: read as the text {value!r}"


def read_all(project):
    from foamlib import FoamFile

    with tempfile.TemporaryDirectory() as folder:  # a test that cannot fail proves nothing
        broken = Path(folder) / "brokenDict"
        broken.write_text("parts { rod { density 1; }\n")
        try:
            FoamFile(broken).as_dict()
            print("an unclosed brace was not refused")
            return 1
        except Exception:
            pass

    files = [f for pattern in PATTERNS for f in sorted(Path(project).glob(pattern))]
    files = [f for f in files if f.is_file() and f.suffix not in GENERATED]
    failures = 0
    for file in files:
        name = file.relative_to(project)
        try:
            found = list(problems(FoamFile(file).as_dict(), str(name)))
        except Exception as error:
            found = [f"{name}: {type(error).__name__}: {error}"]
        for line in found:
            print(line)
        failures += bool(found)
    print(f"{len(files)} dictionaries read by foamlib, {failures} not")
    return 1 if failures or not files else 0


if __name__ == "__main__":
    if len(sys.argv) == 3 and sys.argv[1] == "--inside":
        sys.exit(read_all(os.path.abspath(sys.argv[2])))
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    sys.exit(run_inside_environment(os.path.abspath(sys.argv[1])))
