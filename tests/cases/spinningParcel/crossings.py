# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Streams that come in beside a wall, of which every parcel is to be there:
after the time step has become shorter, and at a plane of the faces of the mesh,
which the stock particleCollector counts them at; stands in a temporary
folder."""

import re

import numpy as np

from caseTools import edit, solve, verdict
from spinningCloud import write_cloud, write_cube

DIAMETER, SHARE, LENGTH, N = 1e-4, 2e-5, 0.1, 10
ONE = np.pi*DIAMETER**3/6


def prepare(case, control, U, injection):
    write_cube(case, LENGTH, N, {"libs": "(spinningParcel parcelInjection"
                                         " lagrangianFunctionObjects)",
                                 **control})
    write_cloud(case, "dust", f"""
        type crossSectionInjection; volumeFraction {SHARE!r};
        diameter {DIAMETER!r}; nParticle 1; U0 {U}; patches (xMin);
        {injection}""")


# A fifth of the stream leaves through the side in its first step. Shorter steps
# follow in a second run
LONG, SHORT, END = 1e-3, 5e-4, 1e-2
case = "shorterStep"
prepare(case, {"endTime": 5*LONG, "deltaT": LONG, "writeInterval": 5*LONG},
        "(20 -20 0)", "")
solve(case)
edit(case, "system/controlDict", f"endTime {5*LONG!r}", f"endTime {END!r}")
edit(case, "system/controlDict", f"deltaT {LONG!r}", f"deltaT {SHORT!r}")
log = solve(case)
due = SHARE/ONE*20*LENGTH**2*(END - SHORT)
came = float(re.findall(r"parcels added *= *(\S+)", log)[-1])
verdict("shorterStep", abs(came - due) < 1.5 and due > 1000,
        f"{came:.0f} parcels came in, {due:.1f} are due")

# All cross the planes at half and at seven tenths of the length, of which the
# first is one of faces and the other is, but for round-off
for place in 0.5, 0.7, 0.73:
    case = f"collector_{place}"
    x = place*LENGTH
    prepare(case, {"endTime": 2e-2, "deltaT": 1e-3, "writeInterval": 2e-2},
            "(20 -1 2)", "duration 5e-3; arrival quiet;")
    corners = " ".join(f"({x!r} {y} {z})" for y, z in (
        (-1, -1), (2, -1), (2, 2), (-1, 2)))
    edit(case, "constant/dustProperties", "cloudFunctions {}", f"""
cloudFunctions
{{
    plane
    {{
        type particleCollector; mode polygon; polygons (({corners}));
        normal (1 0 0); negateParcelsOppositeNormal no; removeCollected no;
        surfaceFormat none; resetOnWrite no; log yes; origin (0 0 0);
    }}
}}""")
    log = solve(case)
    crossed = float(re.findall(r"sum\(total mass\) = (\S+)", log)[-1])
    came = float(re.findall(r"mass introduced *= *(\S+)", log)[-1])

    # The others have left through the sides
    due = (1 - 0.05*place)*(1 - 0.1*place)
    verdict(case, abs(crossed/came/due - 1) < 1e-3,
            f"{100*crossed/came:.3f} % of the mass crossed the plane,"
            f" {100*due:.3f} % are due, tolerance 0.1 %")
