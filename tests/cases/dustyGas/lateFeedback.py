# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Sand that comes into a steady stream after the first round of the feedback,
and ends long after gas and particles have come to rest: neither is a rest. Nor
is that of another stream, in which a run goes on. Too few parcels are said to
be what keeps both from rest, and how closely they may come to it."""

import os
import re

import numpy as np
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
    feedback {{ delay {ROUND/2!r}; window {ROUND/2!r}; tolerance 0.001; }}
}}
""")


def gas(case, n, beside):
    """A block of n cells, and the stream through it."""
    sides = {"xMin": "patch", "xMax": "patch"}
    sides.update(dict.fromkeys(("yMin", "yMax"), beside))
    write_block(case, box((0.1, 0.01, 0.01)), (*n, 1), sides)
    conditions = {"xMax": "type zeroGradient;"}
    for side, kind in ("y", beside), ("z", "empty"):
        for end in "Min", "Max":
            conditions[side + end] = f"type {kind};"
    for name, value in ("p", P), ("T", T), ("U", (SPEED, 0.0, 0.0)):
        text = f"({SPEED!r} 0 0)" if name == "U" else repr(value)
        write_field(case, name, value, {
            **conditions, "xMin": f"type fixedValue; value uniform {text};"})
    must(case, "blockMesh")


gas(case, (40, 1), "empty")
write_cloud(
    case, "sand", f"""
    type crossSectionInjection; patches (xMin); U0 (700 0 0);
    volumeFraction 1e-4; diameter 2e-5; nParticle 20; arrival quiet;
    startTime {FIRST!r}; duration {LAST - FIRST!r};""",
    forces="hendersonDrag;", coupled="yes")
write_foam(case, "constant/parcelClouds", "clouds (sand);")
copy_case(case, "early")
copy_case(case, "few")
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

# Few parcels, at random: not within the tolerance, but within twice that which
# the log names
gas("few", (40, 8), "symmetryPlane")
edit("few", "constant/sandProperties", "quiet", "random")
edit("few", "constant/sandProperties", "nParticle 20", "nParticle 2000")
edit("few", "system/controlDict", "endTime 0.006;", f"endTime {LAST};")
copy_case("few", "loose")
log = solve("few")
said = re.search(r"scatter of few parcels. It lets them rest within a tolerance"
                 r" of (\S+); for 0.001 take about (\d+) times as many", log)
within, more = map(float, said.groups()) if said else (np.nan, np.nan)
verdict("few_parcels", within > 2e-3 and 0 <= more - (within/1e-3)**2 < 1
        and "gas and particles rest" not in log,
        f"said to rest within {within:.3g}, or with {more:g} times as many")
edit("loose", "system/fvSolution", "tolerance 0.001;",
     f"tolerance {2*within!r};")
log = solve("loose")
found = "gas and particles rest" in log
verdict("few_parcels_loosely", found and "scatter of few" not in log,
        f"rest within twice that is {'' if found else 'not '}found")
