# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""An octant of a sphere in supersonic flow on a mesh of snappyHexMesh: cubes
cut in eight towards the body, whose steps the shock crosses as it likes."""

import re

import numpy as np
from bluntBody import P, RADIUS, SOUND, T
from caseTools import (R_GAS, SNAPPY_CONTROLS, last_fields, must, solve,
                       verdict, write_case, write_field, write_foam)
from tetrahedra import stagnation

SPHERE = f"type searchableSphere; centre (0 0 0); radius {RADIUS!r};"
NOSE = (f"type searchableSphere; centre ({-1.1*RADIUS!r} 0 0);"
        f" radius {0.55*RADIUS!r};")


def octant(case, n, outer):
    """Cubes of a box of outer radii, n along each side, halved at the body
    and halved twice around the nose."""
    a = outer*RADIUS
    corners = [(x, y, z) for z in (0, a)
               for x, y in ((-a, 0), (0, 0), (0, a), (-a, a))]
    write_foam(
        case, "system/blockMeshDict",
        "scale 1;\nvertices ("
        + " ".join(f"({x!r} {y!r} {z!r})" for x, y, z in corners)
        + f");\nblocks (hex (0 1 2 3 4 5 6 7) ({n} {n} {n})"
        " simpleGrading (1 1 1));\nedges ();\nboundary\n(\n"
        "inlet { type patch; faces ((0 4 7 3) (3 7 6 2) (4 5 6 7)); }\n"
        "outlet { type patch; faces ((1 2 6 5)); }\n"
        "sideY { type symmetryPlane; faces ((0 1 5 4)); }\n"
        "sideZ { type symmetryPlane; faces ((0 3 2 1)); }\n);")
    write_foam(case, "system/snappyHexMeshDict", f"""
castellatedMesh true; snap true; addLayers false;
geometry {{ body {{ {SPHERE} }} nose {{ {NOSE} }} }}
castellatedMeshControls
{{
    maxLocalCells 1000000; maxGlobalCells 2000000; minRefinementCells 0;
    nCellsBetweenLevels 2; features (); resolveFeatureAngle 30;
    refinementSurfaces {{ body {{ level (1 1); }} }}
    refinementRegions {{ nose {{ mode inside; levels ((1 2)); }} }}
    locationInMesh ({-0.93*a!r} {0.91*a!r} {0.92*a!r});
    allowFreeStandingZoneFaces true;
}}
""" + SNAPPY_CONTROLS)
    must(case, "blockMesh")
    must(case, "snappyHexMesh", "-overwrite")


def fields(case, M):
    for name, value in ("p", P), ("T", T), ("U", (M*SOUND, 0, 0)):
        write_field(case, name, value, {
            "inlet": "type fixedValue; value $internalField;",
            "outlet": "type zeroGradient;",
            "sideY": "type symmetryPlane;",
            "sideZ": "type symmetryPlane;",
            "body": "type slip;" if name == "U" else "type zeroGradient;"})


def main():
    M = 6
    case = "hexDominant"
    write_case(case, {"endTime": 1, "deltaT": 1, "writeInterval": 1,
                      "functions": "{ balance { type div; field phi;"
                      " libs (fieldFunctionObjects);"
                      " writeControl writeTime; } }"},
               {"mode": "steady", "residual": 1e-8}, "HLLC", "vanAlbada")
    octant(case, 14, 1.7)
    fields(case, M)
    text = solve(case)
    steady = re.search(r"Gas: steady after (\d+) iterations, imbalance of .*",
                       text)
    verdict(case + "_steady", steady is not None,
            steady[0] if steady else "does not say that it is steady")
    # (362 where Newton's linear equations were not solved, 149 since)
    verdict(case + "_newton_ends_it", steady and int(steady[1]) < 250,
            "bound 250 iterations")
    # What flows through faces that the gas numbers and turns as it likes
    divergence = np.abs(last_fields(case, "div(phi)")[0]).max()
    scale = P/(R_GAS*T)*M*SOUND/(1.7*RADIUS/14)
    verdict(case + "_mass_fluxes", divergence < 1e-5*scale,
            f"largest divergence {divergence/scale:.1e} of what flows through "
            "a cube, bound 1e-5")
    p0, least, most, count = stagnation(case, M)
    verdict(case + "_stagnation_pressure", abs(p0) < 0.01,
            f"total pressure {100*p0:+.2f} % in {count} cells at the nose")
    verdict(case + "_total_temperature", -0.03 < least and most < 0.03,
            f"{100*least:+.2f} to {100*most:+.2f} %")
    told = re.search(r"total pressure is (\S+) % (below|above)", text)
    verdict(case + "_nose", not told, f"warns of {told[1]} % of total pressure"
            if told else "does not warn of lost total pressure")


if __name__ == "__main__":
    main()
