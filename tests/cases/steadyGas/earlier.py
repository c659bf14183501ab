# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Gas that an earlier run has left steady is taken as it is, or not if the
case is another one by now."""

import os

from bluntBody import prepare
from caseTools import copy_case, edit, solve, times_of, verdict

FROZEN = "steady since an earlier run"


def again(case, source, changes):
    copy_case(source, case)
    for path, old, new in [("system/controlDict", "endTime 1;",
                            "endTime 2;")] + changes:
        edit(case, path, old, new)
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
