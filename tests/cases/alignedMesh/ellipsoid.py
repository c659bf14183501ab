# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""A slender ellipsoid in cells longer along its nose than the layer of gas
between that and the shock is thick: within their length the pressure rises as
in a shock, where none is. Stands in a temporary folder."""

import re

import numpy as np
from bluntBody import before, between
from caseTools import must, solve, verdict

MACH, LENGTH, RADIUS = 8, 0.125, 0.05

turn = np.linspace(0, np.pi/2, 402)
body = np.column_stack([LENGTH*(1 - np.cos(turn)), RADIUS*np.sin(turn)])
normal = np.column_stack([-RADIUS*np.cos(turn), LENGTH*np.sin(turn)])
normal /= np.linalg.norm(normal, axis=1)[:, None]
outer = body + 0.6*RADIUS*(1 + turn/turn[-1])[:, None]*normal

for cells in (30, 40), (40, 60):
    case = f"ellipsoid_{cells[0]}"
    between(case, body, outer, cells, MACH)
    text = must(case, "alignMeshToShock")
    solve(case)
    rest, _, H = before(case, cells, MACH)
    worst = np.abs(H[:cells[1]//2]).max()
    verdict(case, "Mesh: follows the shock after" in text
            and abs(rest) < 3e-3 and worst < 6e-3,
            f"total pressure at the nose {100*rest:+.2f} % of Rayleigh's, total"
            f" enthalpy within {100*worst:.2f} %; "
            + (re.findall(r"Mesh: follows.*|The shock still.*", text)
               or ["said nothing"])[0])
