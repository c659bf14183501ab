# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""A quarter of a sphere between two planes of symmetry, which may be one patch;
a patch of symmetry that is curved is refused."""

import numpy as np
from bluntBody import P, RADIUS, SOUND, T
from caseTools import (box, complaint, edit, must, read_points, run, verdict,
                       write_block, write_case, write_field, write_points)

LAYERS, ACROSS, OUTER, M = 16, 6, 1.8, 6


def prepare(case, one_patch=False, outer="patch"):
    write_case(case, {"endTime": 1, "deltaT": 1, "writeInterval": 1,
                      "writeFormat": "ascii"}, {"mode": "steady"})
    write_block(case, box((1, 1, 1)), (LAYERS, ACROSS, ACROSS),
                {"xMin": "wall", "xMax": outer, "yMin": "symmetry",
                 "yMax": "patch", "zMin": "symmetry", "zMax": "patch"})
    sides = ["yMin", "zMin"]
    if one_patch:
        mesh = "system/blockMeshDict"
        edit(case, mesh, "zMin { type symmetry; faces ((0 3 2 1)); }\n", "")
        edit(case, mesh, "faces ((0 1 5 4))", "faces ((0 1 5 4) (0 3 2 1))")
        sides = ["yMin"]
    must(case, "blockMesh")
    cube = read_points(case)
    a, b = np.tan(np.radians(45)*cube[:, 1:]).T
    way = np.stack([-np.ones_like(a), -a, b], axis=1)
    way /= np.linalg.norm(way, axis=1)[:, None]
    write_points(case, RADIUS*(1 + (OUTER - 1)*cube[:, :1])*way)
    inlet = ("type symmetry;" if outer == "symmetry"
             else "type fixedValue; value $internalField;")
    for name, value in ("p", P), ("T", T), ("U", (M*SOUND, 0, 0)):
        write_field(case, name, value, {
            "xMin": "type slip;" if name == "U" else "type zeroGradient;",
            "xMax": inlet, "yMax": "type zeroGradient;",
            "zMax": "type zeroGradient;",
            **{side: "type symmetry;" for side in sides}})


for name, one_patch in ("quarter", False), ("quarter_one_patch", True):
    prepare(name, one_patch)
    must(name, "alignMeshToShock")
moved, other = read_points("quarter"), read_points("quarter_one_patch")
far = np.abs(other - moved).max()/RADIUS
depth = np.linalg.norm(moved, axis=1).max()/RADIUS - 1
verdict("planes_in_one_patch", far < 1e-9 and 0.1 < depth < 0.7,
        f"points apart by {far:.1e} of the radius, of the mesh that reaches "
        f"{depth:.3f}")

prepare("curved", outer="symmetry")
status, text = run("curved", "alignMeshToShock")
verdict("refused_curved_symmetry",
        status != 0 and "Patch xMax of type symmetry is curved" in text,
        complaint(text))
