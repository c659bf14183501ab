# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""A closed tube that is emptied into nearly a vacuum, and filled out of a
reservoir, against exact mass flows until the first wave has come to its end;
stands in a temporary folder."""

import numpy as np

from caseTools import (GAMMA, R_GAS, box, last_fields, must, solve, verdict,
                       write_block, write_case, write_field)

P, T, N, END = 1e5, 300.0, 200, 1.5e-3
SOUND = np.sqrt(GAMMA*R_GAS*T)


def mass_gained(case, pressure, temperature, velocity):
    """Of a tube of 1 m with the given conditions at its end, over what was in
    it."""
    write_case(case, {"endTime": END, "deltaT": 1e-6, "writeInterval": END},
               {"mode": "transient"})
    write_block(case, box((1, 0.01, 0.01)), (N, 1, 1),
                {"xMin": "wall", "xMax": "patch"})
    sides = {s + e: "type empty;" for s in "yz" for e in ("Min", "Max")}
    write_field(case, "p", P, dict(sides, xMin="type zeroGradient;",
                                   xMax=pressure))
    write_field(case, "T", T, dict(sides, xMin="type zeroGradient;",
                                   xMax=temperature))
    write_field(case, "U", (0, 0, 0), dict(sides, xMin="type slip;",
                                           xMax=velocity))
    must(case, "blockMesh")
    solve(case)
    return last_fields(case, "rho")[0].mean()/(P/(R_GAS*T)) - 1


# A centred fan up to the speed of sound
share = 2/(GAMMA + 1)
exact = -share**(2/(GAMMA - 1))*share*SOUND*END
for kind, entries in (("fixedValue", "value uniform 100;"),
                      ("fixedMean", "meanValue constant 100;"
                       " value uniform 100;"),
                      ("outletInlet", "outletValue uniform 100;"
                       " value uniform 100;")):
    gained = mass_gained("discharge_" + kind, f"type {kind}; {entries}",
                         "type zeroGradient;", "type zeroGradient;")
    verdict("discharge_" + kind, abs(gained/exact - 1) < 2e-3,
            f"{-100*gained:.3f} % of the mass have left, exact"
            f" {-100*exact:.3f} %, tolerance 0.2 % of it")

# A shock into gas at rest, behind it what the reservoir gives at that pressure
for ratio in 1.5, 3.0:
    low, high = P, ratio*P
    for _ in range(60):
        p = 0.5*(low + high)
        behind = SOUND*(p/P - 1)/GAMMA/np.sqrt(
            1 + 0.5*(GAMMA + 1)/GAMMA*(p/P - 1))
        Tp = T*(p/(ratio*P))**((GAMMA - 1)/GAMMA)
        comes = np.sqrt(2*GAMMA*R_GAS/(GAMMA - 1)*(T - Tp))
        low, high = (p, high) if behind < comes else (low, p)
    exact = p/Tp*comes*END/(P/T)
    gained = mass_gained(
        f"filling_{ratio}",
        f"type totalPressure; p0 uniform {ratio*P!r}; gamma {GAMMA};"
        f" psi thermo:psi; value uniform {P};",
        f"type totalTemperature; T0 uniform {T}; gamma {GAMMA};"
        f" psi thermo:psi; value uniform {T};",
        "type pressureInletOutletVelocity; value uniform (0 0 0);")
    verdict(f"filling_{ratio}", abs(gained/exact - 1) < 2e-3,
            f"{100*gained:.3f} % of the mass have come in, exact"
            f" {100*exact:.3f} %, tolerance 0.2 % of it")
