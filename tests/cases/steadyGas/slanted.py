# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""A sphere-cone in a wedge at Mach 2, with layers that widen from the axis on,
so that mesh lines lie aslant the shock: the total pressure before the nose is too
high, which is to be said, and right once the mesh follows the shock; stands in a
temporary folder."""

import numpy as np

from bluntBody import P, T, SOUND, pitot
from caseTools import (copy_case, last_fields, must, solve, verdict,
                       wedge_point, write_case, write_field, write_foam)

MACH, HALF, CONE = 2.0, np.radians(2.5), np.radians(15)
LENGTH, NS, NN = 4, 60, 40

# Body from the nose to the rear, and the outer boundary at 0.8 to 5.5 radii
angle = np.linspace(0, np.pi/2 - CONE, 200)
nose = np.column_stack([1 - np.cos(angle), np.sin(angle)])
run = (LENGTH - nose[-1, 0])*np.linspace(0, 1, 200)[1:, None]
body = np.concatenate([nose, nose[-1] + run*[1, np.tan(CONE)]])
along = np.gradient(body, axis=0)
normal = np.column_stack([-along[:, 1], along[:, 0]])
normal /= np.linalg.norm(normal, axis=1)[:, None]
normal[0] = -1, 0
way = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(body, axis=0),
                                                    axis=1))])
outer = body + normal*(0.8 + 4.7*way/way[-1])[:, None]


def at(point, side):
    return wedge_point(point, side, HALF)


def line(curve, side):
    return "(" + " ".join(at(point, side) for point in curve[-2:0:-1]) + ")"


case = "slanted"
write_case(case, {"endTime": 1, "deltaT": 1, "writeInterval": 1},
           {"mode": "steady"})
write_foam(case, "system/blockMeshDict", f"""
scale 1;
vertices ({at(body[0], 0)} {at(outer[0], 0)} {at(outer[-1], 1)}
    {at(body[-1], 1)} {at(outer[-1], -1)} {at(body[-1], -1)});
blocks (hex (3 0 1 2 5 0 1 4) ({NS} {NN} 1) simpleGrading (1 1 1));
edges (polyLine 3 0 {line(body, 1)} polyLine 2 1 {line(outer, 1)}
    polyLine 5 0 {line(body, -1)} polyLine 4 1 {line(outer, -1)});
boundary
(
    body {{ type wall; faces ((0 3 5 0)); }}
    inlet {{ type patch; faces ((1 2 4 1)); }}
    outlet {{ type patch; faces ((2 3 5 4)); }}
    front {{ type wedge; faces ((0 1 4 5)); }}
    back {{ type wedge; faces ((0 1 2 3)); }}
    axis {{ type empty; faces ((0 1 1 0)); }}
);""")
must(case, "blockMesh")
sides = {"front": "type wedge;", "back": "type wedge;", "axis": "type empty;",
         "outlet": "type zeroGradient;", "body": "type zeroGradient;"}
for field, value in ("p", P), ("T", T), ("U", (MACH*SOUND, 0, 0)):
    given = f"({MACH*SOUND!r} 0 0)" if field == "U" else repr(value)
    write_field(case, field, value, dict(
        sides, inlet=f"type fixedValue; value uniform {given};",
        **({"body": "type slip;"} if field == "U" else {})))
moved = copy_case(case, "slantedMoved")
must(moved, "alignMeshToShock")
for name in case, moved:
    log = solve(name)
    p, temperature, U = last_fields(name, "p T U")
    MM = (U**2).sum(1)/(SOUND**2*temperature/T)
    rest = (p*(1 + 0.2*MM)**3.5)[MM < 0.04].mean()/(P*pitot(MACH)) - 1
    said = "above that behind a normal shock" in " ".join(log.split())
    verdict(f"steady_{name}", "Gas: steady" in log
            and (said if name == case else not said and abs(rest) < 0.01),
            f"total pressure before the nose {100*rest:+.2f} % of that behind a"
            f" normal shock, {'said' if said else 'nothing said'}")
