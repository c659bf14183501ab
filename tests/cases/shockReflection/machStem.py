# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""A shock that runs over a wall inclined to it by 30 degrees (Woodward &
Colella, J. Comput. Phys. 54 (1984) 115-173), seen along the wall. At a plane
wall without friction the gas is what it is at a plane of symmetry, behind
which there is its image: the Mach stem stands on the wall, and no vortex
follows its foot."""

import numpy as np
from caseTools import (GAMMA, R_GAS, box, decompose, largest, last_fields,
                       must, solve, verdict, write_block, write_case,
                       write_field)

P, T = 26500.0, 223.25
SOUND = np.sqrt(GAMMA*R_GAS*T)
INCLINED = np.radians(30)
LENGTH, HEIGHT = 2.4, 1.2
NX, NY = 120, 60


def behind(M):
    """Behind a shock of Mach number M in gas at rest: p, T, u."""
    g = GAMMA
    p = 1 + 2*g/(g + 1)*(M*M - 1)
    rho = (g + 1)*M*M/((g - 1)*M*M + 2)
    return P*p, T*p/rho, SOUND*M*(1 - 1/rho)


def case(name, M, flux, mirror):
    end = 1.75/(M*SOUND)
    write_case(name, {"endTime": end, "deltaT": 1e-3*end, "writeInterval": end,
                      "adjustTimeStep": "yes", "maxCo": 0.4, "maxDeltaT": 1,
                      "writeControl": "adjustableRunTime"},
               {"mode": "transient"}, flux, "vanLeer")
    write_block(name, box((LENGTH, HEIGHT, 0.1)), (NX, NY, 1),
                {"xMin": "patch", "xMax": "patch", "yMax": "patch",
                 "yMin": "symmetryPlane" if mirror else "wall"})
    y, x = np.meshgrid((np.arange(NY) + 0.5)*HEIGHT/NY,
                       (np.arange(NX) + 0.5)*LENGTH/NX, indexing="ij")
    shocked = (x*np.cos(INCLINED) < y*np.sin(INCLINED)).ravel()
    p, t, u = behind(M)
    velocity = u*np.array([np.cos(INCLINED), -np.sin(INCLINED), 0])
    for field, state, before in (("p", p, P), ("T", t, T),
                                 ("U", velocity, np.zeros(3))):
        values = np.where(shocked[:, None] if field == "U" else shocked, state,
                          before)
        uniform = ("(" + " ".join(map(repr, map(float, state))) + ")"
                   if field == "U" else repr(float(state)))
        wall = "slip" if field == "U" else "zeroGradient"
        write_field(name, field, values, {
            "xMin": f"type fixedValue; value uniform {uniform};",
            "xMax": "type zeroGradient;", "yMax": "type zeroGradient;",
            "yMin": f"type {'symmetryPlane' if mirror else wall};",
            "zMin": "type empty;", "zMax": "type empty;"})
    must(name, "blockMesh")
    return name


def reflection(name):
    """In cells how far the foot of the stem stands before the stem eight cells
    above it, and the lowest pressure of the wall behind the foot over the
    highest."""
    p, rho = [f.reshape(NY, NX) for f in last_fields(name, "p rho")]
    front = [np.where(rho[j] > 2*P/(R_GAS*T))[0].max() for j in range(12)]
    wall = p[0, front[0] - 30:front[0] - 2]
    return front[0] - front[8], wall.min()/wall.max(), front[0]


for M, flux in (10, "HLLC"), (10, "Kurganov"), (5, "HLLC"):
    of_wall, of_mirror = (
        (solve(case(f"{kind}_{M}_{flux}", M, flux, kind == "mirror")),
         reflection(f"{kind}_{M}_{flux}"))[1] for kind in ("wall", "mirror"))
    verdict(f"machStem_{M}_{flux}",
            abs(of_wall[2] - of_mirror[2]) <= 1
            and abs(of_wall[0] - of_mirror[0]) <= 1
            and abs(of_wall[1]/of_mirror[1] - 1) < 0.2,
            f"foot in cell {of_wall[2]}, {of_wall[0]} before the stem above, "
            f"lowest pressure of the wall {of_wall[1]:.3f} of the highest; "
            f"with a mirror {of_mirror[2]}, {of_mirror[0]}, "
            f"{of_mirror[1]:.3f}; tolerance one cell, 20 %")

whole = "wall_10_HLLC"
ranks = case("ranks", 10, "HLLC", False)
# (the cells at the wall are those of one rank, all above them of the other)
decompose(ranks, of_cells=(np.arange(NX*NY) >= NX).astype(int))
solve(ranks, 2)
must(ranks, "reconstructPar")
worst = largest(abs(a/b - 1).max() for a, b in
                zip(last_fields(ranks, "p T"), last_fields(whole, "p T")))
verdict("machStem_ranks", worst < 1e-9,
        f"on two ranks within {worst:.1e}, tolerance 1e-9")
