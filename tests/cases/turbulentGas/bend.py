# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Air at 45 m/s through a bend between two walls, in mode steady: each end
feels the other, and the eddies follow. Stands in a folder of its own."""

import re

import numpy as np
from caseTools import (box, decompose, edit, last_fields, must, read_points,
                       solve, verdict, write_block, write_field, write_points)
from plateCase import prepare_steady

WIDTH, LEG, INNER = 0.025, 0.25, 0.025
SPEED, P, T, K, OMEGA = 45.0, 1e5, 300.0, 7.6, 2850.0
NX, NY = 160, 30
TURN = np.pi/2*(INNER + WIDTH/2)


def turned(points):
    """The straight duct, with a quarter of a turn in its middle."""
    x, y, z = points.T
    angle = np.clip((x - LEG)/TURN, 0, 1)*np.pi/2
    after = np.maximum(x - LEG - TURN, 0)
    radius = INNER + WIDTH - y
    return np.column_stack((
        np.minimum(x, LEG) + radius*np.sin(angle),
        INNER + WIDTH - radius*np.cos(angle) + after, z))


def bend(case, residual):
    prepare_steady(case, residual)
    edit(case, "system/fvSchemes", "fluxScheme Kurganov", "fluxScheme HLLC")
    edit(case, "system/fvSolution", "maxIterations 500", "maxIterations 2000")
    edit(case, "system/controlDict", "patches (yMin);", "")
    edit(case, "system/controlDict", "writeFormat binary", "writeFormat ascii")
    write_block(case, box((2*LEG + TURN, WIDTH, 0.01)), (NX, NY, 1),
                {"xMin": "patch", "xMax": "patch", "yMin": "wall",
                 "yMax": "wall"})
    zero = "type zeroGradient;"
    calculated = "type calculated; value uniform 0;"

    def fixed(value):
        return f"type fixedValue; value uniform {value};"

    for name, value, inlet, outlet, wall in (
            ("p", P, zero, fixed(P), zero),
            ("T", T, fixed(T), zero, zero),
            ("U", (0, 0, 0), fixed(f"({SPEED} 0 0)"), zero, "type noSlip;"),
            ("k", K, fixed(K), zero,
             f"type kqRWallFunction; value uniform {K};"),
            ("omega", OMEGA, fixed(OMEGA), zero,
             f"type omegaWallFunction; value uniform {OMEGA};"),
            ("nut", 0.0, calculated, calculated,
             "type nutkWallFunction; value uniform 0;"),
            ("alphat", 0.0, calculated, calculated,
             "type compressible::alphatWallFunction; value uniform 0;")):
        write_field(case, name, value, {
            "xMin": inlet, "xMax": outlet, "yMin": wall, "yMax": wall,
            "zMin": "type empty;", "zMax": "type empty;"})
    must(case, "blockMesh")
    write_points(case, turned(read_points(case)))


bend("bend", 1e-6)
log = solve("bend")
after = re.search(r"Gas: steady after (\d+)", log)
verdict("bend_steady", after and int(after[1]) < 600,
        f"steady after {after[1] if after else 'no'} iterations, bound 600")

bend("bendCloser", 1e-8)
bend("bendRanks", 1e-8)
decompose("bendRanks", (1, 2, 1))
logs = [solve("bendCloser"), solve("bendRanks", 2)]
must("bendRanks", "reconstructPar")
NAMES = "p T U k omega nut"
# (meshWave's distance from a curved wall depends on the ranks, and with it the
# eddies)
fields = [last_fields(case, NAMES)
          for case in ("bendCloser", "bend", "bendRanks")]
for name, others, bounds in (("residual_suffices", fields[1], (1e-3, 5e-3)),
                             ("two_ranks", fields[2], (1e-4, 1e-3))):
    d = [abs(a - b).max()/np.ptp(b) for a, b in zip(others, fields[0])]
    verdict("bend_" + name, all("Gas: steady" in text for text in logs)
            and np.max(d[:3]) < bounds[0] and np.max(d[3:]) < bounds[1],
            "largest differences over the ranges of "
            + ", ".join(f"{n} {x:.1e}" for n, x in zip(NAMES.split(), d))
            + f", bounds {bounds[0]:g} of p T U, {bounds[1]:g} of the others")
