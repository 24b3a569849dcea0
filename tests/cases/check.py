#!/usr/bin/env python3
"""Runs one check of this folder: check.py <check> <folder of the applications>

One line with the measured values and their pass marks; status 0 passed, 1 failed, 77 skipped."""

import importlib
import pathlib
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

from driver.caseRun import Failed, Marks  # noqa: E402


def found(name):
    """The function of a check: <module of driver>[.<function>]."""
    module, _, function = name.partition(".")
    return getattr(importlib.import_module(f"driver.{module}"), function or "check")


def main(name, binaries):
    check = found(name)
    marks = Marks()
    try:
        skipped = check(binaries, marks)
    except Failed as failure:
        marks.failures.append(str(failure))
        skipped = None
    if skipped:
        print(f"{name}: skipped, {skipped}")
        return 77
    print(f"{name}: " + "; ".join(marks.words))
    for failure in marks.failures:
        print(f"  FAILED {failure}")
    return 1 if marks.failures else 0


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    sys.exit(main(sys.argv[1], sys.argv[2]))
