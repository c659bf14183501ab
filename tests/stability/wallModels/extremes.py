# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Parcels at the edge of what wall models meet, in a closed box of walls and in
the unmodified solver: rows for doc/stability.md."""

import math
import os
import shutil

import numpy as np

from caseTools import run
from plate import SOLVER, counters, injector, parcels, write_plate

WALLS = {side + end: "wall" for side in "xyz" for end in ("Min", "Max")}
SIZE = 0.1
BOX = "shape { type box; size (32e-6 25.6e-6 25.6e-6); }"
SPHERE = "shape { type sphere; diameter 3e-5; }"
ROUGH = ("wall { type rough; meanSpacing 80e-6; sigmaSpacing 10e-6;"
         " sigmaHeight 20e-6; treatment %s; }")
SMOOTH = "wall { type smooth; treatment %s; }"
LAW = "law { type restitution; normal 0.8; tangential 0; }"
LAZY = "law { type friction; restitution 0; friction 0.3; }"
MANY = ((0.02, 0.03, 0.04), (0.07, 0.08, 0.06), 100)
MIDDLE = ((0.05, 0.05, 0.05), (0.05, 0.05, 0.05), 1)


def row(name, expected, model, settings, rake, velocity, d, right,
        end=2e-3, step=1e-4, left=None):
    """One case; right(U, w, hits) is True if the outcome is that expected.
    left: number of parcels that are not captured; default all."""
    shutil.rmtree("case", ignore_errors=True)
    os.mkdir("case")
    write_plate("case", model, f'patches ( "[xyz]M.*" {{ {settings} }} );',
                [injector(*rake, velocity, d)], end=end, step=step,
                lengths=(SIZE,)*3, cells=(5, 4, 3), sides=WALLS)
    run("case", "blockMesh")
    status, log = run("case", "timeout", "300", SOLVER)
    good, seen = False, f"exit status {status}"
    if status == 0:
        if left == 0:
            U = L = np.zeros((0, 3))
            fine = "parcels       = 0\n" in log[log.rindex("\nTime = "):]
        else:
            U, L = parcels("case", f"{end:g}", "U", "angularMomentum")[1:]
            fine = len(U) == (rake[2] if left is None else left)
        I = 0.1*2500*math.pi/6*d**5
        hits = sum(counters(log, side)["hits"][0] for side in WALLS)
        fine = bool(fine and np.isfinite(U).all() and np.isfinite(L).all())
        good = fine and bool(right(U, L/I, hits))
        speed = np.linalg.norm(U, axis=1) if len(U) else np.zeros(1)
        seen = (f"{len(U)} of {rake[2]} parcels, {hits:.0f} hits, speeds"
                f" {speed.min():.3g} to {speed.max():.3g} m/s, spin up to"
                f" {np.abs(L/I).max(initial=0):.3g} 1/s")
    print(f"{name} | {expected} | {seen} | {'ok' if good else 'FAILED'}",
          flush=True)


def slower(U, w, hits):
    return hits > 0 and np.linalg.norm(U, axis=1).max() <= 200.0001


V = (150, -80, 60)
SPEED = np.linalg.norm(V)
H, S, N = "hardSphereWall", "semiEmpiricalRebound", "nonSphericalRebound"

row("hardSphereWall, restitution 1, friction 0", "speed kept to 1e-12", H,
    "restitution 1; friction 0;", MANY, V, 3e-5, lambda U, w, hits: hits > 100
    and np.allclose(np.linalg.norm(U, axis=1), SPEED, rtol=1e-12))
row("hardSphereWall, restitution 0", "parcels stay in their walls' planes, and"
    " roll", H, "restitution 0; friction 0.2;", MANY, V, 3e-5,
    lambda U, w, hits: slower(U, w, hits) and hits >= 100)
row("hardSphereWall, grazing at 1e-9 rad", "leaves at 0.7 times the normal"
    " speed", H, "restitution 0.7; friction 0.2;",
    ((0.02, 1e-13, 0.05), (0.02, 1e-13, 0.05), 1), (100, -1e-7, 0), 3e-5,
    lambda U, w, hits: hits == 1 and abs(U[0, 1]/0.7e-7 - 1) < 1e-6,
    end=4e-4)
row("hardSphereWall, straight down, no slip", "straight up at 0.7 times the"
    " speed, no spin", H, "restitution 0.7; friction 0.2;", MIDDLE,
    (0, -100, 0), 3e-5, lambda U, w, hits: hits == 1 and abs(
        U[0, 1] - 70) < 1e-10 and abs(w).max() == 0, end=8e-4)
row("hardSphereWall, grains of 20 nm", "spin of the order of V/r = 2e10 1/s",
    H, "restitution 0.7; friction 0.5;", MANY, V, 2e-8,
    lambda U, w, hits: slower(U, w, hits) and 1e9 < np.abs(w).max() < 1e11)
row("hardSphereWall, into an edge of two walls", "comes back", H,
    "restitution 1; friction 0;", MIDDLE, (-100, -100, 0), 3e-5,
    lambda U, w, hits: hits >= 2 and np.allclose(U[0], (100, 100, 0)),
    end=8e-4)
row("hardSphereWall, into a corner of three walls", "comes back", H,
    "restitution 1; friction 0;", MIDDLE, (-100, -100, -100), 3e-5,
    lambda U, w, hits: hits >= 3 and np.allclose(U[0], (100, 100, 100)),
    end=8e-4)
row("semiEmpiricalRebound, e_N = e_T = 0", "stops at the wall", S,
    "normal 0; tangential 0; criticalAngle 0;", MIDDLE, (70, -100, 0), 3e-5,
    lambda U, w, hits: hits >= 1 and np.abs(U).max() < 1e-9)
row("nonSphericalRebound, box, rough, one step of many impacts",
    "slows down", N, f"{BOX} {ROUGH % 'untilExit'} {LAW}", MANY, V, 3.4e-5,
    lambda U, w, hits: hits > 500 and np.linalg.norm(U, axis=1).mean()
    < 0.5*SPEED, end=1e-2, step=1e-2)
row("nonSphericalRebound, box, smooth, firstImpact", "parcels sent into the"
    " wall strike again at once", N, f"{BOX} {SMOOTH % 'firstImpact'} {LAW}",
    MANY, V, 3.4e-5, lambda U, w, hits: hits > 200)
row("nonSphericalRebound, grazing a rough wall at 1e-9 rad", "is scattered", N,
    f"{BOX} {ROUGH % 'untilExit'} {LAW}",
    ((0.02, 1e-13, 0.05), (0.02, 1e-13, 0.05), 1), (100, -1e-7, 0), 3.4e-5,
    lambda U, w, hits: hits >= 1 and abs(U[0, 1]) > 1e-3, end=4e-4)
row("nonSphericalRebound, sphere without restitution, rough", "slows down,"
    " rolling on the relief", N, f"{SPHERE} {ROUGH % 'untilExit'} {LAZY}",
    ((0.02, 0.03, 0.04), (0.07, 0.08, 0.06), 10), V, 3e-5, slower)
row("nonSphericalRebound, body of 0.1 mm on relief of 80 nm", "rebounds as on"
    " a smooth wall, near 0.8 times the normal speed", N,
    f"{SPHERE} wall {{ type rough; meanSpacing 80e-9; sigmaSpacing 1e-8;"
    f" sigmaHeight 1e-10; }} {LAW}", MIDDLE, (70, -100, 0), 1e-4,
    lambda U, w, hits: abs(U[0, 1] - 80) < 8, end=6e-4)

J = "jkrAdhesion"
STEEL = "contact { modulus 50e9; workOfAdhesion 0.1528; } friction 0.3;"
LAYER = "layer { modulus 36.55648e9; workOfAdhesion 0.0607; }"
GRAZING = ((0.02, 1e-13, 0.05), (0.02, 1e-13, 0.05), 1)
row("jkrAdhesion, grains of 20 nm", "adhere at 180 m/s", J,
    f"{STEEL} alpha 1.1891; {LAYER}", MANY, V, 2e-8,
    lambda U, w, hits: hits == 100, left=0)
row("jkrAdhesion, grazing at 1e-9 rad", "adheres", J,
    f"{STEEL} alpha 0; {LAYER}", GRAZING, (100, -1e-7, 0), 3e-5,
    lambda U, w, hits: hits == 1, end=4e-4, left=0)
row("jkrAdhesion, alpha 3", "all adhere at any speed", J,
    f"{STEEL} alpha 3; {LAYER}", MANY, (1.5e4, -8e3, 6e3), 3e-5,
    lambda U, w, hits: hits == 100, left=0)
row("jkrAdhesion, alpha 0, body of 1 cm", "straight up at its speed", J,
    f"{STEEL} alpha 0; {LAYER}", MIDDLE, (0, -100, 0), 1e-2,
    lambda U, w, hits: hits == 1 and 99.999 < U[0, 1] <= 100, end=8e-4)
row("jkrAdhesion, many grains on a layer of themselves, steps of many"
    " impacts", "all adhere in the end", J, f"{STEEL} alpha 0.2; {LAYER}",
    ((0.02, 0.03, 0.04), (0.02, 0.03, 0.04), 100), (15, -8, 6), 3e-5,
    lambda U, w, hits: hits >= 100, end=10, step=1, left=0)
