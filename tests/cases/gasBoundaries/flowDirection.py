# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Conditions that ask whether gas flows in or out: a duct between a reservoir
(totalPressure, totalTemperature) and a boundary that lets waves leave."""

import numpy as np
from caseTools import (GAMMA, R_GAS, box, copy_case, decompose, edit, largest,
                       last_fields, must, same_bits, solve, verdict,
                       write_block, write_case, write_field)

P, T, U = 1e5, 300.0, 100.0
M2 = U*U/(GAMMA*R_GAS*T)
# (Rounded, as boundary conditions write their constants with few digits)
P0 = round(P*(1 + 0.5*(GAMMA - 1)*M2)**(GAMMA/(GAMMA - 1)), 4)
T0 = round(T*(1 + 0.5*(GAMMA - 1)*M2), 6)
N, END = 80, 2e-3


def duct(case, bump):
    """Uniform flow with a rise of pressure in the middle."""
    # (Boundary values that are uniform are written as text: 17 digits are
    # what a restart to the last bit needs)
    write_case(case, {"endTime": END, "deltaT": 1e-5, "writeInterval": END/2,
                      "writePrecision": 17}, {"mode": "transient"})
    write_block(case, box((1, 0.1, 0.1)), (N, 2, 1),
                {"xMin": "patch", "xMax": "patch", "yMin": "wall",
                 "yMax": "wall"})
    sides = {"zMin": "type empty;", "zMax": "type empty;"}
    walls = {s: "type zeroGradient;" for s in ("yMin", "yMax")}
    slip = {s: "type slip;" for s in ("yMin", "yMax")}
    p = P*(1 + bump*np.exp(-((np.arange(2*N) % N - N/2)/5)**2))
    write_field(case, "p", p, {
        **sides, **walls,
        "xMin": f"type totalPressure; psi thermo:psi; gamma {GAMMA};"
                f" p0 uniform {P0!r}; value uniform {P};",
        "xMax": f"type waveTransmissive; psi thermo:psi; gamma {GAMMA};"
                f" fieldInf {P}; lInf 1; value uniform {P};"})
    write_field(case, "T", T, {
        **sides, **walls,
        "xMin": f"type totalTemperature; psi thermo:psi; gamma {GAMMA};"
                f" T0 uniform {T0!r}; value uniform {T};",
        "xMax": f"type inletOutlet; inletValue uniform {T};"
                f" value uniform {T};"})
    write_field(case, "U", (U, 0, 0), {
        **sides, **slip,
        "xMin": "type pressureInletOutletVelocity;"
                f" value uniform ({U} 0 0);",
        "xMax": "type pressureInletOutletVelocity;"
                f" value uniform ({U} 0 0);"})
    must(case, "blockMesh")


# A flow that satisfies all of them stays as it is from the first step on
duct("still", 0)
solve("still")
p, t, u, _ = last_fields("still")
d = largest(abs(p/P - 1).max(), abs(t/T - 1).max(), abs(u[:, 0]/U - 1).max())
verdict("uniformFlowStays", d < 1e-6,
        f"largest relative change {d:.1e}, tolerance 1e-6")

# A pulse leaves; a restart halfway goes the same way, and so do two ranks
duct("straight", 0.2)
for case in "restarted", "ranks":
    copy_case("straight", case)
solve("straight")
p, t, u, _ = last_fields("straight")
d = abs(p/P - 1).max()
verdict("pulseMoves", 1e-3 < d < 0.1,
        f"pressure differs by {d:.1e} from that of the reservoir's flow, of a"
        " pulse of 0.2; wanted 1e-3 to 0.1")

edit("restarted", "system/controlDict", f"endTime {END}", f"endTime {END/2}")
solve("restarted")
edit("restarted", "system/controlDict", f"endTime {END/2}", f"endTime {END}")
solve("restarted")
different = same_bits("straight", "restarted", f"{END:g}")
verdict("restartBitwise", not different,
        "straight run = restarted run; different: "
        + (" ".join(different) or "nothing"))

decompose("ranks", (2, 1, 1))
solve("ranks", 2)
must("ranks", "reconstructPar")
q, s, v, _ = last_fields("ranks")
d = largest(abs(q/p - 1).max(), abs(s/t - 1).max(), abs(v - u).max()/U)
verdict("twoRanks", d < 1e-10,
        f"largest relative difference {d:.1e}, tolerance 1e-10")
