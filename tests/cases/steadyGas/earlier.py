# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Gas that an earlier run has left steady is taken as it is, or not if the
case is another one by now."""

import os

from bluntBody import prepare
from caseTools import (GAMMA, R_GAS, box, copy_case, edit, last_fields, must,
                       solve, times_of, verdict, write_block,
                       write_case, write_field)

FROZEN = "steady since an earlier run"


def again(case, source, changes):
    copy_case(source, case)
    for path, old, new in [("system/controlDict", "endTime 1;",
                            "endTime 2;")] + changes:
        edit(case, path, old, new)
        if path.startswith("1/"):   # whose sum is not that of the list
            os.remove(f"{case}/1/uniform/complete")
    return solve(case)


prepare("first", "sphere", (24, 24), 2.0, 3, {"mode": "steady"})
solve("first")
log = again("same", "first", [])
verdict("steady_gas_is_taken_as_it_is",
        FROZEN in log and "looking for" not in log, "no march")

flux = [("system/fvSchemes", "fluxScheme HLLC", "fluxScheme Kurganov")]
log = again("otherFlux", "first", flux)
verdict("another_flux_marches",
        FROZEN not in log and "not steady any more" in log
        and "Gas: steady after" in log, "said, and marched anew")

# Six digits are enough to know the gas again
prepare("short", "sphere", (24, 24), 2.0, 3, {"mode": "steady"})
edit("short", "system/controlDict", "writePrecision 16;", "writePrecision 6;")
edit("short", "system/controlDict", "binary;", "ascii;")
solve("short")
log = again("shortSame", "short", [])
verdict("six_digits_will_do", FROZEN in log, "no march")

# Conditions whose entries change, not the values that they had in the file
write_case("duct", {"endTime": 1, "deltaT": 1, "writeInterval": 1,
                    "writeFormat": "ascii", "writePrecision": 17},
           {"mode": "steady", "residual": 1e-8})
write_block("duct", box((1, 0.1, 0.1)), (20, 2, 1),
            {"xMin": "patch", "xMax": "patch", "yMin": "wall", "yMax": "wall"})
GAS = f"psi thermo:psi; gamma {GAMMA};"
for name, value, inlet, outlet, wall in (
        ("p", 1e5, f"totalPressure; {GAS} p0 uniform 1.1e5",
         "fixedValue", "zeroGradient"),
        ("T", 300.0, f"totalTemperature; {GAS} T0 uniform 300",
         "zeroGradient", "zeroGradient"),
        ("U", (0, 0, 0), "pressureInletOutletVelocity", "zeroGradient",
         "slip")):
    given = "(0 0 0)" if name == "U" else repr(value)
    write_field("duct", name, value, {
        "xMin": f"type {inlet}; value uniform {given};",
        "xMax": f"type {outlet}; value uniform {given};",
        "yMin": f"type {wall};", "yMax": f"type {wall};",
        "zMin": "type empty;", "zMax": "type empty;"})
must("duct", "blockMesh")
solve("duct")
log = again("ductSame", "duct", [])


def body(path):
    with open(path, encoding="utf-8") as file:
        return file.read().split("dimensions")[1]


different = [f for f in "pTU" if body(f"duct/1/{f}")
             != body(f"ductSame/2/{f}")]
verdict("reservoir_is_known_again", FROZEN in log and "looking for" not in log
        and not different, "no march; different files: "
        + (" ".join(different) or "none"))
for field, old, new in ("p", 110000, 150000), ("T", 300, 500):
    log = again("another_" + field, "duct", [
        (f"1/{field}", f"{field}0              uniform {old};",
         f"{field}0 uniform {new};")])
    p, T, U = last_fields("another_" + field, "p T U")
    T0 = T + (GAMMA - 1)/(2*GAMMA)*(U**2).sum(axis=1)/R_GAS
    found = {"p": p*(T0/T)**(GAMMA/(GAMMA - 1)), "T": T0}[field]
    far = abs(found/new - 1).max()
    verdict(f"another_{field}0_marches", "not steady any more" in log
            and "Gas: steady after" in log and far < 1e-3,
            f"{field}0 of the gas within {far:.1e} of the new one")

# A march in time leaves no steady gas
short = [("system/fvSolution", "mode steady", "mode transient"),
         ("system/controlDict", "endTime 2;", "endTime 1.000002;"),
         ("system/controlDict", "deltaT 1;", "deltaT 2e-6;"),
         ("system/controlDict", "writeInterval 1;", "writeInterval 2e-6;")]
again("thenInTime", "first", short)
last = times_of("thenInTime")[-1]
with open(os.path.join("thenInTime", last, "uniform", "highSpeedGas"),
          encoding="utf-8") as file:
    verdict("time_leaves_no_mark", "imbalance" not in file.read(),
            f"uniform/highSpeedGas at {last}")
