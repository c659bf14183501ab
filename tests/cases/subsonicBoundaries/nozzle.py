#!/usr/bin/env python3
# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Converging-diverging nozzle between a total pressure and a supersonic
outlet, as a wedge: steady from any start, whatever stands in the nozzle at
first; stands in a temporary folder."""

import numpy as np

from caseTools import (GAMMA, R_GAS, last_fields, must, read_field, solve,
                       times_of, verdict, wedge_point, write_case, write_field,
                       write_foam)

CP = GAMMA*R_GAS/(GAMMA - 1)
P0, T0 = 1e6, 1000.0
THROAT, CHAMBER, LENGTH = 0.01, 0.06, 0.18
NX, NR = 120, 20
HALF = np.radians(2.5)


def radius(x, inlet, outlet):
    """Cosines from the inlet and from the outlet to the throat; the ratios are
    those of areas."""
    ratio, length = np.where(x < 0, inlet, outlet), np.where(
        x < 0, CHAMBER, LENGTH - CHAMBER)
    swell = 0.5*(np.sqrt(ratio) - 1)
    return THROAT*(1 + swell*(1 - np.cos(np.pi*np.abs(x)/length)))


def prepare(case, inlet, outlet, p, U, back=None):
    def at(x, r, side):
        return wedge_point((x, r), side, HALF)

    def contour(side):
        x = np.linspace(-CHAMBER, LENGTH - CHAMBER, 400)[1:-1]
        return "(" + " ".join(
            at(*point, side) for point in zip(x, radius(x, inlet, outlet))) + ")"

    write_case(case, {"endTime": 1, "deltaT": 1, "writeInterval": 1},
               {"mode": "steady", "viscous": "no"})
    ends = np.array([-CHAMBER, LENGTH - CHAMBER])
    begin, end = radius(ends, inlet, outlet)
    write_foam(case, "system/blockMeshDict", f"""
scale 1;
vertices ({at(ends[0], 0, 1)} {at(ends[1], 0, 1)} {at(ends[1], end, 1)}
    {at(ends[0], begin, 1)} {at(ends[1], end, -1)} {at(ends[0], begin, -1)});
blocks (hex (0 1 4 5 0 1 2 3) ({NX} {NR} 1) simpleGrading (1 1 1));
edges (polyLine 3 2 {contour(1)} polyLine 5 4 {contour(-1)});
boundary
(
    inlet {{ type patch; faces ((0 3 5 0)); }}
    outlet {{ type patch; faces ((1 2 4 1)); }}
    wall {{ type wall; faces ((3 2 4 5)); }}
    front {{ type wedge; faces ((0 1 2 3)); }}
    back {{ type wedge; faces ((0 1 4 5)); }}
    axis {{ type empty; faces ((0 1 1 0)); }}
);""")
    must(case, "blockMesh")
    sides = {"front": "type wedge;", "back": "type wedge;",
             "axis": "type empty;", "wall": "type zeroGradient;",
             "outlet": "type zeroGradient;"}
    ambience = {field: {"outlet": condition} if back else {}
                for field, condition in (
                    ("p", f"type fixedValue; value uniform {back};"),
                    ("T", "type inletOutlet; inletValue uniform 900;"
                     " value uniform 900;"),
                    ("U", "type pressureInletOutletVelocity;"
                     " value uniform (0 0 0);"))}
    total = f"gamma {GAMMA}; psi thermo:psi;"
    write_field(case, "p", p, dict(
        sides, **ambience["p"],
        inlet=f"type totalPressure; p0 uniform {P0}; {total}"
        f" value uniform {p};"))
    write_field(case, "T", 900.0, dict(
        sides, **ambience["T"],
        inlet=f"type totalTemperature; T0 uniform {T0}; {total}"
        f" value uniform {T0};"))
    write_field(case, "U", (U, 0, 0), dict(
        sides, **ambience["U"], wall="type slip;",
        inlet="type pressureInletOutletVelocity;"
        f" value uniform ({U} 0 0);"))


def exact_exit(outlet, back):
    """Mach number at the outlet of one-dimensional flow that is choked in the
    throat, by bisection: of the area relation, or of the mass flow at a
    pressure behind a shock."""
    g = GAMMA
    choked = np.sqrt(g)*(2/(g + 1))**(0.5*(g + 1)/(g - 1))

    def too_slow(M):
        stagnation = 1 + 0.5*(g - 1)*M*M
        p = back/P0 if back else stagnation**(-g/(g - 1))
        flux = p*outlet*M*np.sqrt(g*stagnation)
        return flux < choked if back else flux > choked

    low, high = (0.0, 1.0) if back else (1.0, 20.0)
    for _ in range(60):
        middle = 0.5*(low + high)
        low, high = (middle, high) if too_slow(middle) else (low, middle)
    return low


def judge(name, inlet, outlet, p, U, back=None, felt=True):
    case = name
    prepare(case, inlet, outlet, p, U, back)
    log = solve(case)
    T, velocity = last_fields(case, "T U")
    H = np.abs(T + 0.5*(velocity**2).sum(1)/CP)/T0 - 1
    must(case, "postProcess", "-func", "writeCellVolumes", "-latestTime")

    exact = exact_exit(outlet, back if felt else None)
    rows = (velocity[:, 0]/np.sqrt(GAMMA*R_GAS*T)).reshape(NR, NX)
    V = read_field(f"{case}/{times_of(case)[-1]}/V").reshape(NR, NX)
    mean = (rows*V)[:, -1].sum()/V[:, -1].sum()
    said = "does not feel the condition on p" in log
    verdict(name, "Gas: steady" in log and np.abs(H).max() < 5e-3
            and abs(mean/exact - 1) < 0.02 and said == (not felt),
            f"total temperature within {100*np.abs(H).max():.3f} %, mean Mach"
            f" number of the last cells {mean:.4f} (one-dimensional:"
            f" {exact:.4f})" + ", pressure outside not felt"*said)


# A start that would let a shock stand before the outlet, and one from rest
judge("nozzle_from_uniform_flow", 9.8, 6.6, 0.23*P0, 300.0)
judge("nozzle_from_rest", 3.0, 4.0, 0.9*P0, 0.0)

# Against a pressure, which on the way gas comes back through both ends from: a
# shock in the nozzle, and one that the jet keeps outside
judge("nozzle_with_a_shock", 3.0, 4.0, 0.3*P0, 0.0, 0.62*P0)
judge("nozzle_against_pressure", 3.0, 1.5, 0.3*P0, 0.0, 0.5*P0, felt=False)
