# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Grains that heat up and begin to melt while they are taken along, in a
uniform gas, in time steps of several relaxation times and in ones forty times
shorter: the tolerance, not the time step, is to decide on the error."""

import re

import numpy as np

from caseTools import (box, copy_case, edit, largest, must, read_field, solve,
                       times_of, verdict, write_block, write_case,
                       write_field, write_foam)
from spinningCloud import write_cloud

END = 1e-3
GAS = 180.0, 60.0, 0.0
TOLERANCES = {"coarse": 1e-3, "usual": 1e-5, "fine": 1e-8}

case = "longStep"
write_case(case, {"endTime": END, "deltaT": END, "writeInterval": END,
                  "writeFormat": "ascii", "writePrecision": 16,
                  "libs": "(spinningParcel parcelForces parcelInjection)"},
           {"mode": "frozen"})
write_block(case, box((1, 1, 1)), (4, 4, 4),
            {s + e: "cyclic" for s in "xyz" for e in ("Min", "Max")})
sides = {s + e: "type cyclic;" for s in "xyz" for e in ("Min", "Max")}
write_field(case, "p", 2e4, sides)
write_field(case, "T", 650.0, sides)
write_field(case, "U", GAS, sides)
must(case, "blockMesh")
for name, tolerance in TOLERANCES.items():
    write_cloud(
        case, name, """
        type rakeInjection; start (0.37 0.41 0.53); end (0.37 0.41 0.53);
        nParcels 1; diameter 8e-6; U0 (-20 50 20);""",
        forces="singhDrag;", walls="patchInteractionModel none;",
        models="heatTransferModel kavanau;", solution="heatTransfer on;",
        constants="""rho0 2200; T0 350; Cp0 (600 0.5); epsilon0 0.8;
        TSurroundings 900;
        melting { solidus 500; liquidus 560; latentHeat 2e5; }""",
        tolerance=tolerance)
write_foam(case, "constant/parcelClouds", f"clouds ({' '.join(TOLERANCES)});")
short = copy_case(case, "shortStep")
edit(short, "system/controlDict", f"deltaT {END};", f"deltaT {END/40};")
log = solve(case)
solve(short)

uncontrolled = [int(n) for n in re.findall(
    r"uncontrolled, at rest *= *(\d+),", log)]
verdict("longStep_is_controlled", uncontrolled and not any(uncontrolled),
        f"steps without error control: {uncontrolled}")


def grain(folder, name):
    last = f"{folder}/{times_of(folder)[-1]}/lagrangian/{name}"
    return read_field(f"{last}/T")[0], read_field(f"{last}/U")[0]


T, U = grain(short, "fine")
lag = np.linalg.norm(U - GAS)
verdict("longStep_melts_and_follows", 550 < T < 560 and 0 < lag < 5,
        f"{T:.1f} K, between solidus and the liquidus of 560 K, {lag:.2f} m/s"
        " from the gas")
for name, tolerance in TOLERANCES.items():
    t, u = grain(case, name)
    dT, dU = abs(t - T)/210, abs(u - U).max()/201
    verdict(f"longStep_{name}", largest(dT, dU) < 10*tolerance,
            f"tolerance {tolerance:.0e}: {dT:.1e} of its heating by 210 K and"
            f" {dU:.1e} of its slip of 201 m/s at the start from short steps,"
            " bound ten times the tolerance")
