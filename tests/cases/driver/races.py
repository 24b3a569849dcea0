"""Data races of the threads that share a step: scenes of driver/bits.py on two and three threads, by the programs
of preset tsan (cmake --preset tsan && cmake --build --preset tsan; check.py races build-tsan/bin).

The sanitizer knows the barriers of OpenMP through Archer, a part of libomp. A small program with a race,
and the same without, show first that races are seen and that barriers are."""

import os
import pathlib
import subprocess
import tempfile

from driver.bits import SCENES

# Scenes of every kind on three threads, and tutorials on two.
FEW = {**dict.fromkeys(("plastic", "struck.selective", "bodies", "towers", "general", "self",
                        "eroding.general"), 3),
       **dict.fromkeys(("slidingBlock", "plateImpact", "squeezedTube", "ringCrush"), 2)}
STEPS = 60
REPORT = "WARNING: ThreadSanitizer"
REVERSED = """
int main()
{
    constexpr int count = 300;
    int values[count] = {}, reversed[count];
#pragma omp parallel num_threads(3)
    {
#pragma omp for%s
        for (int i = 0; i < count; ++i) values[i] = i;
#pragma omp for
        for (int i = 0; i < count; ++i) reversed[i] = values[count - 1 - i];
    }
    return reversed[0] > 0 ? 0 : 1;
}
"""
PLANTED_RACE, BARRIER = REVERSED % " nowait", REVERSED % ""


def archer():
    """The tool's file, or None."""
    try:
        done = subprocess.run(["clang", "-print-resource-dir"], text=True, check=True,
                              stdout=subprocess.PIPE)
    except OSError:
        return None
    found = pathlib.Path(done.stdout.strip()).parents[1] / "libarcher.so"
    return str(found) if found.exists() else None


def settings(tool):
    return {"OMP_TOOL_LIBRARIES": tool, "OMP_WAIT_POLICY": "passive",
            "TSAN_OPTIONS": "ignore_noninstrumented_modules=1"}


def reports(source, tool):
    """Number of races that a program is reported for."""
    with tempfile.TemporaryDirectory() as folder:
        file, program = pathlib.Path(folder) / "planted.cpp", pathlib.Path(folder) / "planted"
        file.write_text(source)
        subprocess.run(["clang++", "-O1", "-g", "-fopenmp", "-fsanitize=thread", file, "-o", program],
                       check=True)
        done = subprocess.run([program], text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              env={**os.environ, **settings(tool)}, check=False)
        return done.stdout.count(REPORT)


def check(binaries, marks):
    tool = archer()
    if tool is None:
        return "no clang with libarcher.so (packages clang, libomp-dev)"
    if b"__tsan_init" not in (pathlib.Path(binaries) / "fpmExplicit").read_bytes():
        return "these programs are not of preset tsan"
    marks.true("a planted race is seen", reports(PLANTED_RACE, tool) > 0)
    marks.true("a barrier is none", reports(BARRIER, tool) == 0)
    for name, threads in FEW.items():
        with SCENES[name][0](binaries) as case:
            case.mesh()
            done = case.start(
                "fpmExplicit", "-backend", "openmp", "-threads", str(threads), "-maxSteps", str(STEPS),
                **settings(tool))
            races = done.stdout.count(REPORT)
            marks.true(f"{name}: no race", done.returncode == 0 and races == 0)
            if done.returncode != 0 or races:
                at = max(0, done.stdout.find(REPORT))
                marks.failures.append(f"{name}: {races} races\n{done.stdout[at:at + 3000]}")
    return None
