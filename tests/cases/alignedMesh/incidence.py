# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""A round nose with straight flanks at incidence, in few layers: before the lee
side the layers reach far beyond the shock, whose cells are then the last ones.
That is no reason to widen the band, or it goes to and fro."""

import re

import numpy as np
from bluntBody import CP, P, RADIUS, SOUND, T, pitot
from caseTools import (box, last_fields, must, read_points, verdict,
                       write_block, write_case, write_field, write_points)

MACH, LAYERS, ALONG = 8, 24, 72
FLANK, LENGTH = np.radians(10), 3


def body(s):
    """Place and outward normal, in radii, at arc lengths from the nose: along
    the stream's axis, and away from it."""
    arc = np.pi/2 - FLANK
    t = np.minimum(s, arc)
    beyond = np.maximum(s - arc, 0)
    normal = np.stack([-np.cos(t), np.sin(t)])
    return np.stack([1 - np.cos(t) + beyond*np.cos(FLANK),
                     np.sin(t) + beyond*np.sin(FLANK)]), normal


def prepare(case, incidence):
    write_case(case, {"endTime": 1, "deltaT": 1, "writeInterval": 1,
                      "writeFormat": "ascii"},
               {"mode": "steady"}, "HLLC", "vanAlbada")
    ends = {"yMin": "patch", "yMax": "patch"}
    sides = {"zMin": "empty", "zMax": "empty"}
    write_block(case, box((1, 1, 0.1)), (LAYERS, ALONG, 1),
                {"xMin": "wall", "xMax": "patch", **ends, **sides})
    must(case, "blockMesh")
    away, along, across = read_points(case).T
    share = np.abs(2*along - 1)
    end = np.pi/2 - FLANK + (LENGTH - 1 + np.sin(FLANK))/np.cos(FLANK)
    place, normal = body(share*end)
    x, y = RADIUS*(place + 1.2*(1 + 2.2*share)*away*normal)
    write_points(case, np.stack([x, np.copysign(y, 0.5 - along),
                                 RADIUS*across], axis=1))
    angle = np.radians(incidence)
    U = MACH*SOUND*np.cos(angle), MACH*SOUND*np.sin(angle), 0
    for name, value in ("p", P), ("T", T), ("U", U):
        write_field(case, name, value, {
            "xMin": "type slip;" if name == "U" else "type zeroGradient;",
            "xMax": "type fixedValue; value $internalField;",
            **{side: "type zeroGradient;" for side in ends},
            **{side: "type empty;" for side in sides}})


for incidence in 15, 25:
    case = f"incidence_{incidence}"
    prepare(case, incidence)
    text = must(case, "alignMeshToShock")
    verdict(case + "_follows", "Mesh: follows the shock after" in text,
            (re.findall(r"Mesh: follows.*|The shock still.*", text)
             or ["said nothing"])[0])
    p, t, U = last_fields(case, "p T U")
    highest = p.max()/(P*pitot(MACH)) - 1
    H = (CP*t + 0.5*(U**2).sum(axis=1))/(CP*T + 0.5*(MACH*SOUND)**2) - 1
    layer = p > 2*P
    verdict(case + "_highest_pressure", abs(highest) < 3e-3,
            f"{100*highest:+.2f} % of Rayleigh's")
    scatter = np.sqrt(np.mean(H[layer]**2))
    verdict(case + "_total_enthalpy", scatter < 2e-3,
            f"{100*scatter:.2f} % root mean square behind the shock")
