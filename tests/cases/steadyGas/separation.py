# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Laminar Mach 6 flow off a plate before a ramp: what the steady march finds at
rest stays as it is when the gas goes on in time."""

import re
import shutil

import numpy as np
from caseTools import (GAMMA, R_GAS, box, edit, last_fields, must, run, verdict,
                       write_block, write_case, write_field)

MACH, P, T, WALL_T = 6, 1500.0, 100.0, 300.0
LENGTH, HEIGHT, CORNER, ANGLE = 0.08, 0.04, 0.04, np.radians(24)
NX, NY = 100, 48
TIME = 6e-5         # the stream passes the ramp twice


def bend(case):
    """Raise the bottom of the box behind the corner, less towards the top."""
    path = f"{case}/constant/polyMesh/points"
    with open(path) as file:
        head, body = file.read().split("\n(\n")
    points = np.array([row.split() for row in
                       re.findall(r"^\(([^()]*)\)$", body, re.M)], float)
    ramp = np.maximum(points[:, 0] - CORNER, 0)*np.tan(ANGLE)
    points[:, 1] += ramp*(1 - points[:, 1]/HEIGHT)
    with open(path, "w") as file:
        file.write(head + "\n(\n" + "\n".join(
            "({!r} {!r} {!r})".format(*map(float, p)) for p in points)
            + "\n)\n")


def prepare(case):
    write_case(case, {"endTime": 1, "deltaT": 1, "writeInterval": 1,
                      "writeFormat": "ascii"},
               {"mode": "steady", "viscous": "yes", "residual": 1e-7},
               flux="Kurganov", limiter="vanLeer")
    write_block(case, box((LENGTH, HEIGHT, 0.01)), (NX, NY, 1),
                {"xMin": "patch", "xMax": "patch", "yMin": "wall",
                 "yMax": "patch"}, "(1 60 1)")
    U = MACH*np.sqrt(GAMMA*R_GAS*T)
    zero = "type zeroGradient;"
    for name, value, wall in (("p", P, zero), ("U", (U, 0, 0), "type noSlip;"),
                              ("T", T, "type fixedValue; value uniform"
                               f" {WALL_T};")):
        text = f"({U!r} 0 0)" if name == "U" else repr(value)
        inflow = f"type fixedValue; value uniform {text};"
        write_field(case, name, value, {
            "xMin": inflow, "yMax": inflow, "xMax": zero, "yMin": wall,
            "zMin": "type empty;", "zMax": "type empty;"})
    must(case, "blockMesh")
    bend(case)


def separated(case):
    """Where the gas next to the wall begins to flow back, and where it ends to
    [m]."""
    U, C = (f.reshape(NY, NX, 3)[0] for f in last_fields(case, "U C"))
    along = np.where(C[:, 0] < CORNER, U[:, 0],
                     U[:, 0]*np.cos(ANGLE) + U[:, 1]*np.sin(ANGLE))
    at = np.flatnonzero(along[1:]*along[:-1] < 0)
    x = C[at, 0] + (C[at + 1, 0] - C[at, 0])*along[at]/(along[at]
                                                      - along[at + 1])
    return (x.min(), x.max()) if len(x) > 1 else (np.nan, np.nan)


prepare("ramp")
status, text = run("ramp", "rhoCentralParcelFoam")
verdict("limiter_advised", "with limiter vanLeer the way to a steady" in text,
        "mode steady does not advise against vanLeer")
must("ramp", "postProcess", "-func", "writeCellCentres", "-latestTime")
steady = re.search(r"steady after (\d+)", text)
ends = separated("ramp")
verdict("ramp_steady", steady and ends[1] - ends[0] > 0.1*CORNER,
        f"steady after {steady.group(1) if steady else '-'} iterations, flow"
        f" back from {1e3*ends[0]:.2f} to {1e3*ends[1]:.2f} mm")

# In steps of its own: 1/uniform has that of the steady march
shutil.copytree("ramp", "onward")
shutil.rmtree("onward/1/uniform")
edit("onward", "system/fvSolution", "mode steady", "mode transient")
edit("onward", "system/controlDict", "endTime 1;", f"endTime {1 + TIME!r};")
edit("onward", "system/controlDict", "deltaT 1;",
     "deltaT 1e-9; adjustTimeStep yes; maxCo 0.5;")
edit("onward", "system/controlDict", "writeInterval 1;",
     f"writeInterval {TIME!r};")
must("onward", "rhoCentralParcelFoam")
must("onward", "postProcess", "-func", "writeCellCentres", "-latestTime")
later = separated("onward")
verdict("ramp_stays", np.allclose(later, ends, rtol=0, atol=2e-3*CORNER),
        f"after {1e6*TIME:.0f} us flow back from {1e3*later[0]:.2f} to"
        f" {1e3*later[1]:.2f} mm, tolerance 2e-3 of the plate")

# Both schemes leave it there, too, when they do not know that it is steady
for scheme in "implicit", "RK3":
    case = f"again_{scheme}"
    shutil.copytree("ramp", case)
    shutil.rmtree(f"{case}/1/uniform")
    edit(case, "system/fvSolution", "mode steady;",
         f"mode steady; scheme {scheme};"
         + (" maxCo 0.5; maxIterations 100;" if scheme == "RK3" else ""))
    edit(case, "system/controlDict", "endTime 1;", "endTime 2;")
    text = must(case, "rhoCentralParcelFoam")
    again = re.search(r"steady after (\d+)", text)
    verdict(f"ramp_{scheme}_again", again and int(again.group(1)) <= 2,
            f"steady after {again.group(1) if again else '-'} iterations"
            " from there")
