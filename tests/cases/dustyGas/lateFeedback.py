# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Sand that comes into a steady stream after the first round of the feedback,
and ends long after gas and particles have come to rest: neither is a rest."""

import re

from caseTools import (box, must, solve, verdict, write_block, write_case,
                       write_field, write_foam)
from spinningCloud import write_cloud

SPEED, P, T = 1200.0, 1e5, 400.0
STEP, ROUND = 2e-6, 4e-4
FIRST, LAST = 5e-4, 4e-3

case = "lateFeedback"
write_case(case, {"endTime": 6e-3, "deltaT": STEP, "writeInterval": 6e-3,
                  "libs": "(spinningParcel parcelForces parcelInjection)"},
           {"mode": "steady"})
write_foam(case, "system/fvSolution", f"""
highSpeedGas
{{
    mode steady; viscous no;
    feedback {{ delay {ROUND/2!r}; window {ROUND/2!r}; tolerance 1e-3; }}
}}
""")
write_block(case, box((0.1, 0.01, 0.01)), (40, 1, 1),
            {"xMin": "patch", "xMax": "patch"})
sides = {s + e: "type empty;" for s in "yz" for e in ("Min", "Max")}
sides["xMax"] = "type zeroGradient;"
for name, value in ("p", P), ("T", T), ("U", (SPEED, 0.0, 0.0)):
    text = f"({SPEED!r} 0 0)" if name == "U" else repr(value)
    write_field(case, name, value,
                {**sides, "xMin": f"type fixedValue; value uniform {text};"})
write_cloud(
    case, "sand", f"""
    type crossSectionInjection; patches (xMin); U0 (700 0 0);
    volumeFraction 1e-4; diameter 2e-5; nParticle 20; arrival quiet;
    startTime {FIRST!r}; duration {LAST - FIRST!r};""",
    forces="hendersonDrag;", coupled="yes")
write_foam(case, "constant/parcelClouds", "clouds (sand);")
must(case, "blockMesh")
log = solve(case)
body = log.split("warnings, each once")[0]
rests = [int(n) for n in re.findall(
    r"in round (\d+) p, T, U have changed by [^\n]*: gas and particles rest",
    body)]
rounds = [int(n) for n in re.findall(r"round (\d+) of the particles ends",
                                     body)]
verdict("no_rest_before_particles", rests and rests[0] > 2,
        f"rest after rounds {rests}")
again = [float(t) for t in re.findall(
    r"Time = (\S+)\n(?:(?!Time = )[^\n]*\n)*?[^\n]*had come to rest", body)]
verdict("looked_at_again", len(again) == 1 and LAST < again[0]
        < LAST + 2*ROUND + STEP and rounds[-1] > rests[0],
        f"other sources noticed at {again}, the sand ends at {LAST}; the last"
        f" round is {rounds[-1]}")
