# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Slow gas around a sphere, without friction: its total pressure is the same
everywhere. Steady, it is so at any Mach number with all fluxes but the central
ones, and where it is not the log says so. Stands in a temporary folder."""

import re

import numpy as np
from bluntBody import P, RADIUS, SOUND, T
from caseTools import (GAMMA, R_GAS, last_fields, must, solve, verdict,
                       wedge_point, write_case, write_field, write_foam)

N, FAR, HALF = 32, 15, np.radians(2.5)


def corner(radius, angle, side):
    return wedge_point((-radius*np.cos(angle), radius*np.sin(angle)), side,
                       HALF)


def arc(radius, first, last, side):
    angles = np.linspace(first, last, 202)[1:-1]
    return "(" + " ".join(corner(radius, a, side) for a in angles) + ")"


def sphere(case, M, flux, gas):
    """Cells over 0 to 180 degrees from the body to FAR radii, N x 2 N."""
    step = 1 if gas["mode"] == "steady" else 1e-6
    write_case(case, {"endTime": step, "deltaT": step, "writeInterval": step},
               gas, flux)
    near, far, quarter = RADIUS, FAR*RADIUS, 0.5*np.pi
    vertices = " ".join(corner(r, a, s) for r, a, s in (
        (near, 0, 0), (far, 0, 0), (far, quarter, 1), (near, quarter, 1),
        (far, quarter, -1), (near, quarter, -1), (far, np.pi, 0),
        (near, np.pi, 0)))
    edges = "\n".join(
        f"polyLine {i} {j} {arc(r, a, a + quarter, s)}"
        for i, j, r, a, s in (
            (0, 3, near, 0, 1), (1, 2, far, 0, 1), (0, 5, near, 0, -1),
            (1, 4, far, 0, -1), (3, 7, near, quarter, 1),
            (2, 6, far, quarter, 1), (5, 7, near, quarter, -1),
            (4, 6, far, quarter, -1)))
    write_foam(case, "system/blockMeshDict", f"""
scale 1;
vertices ({vertices});
blocks
(
    hex (0 1 2 3 0 1 4 5) ({N} {N} 1) simpleGrading (9 1 1)
    hex (3 2 6 7 5 4 6 7) ({N} {N} 1) simpleGrading (9 1 1)
);
edges ({edges});
boundary
(
    body {{ type wall; faces ((0 3 5 0) (3 7 5 7)); }}
    far {{ type patch; faces ((1 2 4 1) (2 6 4 6)); }}
    front {{ type wedge; faces ((0 1 2 3) (3 2 6 7)); }}
    back {{ type wedge; faces ((0 1 4 5) (5 4 6 7)); }}
    axis {{ type empty; faces ((0 1 1 0)); }}
);""")
    must(case, "blockMesh")
    U = f"({M*SOUND!r} 0 0)"
    sides = {"front": "type wedge;", "back": "type wedge;",
             "axis": "type empty;", "body": "type zeroGradient;"}
    for field, value, far in (
            ("p", P,
             f"type freestreamPressure; freestreamValue uniform {P!r};"),
            ("T", T, f"type inletOutlet; inletValue uniform {T!r};"
                     f" value uniform {T!r};"),
            ("U", (M*SOUND, 0, 0),
             f"type freestreamVelocity; freestreamValue uniform {U};")):
        write_field(case, field, value, dict(
            sides, far=far, **({"body": "type slip;"} if field == "U" else {})))


def lost(case, M):
    """Total pressure lost in the cells at the front of the sphere, in dynamic
    pressures of the stream: (at the nose, most of 0 to 90 degrees)."""
    p, t, U = (f[:N*N].reshape(N, N, -1)[:, 0] for f in
               last_fields(case, "p T U"))
    MM = (U**2).sum(axis=1)/(GAMMA*R_GAS*t[:, 0])
    total = p[:, 0]*(1 + 0.5*(GAMMA - 1)*MM)**3.5
    exact = P*(1 + 0.5*(GAMMA - 1)*M*M)**3.5
    loss = (exact - total)/(0.5*GAMMA*P*M*M)
    return loss[0], np.abs(loss).max()


def slowest(case, text):
    """What the log says of it: (warned, whether rightly)."""
    said = set(re.findall(r"The gas is slow, Mach number (\S+) at most", text))
    _, t, U = last_fields(case, "p T U")
    fastest = np.sqrt(((U**2).sum(axis=1)/(GAMMA*R_GAS*t)).max())
    return said, all(abs(float(M)/fastest - 1) < 1e-4 for M in said)


for M, flux, right in (
        (0.01, "SLAU2", True), (0.01, "AUSMPlusUp", True),
        (0.01, "HLLC", True), (0.1, "HLLC", True), (0.3, "HLLC", True),
        (0.01, "Kurganov", False)):
    case = f"slow_{flux}_{M}"
    sphere(case, M, flux, {"mode": "steady"})
    text = solve(case)
    nose, worst = lost(case, M)
    said, true = slowest(case, text)
    steady = re.search(r"Gas: steady after (\d+) iterations", text)
    # (gas that begins subsonic needs no march before Newton's method)
    good = nose < 0.04 and worst < 0.08 if right else nose > 0.1
    verdict(case, steady and int(steady[1]) < 30 and good and true
            and len(said) == (not right),
            f"{steady[0] if steady else 'not steady'}, {100*nose:.1f} % of the"
            f" dynamic pressure lost at the nose, at most {100*worst:.1f} %;"
            f" warned of {sorted(said)}")

# The default residual is small beside the dynamic pressure, too
sphere("slow_to_the_end", 0.01, "HLLC", {"mode": "steady", "residual": 1e-9})
solve("slow_to_the_end")
change = lost("slow_to_the_end", 0.01)[0] - lost("slow_HLLC_0.01", 0.01)[0]
verdict("slow_residual", abs(change) < 1e-3,
        f"a residual of 1e-9 changes the loss at the nose by {100*change:.3f} %"
        " of the dynamic pressure")

# In time there is sound
for flux, warns in ("SLAU2", 0), ("HLLC", 1), ("Kurganov", 1):
    case = f"slow_{flux}_in_time"
    sphere(case, 0.05, flux, {"mode": "transient"})
    said, true = slowest(case, solve(case))
    verdict(case, true and len(said) == warns, f"warned of {sorted(said)}")
