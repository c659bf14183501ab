# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Supersonic flow along a plate in time; stands in a folder of its own."""

import os

from caseTools import (copy_case, decompose, edit, largest, last_fields, must,
                       same_bits, solve, verdict)
from plateCase import END, SST, prepare, wall

prepare("ours", SST)
for case in "restarted", "ranks":
    copy_case("ours", case)
solve("ours")
stress = -wall("ours", f"{END:g}")[:, 0]
nut, = last_fields("ours", "nut")
verdict("eddies", nut.max() > 1e-3 and stress[4:].min() > 0,
        f"nut up to {nut.max():.1e} m2/s, wanted 1e-3; stress over density"
        f" {stress[4:].min():.0f} to {stress[4:].max():.0f} m2/s2")
missing = [f for f in ("wallShearStress", "yPlus", "wallHeatFlux",
                       "turbulenceProperties:R")
           if not os.path.exists(os.path.join("ours", f"{END:g}", f))]
verdict("functionObjects", not missing,
        "missing: " + (" ".join(missing) or "none"))

prepare("laminar", "simulationType laminar;")
edit("laminar", "system/controlDict", f"endTime {END}", "endTime 2e-6")
edit("laminar", "system/controlDict", f"writeInterval {END/2}",
     "writeInterval 2e-6")
edit("laminar", "system/controlDict", "type turbulenceFields",
     "enabled no; type turbulenceFields")
solve("laminar")
verdict("functionObjectsLaminar",
        os.path.exists("laminar/2e-06/wallShearStress"),
        "wallShearStress in laminar flow")

edit("restarted", "system/controlDict", f"endTime {END}", f"endTime {END/2}")
solve("restarted")
edit("restarted", "system/controlDict", f"endTime {END/2}", f"endTime {END}")
solve("restarted")
different = same_bits("ours", "restarted", f"{END:g}", "p T U k omega nut")
verdict("restartBitwise", not different,
        "straight run = restarted run; different: "
        + (" ".join(different) or "nothing"))

decompose("ranks", (2, 1, 1))
solve("ranks", 2)
must("ranks", "reconstructPar")
d = [abs(x - y).max()/abs(x).max()
     for x, y in zip(last_fields("ours", "p T U k omega"),
                     last_fields("ranks", "p T U k omega"))]
verdict("twoRanks", largest(d) < 1e-5,
        f"largest relative difference {largest(d):.1e}, tolerance 1e-5 (the"
        " linear solvers of k and omega stop at a residual)")
