# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""A gas that turns like a rigid body in a closed can: centrifugal force and
pressure balance, p = p0 exp(w^2 r^2/(2 R T)) at uniform T, an exact solution of
the Euler equations that lasts for ever."""

import numpy as np
from caseTools import (R_GAS, largest, last_fields, must, solve, verdict,
                       write_case, write_field, write_foam)

T, P0, RADIUS, N = 300.0, 1e5, 0.1, 40
SPIN = 2500.0       # [rad/s]: 250 m/s at the wall
END = 2e-3          # [s]: 7 passages of sound
HALF = np.radians(2.5)


def corner(x, r, side):
    return f"({x} {r*np.cos(HALF)!r} {side*r*np.sin(HALF)!r})"


case = "swirl"
write_case(case, {"endTime": END, "deltaT": 5e-7, "writeInterval": END}, {})
write_foam(
    case, "system/blockMeshDict",
    "scale 1;\nvertices (" + " ".join(
        [corner(x, r, s) for x, r, s in
         ((0, 0., 1), (0.01, 0., 1), (0.01, RADIUS, -1), (0, RADIUS, -1),
          (0.01, RADIUS, 1), (0, RADIUS, 1))])
    + f");\nblocks (hex (0 1 2 3 0 1 4 5) (2 {N} 1) simpleGrading (1 1 1));\n"
    "edges ();\nboundary (\n"
    "ends { type symmetry; faces ((0 3 5 0) (1 1 4 2)); }\n"
    "wall { type wall; faces ((3 2 4 5)); }\n"
    "back { type wedge; faces ((0 1 2 3)); }\n"
    "front { type wedge; faces ((0 5 4 1)); }\n"
    "axis { type empty; faces ((0 0 1 1)); }\n);")
must(case, "blockMesh")
must(case, "postProcess", "-func", "writeCellCentres", "-constant")
r = last_fields(case, "C", "constant")[0][:, 1]

U = np.zeros((2*N, 3))
U[:, 2] = SPIN*r
kinds = {"ends": "type symmetry;", "wall": "type zeroGradient;",
         "back": "type wedge;", "front": "type wedge;", "axis": "type empty;"}
p = P0*np.exp((SPIN*r)**2/(2*R_GAS*T))
write_field(case, "p", p, kinds)
write_field(case, "T", T, kinds)
write_field(case, "U", U, {**kinds, "wall": "type slip;"})
solve(case)

p1, T1, U1 = last_fields(case, "p T U")
speed = SPIN*RADIUS
apart = largest(np.abs(p1/p - 1).max(), np.abs(T1/T - 1).max())
turned = np.abs(U1[:, 2] - U[:, 2]).max()/speed
radial = np.abs(U1[:, 1]).max()/speed
verdict("swirl", apart < 2e-3 and turned < 5e-3 and radial < 2e-3,
        f"after 7 passages of sound p and T are {apart:.1e} apart, the swirl "
        f"{turned:.1e}, radial speed {radial:.1e}")
