# SPDX-License-Identifier: BSL-1.0
"""Opens a series of riprap's in VTK, by the reader that ParaView uses, and compares all of it with
the numbers that the simulation wrote beside it: read_series.py FOLDER"""

import sys
import xml.etree.ElementTree as xml
from pathlib import Path

from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

PARTICLE = ["id", "parent", "root", "generation", "material", "motion", "velocity", "spin",
            "s11", "s22", "s12", "rattler", "rat", "volumetric_strain", "deviatoric_strain", "rotation",
            "cg_s11", "cg_s22", "cg_s12"]
CONTACT = ["a", "b", "normal_force", "tangential_force", "depth"]


def check(holds, what):
    if not holds:
        sys.exit(f"read_series.py: {what}")


def expected_states(path):
    states = []
    for line in path.read_text().splitlines():
        kind, *numbers = line.split()
        numbers = [float(number) for number in numbers]
        if kind == "state":
            states.append({"time": numbers[0], "particle": [], "ring": [], "contact": []})
        else:
            states[-1][kind].append(numbers)
    return states


def collection(path):
    """Times and files of a .pvd."""
    root = xml.parse(path).getroot()
    check(root.tag == "VTKFile" and root.get("type") == "Collection", f"{path}: no collection")
    sets = root.findall("./Collection/DataSet")
    return [float(s.get("timestep")) for s in sets], [path.parent / s.get("file") for s in sets]


def read(path):
    reader = vtkXMLPolyDataReader()
    check(reader.CanReadFile(str(path)), f"{path}: VTK cannot read it")
    reader.SetFileName(str(path))
    reader.Update()
    check(reader.GetErrorCode() == 0, f"{path}: VTK reports error {reader.GetErrorCode()}")
    return reader.GetOutput()


def check_values(path, data, names, rows):
    """Every array of the cells, number by number, without tolerance."""
    cells = data.GetCellData()
    found = [cells.GetArrayName(k) for k in range(cells.GetNumberOfArrays())]
    check(found == names, f"{path}: arrays {found}")
    column = 0
    for name in names:
        array = cells.GetArray(name)
        count = array.GetNumberOfComponents()
        check(array.GetNumberOfTuples() == len(rows), f"{path}: {name} has another length")
        for k, row in enumerate(rows):
            value = list(array.GetTuple(k))
            check(value == row[column:column + count], f"{path}: {name} of cell {k} is {value}")
        for c in range(count if rows else 0):
            values = [row[column + c] for row in rows]
            check(array.GetRange(c) == (min(values), max(values)), f"{path}: range of {name}")
        column += count
    return column


def points_of(data, k):
    points = data.GetCell(k).GetPoints()
    return [points.GetPoint(i) for i in range(points.GetNumberOfPoints())]


def area_and_centroid(ring):
    twice = x = y = 0.0
    for p, q in zip(ring, ring[1:] + ring[:1]):
        # From the first vertex, for the round-off of far places.
        p, q = [(v[0] - ring[0][0], v[1] - ring[0][1]) for v in (p, q)]
        cross = p[0] * q[1] - p[1] * q[0]
        twice += cross
        x += cross * (p[0] + q[0])
        y += cross * (p[1] + q[1])
    return 0.5 * twice, (ring[0][0] + x / (3 * twice), ring[0][1] + y / (3 * twice))


def near(point, x, y):
    # Round-off of coordinates of some 0.1 m, millionths of a particle away from mattering.
    return abs(point[0] - x) < 1e-14 and abs(point[1] - y) < 1e-14


def check_particles(path, state):
    rows, rings = state["particle"], state["ring"]
    data = read(path)
    check(data.GetNumberOfPolys() == len(rows) == data.GetNumberOfCells(), f"{path}: cells")
    column = check_values(path, data, PARTICLE, rows)
    check(data.GetNumberOfPoints() == sum(len(ring) // 2 for ring in rings), f"{path}: points")
    for k, row in enumerate(rows):
        area, x, y = row[column:]
        ring = points_of(data, k)
        expected = [(*xy, 0.0) for xy in zip(rings[k][::2], rings[k][1::2])]
        check(ring == expected, f"{path}: vertices of polygon {k}")
        measured, centroid = area_and_centroid(ring)
        check(abs(measured - area) < 1e-11 * area, f"{path}: area {measured} of polygon {k}")
        check(near(centroid, x, y), f"{path}: centroid {centroid} of polygon {k}")


def check_contacts(path, state):
    rows = state["contact"]
    data = read(path)
    check(data.GetNumberOfLines() == len(rows) == data.GetNumberOfCells(), f"{path}: cells")
    check(data.GetNumberOfPoints() == 3 * len(rows), f"{path}: points")
    column = check_values(path, data, CONTACT, rows)
    for k, row in enumerate(rows):
        line = points_of(data, k)
        check(near(line[0], *row[column:column + 2]), f"{path}: begin of line {k}")
        check(near(line[2], *row[column + 2:]), f"{path}: end of line {k}")


def main(folder):
    states = expected_states(folder / "expected.txt")
    check(len(states) == 3, "three states are expected")
    for kind, check_file in ("particles", check_particles), ("contacts", check_contacts):
        times, files = collection(folder / f"{kind}.pvd")
        check(times == [state["time"] for state in states], f"times {times}")
        for file, state in zip(files, states):
            check_file(file, state)
    check(any(row[3] > 0 for row in states[-1]["particle"]), "nothing has broken")
    check(len(states[-1]["contact"]) > 50, "few contacts")
    print(f"{len(states)} states, {len(states[-1]['particle'])} particles and "
          f"{len(states[-1]['contact'])} contacts in the last")


if __name__ == "__main__":
    main(Path(sys.argv[1]))
