# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Gas that goes round between a spike and the flat face behind it gets nothing
of the stream, and without friction nothing says how warm it is: that is to be
said; stands in a temporary folder."""

import re

import numpy as np
from bluntBody import CP, P, SOUND, T
from caseTools import (last_fields, must, read_field, solve, times_of, verdict,
                       write_case, write_field, write_foam)

MACH, HALF, N = 3, np.radians(1), 16

case = "spike"
write_case(case, {"endTime": 1, "deltaT": 1, "writeInterval": 1},
           {"mode": "steady"}, "HLLC", "vanAlbada")
corners = [(x, r*np.cos(HALF), side*r*np.sin(HALF)) for side, r in
           ((0, 0), (1, 3), (-1, 3)) for x in (0, 4)]
write_foam(case, "system/blockMeshDict", "scale 1;\nvertices (\n" + "\n".join(
    "(%r %r %r)" % tuple(map(float, x)) for x in corners) + f"""
);
blocks (hex (0 1 5 4 0 1 3 2) ({4*N} {3*N} 1) simpleGrading (1 1 1));
boundary
(
    inlet {{ type patch; faces ((0 4 2 0)); }}
    outlet {{ type patch; faces ((1 3 5 1) (2 3 5 4)); }}
    axis {{ type empty; faces ((0 1 1 0)); }}
    front {{ type wedge; faces ((0 1 3 2)); }}
    back {{ type wedge; faces ((0 1 5 4)); }}
    body {{ type wall; faces (); }}
);""")
must(case, "blockMesh")

# The spike, 0.2 in radius, before a cylinder of radius 1
boxes = "(1.6 -1 -1) (4 0.2 1)", "(2.6 -1 -1) (4 1 1)"
write_foam(case, "system/topoSetDict", "actions (" + "".join(
    f"""
{{
    name gas; type cellSet; action {action}; source boxToCell;
    box {corner};
}}""" for action, corner in
    (("new", "(-1 -1 -1) (9 9 9)"), *(("subtract", b) for b in boxes)))
    + "\n);")
must(case, "topoSet")
must(case, "subsetMesh", "-overwrite", "-patch", "body", "gas")
for name, value in ("p", P), ("T", T), ("U", (MACH*SOUND, 0, 0)):
    boundary = {side: f"type {kind};" for side, kind in
                (("front", "wedge"), ("back", "wedge"), ("axis", "empty"),
                 ("outlet", "zeroGradient"))}
    boundary["inlet"] = "type fixedValue; value $internalField;"
    boundary["body"] = ("type slip;" if name == "U"
                        else "type zeroGradient;")
    write_field(case, name, value, boundary)
text = solve(case)
must(case, "postProcess", "-func", "writeCellCentres", "-latestTime")
t, U = last_fields(case, "T U")
C = read_field(f"{case}/{times_of(case)[-1]}/C")
off = (CP*t + 0.5*(U**2).sum(axis=1))/(CP*T + 0.5*(MACH*SOUND)**2) - 1
cavity = (C[:, 0] > 1.6) & (C[:, 0] < 2.6) & (C[:, 1] < 1)
said = re.search(r"In (\d+) cells around \((\S+) (\S+) \S+\) the total"
                 r" enthalpy is (\S+) % below", text)
good = (said is not None and 1.6 < float(said[2]) < 2.6
        and float(said[3]) < 1
        and 3 < float(said[4]) < -100*off[cavity].min()
        and int(said[1]) <= (off < -0.03).sum())
verdict("eddy_without_the_stream's_enthalpy",
        good and "Gas: steady" in text,
        (said[0] if said else "nothing was said")
        + f"; least in the cavity {100*off[cavity].min():.1f} %")
