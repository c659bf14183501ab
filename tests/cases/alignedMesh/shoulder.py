# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""A flat-faced cylinder, round whose shoulder the pressure at the wall falls
steeply, where no shock is; stands in a temporary folder."""

import re

import numpy as np
from bluntBody import before, between
from caseTools import largest, must, verdict

MACH, CELLS, EDGE = 12, (60, 40), 0.2

# From the axis along the face and round the shoulder, in radii
length = np.linspace(0, 1 - EDGE + EDGE*np.pi/2, 402)
turn = np.maximum(length - (1 - EDGE), 0)/EDGE
body = np.column_stack([EDGE*(1 - np.cos(turn)), np.minimum(length, 1 - EDGE)
                        + EDGE*np.sin(turn)])
angle = np.linspace(0, np.pi/2, 402)
outer = np.column_stack([0.2 - 1.7*np.cos(angle), 3*np.sin(angle)])

between("shoulder", body, outer, CELLS, MACH)
text = must("shoulder", "alignMeshToShock")
bands = [float(band) for band in re.findall(r"Mesh: band of (\S+),", text)]
rest = before("shoulder", CELLS, MACH)[0]
verdict("shoulder", "Mesh: follows the shock" in text and largest(bands) < 0.5
        and abs(rest) < 1e-3,
        f"bands of {largest(bands):g} and less, total pressure at the nose"
        f" {100*rest:+.3f} % of Rayleigh's")
