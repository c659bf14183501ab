# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Molecules that do not collide, against their exact positions: through a
regular mesh, one with warped and concave cells, one shared by two ranks, and a
flat one; cyclic in x, between specular walls in y and symmetry planes (or
empty patches) in z. Then through a sector with turned cyclic planes."""

import os
import re

import numpy as np

from caseTools import (decompose, edit, must, read_field, times_of, verdict,
                       write_block, write_foam)
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


def exact(x, u, t, flat):
    """Positions and velocities at a time."""
    end = x + u*t
    v = u.copy()
    end[:, 0] %= LENGTHS[0]
    if flat:
        end[:, 2] = x[:, 2]
    for d in (1,) if flat else (1, 2):
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


for name, warped, ranks, flat in (
        ("regular", False, 1, False), ("warped", True, 1, False),
        ("twoRanks", True, 2, False), ("flat", False, 1, True)):
    cells = CELLS[:2] + (1,) if flat else CELLS
    types = dict(TYPES, zMin="empty", zMax="empty") if flat else TYPES
    write_gas(name, types, cells, LENGTHS, weight=6e12, density=5e19,
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
    there, turned = exact(x0, u0, STEPS*DT, flat)
    error = np.abs(x1 - there)
    error[:, 0] = np.minimum(error[:, 0], LENGTHS[0] - error[:, 0])
    verdict(f"{name}_positions", error.max() < 1e-12,
            f"largest error {error.max():.1e} m after up to"
            f" {np.abs(u0).max()*STEPS*DT/0.01:.0f} cells,"
            f" {split.group(1) if split else 0} cells split")
    verdict(f"{name}_velocities", np.abs(u1 - turned).max() < 1e-9,
            f"largest error {np.abs(u1 - turned).max():.1e} m/s")
    if not warped:
        i = np.minimum((x1/0.01).astype(int), np.array(cells) - 1)
        where = i[:, 0] + cells[0]*(i[:, 1] + cells[1]*i[:, 2])
        # Round-off may put one on a face into either cell
        wrong = np.count_nonzero(where != cell)
        verdict(f"{name}_cells", wrong == 0, f"{wrong} in a wrong cell")
    else:
        verdict(f"{name}_splitsAndSays",
                split is not None and 100 < int(split.group(1)) < 480,
                f"split: {split.group(1) if split else 'nothing'}")

# A uniform gas has the same density in each warped cell, whose volume is that
# of its tetrahedra: that of its faces' centres is another one
write_gas("density", TYPES, CELLS, LENGTHS, weight=1.2e12, density=5e19,
          gas={"N2": NITROGEN}, collisions="none", wall="SpecularReflection",
          initialise=False, more="sampling { start 0; }\n",
          control={"deltaT": DT, "endTime": 60*DT, "writeFormat": "ascii"})
warp("density")
must("density", "dsmcInitialise")
must("density", "postProcess", "-func", "writeCellVolumes", "-time", "0")
solve("density")
end = times_of("density")[-1]
rho, count, V = (read_field(f"density/{f}") for f in (
    f"{end}/rhoNMean", f"{end}/dsmcRhoNMean", "0/V"))
off = 1.2e12*count/rho/V - 1
slope = (off*(rho/rho.mean() - 1)).sum()/(off**2).sum()
verdict("density_ofWarpedCells", off.std() > 0.01 and abs(slope) < 0.2,
        f"volumes differ by {off.std():.3f} r.m.s., densities by"
        f" {slope:.2f} of that")

# --- a sector of 90 degrees: the distance from the axis, the radial and the
#     axial velocity and the spin about the axis are those of the straight flight
types = {"xMin": "patch", "xMax": "patch", "yMin": "cyclic", "yMax": "cyclic",
         "zMin": "cyclic", "zMax": "cyclic"}
write_gas("sector", types, (8, 8, 4), LENGTHS, weight=6e11, density=5e19,
          gas={"N2": NITROGEN}, collisions="none", initialise=False,
          control={"deltaT": 1e-5, "endTime": 8e-5})
write_block("sector", [(x, y, z) for z in (0, 0.06) for x, y in (
    (0.02, 0), (0.1, 0), (0, 0.1), (0, 0.02))], (8, 8, 4), types)
turned = (" transform rotational; rotationAxis (0 0 1);"
          " rotationCentre (0 0 0);")
for side in ("yMin", "yMax"):
    edit("sector", "system/blockMeshDict", f"neighbourPatch {side};",
         f"neighbourPatch {side};{turned}")
must("sector", "blockMesh")
must("sector", "dsmcInitialise")
log = solve("sector")
x0, _, u0, e0 = ordered("sector", "0")
x1, _, u1, e1 = ordered("sector", times_of("sector")[-1])
stayed = np.isin(e0, e1)
x0, u0 = x0[stayed], u0[stayed]
there = x0 + 8e-5*u0


def invariants(x, u):
    return np.column_stack([
        np.hypot(x[:, 0], x[:, 1]),
        (x[:, 0]*u[:, 0] + x[:, 1]*u[:, 1])*1e-3,
        (x[:, 0]*u[:, 1] - x[:, 1]*u[:, 0])*1e-3, u[:, 2]*1e-3])


error = np.abs(invariants(x1, u1) - invariants(there, u0)).max()
crossed = np.count_nonzero((there[:, 0] < 0) | (there[:, 1] < 0))
verdict("sector_turns", error < 1e-12 and crossed > 300 and " 0 lost" in log
        and np.all(x1[:, :2] > -1e-12),
        f"largest error {error:.1e}, {crossed} of {len(x1)} were turned")

# --- a wedge of 10 degrees, its tip on the axis: distance from the axis, radial
#     and axial velocity and the size of the spin, after up to 18 mirrors
types = {"xMin": "patch", "xMax": "patch", "yMin": "patch", "yMax": "patch",
         "zMin": "wedge", "zMax": "wedge"}
write_gas("wedge", dict(types, zMin="patch", zMax="patch"), (8, 8, 1), LENGTHS, weight=1e11, density=5e19,
          gas={"N2": NITROGEN}, collisions="none", initialise=False,
          control={"deltaT": 1e-5, "endTime": 8e-5})
c, s = 0.1*np.cos(np.radians(5)), 0.1*np.sin(np.radians(5))
write_foam(
    "wedge", "system/blockMeshDict",
    f"vertices ((0 0 0) (0.1 0 0) (0.1 {c!r} {-s!r}) (0 {c!r} {-s!r})"
    f" (0.1 {c!r} {s!r}) (0 {c!r} {s!r}));\n"
    "blocks (hex (0 1 2 3 0 1 4 5) (8 8 1) simpleGrading (1 1 1));\n"
    "edges ();\nboundary (\n" + "\n".join(
        f"{side} {{ type {types[side]}; faces ({face}); }}"
        for side, face in (
            ("xMin", "(0 3 5 0)"), ("xMax", "(1 2 4 1)"), ("yMin", ""),
            ("yMax", "(3 5 4 2)"), ("zMin", "(0 1 2 3)"),
            ("zMax", "(0 1 4 5)"))) + "\n);")
must("wedge", "blockMesh")
for name in ("boundaryT", "boundaryU"):
    os.remove(f"wedge/0/{name}")
must("wedge", "dsmcInitialise")
log = solve("wedge")
x0, _, u0, e0 = ordered("wedge", "0")
x1, _, u1, e1 = ordered("wedge", times_of("wedge")[-1])
stayed = np.isin(e0, e1)
x0, u0 = x0[stayed], u0[stayed]
there = x0 + 8e-5*u0


def of_axis(x, u):
    return np.column_stack([
        x[:, 0], np.hypot(x[:, 1], x[:, 2]),
        (x[:, 1]*u[:, 1] + x[:, 2]*u[:, 2])*1e-3,
        np.abs(x[:, 1]*u[:, 2] - x[:, 2]*u[:, 1])*1e-3, u[:, 0]*1e-3])


error = np.abs(of_axis(x1, u1) - of_axis(there, u0)).max()
turned = np.degrees(np.arctan2(there[:, 2], there[:, 1]))
crossed = np.count_nonzero(np.abs(turned) > 15)
verdict("wedge_mirrors", error < 1e-12 and crossed > 300 and " 0 lost" in log
        and np.all(np.abs(x1[:, 2])
                   < x1[:, 1]*np.tan(np.radians(5)) + 1e-12),
        f"largest error {error:.1e}, {crossed} of {len(x1)} were mirrored"
        " twice or more")
