# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""A stream through a face with a corner that points inwards, as some polygons
have: no part of it is to let parcels in twice."""

import re

import numpy as np

from caseTools import (must, solve, verdict, write_block, write_case,
                       write_field, write_foam)
from spinningCloud import write_cloud

# The last corner lies within the triangle of the others
CORNERS = np.array([(0.1, 1), (0, 0), (1, 0), (0.4, 0.35)])
DIAMETER, SHARE, SPEED, END, STEPS = 1e-4, 1e-7, 100.0, 1e-3, 10

case = "concaveInlet"
write_case(case, {"endTime": END, "deltaT": END/STEPS, "writeInterval": END,
                  "libs": "(spinningParcel parcelInjection)"},
           {"mode": "frozen"})
write_block(case, [(x, y, z) for z in (0, 1) for x, y in CORNERS], (1, 1, 4),
            {s + e: "patch" for s in "xyz" for e in ("Min", "Max")})
sides = {s + e: "type zeroGradient;" for s in "xyz" for e in ("Min", "Max")}
write_field(case, "p", 1e5, sides)
write_field(case, "T", 300.0, sides)
write_field(case, "U", (0.0, 0.0, SPEED), sides)
write_cloud(case, "dust", f"""
    type crossSectionInjection; volumeFraction {SHARE!r};
    diameter {DIAMETER!r}; U0 (0 0 {SPEED!r}); patches (zMin);""")
write_foam(case, "constant/parcelClouds", "clouds (dust);")
must(case, "blockMesh")
log = solve(case)
x, y = CORNERS.T
area = 0.5*abs(np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1)))
# (those of the last step are placed in the next)
due = SHARE/(np.pi*DIAMETER**3/6)*SPEED*area*END*(1 - 1/STEPS)
came = int(re.findall(r"parcels added *= *(\d+)", log)[-1])
verdict("concave_inlet", abs(came - due) < 1.5 and due > 1000,
        f"{came} parcels came in, {due:.1f} are due")
