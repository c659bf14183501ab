# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""A wedge without swirl is solved in its section. A trace of swirl, which
changes nothing else, has it solved with three components: both are to agree."""

import re

import numpy as np
from bluntBody import SOUND, prepare
from caseTools import (decompose, edit, largest, last_fields, must, run,
                       solve, verdict, write_field)

CELLS, MACH = (24, 24), 3
SPEED = MACH*SOUND


def velocity(case, swirl, body, inlet=None):
    U = np.zeros((CELLS[0]*CELLS[1], 3))
    U[:, 0] = SPEED
    U[5, 2] = swirl*SPEED
    write_field(case, "U", U, {
        "axis": "type empty;", "front": "type wedge;", "back": "type wedge;",
        "outlet": "type zeroGradient;", "body": f"type {body};",
        "inlet": inlet
        or f"type fixedValue; value uniform ({SPEED!r} 0 0);"})


def apart(a, b):
    return largest(np.abs(x - y).max()/np.abs(y).max() for x, y in zip(a, b))


def compare(name, gas, edits, body, bound):
    fields, said = [], []
    for swirl in (0, 2e-6):
        case = name + ("Swirl" if swirl else "")
        prepare(case, "sphere", CELLS, 2.0, MACH, gas)
        for path, old, new in edits:
            edit(case, path, old, new)
        velocity(case, swirl, body)
        text = solve(case)
        said.append(re.search(r"Gas: (\d-D.*),", text)[1])
        p, T, U = last_fields(case, "p T U")
        fields.append((p, T, U[:, :2]))
    verdict(name + "_is_solved_in_its_section",
            said == ["2-D, axisymmetric without swirl", "3-D"],
            " and ".join(said))
    far = apart(*fields)
    verdict(name + "_as_with_three_components", far < bound,
            f"p, T and U are {far:.1e} apart, bound {bound}")
    return fields[0]


VISCOUS = {"residual": 1e-9, "viscous": "yes"}

# Hot and thick enough for friction and heat to reach everywhere
thick = [("constant/thermophysicalProperties", "As 1.458e-06", "As 1e-4")]
steady = compare("steadyWedge", VISCOUS, thick, "noSlip", 1e-7)
transient = [("system/controlDict", f"{name} 1;", f"{name} {value};")
             for name, value in (("endTime", 4e-6), ("deltaT", 2e-8),
                                 ("writeInterval", 4e-6))]
compare("wedgeInTime", {"mode": "transient"}, transient, "slip", 1e-9)

prepare("twoRanks", "sphere", CELLS, 2.0, MACH, VISCOUS)
for path, old, new in thick:
    edit("twoRanks", path, old, new)
velocity("twoRanks", 0, "noSlip")
decompose("twoRanks")
solve("twoRanks", 2)
must("twoRanks", "reconstructPar", "-latestTime")
p, T, U = last_fields("twoRanks", "p T U")
far = apart((p, T, U[:, :2]), steady)
verdict("section_on_two_ranks", far < 1e-7, f"{far:.1e} apart, bound 1e-7")

# An inlet that begins to turn later
prepare("late", "sphere", CELLS, 2.0, MACH, {"mode": "transient"})
for path, old, new in transient:
    edit("late", path, old, new)
velocity("late", 0, "slip",
         "type uniformFixedValue; uniformValue table"
         f" ((0 ({SPEED!r} 0 0)) (1e-6 ({SPEED!r} 0 0))"
         f" (2e-6 ({SPEED!r} 0 50)));"
         f" value uniform ({SPEED!r} 0 0);")
status, text = run("late", "rhoCentralParcelFoam")
verdict("swirl_that_begins_later_is_refused",
        status and "go around the axis" in text and "patch inlet" in text,
        f"exit code {status}")
