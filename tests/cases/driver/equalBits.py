"""The same bits from every backend: state checksum after 1000 steps of the plate impact."""

from driver.caseRun import DEVICE, CaseRun, Failed
from driver.plate import prepared

STEPS = ("-maxSteps", "1000")
WAYS = {
    "serial scalar": ("-backend", "serial", "-simd", "scalar", "-maxSteps", "300"),
    "serial avx2": ("-backend", "serial", "-simd", "avx2", *STEPS),
    "serial avx512": ("-backend", "serial", "-simd", "avx512", *STEPS),
    "openmp 1": ("-backend", "openmp", "-threads", "1", *STEPS),
    "openmp 2": ("-backend", "openmp", "-threads", "2", *STEPS),
}


def missing(binaries, case, options):
    """None, or why this machine cannot run with these options."""
    done = case.start("fpmExplicit", *options)
    if done.returncode == DEVICE:
        return next(line for line in done.stdout.splitlines() if "error" in line.lower())
    if done.returncode != 0:
        raise Failed(f"fpmExplicit {' '.join(options)}: status {done.returncode}")
    return None


def check(binaries, marks):
    with prepared(binaries) as case:
        case.replace("system/controlDict", r"^writeInterval .*;", "writeInterval 4e-4;")
        short = ("-backend", "serial", "-maxSteps", "300")
        expected300 = case.solve(*short)
        marks.true(f"300 steps: serial scalar = auto = {expected300}",
                   case.solve(*WAYS["serial scalar"]) == expected300)
        expected = case.solve("-backend", "serial", *STEPS)
        marks.note(f"1000 steps: serial auto {expected}")
        for way in ("serial avx2", "serial avx512", "openmp 1", "openmp 2"):
            done = case.start("fpmExplicit", *WAYS[way])
            if done.returncode == DEVICE and way == "serial avx512":
                marks.note("avx512 SKIPPED: this processor has none")
                continue
            if done.returncode != 0:
                raise Failed(f"fpmExplicit {way}: status {done.returncode}\n{done.stdout[-600:]}")
            marks.true(f"= {way}", CaseRun.checksum(done.stdout) == expected)


def gpu(binaries, marks):
    with prepared(binaries) as case:
        case.replace("system/controlDict", r"^writeInterval .*;", "writeInterval 4e-4;")
        why = missing(binaries, case, ("-backend", "cuda", "-maxSteps", "1"))
        if why:
            return why
        for precision in ("double", "mixed", "single"):
            expected = case.solve("-backend", "serial", "-precision", precision, *STEPS)
            found = case.solve("-backend", "cuda", "-precision", precision, *STEPS)
            marks.true(f"{precision}: cuda = serial = {expected}", found == expected)
    return None
