# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""What paraviewPictures has drawn in a run of the tutorial (argument)."""

import os
import sys

import matplotlib.pyplot as plt
import numpy as np
from caseTools import verdict

os.chdir(sys.argv[1])
WIDTH, HEIGHT = 1000, 960
SCALE = HEIGHT/(2*1.95)     # pixels in a radius
picture = (plt.imread("paraview.png")[:, :, :3]
           if os.path.exists("paraview.png") else np.ones((HEIGHT, WIDTH, 3)))
column, row = np.meshgrid(np.arange(WIDTH), np.arange(HEIGHT))
x = (column - WIDTH/2)/SCALE - 0.05
y = 1.8 - (row - HEIGHT/2)/SCALE
r, phi = np.hypot(x, y), np.degrees(np.arctan2(y, -x))
bright, vivid = picture.max(axis=2), np.ptp(picture, axis=2)
blue = picture[..., 2] - picture[..., 0]

wall = abs(r - 1) < 0.01
near, far = (wall & (abs(phi - p) < 5) for p in (5, 85))
verdict("paraview_wall", np.median(bright[near]) > 0.8
        and np.median(vivid[near]) > 0.3
        and np.median(bright[far]) < 0.1,
        f"{np.median(bright[near]):.2f}, {np.median(vivid[near]):.2f} at the"
        f" stagnation point, {np.median(bright[far]):.2f} at 85 degrees")
stream, layer = ((phi > 0) & (phi < 5) & (abs(r - s) < 0.02)
                 for s in (1.5, 1.3))
verdict("paraview_gas", np.median(blue[stream]) > 0.15
        and 0 < np.median(blue[layer]) < 0.1,
        f"{np.median(blue[stream]):.3f} upstream of the shock,"
        f" {np.median(blue[layer]):.3f} behind it")
flow = (r > 1.06) & (phi > 1) & (phi < 95) & (x < 0.3)
spinning, still = (np.sum(flow & (vivid > 0.5)), np.sum(flow & (bright < 0.4)))
verdict("paraview_parcels", spinning > 2000 and still > 500,
        f"{spinning} pixels of spinning, {still} of other parcels")
film = b""
if os.path.exists("sandFront.ogv"):
    with open("sandFront.ogv", "rb") as file:
        film = file.read()
verdict("paraview_animation", film[:4] == b"OggS" and b"theora" in film[:100]
        and len(film) > 2e5, f"{len(film)} bytes")
