# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""The same plate in mode steady, against what the march in time comes to;
stands in a folder of its own."""

import os
import re
import shutil

import numpy as np
from caseTools import (GAMMA, R_GAS, copy_case, decompose, edit, largest,
                       last_fields, must, same_bits, solve, times_of, verdict,
                       write_foam)
from plateCase import (END, K, P, SST, T, U, WALL_T, prepare, prepare_steady,
                       wall)

LATE = 2e-3     # six passages of the stream, boundary layer at rest to 3e-8


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
log = solve("steady")
iterations = steady_after(log)
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
verdict("steady_as_in_time", largest(d[:3]) < 5e-4 and largest(d) < 0.01,
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
d = largest(abs(a - b).max()/abs(b).max() for a, b in
            zip(last_fields("steady", names), last_fields("closer", names)))
verdict("residual_suffices", d < 1e-4,
        f"residual 1e-6 and 1e-7 differ by {d:.1e}, bound 1e-4")

copy_case("closer", "again")
different = ("steady since an earlier run" not in solve("again")) * ["log"]
different += same_bits("closer", "again", times_of("closer")[-1], names)
verdict("steady_restarted", not different,
        "goes on from its steady state; different: "
        + (" ".join(different) or "nothing"))

prepare_steady("steadyRanks", 1e-7)
decompose("steadyRanks", (2, 1, 1))
solve("steadyRanks", 2)
must("steadyRanks", "reconstructPar")
d = largest(abs(a - b).max()/abs(b).max() for a, b in
            zip(last_fields("steadyRanks", names),
                last_fields("closer", names)))
verdict("steady_two_ranks", d < 1e-5,
        f"residual 1e-7: two ranks differ by {d:.1e}, bound 1e-5")

# A mesh that resolves the wall layer, beside the pressure-based stock solver;
# HLLC, since the central fluxes thicken the layer
prepare_steady("resolved", 1e-6, n=(40, 48), grading="(10 1500 1)")
edit("resolved", "system/fvSchemes", "fluxScheme Kurganov", "fluxScheme HLLC")
edit("resolved", "0/k", f"kqRWallFunction; value uniform {K}",
     "fixedValue; value uniform 1e-8")
coarse, log = log, solve("resolved")
# (the stock one from its fields, less far from where its own residuals end)
copy_case("resolved", "stock")
ended = times_of("stock")[-1]
for name in "p T U k omega nut alphat".split():
    os.replace(f"stock/{ended}/{name}", f"stock/0/{name}")
shutil.rmtree(f"stock/{ended}")
write_foam("stock", "system/fvSchemes", """
ddtSchemes { default steadyState; }
gradSchemes { default Gauss linear; limited cellLimited Gauss linear 1; }
divSchemes { default bounded Gauss linearUpwind limited;
    div(phid,p) Gauss upwind; div((phi|interpolate(rho)),p) Gauss linear;
    div(phi,k) bounded Gauss upwind; div(phi,omega) bounded Gauss upwind;
    div(((rho*nuEff)*dev2(T(grad(U))))) Gauss linear; }
laplacianSchemes { default Gauss linear corrected; }
interpolationSchemes { default linear; }
snGradSchemes { default corrected; }
wallDist { method meshWave; }""")
write_foam("stock", "system/fvSolution", """
solvers { "(p|U|e|k|omega)" { solver PBiCGStab; preconditioner DILU;
    tolerance 1e-10; relTol 0.01; } }
SIMPLE { transonic yes; rhoMin 0.1; rhoMax 5; pMinFactor 0.5; pMaxFactor 2;
    residualControl { p 1e-7; U 1e-7; } }
relaxationFactors { fields { p 0.5; rho 0.2; }
    equations { p 0.9; "(U|e|k|omega)" 0.5; } }""")
for key, value in (("endTime", 5000), ("writeInterval", 5000), ("deltaT", 1),
                   ("adjustTimeStep", "no")):
    must("stock", "foamDictionary", "system/controlDict", "-entry", key,
         "-set", str(value))
must("stock", "rhoSimpleFoam")
to_wall = [-wall(case, times_of(case)[-1], "wallHeatFlux")[-1, 0]
           for case in ("steady", "resolved")]
verdict("heat_of_wall_functions_warned_of",
        "heat flux of patch yMin is not to be relied on" in coarse
        and "not to be relied on" not in log
        and -0.5 < to_wall[0]/to_wall[1] < 0.5,
        f"at the end {1e-3*to_wall[0]:.0f} kW/m2 to the wall with wall"
        f" functions, {1e-3*to_wall[1]:.0f} without; a warning with, none"
        " without")
iterations = steady_after(log)
verdict("resolved_steady", iterations, f"steady after {iterations} iterations")
a, b = (wall(case, times_of(case)[-1])[4:, 0] for case in ("resolved", "stock"))
verdict("resolved_wallShearStress", abs(a/b - 1).max() < 0.02,
        f"at most {100*abs(a/b - 1).max():.2f} % from rhoSimpleFoam, bound 2 %")

# Heat and friction are in proportion (Reynolds' analogy; the model's turbulent
# Prandtl number is 1, so that a wall without heat has the total temperature)
cp = GAMMA*R_GAS/(GAMMA - 1)
friction = -a*P/(R_GAS*WALL_T)
heat = -wall("resolved", times_of("resolved")[-1], "wallHeatFlux")[4:, 0]
factor = heat*U/(friction*cp*(T + 0.5*U**2/cp - WALL_T))
verdict("resolved_wallHeatFlux", factor.min() > 1.05 and factor.max() < 1.3,
        f"2 St/cf {factor.min():.3f} to {factor.max():.3f}, bounds 1.05 and"
        " 1.3")
