"""The four applications one after the other, and what stops them."""

import os
import subprocess

from driver.caseRun import PROJECT, CaseRun


def small(binaries, source="tutorials/plateImpact"):
    """The plate with few cells and a few microseconds."""
    case = CaseRun(source, binaries)
    case.replace("system/meshDict", r"cells +\(50 50 1\)", "cells (12 12 1)")
    case.replace("system/meshDict", r"axial +20", "axial 8")
    case.replace("system/controlDict", r"^endTime .*;", "endTime 4e-6;")
    case.replace("system/controlDict", r"^writeInterval .*;", "writeInterval 2e-6;")
    case.replace("system/probeDict", r"times +\(1.5e-4 2.5e-4 3.5e-4\)", "times (2e-6 4e-6)", 3)
    return case


def allrun(case):
    """The case's own Allrun with the applications under test."""
    root = case.root / "project"
    root.mkdir()
    (root / "bin").symlink_to(case.binaries)
    (root / "etc").symlink_to(PROJECT / "etc")
    return subprocess.run([case.root / "Allrun"], env={**os.environ, "FPM_ROOT": str(root)},
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=600)


def complete(binaries, marks):
    """Allrun from the mesh to the pictures: files, status, performance record."""
    with small(binaries) as case:
        done = allrun(case)
        marks.true("Allrun succeeds", done.returncode == 0)
        if done.returncode != 0:
            marks.failures.append(done.stdout)
            return
        status = case.status()
        marks.true("status finished at 4e-06", status["state"] == "finished"
                   and float(status["time"]) == 4e-6 and int(status["steps"]) > 10)
        frames = [case.root / time / "fields.vtkhdf" for time in ("0", "2e-06", "4e-06")]
        marks.true("frames 0, 2e-06, 4e-06", all(frame.exists() for frame in frames))
        pictures = [p.name for p in (case.root / "postProcessing/pictures").iterdir()]
        plots = [p.name for p in (case.root / "postProcessing/plots").iterdir()]
        marks.true(f"{len(plots)} plots, {len(pictures)} pictures", plots and pictures)
        performance = case.performance()
        wanted = {"elements", "nodes", "contactors", "steps", "wallSeconds", "nsPerElementStep",
                  "contactShare", "searches", "backend", "precision", "description", "deviceBytes",
                  "nsPerContactorStep", "bytesPerElementStep", "algorithm", "checksum"}
        marks.true("keys of the performance record", wanted <= performance.keys())
        marks.true("elements of the performance record", performance["elements"] == 3 * 144 + 12 * 8)
        pairs = sorted(p.stem for p in (case.root / "postProcessing/contactForces/0").iterdir())
        marks.true("a history for each pair", pairs == ["layer2Layer1", "layer3Layer2", "rodLayer"])


def withoutSetContact(binaries, marks):
    """fpmMesh && fpmExplicit: the solver makes the missing surfaces itself and says so."""
    with small(binaries) as case, small(binaries) as other:
        case.run("fpmMesh")
        output = case.run("fpmExplicit", "-backend", "serial")
        marks.true("it says that surfaces are missing", "contact surfaces are missing" in output)
        other.mesh()
        full = other.run("fpmExplicit", "-backend", "serial")
        marks.true("it is silent where they are there", "surfaces are missing" not in full)
        marks.true("same bits", CaseRun.checksum(output) == CaseRun.checksum(full))
        again = case.run("fpmExplicit", "-backend", "serial")
        marks.true("they are kept", "surfaces are missing" not in again)


def damaged(binaries, marks):
    """What is broken stops the pipeline with a status of its own, and nothing after it runs."""
    with small(binaries) as case:
        case.replace("system/meshDict", r"axis +z;", "axis z")
        done = allrun(case)
        marks.true(f"meshDict without semicolon: status {done.returncode}", done.returncode == 3)
        marks.true("no solver log", not (case.root / "log.fpmExplicit").exists())
    with small(binaries) as case:
        case.replace("constant/partProperties", r"density +7.85e-9;", "density -1;")
        done = allrun(case)
        marks.true(f"negative density: status {done.returncode}", done.returncode == 3)
        marks.true("nothing probed", not (case.root / "log.fpmProbe").exists())
    with small(binaries) as case:
        case.mesh()
        mesh = case.root / "constant/mesh.vtkhdf"
        mesh.write_bytes(mesh.read_bytes()[: mesh.stat().st_size // 2])
        done = case.start("fpmExplicit")
        marks.true(f"half a mesh file: status {done.returncode}", done.returncode in (4, 6))
    with small(binaries) as case:
        case.replace("system/controlDict", r"safety 0.9; contactLimit 0.8;", "fixed 2e-6;")
        case.mesh()
        done = case.start("fpmExplicit", "-backend", "serial")
        marks.true(f"a step far too long: status {done.returncode}", done.returncode == 10)
        marks.true("status failed", case.status()["state"] == "failed")
        marks.true("why.txt", (case.root / "why.txt").stat().st_size > 20)
