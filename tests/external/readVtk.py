#!/usr/bin/env python3
"""Opens our result files with VTK's own reader and compares what it finds.

usage: readVtk.py <program writeVtkExample> <work folder>

VTK comes from the package index, into a throw-away virtual environment in the work folder. Where it
cannot be had, the test is skipped (exit code 77).
"""

import json
import os
import shutil
import subprocess
import sys

skipped = 77


def pythonWithVtk(folder):
    """Path of a Python that has vtk >= 9.4; None where it cannot be installed."""
    environment = os.path.join(folder, "venv")
    python = os.path.join(environment, "bin", "python")
    importVtk = [python, "-c", "import vtkmodules.vtkIOHDF"]
    if os.path.exists(python) and subprocess.run(importVtk, capture_output=True).returncode == 0:
        return python
    shutil.rmtree(environment, ignore_errors=True)
    install = [python, "-m", "pip", "install", "--quiet", "--no-deps", "vtk>=9.4"]
    for command in [[sys.executable, "-m", "venv", environment], install, importVtk]:
        try:
            result = subprocess.run(command, capture_output=True, text=True, timeout=240)
        except (OSError, subprocess.TimeoutExpired) as error:
            print(error)
            return None
        if result.returncode != 0:
            print((result.stderr or result.stdout).strip()[-500:])
            return None
    return python


def readGrid(file):
    from vtkmodules.vtkIOHDF import vtkHDFReader

    reader = vtkHDFReader()
    assert reader.CanReadFile(file), f"VTK does not take {file} for one of its files"
    reader.SetFileName(file)
    reader.Update()
    # The reader reports a failure as an empty grid.
    return reader.GetOutput()


def near(found, expected, what):
    tolerance = 1e-6 * max(1, abs(expected))
    assert abs(found - expected) <= tolerance, f"{what}: {found}, not {expected}"


def checkGrid(grid, file):
    assert grid.GetNumberOfPoints() == 5 * 4 * 3 + 3 * 3 * 2, f"{file}: {grid.GetNumberOfPoints()}"
    assert grid.GetNumberOfCells() == 4 * 3 * 2 + 2 * 2, f"{file}: {grid.GetNumberOfCells()}"
    for cell in range(grid.GetNumberOfCells()):
        assert grid.GetCellType(cell) == 12, f"{file}: cell {cell} is no hexahedron"
    for found, expected in zip(grid.GetBounds(), [0, 4, 0, 3, 0, 3]):
        near(found, expected, f"{file}: bounds")


def checkIds(grid, file):
    """The numbers that messages use, integers, whatever else is in the file."""
    for data, name, count in [
        (grid.GetPointData(), "NodeId", grid.GetNumberOfPoints()),
        (grid.GetCellData(), "ElementId", grid.GetNumberOfCells()),
    ]:
        ids = data.GetArray(name)
        assert ids is not None, f"{file}: no {name}"
        assert ids.GetDataTypeAsString() in ["int", "vtktypeint32"], ids.GetDataTypeAsString()
        found = [ids.GetValue(i) for i in range(count)]
        assert found == list(range(count)), f"{file}: {name}: {found}"


def checkMesh(folder):
    file = os.path.join(folder, "constant", "mesh.vtkhdf")
    grid = readGrid(file)
    checkGrid(grid, file)
    checkIds(grid, file)
    parts = grid.GetCellData().GetArray("Part")
    patches = grid.GetCellData().GetArray("Patch")
    found = [parts.GetValue(cell) for cell in range(grid.GetNumberOfCells())]
    assert found == 24 * [0] + 4 * [1], f"parts: {found}"
    assert found == [patches.GetValue(cell) for cell in range(grid.GetNumberOfCells())]


def checkVolumes(grid, factor):
    """Volumes of the cells, whose numbering must be VTK's: positive and of the right sum."""
    from vtkmodules.vtkFiltersVerdict import vtkMeshQuality

    quality = vtkMeshQuality()
    quality.SetInputData(grid)
    quality.SetHexQualityMeasureToVolume()
    quality.Update()
    values = quality.GetOutput().GetCellData().GetArray("Quality")
    volumes = [values.GetValue(cell) for cell in range(grid.GetNumberOfCells())]
    assert min(volumes) > 0, "a cell is inside out"
    near(sum(volumes), 36 * factor, "volume")


def checkDeformed(grid, time):
    from vtkmodules.vtkFiltersGeneral import vtkWarpVector

    scale = 1e4 * time
    warp = vtkWarpVector()
    warp.SetInputData(grid)
    warp.SetInputArrayToProcess(0, 0, 0, 0, "U")
    warp.Update()
    deformed = warp.GetOutput()
    for point in range(grid.GetNumberOfPoints()):
        x, y, z = grid.GetPoint(point)
        expected = (x + scale * y, y - scale * x, z + scale * 0.5 * z)
        for found, one in zip(deformed.GetPoint(point), expected):
            near(found, one, f"deformed point {point}")
    checkVolumes(deformed, (1 + scale**2) * (1 + 0.5 * scale))


def checkFrame(folder, name, time):
    file = os.path.join(folder, name)
    grid = readGrid(file)
    checkGrid(grid, file)
    checkIds(grid, file)
    stress = grid.GetCellData().GetArray("S")
    strain = grid.GetCellData().GetArray("PEEQ")
    assert stress.GetNumberOfComponents() == 6 and strain.GetNumberOfComponents() == 1
    for cell in range(grid.GetNumberOfCells()):
        near(strain.GetValue(cell), time + cell, f"{file}: PEEQ of {cell}")
        for component, found in enumerate(stress.GetTuple(cell)):
            near(found, component + 1 + cell, f"{file}: S of {cell}")
    checkDeformed(grid, time)


def check(folder):
    checkMesh(folder)
    for ending in ["vtkhdf", "hdf"]:
        with open(os.path.join(folder, f"case.{ending}.series")) as stream:
            series = json.load(stream)
        assert series["file-series-version"] == "1.0"
        assert [entry["time"] for entry in series["files"]] == [0, 5e-5], series
        for entry in series["files"]:
            checkFrame(folder, entry["name"], entry["time"])
    from vtkmodules.vtkCommonCore import vtkVersion

    print(f"VTK {vtkVersion.GetVTKVersion()} reads mesh, fields and series")


def main():
    if sys.argv[1] == "--check":
        check(sys.argv[2])
        return 0
    program, folder = sys.argv[1:]
    os.makedirs(folder, exist_ok=True)
    case = os.path.join(folder, "case")
    shutil.rmtree(case, ignore_errors=True)
    subprocess.run([program, case], check=True)
    python = pythonWithVtk(folder)
    if python is None:
        print("SKIPPED: the package vtk >= 9.4 cannot be installed here")
        return skipped
    return subprocess.run([python, os.path.abspath(__file__), "--check", case]).returncode


if __name__ == "__main__":
    sys.exit(main())
