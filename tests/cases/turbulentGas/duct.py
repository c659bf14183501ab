# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""A duct in mode steady whose inlet has next to no dissipation, and so an eddy
viscosity that no flow has: it is cut, and the gas is not called steady. Stands
in a folder of its own."""

import re

from caseTools import (box, edit, must, solve, verdict, write_block,
                       write_field, write_foam)
from plateCase import prepare_steady

CASE = "duct"

prepare_steady(CASE, 1e-6)
for file, old in (("fvSchemes", "div(phi,omega)"),
                  ("fvSchemes", "ddt(rho,omega)"),
                  ("fvSolution", '"(k|omega)"'),
                  ("fvSolution", '"(U|e|k|omega)"')):
    edit(CASE, f"system/{file}", old, old.replace("omega", "epsilon"))
write_foam(CASE, "constant/turbulenceProperties",
           "simulationType RAS;\n"
           "RAS { RASModel kEpsilon; turbulence on; printCoeffs off; }")
write_block(CASE, box((0.5, 0.05, 0.01)), (60, 20, 1),
            {"xMin": "patch", "xMax": "patch", "yMin": "wall",
             "yMax": "wall"})


def field(name, value, inlet, wall="zeroGradient", outlet="zeroGradient"):
    write_field(CASE, name, value, {
        "xMin": f"type {inlet};", "xMax": f"type {outlet};",
        "yMin": f"type {wall};", "yMax": f"type {wall};",
        "zMin": "type empty;", "zMax": "type empty;"})


def uniform(value):
    return f"fixedValue; value uniform {value}"


field("p", 1e5, "zeroGradient", outlet=uniform(1e5))
field("T", 300.0, uniform(300))
field("U", (100, 0, 0), uniform("(100 0 0)"), "noSlip")
field("k", 40.0, uniform(40), "kqRWallFunction; value uniform 40")
field("epsilon", 1e-3, uniform(1e-3), "epsilonWallFunction; value uniform 1")
calculated = "calculated; value uniform 0"
field("nut", 0.0, calculated, "nutkWallFunction; value uniform 0", calculated)
must(CASE, "blockMesh")
log = solve(CASE)

cut = re.search(r"gives (\d+) cells an eddy viscosity beyond", log)
above = re.search(r"in (\d+) cells the imbalance is above 1e-06", log)
verdict("duct_eddies_cut",
        cut and "Gas: steady" not in log and above and above[1] == "0",
        f"not steady, {cut.group(1) if cut else 'no'} cells are cut, bound 1;"
        f" imbalance above 1e-6 in {above[1] if above else 'unknown'} cells,"
        " bound 0")
