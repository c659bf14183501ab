# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Sand that comes into a steady stream after the first round of the feedback,
and ends long after gas and particles have come to rest: neither is a rest. Nor
is that of another stream, in which a run goes on."""

import os
import re

from caseTools import (box, copy_case, edit, last_fields, must, solve, verdict,
                       write_block, write_case, write_field, write_foam)
from spinningCloud import write_cloud

SPEED, P, T = 1200.0, 1e5, 400.0
STEP, ROUND = 2e-6, 4e-4
FIRST, LAST = 5e-4, 4e-3

case = "lateFeedback"
write_case(case, {"endTime": 6e-3, "deltaT": STEP, "writeInterval": ROUND,
                  "writeFormat": "ascii",
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
copy_case(case, "early")
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

# The run goes on at rest, in the same stream and in a thinner one
END = 2.8e-3
edit("early", "system/controlDict", "endTime 0.006;", f"endTime {END};")
rests = "gas and particles rest" in solve("early")
for case, thinner in ("same", 1), ("thinner", 0.5):
    copy_case("early", case)
    edit(case, "system/controlDict", f"endTime {END};",
         f"endTime {END + 2*ROUND};")
    edit(case, f"{END}/p", f"uniform {P:g};", f"uniform {thinner*P:g};")
    os.remove(f"{case}/{END}/uniform/complete")     # (with the sum of p)
    log = solve(case)
    p = last_fields(case, "p")[0].mean()/P
    found = ("not steady any more" in log, "round 1 of the particles" in log)
    verdict(case + "_stream", rests and set(found) == {thinner < 1}
            and (p < 0.9) == (thinner < 1), f"p is {p:.2f} of that at the"
            f" start, {'' if found[0] else 'not '}marched anew")
