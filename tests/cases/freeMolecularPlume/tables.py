# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Tables and VTK files of one time of freeMolecularPlume: tables.py FOLDER"""

import math
import re
import sys

import numpy as np

from caseTools import verdict
import csvTables

folder = sys.argv[1]


def table(name):
    return csvTables.table(f"{folder}/{name}.csv")


about = csvTables.summary(folder)

# Numbers of real particles: density times volume, against what was emitted
t = table("map")
dx, dr = 5e3, 5e3
volume = math.pi*dx*((t["r"] + dr/2)**2 - (t["r"] - dr/2)**2)
for group, emitted in ((1, 70e9), (2, 70e7), (0, 70e9 + 70e7)):
    some = t["group"] == group
    total = (t["numberDensity"]*volume)[some].sum()
    verdict(f"number_group{group}", abs(total/emitted - 1) < 1e-8,
            f"{total:.10g} particles in the map, {emitted:g} emitted (1e-8)")
    error = (t["numberDensityError"]*volume)[some]
    if group:
        n = t["testParticles"][some]
        binomial = np.sqrt(n*(1 - n/1e5))*emitted/1e5
        verdict(f"error_group{group}", np.allclose(error, binomial, 1e-6, 0),
                "binomial standard errors (1e-6)")
verdict("realParticles", about["realParticles"] == 70e9 + 70e7,
        f"{about['realParticles']:.12g}")
verdict("insideMap", about["testParticlesInside_map"] == 200000,
        f"{about['testParticlesInside_map']:g} test particles")

# Cells without a particle have no temperature, the others have one
empty = t["testParticles"] == 0
verdict("emptyCells", empty.any() and not empty.all()
        and np.array_equal(np.isnan(t["temperature"]), empty)
        and not t["numberDensity"][empty].any(),
        f"{empty.sum()} of {len(empty)} cells are empty and say so")
T = t["temperature"][~empty]
verdict("temperatures", ((T > 278.67) & (T <= 2200)).all(),
        f"{T.min():.2f} to {T.max():.2f} K")

# Both grids hold all particles: the same mean temperature
sums = []
for name in ("map", "shells"):
    data = table(name)
    some = (data["group"] == 1) & (data["testParticles"] > 0)
    n = data["testParticles"][some]
    sums.append((n*data["temperature"][some]).sum()/n.sum())
groups = table("groups")
verdict("meanTemperature", np.allclose(sums, groups["meanTemperature"][0],
                                       rtol=1e-8),
        f"{sums} and {groups['meanTemperature'][0]} K")


def vtk(name):
    """Cell fields of a legacy binary VTK file, and its points."""
    with open(f"{folder}/{name}.vtk", "rb") as file:
        data = file.read()
    assert data.startswith(b"# vtk DataFile Version 3.0\n")
    size = [int(v) for v in re.search(
        rb"DIMENSIONS (\d+) (\d+) (\d+)", data).groups()]
    coordinates = {}
    for m in re.finditer(rb"([XYZ])_COORDINATES (\d+) double\n", data):
        coordinates[m[1].decode()] = np.frombuffer(
            data, ">f8", int(m[2]), m.end())
    m = re.search(rb"POINTS (\d+) double\n", data)
    if m:
        coordinates["points"] = np.frombuffer(
            data, ">f8", 3*int(m[1]), m.end()).reshape(-1, 3)
    m = re.search(rb"CELL_DATA (\d+)\nFIELD plume (\d+)\n", data)
    cells, fields, at, found = int(m[1]), int(m[2]), m.end(), {}
    for _ in range(fields):
        m = re.compile(rb"(\w+) 1 (\d+) double\n").match(data, at)
        found[m[1].decode()] = np.frombuffer(data, ">f8", cells, m.end())
        at = m.end() + 8*cells + 1
    assert at == len(data)
    return size, coordinates, found


for name in ("axis", "map", "plane", "shells"):
    data = table(name)
    size, coordinates, fields = vtk(name)
    cells = int(np.prod([max(n - 1, 1) for n in size]))
    good = len(fields) == 15
    for group, tag in ((0, "all"), (1, "group1"), (2, "group2")):
        some = data["group"] == group
        for what in ("numberDensity", "temperature", "testParticles"):
            good = good and some.sum() == cells and np.allclose(
                fields[f"{what}_{tag}"], data[what][some], rtol=1e-8,
                atol=0, equal_nan=True)
    if "points" in coordinates:
        radius = np.linalg.norm(coordinates["points"], axis=1)
        good = good and len(radius) == np.prod(size) \
            and abs(radius.max() - 120e3) < 1e-6
    else:
        x = coordinates["X"]
        good = good and np.allclose(np.unique(data["x"]),
                                    0.5*(x[1:] + x[:-1]))
    verdict(f"vtk_{name}", good, "fields and places as in the table")
