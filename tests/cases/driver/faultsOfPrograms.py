"""Every call of fpmMesh, fpmSetContact and fpmProbe on a file of the case fails, or is its last.

What they write is whole, as before or as after; exit code 0 means that all of it is there; and run again,
they need no cleaning up."""

import signal

from driver.caseRun import Failed
from driver.faults import FILE_IO, Bench, everything, sample
from driver.hostile import scene
from driver.results import RUN, fastFolder, fresh, isTemporary, temporaries

PROGRAMS = ("fpmMesh", "fpmSetContact", "fpmProbe")


def files(root):
    """Contents by name, without the ids of runs, of all but logs, the lock and temporaries."""
    return {path.relative_to(root).as_posix(): RUN.sub(b"run", path.read_bytes())
            for path in root.rglob("*")
            if path.is_file() and not path.name.startswith(("log.", ".lock")) and not isTemporary(path)}


class Judge:
    def __init__(self, bench, program, marks):
        self.bench, self.program, self.marks = bench, program, marks
        self.before = files(bench.pristine)
        bench.clean()
        code, output = bench.start(program)
        if code != 0:
            raise Failed(f"{program} without a fault: status {code}\n{output}")
        self.after, self.calls = files(bench.root), bench.calls()

    def run(self, plan):
        for number, kind, lasts in plan:
            call, file = self.calls[number - 1]
            self.bench.clean()
            code, output = self.bench.start(self.program, kind=kind, at=number, lasts=lasts)
            for wrong in self.judge(code, output, kind in ("kill", "tear")) + self.again():
                self.marks.failures.append(
                    f"{self.program}: {kind}{' from' if lasts else ' at'} call {number}, "
                    f"{call} of {file}: {wrong}")

    def judge(self, code, output, dies):
        if code is None:
            return ["it hangs"]
        if dies != (code == -signal.SIGKILL) or code not in (0, FILE_IO, -signal.SIGKILL):
            return [f"status {code}\n{output}"]
        found = files(self.bench.root)
        wrong = [f"{name} is damaged" for name, here in found.items()
                 if here not in (self.before.get(name), self.after.get(name))]
        wrong += [f"{name} is gone" for name in self.before if name in self.after and name not in found]
        if code == 0 and found != self.after:
            wrong.append("status 0, but not all is there")
        return wrong

    def again(self):
        code, output = self.bench.start(self.program)
        if code != 0:
            return [f"again: status {code}\n{output}"]
        wrong = ["again: not as without the fault"] if files(self.bench.root) != self.after else []
        if self.program == "fpmProbe" and temporaries(self.bench.root):
            # It works beside a run, without the lock: what has the case for itself cleans up.
            self.bench.start("fpmSetContact")
        return wrong + [f"again: {name} is left" for name in temporaries(self.bench.root)]


def judged(binaries, marks, planned):
    with fastFolder() as folder, scene(binaries) as case:
        bench = Bench(binaries, folder)
        for program in PROGRAMS:
            if program == "fpmProbe":
                case.solve()
            fresh(case.root, bench.pristine)
            judge = Judge(bench, program, marks)
            plan = planned(judge.calls)
            judge.run(plan)
            marks.note(f"{program}: {len(judge.calls)} calls, {len(plan)} faults")
            case.run(program)
    marks.true("files whole, as before or as after, and again without cleaning up",
               not marks.failures)


def check(binaries, marks):
    judged(binaries, marks, lambda calls: sample(calls, 3)[::3])


def long(binaries, marks):
    judged(binaries, marks, everything)
