# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Conditions in mode steady that march in time, read the compressibility, or
cells far from their patch: the steady state is that of the condition, whatever
the time step and the start."""

import numpy as np
from caseTools import (GAMMA, R_GAS, box, copy_case, edit, last_fields, must,
                       read_field, read_points, solve, times_of, verdict,
                       write_block, write_case, write_field, write_points)

P, T = 1e5, 300.0
A = np.sqrt(GAMMA*R_GAS*T)
GAS = f"psi thermo:psi; gamma {GAMMA};"
ZERO = "type zeroGradient;"
EMPTY = {"zMin": "type empty;", "zMax": "type empty;"}
TYPES = {"xMin": "patch", "xMax": "patch", "yMin": "wall", "yMax": "patch"}


def control(case, step=1, **gas):
    write_case(case, {"endTime": step, "deltaT": step, "writeInterval": step,
                      "writeFormat": "ascii"}, {"mode": "steady", **gas})


def fields(case, p, t, u, ends):
    for name, value in ("p", p), ("T", t), ("U", (u, 0.0, 0.0)):
        write_field(case, name, value, {**EMPTY, **{
            side: texts[name] for side, texts in ends.items()}})
    must(case, "blockMesh")


def fixed(p, t, u):
    return {"p": f"type fixedValue; value uniform {p!r};",
            "T": f"type fixedValue; value uniform {t!r};",
            "U": f"type fixedValue; value uniform ({u!r} 0 0);"}


FREE = {"p": ZERO, "T": ZERO, "U": ZERO}
SLIP = {"p": ZERO, "T": ZERO, "U": "type slip;"}

# A duct whose gas comes to the pressure far behind its end
for step in 1e-6, 1.0:
    case = f"waves_{step:g}"
    control(case, step, residual=1e-9)
    write_block(case, box((1, 0.1, 0.1)), (40, 2, 1), {**TYPES, "yMax": "wall"})
    fields(case, 1.05*P, T, 100.0, {
        "xMin": {
            "p": f"type totalPressure; {GAS} p0 uniform {1.1*P!r};"
                 f" value uniform {P!r};",
            "T": f"type totalTemperature; {GAS} T0 uniform {T!r};"
                 f" value uniform {T!r};",
            "U": "type pressureInletOutletVelocity; value uniform (100 0 0);"},
        "xMax": {**FREE, "p": f"type waveTransmissive; {GAS} fieldInf {P!r};"
                 f" lInf 0.5; value uniform {1.05*P!r};"},
        "yMin": SLIP, "yMax": SLIP})
    log = solve(case)
    far = abs(last_fields(case, "p")[0]/P - 1).max()
    verdict(case, "Gas: steady" in log and far < 1e-6,
            f"p within {far:.1e} of that far behind the end, bound 1e-6")

# Below a stream at Mach 2.5 a ramp of 5 degrees, from hot and cold gas
found = []
for start in 200.0, 600.0:
    case = f"freestream_{start:g}"
    u = round(2.5*A, 3)
    control(case)
    write_block(case, box((1, 0.3, 0.1)), (40, 16, 1), TYPES)
    fields(case, P, start, u, {
        "xMin": fixed(P, T, u), "xMax": FREE, "yMin": SLIP,
        "yMax": {"p": ZERO, "T": ZERO, "U":
                 f"type supersonicFreestream; UInf ({u!r} 0 0); pInf {P!r};"
                 f" TInf {T!r}; {GAS} value uniform ({u!r} 0 0);"}})
    points = read_points(case)
    rise = np.maximum(points[:, 0] - 0.2, 0)*np.tan(np.radians(5))
    points[:, 1] += rise*(1 - points[:, 1]/0.3)
    write_points(case, points)
    solve(case)
    found.append(last_fields(case, "p")[0])
far = abs(found[0]/found[1] - 1).max()
# Behind the shock of the ramp (theta-beta-M), next to the ramp and where the
# waves meet the stream above
exact = 1.37997
p = found[0].reshape(16, 40)/P
wall, above = p[0, -4:].mean(), p[-1, -4:].mean()
verdict("supersonicFreestream", far < 1e-4 and abs(wall/exact - 1) < 0.005
        and abs(above/exact - 1) < 0.01,
        f"started from 200 and 600 K p is {far:.1e} apart, bound 1e-4;"
        f" {wall:.4f} of the stream's at one wall, {above:.4f} at the other,"
        f" behind the shock {exact}, tolerances 0.5 and 1 %")

# A wall as warm as the gas in the middle of the duct, which was hot at first
case = "mapped"
control(case, viscous="yes")
write_block(case, box((1, 0.1, 0.1)), (20, 10, 1),
            {**TYPES, "yMin": "mappedPatch; sampleMode nearestCell;"
             " sampleRegion region0; samplePatch none; offsetMode uniform;"
             " offset (0 0.05 0)"})
fields(case, P, 600.0, 800.0, {
    "xMin": fixed(P, T, 800.0), "xMax": FREE, "yMax": SLIP,
    "yMin": {"p": ZERO, "U": "type noSlip;",
             "T": "type mapped; interpolationScheme cell; setAverage false;"
             " average 0; value uniform 600;"}})
edit(case, "constant/thermophysicalProperties", "As 1.458e-06", "As 1e-4")
log = solve(case)
copy_case(case, "mappedAgain")
edit("mappedAgain", "system/controlDict", "endTime 1;", "endTime 2;")
again = solve("mappedAgain")
t = last_fields(case, "T")[0].reshape(10, 20)
wall = read_field(f"{case}/{times_of(case)[-1]}/T", "yMin")
far = abs(wall - t[4]).max()
verdict("mapped", "Gas: steady" in log and "looking for" not in again
        and far < 1e-6, f"steady by another run as well; the wall is within"
        f" {far:.1e} K of the cells that it samples, bound 1e-6 K")
