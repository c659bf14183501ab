# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Solid particles of dsmcParcelFoam that spin: what a wall with friction and
mirrors leave of it, its decay in a gas, balances, restart to the bit, two
ranks, and when it is followed."""

import csv
import filecmp
import glob
import os
import re
import shutil

import numpy as np

from caseTools import (copy_case, decompose, edit, hard_sphere, largest, must,
                       read_field, times_of, verdict, write_block, write_foam)
from dsmcTools import NITROGEN, refuses, solve, write_gas
from solidTools import (NUMBER, PROPERTIES, changes, fill, read_solids,
                        write_solids)

PERIODIC = dict.fromkeys(("xMin", "xMax", "yMin", "yMax", "zMin", "zMax"),
                         "cyclic")
THIN = {"density": 1e12, "weight": 1e3}     # no force worth the name
L = 0.01
E, F = 0.8, 0.11
STEP = 2.**-17      # of which times are exact sums
FRICTION = f"{{ type hardSphereWall; restitution {E}; friction {F}; }}"


def spins(case, time):
    """The particles in the order of their identities."""
    s = read_solids(case, time)
    for name in ("omega", "origId"):
        s[name] = read_field(f"{case}/{time}/lagrangian/solids/{name}")
    order = np.lexsort((s["origId"], s["origProcId"]))
    return {k: v[order] for k, v in s.items()}


def set_spins(case, time, omega):
    """All with the same spin; what there is at this time."""
    s = spins(case, time)
    n = len(s["d"])
    write_foam(case, f"{time}/lagrangian/solids/omega",
               f"{n}\n(\n" + "({} {} {})\n".format(*omega)*n + ")",
               "vectorField")
    os.remove(f"{case}/{time}/uniform/complete")
    return s


def replayed(a, duration):
    """Their velocities and spins after flights between mirrors across y and
    at x = 0, and a wall with friction at x = L."""
    U, omega = a["U"].copy(), a["omega"].copy()
    hits = 0
    for i in range(len(U)):
        x, left = a["x"][i].copy(), duration
        while True:
            v = U[i]
            times = [(L - x[d])/v[d] if v[d] > 0 else -x[d]/v[d]
                     for d in (0, 1)]
            d = int(np.argmin(times))
            if times[d] > left:
                break
            left -= times[d]
            x += times[d]*v
            n = np.zeros(3)
            n[d] = -np.sign(v[d])
            x[d] = L if v[d] > 0 else 0
            if d == 0 and v[0] > 0:
                hits += 1
                U[i], omega[i] = hard_sphere(v, omega[i], n, a["d"][i]/2, E, F)
            else:
                U[i] = v - 2*(v @ n)*n
                omega[i] = 2*(omega[i] @ n)*n - omega[i]
    return U, omega, hits


def check_replay(name, case):
    first, *_, last = times_of(case)[1:]
    a, b = spins(case, first), spins(case, last)
    U, omega, hits = replayed(a, float(last) - float(first))
    scale = np.abs(omega).max()
    worst = largest(np.abs(b["U"] - U).max()/50,
                    np.abs(b["omega"] - omega).max()/scale)
    verdict(name, len(U) == 80 and hits > 80 and scale > 1e6
            and np.abs(omega).min(axis=0).max() > 0 and worst < 1e-6,
            f"{hits} hits of {len(U)} particles, spins up to {scale:.3g}"
            f" rad/s, off by {worst:.1e}")


def differing(case, again, places):
    """Files of some folders that are not the same to the last bit."""
    return [f"{d}/{f}" for place in places
            for d, _, files in os.walk(f"{case}/{place}") for f in files
            if not filecmp.cmp(f"{d}/{f}", f"{d}/{f}".replace(case, again, 1),
                               False)]


# --- a wall with friction, and mirrors, which turn a spin as an axial vector
types = dict(PERIODIC, xMin="symmetryPlane", xMax="wall",
             yMin="symmetryPlane", yMax="symmetryPlane")
write_gas("oblique", types, (4, 4, 4), (L, L, L), **THIN, collisions="none",
          control={"deltaT": STEP, "endTime": 128*STEP, "writeInterval": 16})
write_solids(
    "oblique", fill(1e-9, (50, 30, -20), simulators=40)
    + f"walls {{ xMax {FRICTION} }}\ncloudFunctions {{ records"
    " { type impactRecords; patches (xMax); } }\n", exchange="none",
    walls=None)
copy_case("oblique", "obliqueTwo")
for name, more in (("obliqueNo", "rotation no;\n"), ("obliqueSmooth", "")):
    copy_case("oblique", name)
    edit(name, PROPERTIES, "reportEvery", more + "reportEvery")
edit("obliqueSmooth", PROPERTIES, f"friction {F}", "friction 0")
log = solve("oblique")
check_replay("spin_afterWallAndMirrors", "oblique")
told = re.findall(rf"greatest spin: {NUMBER} rad/s", log)
end = times_of("oblique")[-1]
now = spins("oblique", end)
greatest = np.sqrt((now["omega"]**2).sum(axis=1)).max()
verdict("spin_isReported", "    spin: followed\n" in log and told
        and abs(float(told[-1])/greatest - 1) < 1e-4,
        f"{told[-1:]} of {greatest:.5g} rad/s")
with open(glob.glob("oblique/postProcessing/records/solids/0/*.csv")[0]) \
        as file:
    rows = list(csv.DictReader(line for line in file if line[0] != "#"))
worst, before = 0, 0
for row in rows:
    V, w, V1, w1 = (
        np.array([float(row[q + c + o]) for c in "xyz"]) if q == "U" else
        np.array([float(row[q + c + o]) for c in "XYZ"])
        for q, o in (("U", ""), ("omega", ""), ("U", "Out"),
                     ("omega", "Out")))
    U, omega = hard_sphere(V, w, (-1, 0, 0), float(row["d"])/2, E, F)
    worst = largest(worst, np.abs(omega - w1).max()/np.abs(omega).max())
    before += np.abs(w).max() > 0
verdict("spin_inImpactRecords", before > 20 and worst < 1e-5,
        f"{len(rows)} impacts, {before} with a spin before, off by"
        f" {worst:.1e}")

# --- it goes with its particle from rank to rank, and over a restart
decompose("obliqueTwo", (2, 2, 1))
solve("obliqueTwo", 4)
copy_case("obliqueTwo", "obliqueTwoAgain")
places = [f"processor{r}/{end}" for r in range(4)]
for place in places:
    shutil.rmtree(f"obliqueTwoAgain/{place}")
solve("obliqueTwoAgain", 4)
differ = differing("obliqueTwo", "obliqueTwoAgain", places)
verdict("spin_ranksRestart", not differ, f"differ: {differ[:5]}")
must("obliqueTwo", "reconstructPar")
check_replay("spin_ranks", "obliqueTwo")

# --- a cyclic patch that turns a velocity by 90 degrees turns the spin, too
types = dict(PERIODIC, xMin="patch", xMax="patch")
write_gas("sector", types, (4, 4, 2), **THIN, collisions="none",
          initialise=False, control={"deltaT": STEP, "endTime": STEP,
                                     "writeInterval": 1})
write_block("sector", [(x, y, z) for z in (0, 0.06) for x, y in (
    (0.02, 0), (0.1, 0), (0, 0.1), (0, 0.02))], (4, 4, 2), types)
for side in ("yMin", "yMax"):
    edit("sector", "system/blockMeshDict", f"neighbourPatch {side};",
         f"neighbourPatch {side}; transform rotational; rotationAxis (0 0 1);"
         " rotationCentre (0 0 0);")
must("sector", "blockMesh")
must("sector", "dsmcInitialise")
write_solids("sector", fill(1e-9, (-300, 400, 50), simulators=200)
             + "rotation yes;\n", exchange="none", walls=None)
solve("sector")
start = times_of("sector")[-1]
a = set_spins("sector", start, (3e5, 1e5, -2e5))
edit("sector", "system/controlDict", f"endTime {STEP}", f"endTime {17*STEP}")
solve("sector")
b = spins("sector", times_of("sector")[-1])
a = {k: v[np.isin(a["origId"], b["origId"])] for k, v in a.items()}
angle = np.pi/2*np.round(2/np.pi*(np.arctan2(b["U"][:, 1], b["U"][:, 0])
                                  - np.arctan2(a["U"][:, 1], a["U"][:, 0])))
c, s = np.cos(angle), np.sin(angle)
wanted = np.column_stack([3e5*c - 1e5*s, 3e5*s + 1e5*c, -2e5 + 0*c])
turned = (np.abs(s) > 0.5).sum()
worst = np.abs(b["omega"] - wanted).max()
verdict("spin_turnedBySectors", turned > 50 and worst < 1e-4,
        f"{turned} of {len(c)} turned, off by {worst:.1e} rad/s")

# --- when it is followed
for name, told in (("obliqueNo", "spin: not followed, rotation no"),
                   ("obliqueSmooth", "spin: not followed, no wall gives any")):
    log = solve(name)
    verdict(f"spin_{name}", told in log and "greatest spin" not in log
            and not glob.glob(f"{name}/*/lagrangian/solids/omega"), told)
other = read_solids("obliqueNo", end)
verdict("spin_changesRebounds", np.abs(
    np.sort(now["U"], axis=0) - np.sort(other["U"], axis=0)).max() > 0.1,
        "velocities differ from those without it")

# --- a directory of before, without a file omega
copy_case("oblique", "old")
names = times_of("old")
shutil.rmtree(f"old/{names[-1]}")
for file in ("lagrangian/solids/omega", "uniform/complete"):
    os.remove(f"old/{names[-2]}/{file}")
edit("old", "system/controlDict", "writeInterval 16", "writeInterval 1")
log = solve("old")
early = spins("old", times_of("old")[len(names) - 1])
verdict("spin_ofAnOldDirectory", "no spin at the start" in log
        and f"{names[-2]}/lagrangian/solids has no file omega" in log
        and (early["omega"] == 0).all(axis=1).sum() > 40
        and np.isfinite(spins("old", end)["omega"]).all(),
        f"{(early['omega'] == 0).all(axis=1).sum()} without spin a step later")

# --- decay in a gas at rest, by Epstein's torque, with balance and restart
d, T, n, spin = 1e-6, 300., 1e23, np.array([6e8, 0., -8e8])
m = NITROGEN["mass"]
mean = np.sqrt(8*1.380649e-23*T/(np.pi*m))
M = 2700*np.pi/6*d**3
rate = 2*np.pi/3*n*m*mean*(d/2)**4/(0.4*M*(d/2)**2)
# Bodies of perCollision also take up what thermal motion gives to them, and
# turn less if they are light
for exchange, weight, concentration, number, tolerance in (
        ("perCell", 1e12, 1e-4, 1000, 0.03),
        ("perCollision", 1e11, 1e-3, 100, 0.08)):
    case = "decay_" + exchange
    write_gas(case, PERIODIC, (4, 4, 4), (0.004,)*3, weight=weight, density=n,
              T=T, gas={"N2": NITROGEN}, collisions="none",
              control={"deltaT": STEP, "endTime": STEP, "writeInterval": 1})
    write_solids(case, fill(concentration, T=T, simulators=number)
                 + "rotation yes;\n", exchange=exchange, walls=None,
                 diameters=(d,))
    solve(case)
    start = times_of(case)[-1]
    set_spins(case, start, spin)
    edit(case, "system/controlDict", f"endTime {STEP}",
         f"endTime {81*STEP}")
    edit(case, "system/controlDict", "writeInterval 1", "writeInterval 40")
    log = solve(case)
    worst = changes(log)
    end = times_of(case)[-1]
    t = float(end) - float(start)
    left = spins(case, end)["omega"].mean(axis=0) @ spin/(spin @ spin)
    verdict(f"{case}_rate", abs(-np.log(left)/(rate*t) - 1) < tolerance
            and rate*t > 1 and worst.max() < 1e-12
            and "exchange by the cell" not in log,
            f"{left:.4f} are left, {np.exp(-rate*t):.4f} by the law; greatest"
            f" changes {worst}")
    copy_case(case, case + "_again")
    shutil.rmtree(f"{case}_again/{end}")
    solve(case + "_again")
    differ = differing(case, case + "_again", [end])
    verdict(f"{case}_restart", not differ, f"differ: {differ[:5]}")

# --- left to itself where there is no law for it, it says why; else refused
write_gas("corrected", dict(PERIODIC, yMin="wall", yMax="wall"), (2, 2, 2),
          (0.004,)*3, weight=1e14, density=n, T=T, gas={"N2": NITROGEN},
          collisions="LarsenBorgnakkeVariableHardSphere",
          control={"deltaT": STEP, "endTime": STEP})
write_solids("corrected", fill(1e-4, T=T, simulators=10)
             + f'walls {{ "y.*" {FRICTION} }}\n'
             "knudsenCorrection { drag singhDrag; heat kavanau; }\n",
             walls=None, diameters=(d,))
log = solve("corrected")
verdict("spin_notWithACorrection", "spin: not followed, knudsenCorrection"
        in log, "the log says why")
for name, old, new, texts in (
        ("word", "reportEvery", "rotation maybe; reportEvery",
         ["solidParticleProperties", "maybe"]),
        ("correction", "reportEvery", "rotation yes; reportEvery",
         ["Entry rotation yes", "knudsenCorrection", "rotation no"]),
        ("deflection", "knudsenCorrection { drag singhDrag; heat kavanau; }",
         "rotation yes; deflection polynomial;",
         ["Entry rotation yes", "deflection polynomial", "rotation no"])):
    case = copy_case("corrected", f"bad_rotation_{name}")
    shutil.rmtree(f"{case}/{times_of(case)[-1]}")
    edit(case, PROPERTIES, old, new)
    refuses(f"refuses_rotation_{name}", case, texts)
