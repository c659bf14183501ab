# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Free flight of the spin-carrying cloud through a mesh of cubes that are halved
in a part of it, where a side of a cell is several faces in one plane; stands in
a temporary folder."""

import numpy as np

from caseTools import (SNAPPY_CONTROLS, box, copy_case, decompose, must,
                       read_field, solve, times_of, verdict, write_block,
                       write_case, write_field, write_foam)
from foamFiles import positions

CLOUD = """
type spinningKinematicCloud;
solution
{
    active yes; coupled no; transient yes; cellValueSourceCorrection off;
    maxCo 0.3;
    motion { type embeddedRK54; tolerance 1e-6; }
    interpolationSchemes
    { rho SCHEME; U SCHEME; T SCHEME; thermo:mu SCHEME; }
    integrationSchemes { U Euler; }
}
constantProperties { rho0 2500; }
subModels
{
    particleForces {}
    injectionModels
    {
        rake
        {
            type rakeInjection; start (0.005 0.003 0.004);
            end (0.005 0.057 0.043); nParcels 500; diameter 1e-5;
            U0 (500 -20 90);
        }
    }
    patchInteractionModel standardWallInteraction;
    standardWallInteractionCoeffs { type escape; }
    dispersionModel none; stochasticCollisionModel none;
    surfaceFilmModel none;
}
cloudFunctions {}
"""
CLOUDS = {"linear": "cellLinear", "point": "cellPoint"}
END = 1.4e-4

case = "refined"
write_case(case, {"endTime": END, "deltaT": END/7, "writeInterval": END,
                  "writeFormat": "ascii", "writePrecision": 16,
                  "libs": "(spinningParcel parcelInjection)"},
           {"mode": "frozen"})
sides = {side: "patch" for side in ("xMin", "xMax", "yMin", "yMax", "zMin",
                                    "zMax")}
write_block(case, box((0.08, 0.06, 0.06)), (8, 6, 6), sides)
write_foam(case, "system/snappyHexMeshDict", """
castellatedMesh true; snap false; addLayers false;
geometry
{
    half { type searchableBox; min (0.03 0 0); max (0.06 0.06 0.031); }
    ball { type searchableSphere; centre (0.045 0.03 0.04); radius 0.012; }
}
castellatedMeshControls
{
    maxLocalCells 100000; maxGlobalCells 100000; minRefinementCells 0;
    nCellsBetweenLevels 1; features (); resolveFeatureAngle 30;
    refinementSurfaces {}
    refinementRegions
    {
        half { mode inside; levels ((1 1)); }
        ball { mode inside; levels ((1 2)); }
    }
    locationInMesh (0.0011 0.0012 0.0013); allowFreeStandingZoneFaces true;
}
""" + SNAPPY_CONTROLS)
must(case, "blockMesh")
must(case, "snappyHexMesh", "-overwrite")
fields = {side: "type zeroGradient;" for side in sides}
for name, value in ("p", 3e4), ("T", 250.0), ("U", (0.0, 0.0, 0.0)):
    write_field(case, name, value, fields)
for name, scheme in CLOUDS.items():
    write_foam(case, f"constant/{name}Properties",
               CLOUD.replace("SCHEME", scheme))
write_foam(case, "constant/parcelClouds", f"clouds ({' '.join(CLOUDS)});")

start, last = np.array([5e-3, 3e-3, 4e-3]), np.array([5e-3, 0.057, 0.043])
there = (start + (last - start)*np.arange(500)[:, None]/499
         + END*np.array([500., -20., 90.]))
inside = ((there > 0) & (there < [0.08, 0.06, 0.06])).all(axis=1)


def check(case, run):
    for name in CLOUDS:
        folder = f"{case}/{times_of(case)[-1]}/lagrangian/{name}"
        ids, x = read_field(f"{folder}/origId"), positions(folder)[0]
        error = (np.abs(x - there[ids]).max() if len(ids) == inside.sum()
                 else np.inf)
        verdict(f"refined_{name}_{run}", error < 1e-12,
                f"{len(ids)} parcels of {inside.sum()} fly straight within"
                f" {error:.1e} m, bound 1e-12")


ranks = copy_case(case, "refinedRanks")
solve(case)
check(case, "serial")
decompose(ranks, (2, 1, 1))
solve(ranks, 2)
must(ranks, "reconstructPar", "-latestTime")
check(ranks, "two_ranks")
