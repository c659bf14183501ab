# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Parcels that are mixed well before elastic walls stay so: they are not
pressed to a wall by the eddy in which they have met it."""

import numpy as np

from caseTools import edit, solve, verdict, write_foam
from turbulence import END, LIFE, N, SIDE, parcels, prepare

for name, d in ("tracers", 1e-7), ("grains", 2e-6):
    case = prepare("walls_" + name, d, 1000., LIFE/2)
    x = SIDE*((np.arange(N) + 0.5)/N - 0.5)
    write_foam(case, "constant/positions",
               "(\n" + "\n".join(f"({a!r} 2e-5 3e-5)" for a in x.tolist())
               + "\n)", "vectorField")
    edit(case, "constant/dustProperties",
         "patchInteractionModel standardWallInteraction;\n"
         "    standardWallInteractionCoeffs { type escape; }",
         "patchInteractionModel hardSphereWall; hardSphereWallCoeffs { patches"
         ' ( "x.*" { restitution 1; friction 0; } "[yz].*" { type escape; }'
         " ); }")
    solve(case)
    place, _ = parcels(case)
    near = 0.5*SIDE - np.abs(place[:, 0] + 1e-5) < 1.5e-3
    due = N*2*1.5e-3/SIDE
    verdict(f"wellMixedAtWalls_{name}",
            len(place) == N and abs(near.sum()/due - 1) < 0.3,
            f"{near.sum()} parcels within 1.5 mm of the walls after"
            f" {END/LIFE:.0f} eddies, {due:.0f} +- {np.sqrt(due):.0f} are due")
