"""Data races of the threads that share a step: scenes of driver/bits.py on three threads, by the programs
of preset tsan (cmake --preset tsan && cmake --build --preset tsan; check.py races build-tsan/bin).

The sanitizer knows the barriers of OpenMP through Archer, a part of libomp."""

import pathlib
import subprocess

from driver.bits import SCENES

FEW = ("plastic", "struck.selective", "bodies", "towers", "general", "self", "eroding.general")
STEPS = 60


def archer():
    """The tool's file, or None."""
    try:
        done = subprocess.run(["clang", "-print-resource-dir"], text=True, check=True,
                              stdout=subprocess.PIPE)
    except OSError:
        return None
    found = pathlib.Path(done.stdout.strip()).parents[1] / "libarcher.so"
    return str(found) if found.exists() else None


def check(binaries, marks):
    tool = archer()
    if tool is None:
        return "no clang with libarcher.so (packages clang, libomp-dev)"
    if b"__tsan_init" not in (pathlib.Path(binaries) / "fpmExplicit").read_bytes():
        return "these programs are not of preset tsan"
    for name in FEW:
        with SCENES[name][0](binaries) as case:
            case.mesh()
            done = case.start(
                "fpmExplicit", "-backend", "openmp", "-threads", "3", "-maxSteps", str(STEPS),
                OMP_TOOL_LIBRARIES=tool, OMP_WAIT_POLICY="passive",
                TSAN_OPTIONS="ignore_noninstrumented_modules=1")
            races = done.stdout.count("WARNING: ThreadSanitizer")
            marks.true(f"{name}: no race", done.returncode == 0 and races == 0)
            if done.returncode != 0 or races:
                at = max(0, done.stdout.find("WARNING: ThreadSanitizer"))
                marks.failures.append(f"{name}: {races} races\n{done.stdout[at:at + 3000]}")
    return None
