"""Maps of tutorials/bar: no point that is predicted to be stable fails; a killed map goes on."""

import os
import signal
import subprocess
import time

from driver.caseRun import CaseRun


def maps(case):
    return sorted((case.root / "postProcessing/stability").glob("*.dat"))


def check(binaries, marks):
    with CaseRun("tutorials/bar", binaries) as case:
        running = subprocess.Popen([case.binaries / "fpmStability", "-threads", "1"], cwd=case.root,
                                   stdout=subprocess.DEVNULL)
        while running.poll() is None and len(maps(case)) < 2:
            time.sleep(0.005)
        os.kill(running.pid, signal.SIGKILL)
        running.wait()
        output = case.run("fpmStability", "-threads", "2")
        marks.true("a killed map goes on", "are there already" in output)
        points = predicted = failed = surprises = 0
        for file in maps(case):
            table = case.table(f"stability/{file.name}")
            points += len(table["outcome"])
            for outcome, done, stable in zip(table["outcome"], table["done"],
                                             table["predictedStable"]):
                predicted += stable == 1
                failed += outcome != 0
                surprises += (stable == 1 and outcome != 0) or done != 1
            marks.true(f"{file.stem} drawn", file.with_suffix(".svg").exists())
        marks.note(f"{points} points, {predicted:g} predicted to be stable, {failed} fail")
        marks.true("more than 200 points", points > 200)
        marks.true("some fail", failed > 20)
        marks.true("none that is predicted to be stable", surprises == 0)
        before = [file.read_bytes() for file in maps(case)]
        for file in maps(case):
            file.unlink()
        case.run("fpmStability", "-threads", "1")
        marks.true("the same again on one thread", before == [f.read_bytes() for f in maps(case)])
