# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""The heat shield of a capsule, metres across, at entry speeds: a spherical
cap with a rounded corner, where all of the internal energy of the stream is a
percent of its total energy and less. Stands in a temporary folder."""

import re

import numpy as np
from bluntBody import before, between
from caseTools import must, solve, verdict

# Radii of the cap, of the corner and of the rim [m]
CAP, CORNER, RIM = 4.69, 0.2, 1.95
CELLS = 80, 40

end = np.arcsin((RIM - CORNER)/(CAP - CORNER))
length = np.linspace(0, CAP*end + CORNER*(np.pi/2 - end), 402)
beyond = np.maximum(length - CAP*end, 0)
turn = np.minimum(length/CAP, end) + beyond/CORNER
place = np.minimum(turn, end)
normal = np.column_stack([-np.cos(turn), np.sin(turn)])
body = (CAP - CORNER)*np.column_stack([-np.cos(place), np.sin(place)]) \
    + CORNER*normal
body[:, 0] += CAP
outer = body + 0.9*(1 + length/length[-1])[:, None]*normal

for M in 10, 25:
    case = f"capsule_{M}"
    between(case, body, outer, CELLS, M)
    text = must(case, "alignMeshToShock")
    verdict(case + "_follows", "Mesh: follows the shock after" in text,
            (re.findall(r"Mesh: follows.*|The shock still.*", text)
             or ["said nothing"])[0])
    solve(case)
    rest, p, H = before(case, CELLS, M)
    scatter = np.sqrt(np.mean(H[p > 0.3*p.max()]**2))
    verdict(case, abs(rest) < 1e-3 and scatter < 2e-3,
            f"total pressure at the nose {100*rest:+.3f} % of Rayleigh's, total"
            f" enthalpy before the face within {100*scatter:.3f} % (root mean"
            " square)")
