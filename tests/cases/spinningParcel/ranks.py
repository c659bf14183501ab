# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Impacts of the spin-carrying cloud on one, two and four ranks, on meshes of
hexahedra, tetrahedra and polyhedra, and of hexahedra beside smaller ones whose
faces are warped; stands in a temporary folder."""

import csv
import glob
import itertools
import os

import numpy as np

from caseTools import (box, copy_case, decompose, must, read_field,
                       read_points, solve, verdict, write_block, write_case,
                       write_field, write_foam, write_points)

LENGTH = np.array([0.02, 0.01, 0.01])
N = (10, 5, 5)

CLOUD = """
type spinningKinematicCloud;
solution
{
    active yes; coupled no; transient yes; cellValueSourceCorrection off;
    motion { type embeddedRK54; tolerance 1e-6; }
    interpolationSchemes
    { rho SCHEME; U SCHEME; T SCHEME; thermo:mu SCHEME; }
    integrationSchemes { U Euler; }
}
constantProperties { rho0 2500; omega0 (0 0 2e6); }
subModels
{
    particleForces { hendersonDrag; magnus; }
    injectionModels
    {
        rake
        {
            type rakeInjection; start (0.0011 0.0013 0.0017);
            end (0.0093 0.0083 0.0079); nParcels 300; diameter 8e-6;
            U0 (300 60 90);
        }
    }
    patchInteractionModel standardWallInteraction;
    standardWallInteractionCoeffs { type rebound; e 0.8; mu 0.1; }
    dispersionModel none; stochasticCollisionModel none;
    surfaceFilmModel none;
}
cloudFunctions { impacts { type impactRecords; patches (".*"); } }
"""


def write_tetrahedra(case):
    """Six tetrahedra for each block of a box, its inner points displaced."""
    n = np.array(N) + 1
    points = np.stack(np.meshgrid(*(np.arange(k) for k in n),
                                  indexing="ij"), axis=-1).reshape(-1, 3)
    inner = np.all((points > 0) & (points < n - 1), axis=1)
    random = np.random.default_rng(1)
    at = points/(n - 1)*LENGTH
    at[inner] += random.uniform(-0.2, 0.2, (inner.sum(), 3))*0.002

    def index(p):
        return (p[0]*n[1] + p[1])*n[2] + p[2]

    cells = []
    for corner in np.ndindex(*N):
        for order in itertools.permutations(range(3)):
            p = np.array(corner)
            tet = [index(p)]
            for d in order:
                p[d] += 1
                tet.append(index(p))
            cells.append(tet)

    # Faces with the cells on both sides; outward of the first
    faces = {}
    for i, tet in enumerate(cells):
        for k in range(4):
            f = [v for j, v in enumerate(tet) if j != k]
            normal = np.cross(at[f[1]] - at[f[0]], at[f[2]] - at[f[0]])
            if normal @ (at[f[0]] - at[tet[k]]) < 0:
                f[1], f[2] = f[2], f[1]
            faces.setdefault(tuple(sorted(f)), []).append((i, f))
    inside = sorted((a[0], b[0], a[1]) for a, b in
                    (v for v in faces.values() if len(v) == 2))
    outside = [v[0] for v in faces.values() if len(v) == 1]
    folder = "constant/polyMesh"
    write_foam(case, f"{folder}/points", f"{len(at)}\n(\n" + "\n".join(
        "(%.17g %.17g %.17g)" % tuple(x) for x in at) + "\n)", "vectorField")
    everything = [f for _, _, f in inside] + [f for _, f in outside]
    write_foam(case, f"{folder}/faces", f"{len(everything)}\n(\n" + "\n".join(
        "3(%d %d %d)" % tuple(f) for f in everything) + "\n)", "faceList")
    for name, values in (
            ("owner", [a for a, _, _ in inside] + [a for a, _ in outside]),
            ("neighbour", [b for _, b, _ in inside])):
        write_foam(case, f"{folder}/{name}", f"{len(values)}\n(\n"
                   + "\n".join(map(str, values)) + "\n)", "labelList")
    write_foam(case, f"{folder}/boundary", "1 ( walls { type wall; nFaces"
               f" {len(outside)}; startFace {len(inside)}; }} )",
               "polyBoundaryMesh")


def refine_and_warp(case):
    """Halve some cells of a block and displace its inner points: faces of the
    others have up to eight points, and some have a base point for their
    tetrahedra that is not the first. Turned about z by a half, as decomposePar
    turns faces round whose owner comes to the higher rank."""
    random = np.random.default_rng(2)
    some = np.nonzero(random.uniform(size=np.prod(N)) < 0.3)[0]
    write_foam(case, "system/topoSetDict", "actions ( { name some; type"
               " cellSet; action new; source labelToCell; value ("
               + " ".join(map(str, some)) + "); } );")
    must(case, "topoSet")
    must(case, "refineHexMesh", "some", "-overwrite")
    points = read_points(case)
    inner = np.all((points > 1e-9) & (points < LENGTH - 1e-9), axis=1)
    points[inner] += 1.5e-4*random.uniform(-1, 1, points.shape)[inner]
    points[:, :2] = LENGTH[:2] - points[:, :2]
    write_points(case, points)


def make(case, scheme):
    write_case(case, {"endTime": 1e-4, "deltaT": 2e-6, "writeInterval": 1e-4,
                      "writeFormat": "ascii", "writePrecision": 17,
                      "libs": "(spinningParcel parcelInjection"
                      " parcelWallInteraction)"}, {"mode": "frozen"})
    kind = case.split("_")[0]
    if kind in ("hexahedra", "refined"):
        write_block(case, box(LENGTH), N, {
            side + end: "wall" for side in "xyz" for end in ("Min", "Max")})
        must(case, "blockMesh")
        if kind == "refined":
            refine_and_warp(case)
    else:
        write_tetrahedra(case)
    if kind == "polyhedra":
        must(case, "polyDualMesh", "75", "-overwrite")
    must(case, "postProcess", "-func", "writeCellCentres", "-constant")
    x, y, z = read_field(os.path.join(case, "constant/C")).T/LENGTH[:, None]
    walls = {"\".*\"": "type zeroGradient;"}
    write_field(case, "p", 3e4*(1 + 0.3*x*y), walls)
    write_field(case, "T", 250 + 100*x*x, walls)
    write_field(case, "U", np.stack([
        300 - 200*x*x, 90*np.sin(np.pi*y)*np.cos(5*x),
        60*np.sin(np.pi*z)*(1 - y)], axis=-1),
        {"\".*\"": "type slip;"})
    write_foam(case, "constant/parcelClouds", "clouds (sand);")
    write_foam(case, "constant/sandProperties",
               CLOUD.replace("SCHEME", scheme))


def impacts(case):
    rows = []
    for name in glob.glob(f"{case}/postProcessing/impacts/sand/*/*.csv"):
        with open(name) as file:
            rows += list(csv.DictReader(file))
    keys = ("time", "x", "y", "z", "Ux", "Uy", "Uz")
    return sorted(((int(r["origId"]), *(float(r[k]) for k in keys))
                   for r in rows))


for kind in ("hexahedra", "tetrahedra", "polyhedra", "refined"):
    for scheme in ("cellLinear", "cellPoint"):
        case = f"{kind}_{scheme}"
        make(case, scheme)
        several = {2: (2, 1, 1), 4: (2, 2, 1)}
        for n, parts in several.items():
            decompose(copy_case(case, f"{case}_{n}"), parts)
        solve(case)
        one = impacts(case)
        for n in several:
            solve(f"{case}_{n}", n)
            other = impacts(f"{case}_{n}")
            same = [a[0] for a in one] == [a[0] for a in other]
            scale = np.array([1e-4, *LENGTH, 300, 300, 300])
            worst = (np.abs(np.subtract(one, other)[:, 1:]/scale).max()
                     if same and one else np.inf)
            verdict(f"{case}_{n}_ranks", len(one) > 100 and worst < 1e-10,
                    f"{len(one)} impacts, {len(other)} on {n} ranks, largest"
                    f" difference {worst:.1e}, tolerance 1e-10")
