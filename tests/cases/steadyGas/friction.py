# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""A cold blunted wedge in viscous gas at Mach 4, on cells that its bow shock
crosses as it likes: the gas comes to rest, and the heat flux at the stagnation
line is that of the theory on each of three meshes. Stands in a folder of its
own."""

import re

import numpy as np
from bluntBody import CP, pitot
from caseTools import (GAMMA, R_GAS, must, read_field, run, times_of, verdict,
                       write_case, write_field, write_foam)

MACH, P, T, WALL = 4, 2000.0, 220.0, 300.0
RADIUS, ANGLE, FLANK = 0.05, np.radians(10), 0.04


def prepare(case, across, along, grading):
    """Layers between the nose with its flank and straight lines far out."""
    write_case(case, {"endTime": 1, "deltaT": 1, "writeInterval": 1,
                      "writeFormat": "ascii"},
               {"mode": "steady", "viscous": "yes"}, "HLLC", "vanAlbada")
    write_foam(case, "constant/turbulenceProperties",
               "simulationType laminar;")
    with open(f"{case}/system/controlDict", "a") as file:
        file.write("functions { heat { type wallHeatFlux; patches (body);"
                   " libs (fieldFunctionObjects); writeControl writeTime; } }")
    touch = RADIUS*np.array([1 - np.sin(ANGLE), np.cos(ANGLE)])
    end = touch + FLANK*np.array([np.cos(ANGLE), np.sin(ANGLE)])
    middle = 0.5*(np.pi/2 - ANGLE)
    corners = [(0, 0), touch, end, (-0.05, 0), (-0.02, 0.13), (0.075, 0.19)]
    points = [(*c, z) for z in (0, 0.005) for c in corners]
    arcs = [f"arc {i} {i + 1} ({RADIUS*(1 - np.cos(middle))!r}"
            f" {RADIUS*np.sin(middle)!r} {z})" for i, z in ((0, 0),
                                                           (6, 0.005))]

    def side(*pairs):
        return " ".join(f"({a} {b} {b + 6} {a + 6})" for a, b in pairs)

    blocks = " ".join(
        f"hex ({o} {i} {i + 1} {o + 1} {o + 6} {i + 6} {i + 7} {o + 7})"
        f" ({across} {n} 1) simpleGrading ({1/grading!r} 1 1)"
        for i, o, n in ((0, 3, along), (1, 4, along//3)))
    write_foam(case, "system/blockMeshDict", "vertices (" + " ".join(
        "({!r} {!r} {!r})".format(*map(float, p)) for p in points)
        + f");\nblocks ({blocks});\nedges ({' '.join(arcs)});\nboundary (\n"
        f"inlet {{ type patch; faces ({side((3, 4), (4, 5))}); }}\n"
        f"outlet {{ type patch; faces ({side((2, 5))}); }}\n"
        f"body {{ type wall; faces ({side((0, 1), (1, 2))}); }}\n"
        f"plane {{ type symmetryPlane; faces ({side((0, 3))}); }}\n"
        "sides { type empty; faces ((0 1 4 3) (1 2 5 4) (6 7 10 9)"
        " (7 8 11 10)); }\n);")
    must(case, "blockMesh")
    speed = MACH*np.sqrt(GAMMA*R_GAS*T)
    free = "type zeroGradient;"
    for name, value, wall in (("p", P, free), ("U", (speed, 0, 0),
                                               "type noSlip;"),
                              ("T", T, f"type fixedValue; value uniform"
                               f" {WALL};")):
        write_field(case, name, value, {
            "inlet": "type fixedValue; value $internalField;", "outlet": free,
            "body": wall, "plane": "type symmetryPlane;",
            "sides": "type empty;"})


def viscosity(t):
    return 1.458e-6*t**1.5/(t + 110.4)


def theory():
    """J. A. Fay and F. R. Riddell, J. Aeronaut. Sci. 25 (1958) 73, for a
    stagnation line (0.570 instead of 0.763), with Newton's gradient of the
    velocity."""
    p0, t0 = P*pitot(MACH), T*(1 + 0.5*(GAMMA - 1)*MACH**2)
    edge, wall = p0/(R_GAS*t0), p0/(R_GAS*WALL)
    cv = CP - R_GAS
    prandtl = CP/(cv*(1.32 + 1.77*R_GAS/cv))
    return (0.570*prandtl**-0.6*(wall*viscosity(WALL))**0.1
            * (edge*viscosity(t0))**0.4
            * np.sqrt(np.sqrt(2*(p0 - P)/edge)/RADIUS)*CP*(t0 - WALL))


for across, along, grading in (60, 36, 40), (90, 54, 40), (120, 72, 60):
    case = f"wedge{across}x{along}"
    prepare(case, across, along, grading)
    status, text = run(case, "rhoCentralParcelFoam")
    steady = re.search(r"Gas: steady after (\d+) iterations", text)
    verdict(case + "_steady", steady and int(steady[1]) < 2500,
            f"after {steady[1] if steady else '-'} iterations, bound 2500")
    flux = -read_field(f"{case}/{times_of(case)[-1]}/wallHeatFlux", "body")
    verdict(case + "_heat", abs(flux[0]/theory() - 1) < 0.04,
            f"{1e-3*flux[0]:.1f} kW/m2 at the stagnation line, Fay and Riddell"
            f" {1e-3*theory():.1f}, tolerance 4 %")
