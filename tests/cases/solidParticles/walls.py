# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""The wall models and cloud functions of all clouds, on solid particles of
dsmcParcelFoam: erosion and heat of a known beam, adhesion with its layer,
bodies that are no spheres; restart to the bit, two ranks, refusals."""

import csv
import filecmp
import math
import os
import re
import shutil

import numpy as np

from adhesionCurve import (ALPHA, MODULUS, RHO, WORK, restitution,
                           separation_speed)
from caseTools import (copy_case, decompose, edit, largest, read_field,
                       times_of, verdict)
from dsmcTools import refuses, solve, write_gas
from solidTools import PROPERTIES, read_solids, tally, write_solids

TYPES = {"xMin": "patch", "xMax": "wall", "yMin": "cyclic", "yMax": "cyclic",
         "zMin": "cyclic", "zMax": "cyclic"}
SIZES = (10e-6, 20e-6)


def beam(case, wall, U, more="", steps=200, gas=None):
    """Grains of two sizes, half of the mass each, fly in near vacuum from
    xMin onto xMax, 0.02 m away, in some 20 steps; 2e-6 kg/s over 1e-4 m2.
    Steps are a power of two: times add up without rounding."""
    step = 2**round(math.log2(1e-3/U[0]))
    write_gas(case, TYPES, (8, 4, 4), (0.02, 0.01, 0.01), density=1e12,
              weight=1e3, collisions="none", inflow="FreeStream",
              **(gas or {}),
              more="FreeStreamCoeffs { numberDensities { Ar 1e12; }"
              " patches (xMin); }\n",
              control={"deltaT": step, "endTime": steps*step,
                       "writeInterval": steps//2})
    write_solids(
        case, "inflows { xMin { massFlow 2e-6; velocity"
        f" ({U[0]!r} {U[1]!r} {U[2]!r});"
        " temperature 800; simulatorsPerStep (3.3 2.1); } }\n"
        f"walls {{ xMax {{ {wall} }} }}\n" + more, diameters=SIZES,
        density=RHO, walls=None, exchange="none")


def table(case, function="surfaceImpact"):
    """The line of xMax in the last byPatch.csv."""
    time = times_of(case)[-1]
    with open(f"{case}/postProcessing/{function}/solids/{time}/"
              "byPatch.csv") as file:
        return {k: float(v) if v else math.nan for k, v in
                next(csv.DictReader(file)).items() if k != "patch"}


def kept(case, fate):
    """Mass of a fate, with all digits."""
    with open(f"{case}/{times_of(case)[-1]}/uniform/solidParticlesState") \
            as file:
        return float(re.search(
            rf"\n{fate}\s*{{[^}}]*mass\s+(\S+);", file.read()).group(1))


def layer(case):
    """Mass on xMax, where all faces are alike in size."""
    mass = read_field(f"{case}/{times_of(case)[-1]}/solids:adheredMass",
                      "xMax")
    return np.broadcast_to(mass, 16).mean()*1e-4


def restarts(case, ranks=1):
    """The files of the second half that are not the same to the last bit where
    it goes on from the time between. Of several ranks the sums of masses are
    left out: the master goes on with those of all."""
    sums = {"solidParticlesState", "complete"} if ranks > 1 else set()
    again = case + "Again"
    copy_case(case, again)
    last = times_of(f"{case}/processor0" if ranks > 1 else case)[-1]
    places = [f"processor{r}/{last}" for r in range(ranks)] \
        if ranks > 1 else [last]
    for place in places:
        shutil.rmtree(f"{again}/{place}")
    solve(again, ranks)
    return [f"{d}/{f}" for place in places
            for d, _, files in os.walk(f"{case}/{place}")
            for f in set(files) - sums if not filecmp.cmp(f"{d}/{f}", f"{d}/{f}".replace(
                case, again, 1), False)]


# --- what surfaceImpact says of a beam whose every number is known
IMPACT = ("cloudFunctions { surfaceImpact { type surfaceImpact;"
          " patches (xMax); window { start 7.62939453125e-4; } erosion { model Finnie;"
          " p 1e9; K 2; psi 2; } heat { wallTemperature 300; } log yes; } }\n")
beam("struck", "type stick;", (100, 0, 0), IMPACT)
log = solve("struck")
row = table("struck")
flux = 2e-6/1e-4
expected = {"massFlux": flux, "capturedMassFlux": flux,
            "meanNormalSpeed": 100, "impactAngle": 90,
            "specificPowerIncident": 5e3*flux, "specificPower": 5e3*flux,
            "specificHeatIncident": 900*500*flux,
            "heatFlux": (5e3 + 900*500)*flux}
off = {k: abs(row[k]/v - 1) for k, v in expected.items()}
verdict("surfaceImpact_ofABeam", largest(off.values()) < 0.01,
        " ".join(f"{k} {v:.1e}" for k, v in off.items()))
with open("struck/postProcessing/surfaceImpact/solids/0/impacts.csv") as file:
    rows = list(csv.DictReader(line for line in file if line[0] != "#"))
ids = {(r["origProc"], r["origId"]) for r in rows}
verdict("surfaceImpact_identities", len(ids) == len(rows) > 400
        and all(abs(float(r["T"])/800 - 1) < 1e-12 for r in rows)
        and "Wall impacts: hardSphereWall, patch xMax" in log,
        f"{len(ids)} identities in {len(rows)} impacts at 800 K")
differ = restarts("struck")
verdict("surfaceImpact_restart", not differ, f"differ: {differ[:5]}")

# --- adhesion: the large rebound with the restitution of the static curve,
# the small stay, and the layer is what has been deposited
WALL = (f"type jkrAdhesion; contact {{ modulus {MODULUS}; workOfAdhesion"
        f" {WORK}; }} alpha {ALPHA}; friction 0.3;")
LAYER = " layer { modulus 36.55648e9; workOfAdhesion 0.0607; }"
low, high = 1., 60.
for _ in range(30):     # of the least speed of rebound over that of separation
    middle = 0.5*(low + high)
    low, high = ((low, middle) if restitution(ALPHA, middle) > 0
                 else (middle, high))
speed = round(1.3*low*separation_speed(SIZES[1]), 6)
beam("adheres", WALL, (speed, 0, 0))
log = solve("adheres")
s = read_solids("adheres", times_of("adheres")[-1])
back = s["U"][:, 0] < 0
e = restitution(ALPHA, speed/separation_speed(SIZES[1]))
worst = np.abs(-s["U"][back, 0]/speed - e).max()
stuck = tally(log, "stuck")
verdict("jkrAdhesion_capturesTheSmall", back.sum() > 10
        and (s["group"][back] == 1).all() and stuck[0] > 500
        and worst < 5e-5,
        f"{stuck[0]:.0f} stay, {back.sum()} come back with e_n {e:.5f} within"
        f" {worst:.1e}")
held, stuck = layer("adheres"), kept("adheres", "stuck")
verdict("jkrAdhesion_layerIsWhatWasDeposited", abs(held/stuck - 1) < 1e-12,
        f"{held:.6e} of {stuck:.6e} kg")
differ = restarts("adheres")
verdict("jkrAdhesion_restart", not differ, f"differ: {differ[:5]}")

# --- what comes off the layer flies again, with its size, in the balance, and
# with the spin of a sphere that one push at its side moves, 5/2 v/r
beam("comesOff", WALL + LAYER, (10*speed, 3*speed, 0), steps=600,
     more="fills { layer { region box; box (0.015 0 0) (0.02 0.01 0.01);"
     f" concentration 0.5; velocity ({0.5*speed!r} 0 0); temperature 400;"
     " simulators 2000; } }\n")
copy_case("comesOff", "comesOffTwo")
log = solve("comesOff")
s = read_solids("comesOff", times_of("comesOff")[-1])
released = s["origProcId"] == 1000000
detached = re.findall(r"detached particles += (\S+)", log)
mass = (RHO*np.pi/6*s["d"]**3*s["nParticle"]).sum()
spin = read_field(f"comesOff/{times_of('comesOff')[-1]}/lagrangian/solids/"
                  "omega")[released]
off = np.abs(spin[:, 2] + 5*s["U"][released, 1]/s["d"][released]).max() \
    / np.abs(spin).max()
stuck, entered, left, initial = (
    kept("comesOff", k) for k in ("stuck", "entered", "left", "initial"))
held = layer("comesOff")
verdict("jkrAdhesion_releases", released.sum() > 10
        and float(detached[-1]) > 0
        and set(np.round(s["d"][released]*1e6, 9)) <= {10., 20.}
        and (s["U"][released, 0] < 0).all()
        and spin[:, 2].min() < -1e5 and off < 1e-6
        and abs(held/stuck - 1) < 1e-12
        and abs((mass + stuck + left)/(entered + initial) - 1) < 1e-12,
        f"{released.sum()} in flight of {detached[-1:]} real ones detached,"
        f" spins to {spin[:, 2].min():.3g} rad/s, off by {off:.1e},"
        f" layer {held:.6e} of {stuck:.6e} kg")
differ = restarts("comesOff")
verdict("jkrAdhesion_releasesRestart", not differ, f"differ: {differ[:5]}")
decompose("comesOffTwo", (1, 2, 1))
log = solve("comesOffTwo", 2)
two = tally(log, "stuck")
verdict("jkrAdhesion_twoRanks", abs(two[2]/stuck - 1) < 0.05
        and float(re.findall(r"detached particles += (\S+)", log)[-1]) > 0,
        f"{two[2]:.4e} of {stuck:.4e} kg stay")
differ = restarts("comesOffTwo", 2)
verdict("jkrAdhesion_twoRanksRestart", not differ, f"differ: {differ[:5]}")

# --- spheroids on a smooth wall without friction or loss: the tangential
# velocity stays, the normal one goes into spin by the orientation, drawn for
# each impact by itself
SPHEROID = ("type nonSphericalRebound; shape { type ellipsoid; size (32e-6"
            " 20e-6 20e-6); } wall { type smooth; } law { type friction;"
            " restitution 1; friction 0; }")
beam("spheroids", SPHEROID, (100., 40., 0.))
solve("spheroids")
s = read_solids("spheroids", times_of("spheroids")[-1])
out = -s["U"][s["U"][:, 0] < 100*(1 - 1e-9), 0]/100
verdict("nonSphericalRebound_smooth", len(out) > 40
        and np.abs(s["U"][:, 1:] - [40, 0]).max() < 1e-9
        and out.max() <= 1 + 1e-9 and out.std() > 0.05
        and len(np.unique(out)) > 40,
        f"{len(out)} come back with {out.min():.3f} to {out.max():.3f} of the"
        f" normal speed")
differ = restarts("spheroids")
verdict("nonSphericalRebound_restart", not differ, f"differ: {differ[:5]}")

# --- identities go on as they were on ranks that have each other's particles
beam("crosses", SPHEROID, (100., 400., 0.), "fills { low { region box;"
     " box (0 0 0) (0.02 0.005 0.01); concentration 0.5;"
     " velocity (100 400 0); temperature 400; simulators 500; } }\n")
decompose("crosses", (1, 2, 1))
solve("crosses", 2)
differ = restarts("crosses", 2)
verdict("identities_twoRanksRestart", not differ, f"differ: {differ[:5]}")

# --- spheres on waves without friction: their crests lie across the motion, or
# across the gas, which goes along z; nothing is given along the crests
for lay, along in (("acrossMotion", 2), ("acrossFlow", 1)):
    beam(lay, "type nonSphericalRebound; shape { type sphere; diameter 10e-6; }"
         " wall { type sinusoidal; amplitude 20e-6; wavelength 160e-6; }"
         " law { type friction; restitution 1; friction 0; }"
         f" lay {lay};", (100., 40., 0.), gas={"T": 1., "U": (0, 0, 3000)})
    solve(lay)
    s = read_solids(lay, times_of(lay)[-1])
    off = s["U"][s["U"][:, 0] < 100*(1 - 1e-9)] - [0, 40, 0]
    kept, given = (np.sqrt((off[:, k]**2).mean()) for k in (along, 3 - along))
    verdict(f"nonSphericalRebound_{lay}", len(off) > 40 and given > 20
            and kept < (1e-9 if lay == "acrossMotion" else 0.02)*given,
            f"{len(off)} come back, r.m.s. {given:.3g} m/s across the crests,"
            f" {kept:.2g} along them")

# --- refused
for name, path, old, new, texts in (
        ("shape", "spheroids", "ellipsoid", "egg",
         ["solidParticleProperties.walls.xMax", "Unknown type egg",
          "ellipsoid"]),
        ("law", "spheroids", "restitution 1", "restitution 1.5",
         ["restitution 1.5", "[0, 1]"]),
        ("contact", "adheres", f"modulus {MODULUS}", "modulus -1",
         ["walls.xMax", "modulus -1"]),
        ("entry", "adheres", "friction 0.3", "frictoin 0.3",
         ["Unknown entry frictoin", "friction"]),
        ("plainEntry", "struck", "type stick;", "type stick; alpha 1;",
         ["walls.xMax", "Unknown entry alpha"]),
        ("function", "struck", "type surfaceImpact", "type voidFraction",
         ["voidFraction", "surfaceImpact"]),
        ("functionPatch", "struck", "patches (xMax)", "patches (yMax)",
         ["yMax"])):
    case = copy_case(path, f"bad_{name}")
    for t in times_of(case)[1:]:
        shutil.rmtree(f"{case}/{t}")
    edit(case, PROPERTIES, old, new)
    refuses(f"refuses_wall_{name}", case, texts)
