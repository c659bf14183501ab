# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""The same plate in mode steady, against what the march in time comes to;
stands in a folder of its own."""

import re

import numpy as np
from caseTools import (copy_case, decompose, edit, last_fields, must,
                       same_bits, solve, times_of, verdict)
from plateCase import END, SST, prepare, wall

LATE = 2e-3     # six passages of the stream, boundary layer at rest to 3e-8


def prepare_steady(case, residual, model=SST, fields="k omega"):
    prepare(case, model)
    edit(case, "system/fvSchemes", "ddtSchemes { default Euler; }",
         "ddtSchemes { default Euler; "
         + " ".join(f"ddt(rho,{f}) steadyState;" for f in fields.split())
         + " }")
    edit(case, "system/fvSolution", "highSpeedGas { mode transient; }",
         "highSpeedGas { mode steady; residual %g;"
         " maxIterations 500; }\n"
         "relaxationFactors { equations { \"(%s)\" 0.7; } }"
         % (residual, fields.replace(" ", "|")))


def steady_after(log):
    found = re.search(r"Gas: steady after (\d+) iterations", log)
    return int(found.group(1)) if found else None


prepare_steady("steady", 1e-6)
prepare_steady("closer", 1e-7)
prepare("late", SST)
for old, new in ((f"endTime {END}", f"endTime {LATE}"),
                 (f"writeInterval {END/2}", f"writeInterval {LATE}"),
                 ("maxCo 0.2", "maxCo 0.5")):
    edit("late", "system/controlDict", old, new)
iterations = steady_after(solve("steady"))
verdict("steady", iterations and iterations < 400,
        f"steady after {iterations} iterations, bound 400")
solve("closer")
solve("late")

# The equations are the same, the limiters are not: in mode steady small
# differences pass them, and cells are uniform in the shock of the edge
time, late = times_of("steady")[-1], times_of("late")[-1]
names = "p T U k omega nut"
d = [np.abs(a - b).sum()/np.abs(b).sum() for a, b in
     zip(last_fields("steady", names), last_fields("late", names))]
verdict("steady_as_in_time", max(d[:3]) < 5e-4 and max(d) < 0.01,
        "mean difference to the march in time "
        + ", ".join(f"{n} {x:.1e}" for n, x in zip(names.split(), d))
        + "; bounds 5e-4 of p T U, 0.01 of the others")
for name in "wallShearStress", "wallHeatFlux":
    a, b = (wall(case, t, name)[1:, 0]
            for case, t in (("steady", time), ("late", late)))
    d = abs(a/b - 1).max()
    verdict(f"steady_{name}", d < 0.01,
            f"at most {d:.1e} from the march in time behind the first cell,"
            " bound 1e-2")
d = max(abs(a - b).max()/abs(b).max() for a, b in
        zip(last_fields("steady", names), last_fields("closer", names)))
verdict("residual_suffices", d < 1e-4,
        f"residual 1e-6 and 1e-7 differ by {d:.1e}, bound 1e-4")

copy_case("closer", "again")
log = solve("again")
different = same_bits("closer", "again", times_of("closer")[-1], names)
verdict("steady_restarted", "steady since an earlier run" in log
        and not different,
        "goes on from its steady state; different: "
        + (" ".join(different) or "nothing"))

prepare_steady("ranks", 1e-7)
decompose("ranks", (2, 1, 1))
solve("ranks", 2)
must("ranks", "reconstructPar")
d = max(abs(a - b).max()/abs(b).max() for a, b in
        zip(last_fields("ranks", names), last_fields("closer", names)))
verdict("steady_two_ranks", d < 1e-5,
        f"residual 1e-7: two ranks differ by {d:.1e}, bound 1e-5")
