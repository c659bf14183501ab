# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""A sphere-cone in a wedge at Mach 2, with layers that widen from the axis on,
so that mesh lines lie aslant the shock: the total pressure before the nose is too
high, which is to be said, and right once the mesh follows the shock; stands in a
temporary folder."""

import numpy as np

from bluntBody import P, T, SOUND, between, pitot, told_at_nose
from caseTools import copy_case, last_fields, must, solve, verdict

MACH, CONE = 2.0, np.radians(15)
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

case = "slanted"
between(case, body, outer, (NS, NN), MACH)
moved = copy_case(case, "slantedMoved")
must(moved, "alignMeshToShock")
for name in case, moved:
    log = solve(name)
    p, temperature, U = last_fields(name, "p T U")
    MM = (U**2).sum(1)/(SOUND**2*temperature/T)
    rest = (p*(1 + 0.2*MM)**3.5)[MM < 0.04].mean()/(P*pitot(MACH)) - 1
    told, right = told_at_nose(name, log, MACH)
    verdict(f"steady_{name}", "Gas: steady" in log and right
            and (told is not None and told > 0 if name == case
                 else told is None and abs(rest) < 0.01),
            f"total pressure before the nose {100*rest:+.2f} % of that behind a"
            f" normal shock, {'nothing' if told is None else told} said,"
            f" {'as' if right else 'not what'} the fields have")
