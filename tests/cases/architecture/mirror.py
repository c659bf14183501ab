# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""The wall model of doc/architecture.md in a stock solver, from a library of
its own: mirror.py FOLDER_OF_THE_LIBRARY"""

import sys

import numpy as np

from caseTools import complaint, run, verdict
from plate import SOLVER, injector, mesh, parcels, solve, write_plate

OPEN = '"[xz]M.*" { type escape; } yMax { type escape; }'


def main():
    libs = ("parcelInjection parcelWallInteraction"
            f' "{sys.argv[1]}/libmirrorWall.so"')
    beam = injector((0.4, 0.005, 0.09), (0.4, 0.005, 0.11), 3,
                    (30, -40, 5), 30e-6)
    write_plate("mirror", "mirrorWall",
                f"patches ( yMin {{ }} {OPEN} );", [beam], libs=libs)
    mesh("mirror")
    solve("mirror")
    _, U = parcels("mirror", "0.0004", "U")
    verdict("wall_model_is_selectable",
            len(U) == 3 and np.allclose(U, (30, 40, 5), rtol=0, atol=1e-12),
            f"velocities behind the wall {U}")
    write_plate("entry", "mirrorWall",
                f"patches ( yMin {{ silver 1; }} {OPEN} );", [beam], libs=libs)
    mesh("entry")
    status, said = run("entry", SOLVER)
    verdict("wall_model_refuses_entries", status and "silver" in said,
            complaint(said))


main()
