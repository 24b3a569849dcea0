"""The programs under the address and undefined-behaviour sanitizers: scenes of driver/bits.py, by the
programs of preset asan or fuzz (cmake --preset asan && cmake --build --preset asan; check.py sanitized
build-asan/bin). A report ends a program with a status of its own."""

import pathlib
import re

from driver.bits import SCENES

# Every tutorial with contact, and what they leave out.
FEW = ("slidingBlock", "plateImpact", "squeezedTube", "squeezedTube.analyticDie", "ringCrush", "hertz",
       "plastic", "struck.selective", "bodies", "towers", "general", "self", "eroding.general")
REPORT = re.compile(r"ERROR: (Address|Leak)Sanitizer|runtime error:")
SETTINGS = (("serial", "scalar"), ("openmp", "avx2"))
STEPS = 60


def check(binaries, marks):
    if b"__asan_init" not in (pathlib.Path(binaries) / "fpmExplicit").read_bytes():
        return "these programs are not of preset asan"
    runs = 0
    for name in FEW:
        with SCENES[name][0](binaries) as case:
            case.mesh()
            for backend, simd in SETTINGS:
                threads = ("-threads", "2") if backend == "openmp" else ()
                done = case.start("fpmExplicit", "-backend", backend, "-simd", simd, *threads,
                                  "-maxSteps", str(STEPS))
                runs += 1
                report = REPORT.search(done.stdout)
                if done.returncode != 0 or report:
                    at = report.start() if report else -2000
                    marks.failures.append(f"{name} {backend} {simd}: status {done.returncode}\n"
                                          f"{done.stdout[at:][:3000]}")
    marks.note(f"{len(FEW)} scenes, {runs} runs of {STEPS} steps: {len(marks.failures)} reports")
    return None
