"""Molecules that do not collide, against their exact positions: through a
regular mesh, one with warped and concave cells, and one shared by two ranks;
cyclic in x, between specular walls in y and symmetry planes in z."""

import os
import re

import numpy as np

from caseTools import decompose, edit, must, times_of, verdict
from dsmcTools import NITROGEN, read_molecules, solve, write_gas

TYPES = {"xMin": "cyclic", "xMax": "cyclic", "yMin": "wall", "yMax": "wall",
         "zMin": "symmetryPlane", "zMax": "symmetryPlane"}
LENGTHS = np.array([0.1, 0.08, 0.06])
CELLS = (10, 8, 6)
STEPS, DT = 40, 2e-5


def warp(case):
    """Move the points of half the inside at random."""
    path = os.path.join(case, "constant/polyMesh/points")
    with open(path) as file:
        text = file.read()
    head = re.search(r"\n(\d+)\n\(\n", text)
    n = int(head.group(1))
    tail = text.index("\n)", head.end())
    points = np.array(re.sub("[()]", " ", text[head.end():tail]).split(),
                      float).reshape(n, 3)
    inside = np.all((points > 1e-6) & (points < LENGTHS - 1e-6), axis=1)
    inside &= points[:, 0] < 0.055
    rng = np.random.default_rng(5)
    points[inside] += rng.uniform(-0.0025, 0.0025, (inside.sum(), 3))
    with open(path, "w") as file:
        file.write(text[:head.end()] + "\n".join(
            "(%.17g %.17g %.17g)" % tuple(p) for p in points) + text[tail:])


def exact(x, u, t):
    """Positions and velocities at a time."""
    end = x + u*t
    v = u.copy()
    end[:, 0] %= LENGTHS[0]
    for d in (1, 2):
        phase = end[:, d] % (2*LENGTHS[d])
        back = phase > LENGTHS[d]
        end[:, d] = np.where(back, 2*LENGTHS[d] - phase, phase)
        v[:, d] = np.where(back, -v[:, d], v[:, d])
    return end, v


def ordered(case, time):
    """Molecules in the order of their internal energy, which is unique."""
    x, cell, fields = read_molecules(case, time)
    order = np.argsort(fields["Ei"])
    return x[order], cell[order], fields["U"][order], fields["Ei"][order]


for name, warped, ranks in (("regular", False, 1), ("warped", True, 1),
                            ("twoRanks", True, 2)):
    write_gas(name, TYPES, CELLS, LENGTHS, weight=6e12, density=5e19,
              gas={"N2": NITROGEN}, collisions="none",
              wall="SpecularReflection", initialise=False,
              control={"deltaT": DT, "endTime": STEPS*DT,
                       "writeFormat": "ascii"})
    if warped:
        warp(name)
    edit(name, "system/controlDict", "ascii", "binary")
    must(name, "dsmcInitialise")
    if ranks > 1:
        decompose(name, (2, 1, 1))
    log = solve(name, ranks)
    if ranks > 1:
        must(name, "reconstructPar")
    end = times_of(name)[-1]

    x0, _, u0, e0 = ordered(name, "0")
    x1, cell, u1, e1 = ordered(name, end)
    split = re.search(r"cells, (\d+) of them", log)
    if not verdict(f"{name}_keepsAllMolecules",
                   len(e0) == len(e1) and np.array_equal(e0, e1)
                   and " 0 lost" in log,
                   f"{len(e0)} before, {len(e1)} after"):
        continue
    there, turned = exact(x0, u0, STEPS*DT)
    error = np.abs(x1 - there)
    error[:, 0] = np.minimum(error[:, 0], LENGTHS[0] - error[:, 0])
    verdict(f"{name}_positions", error.max() < 1e-12,
            f"largest error {error.max():.1e} m after up to"
            f" {np.abs(u0).max()*STEPS*DT/0.01:.0f} cells,"
            f" {split.group(1) if split else 0} cells split")
    verdict(f"{name}_velocities", np.abs(u1 - turned).max() < 1e-9,
            f"largest error {np.abs(u1 - turned).max():.1e} m/s")
    if not warped:
        i = np.minimum((x1/0.01).astype(int), np.array(CELLS) - 1)
        where = i[:, 0] + CELLS[0]*(i[:, 1] + CELLS[1]*i[:, 2])
        # Round-off may put one on a face into either cell
        wrong = np.count_nonzero(where != cell)
        verdict(f"{name}_cells", wrong == 0, f"{wrong} in a wrong cell")
    else:
        verdict(f"{name}_splitsAndSays",
                split is not None and 100 < int(split.group(1)) < 480,
                f"split: {split.group(1) if split else 'nothing'}")
