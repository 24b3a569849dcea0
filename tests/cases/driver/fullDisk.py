"""A disk that is full for a moment, with -onDiskFull wait: the run waits for room and ends as if there had
always been some.

Whatever a run does to a file of its case meets the full disk once: its start, which moves what an earlier
run left, its frames, histories and checkpoints, its records at the end. So does a run that goes on, which
moves what is later than its checkpoint."""

import pathlib

from driver.faults import WRITES, Bench, isLog
from driver.results import different, fastFolder, fresh, results, temporaries

# What needs no room; `status` is written in place, and rows that a sync could not write are lost to it.
NEEDS_NONE = ("unlink", "rmdir", "ftruncate", "fflush")
WAIT = ("-onDiskFull", "wait")


def needsRoom(call, file):
    return not (call in NEEDS_NONE or isLog(file) or file == ".lock" or file.endswith("/.lock")
                or (call in WRITES and file == "status")
                or (call in ("fsync", "fdatasync", "close") and file.endswith((".dat", "status"))))


def moved(root):
    """Names of what a run has set aside."""
    return sorted(path.relative_to(root).as_posix() for folder in ("previous", "later")
                  for path in (root / folder).rglob("*") if path.is_file())


def judge(bench, marks, name, options):
    bench.clean()
    code, output = bench.start("fpmExplicit", *options, *WAIT)
    marks.true(f"{name}, with room: status {code}", code == 0)
    expected, aside, calls = results(bench.root), moved(bench.root), bench.calls()
    first = {}
    for number, (call, file) in enumerate(calls, 1):
        if needsRoom(call, file):
            first.setdefault((call, file.rsplit(".tmp")[0] if ".tmp" in file else file), number)
    for (call, file), number in first.items():
        bench.clean()
        code, output = bench.start("fpmExplicit", *options, *WAIT, kind="ENOSPC", at=number)
        what = f"{name}: call {number}, {call} of {file}"
        if code != 0 or "disk full: waiting for room for" not in output:
            marks.failures.append(f"{what}: status {code}\n{output[-600:]}")
        elif wrong := different(results(bench.root), expected):
            marks.failures.append(f"{what}: not as with room: {wrong}")
        elif moved(bench.root) != aside or temporaries(bench.root):
            marks.failures.append(f"{what}: {moved(bench.root)} set aside, {temporaries(bench.root)}")
    marks.note(f"{name}: {len(first)} waits, {len(aside)} files set aside")


def check(binaries, marks):
    with fastFolder() as folder:
        bench = Bench(binaries, pathlib.Path(folder))
        bench.clean()
        bench.start()
        fresh(bench.root, bench.pristine)
        judge(bench, marks, "a new run", ())
        (bench.pristine / "checkpoint/state.h5").unlink()
        judge(bench, marks, "a run that goes on", ("-continue",))
        marks.true("every one waits and ends as with room", not marks.failures)
