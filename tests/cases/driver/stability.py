"""Maps of tutorials/bar: no point that is predicted to be stable fails; a killed map goes on. The
catalogue of failures, from a folder that is no case."""

import os
import pathlib
import signal
import subprocess
import tempfile
import time

from driver.caseRun import CaseRun


OWN = """maps { own { scene case; steps 300; eigenvalue no;
    x { parameter timeStepFactor; values (0.3 0.6 0.9 1.2 2.5); }
    y { parameter speed; values (1 2); } } }
"""


def maps(case):
    return sorted((case.root / "postProcessing/stability").glob("*.dat"))


def catalogue(binaries, marks):
    def run(*options):
        return subprocess.run([pathlib.Path(binaries).resolve() / "fpmStability", *options],
                              cwd=folder, text=True, capture_output=True)

    with tempfile.TemporaryDirectory() as folder:
        done = run("-catalogue", "-scenes", "F1,rigidOnRigid", "-to", "found")
        marks.true("two scenes of the catalogue",
                   done.returncode == 0 and "2 scenes, all as expected" in done.stdout)
        marks.true("its files and nothing else",
                   [str(f.relative_to(folder)) for f in sorted(pathlib.Path(folder).rglob("*.*"))]
                   == [f"found/failures.{kind}" for kind in ("dat", "md", "svg")])
        wrong = run("-catalogue", "-scenes", "grooveNod")
        marks.true("a slip of the pen in a scene's name",
                   wrong.returncode == 2 and "did you mean 'grooveNode'?" in wrong.stderr)
        marks.true("scenes without catalogue are refused",
                   run("-scenes", "F1", "-case", pathlib.Path("tutorials/bar").resolve(),
                       "-noLog").returncode == 2)


def check(binaries, marks):
    catalogue(binaries, marks)
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
        marks.true("no bound is called one that fails below itself",
                   "alone is no safe bound here: first failure at 0.848 of it" in output
                   and "with omega_c dt <= 0.8 it is one" in output)
        before = [file.read_bytes() for file in maps(case)]
        for file in maps(case):
            file.unlink()
        case.run("fpmStability", "-threads", "1")
        marks.true("the same again on one thread", before == [f.read_bytes() for f in maps(case)])
    with CaseRun("tutorials/bar", binaries) as case:
        (case.root / "system/stabilityDict").write_text(OWN)
        case.mesh()
        output = case.run("fpmStability")
        # Without contact: 0.9 of the bound from elements.
        marks.true("the case is marked on its map, with its margin",
                   "this case: timeStepFactor 0.9, speed 1: stable; the step that is predicted to "
                   "be stable is 1, 1.11 times as far; the first failure beside it is at" in output
                   and ">this case<" in (maps(case)[0].with_suffix(".svg")).read_text())
