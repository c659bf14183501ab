# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""The boundary layer of a cold sphere at Mach 6 in cells that are a few
millionths of the radius thick and that fall off their tangent by several times
as much from one to the next: the heat flux at the stagnation point."""

import numpy as np
from bluntBody import CP, P, RADIUS, SOUND, T, pitot, prepare
from caseTools import (GAMMA, R_GAS, copy_case, decompose, must, read_field,
                       solve, times_of, verdict, write_field, write_foam)

CELLS, MACH, WALL, GRADIENT = (40, 60), 6, 300.0, 0.6175


def viscosity(t):
    return 1.458e-6*t**1.5/(t + 110.4)


def conductivity(t):
    """Of the stock Sutherland transport."""
    cv = CP - R_GAS
    return viscosity(t)*cv*(1.32 + 1.77*R_GAS/cv)


def fay_riddell():
    """J. A. Fay and F. R. Riddell, J. Aeronaut. Sci. 25 (1958) 73, without
    dissociation, with the velocity gradient of the exact inviscid flow."""
    p0, t0 = P*pitot(MACH), T*(1 + 0.5*(GAMMA - 1)*MACH**2)
    edge, wall = p0/(R_GAS*t0), p0/(R_GAS*WALL)
    prandtl = CP*viscosity(WALL)/conductivity(WALL)
    return (0.763*prandtl**-0.6*(wall*viscosity(WALL))**0.1
            * (edge*viscosity(t0))**0.4
            * np.sqrt(GRADIENT*MACH*SOUND/RADIUS)*CP*(t0 - WALL))


def start(case, time="0"):
    """Uniform stream, and a wall that holds the gas and cools it."""
    sides = {"axis": "type empty;", "front": "type wedge;",
             "back": "type wedge;", "outlet": "type zeroGradient;",
             "inlet": "type fixedValue; value $internalField;"}
    for name, value, wall in (
            ("p", P, "type zeroGradient;"),
            ("T", T, f"type fixedValue; value uniform {WALL!r};"),
            ("U", (MACH*SOUND, 0, 0), "type noSlip;")):
        write_field(case, name, value, {**sides, "body": wall}, time)


def heat(case):
    """Heat flux at the stagnation point and in the first faces."""
    time = times_of(case)[-1]
    must(case, "postProcess", "-func", "writeCellCentres", "-time", time)
    C, t = [read_field(f"{case}/{time}/{name}") for name in "CT"]
    first = C.reshape(CELLS[1], CELLS[0], 3)[:6, 0, :2]
    angle = np.arctan2(first[:, 1], -first[:, 0])
    # The faces are plane: the distance from the line through their corners,
    # seen in the plane between the two sides of the wedge
    edges = 0.5*np.pi*np.arange(7)/CELLS[1]
    corner = RADIUS*np.stack([-np.cos(edges), np.sin(edges)
                              * np.cos(np.radians(2.5))], axis=1)
    along = np.diff(corner, axis=0)
    out = first - corner[:-1]
    distance = (np.abs(along[:, 0]*out[:, 1] - along[:, 1]*out[:, 0])
                / np.hypot(along[:, 0], along[:, 1]))
    flux = (conductivity(WALL)
            * (t.reshape(CELLS[1], CELLS[0])[:6, 0] - WALL)/distance)
    return np.polyfit(angle**2, flux, 1)[1], flux


prepare("cold", "sphere", CELLS, 2.5, MACH,
        {"viscous": "yes", "residual": 1e-8})
start("cold")
write_foam("cold", "system/alignMeshToShockDict",
           "bandShare 0.2; bandWidth 0.1; wallShare 0.4; wallWidth 0.01;")
must("cold", "alignMeshToShock")
copy_case("cold", "coldRanks")
solve("cold")
q, faces = heat("cold")
exact = fay_riddell()
verdict("stagnation_heat", abs(q/exact - 1) < 0.03,
        f"{1e-6*q:.4f} MW/m2, Fay and Riddell {1e-6*exact:.4f},"
        " tolerance 3 %")
verdict("stagnation_heat_even", np.max(np.abs(faces/q - 1)) < 0.015,
        "the first faces over the stagnation point: "
        + " ".join(f"{f:.4f}" for f in faces/q) + ", tolerance 1.5 %")

# Another start on two ranks, whose boundary crosses the layers
start("coldRanks")
decompose("coldRanks", (2, 1, 1))
solve("coldRanks", ranks=2)
must("coldRanks", "reconstructPar", "-latestTime")
other = heat("coldRanks")[1]
verdict("stagnation_heat_ranks", np.max(np.abs(other/faces - 1)) < 1e-4,
        "two ranks from another start differ by"
        f" {np.max(np.abs(other/faces - 1)):.1e}, tolerance 1e-4")
