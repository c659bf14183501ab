# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""jkrAdhesion on the spin-carrying cloud of rhoCentralParcelFoam: rebounds and
releases with spin, ranks and restarts, and those who read the identities of
what the wall releases. Stands in an empty folder."""

import csv
import filecmp
import glob
import os
import re

import numpy as np

from adhesion import (ALPHA, CLOSED, CLOUD, D, LAYER, LID, N_LARGE, N_SMALL,
                      WALL, WALLS, all_parcels, closed, fall, layers_filled,
                      mass, new, patches, restitution, same_counters,
                      separation_speed, state, total_mass)
from caseTools import (copy_case, decompose, edit, hard_sphere, largest, must,
                       solve, verdict, write_case, write_field, write_foam)
from plate import SIDES, counters, mesh, write_plate

SPIN = (3e5, -2e5, 4e5)
RELEASED = "1000000"


def spinning(case, end, step, write, sides, spin=SPIN):
    """A case of a stock cloud becomes one of spheres with spin over a frozen
    gas that does not touch them."""
    path = f"constant/{CLOUD}Properties"
    for old, new_text in (
            ("solution\n{", "type spinningKinematicCloud;\nsolution\n{"),
            ("mu cell;", "T cell; thermo:mu cell;"),
            ("rho0 2500;", "rho0 2500; omega0 (%r %r %r);" % spin),
            ("particleForces {}",
             "particleForces {} rotationalTorqueModel none;"),
            ("collisionModel none; radiation off;", "")):
        edit(case, path, old, new_text)
    write_case(
        case,
        {"endTime": end, "deltaT": step, "writeControl": "timeStep",
         "writeInterval": write, "writePrecision": 17, "timePrecision": 12,
         "libs": "(parcelInjection parcelWallInteraction spinningParcel)"},
        {"mode": "frozen"})
    write_foam(case, "constant/parcelClouds", f"clouds ({CLOUD});")
    still = {side: "type zeroGradient;" for side in sides}
    write_field(case, "p", 1e3, still)
    write_field(case, "T", 300, still)


def vector_of(hit, name):
    return np.array([float(hit[name.replace("#", x)]) for x in
                     ("x y z" if name[0] == "U" else "X Y Z").split()])


def same_impacts(first, second):
    """Bit by bit, but for the time, which a restart reads from a name."""
    return len(first) == len(second) and all(
        a[key] == b[key] if key != "time" else
        abs(float(a[key]) - float(b[key])) < 1e-12
        for a, b in zip(first, second) for key in a)


def impacts(case):
    """Lines of the log of impacts, over the parts of a run."""
    hits = []
    for name in sorted(glob.glob(f"{case}/postProcessing/impacts/{CLOUD}/*/"
                                 "impacts.csv"),
                       key=lambda n: float(n.split("/")[-2])):
        with open(name) as file:
            hits += list(csv.DictReader(file))
    return hits


# ----------------------------------------------------- a release with its spin

def check_release():
    """Spheres on the bare wall, and on others that cover a face: the impulse
    along the wall turns both, each about its own centre."""
    case = new("release")
    face = 0.25*0.1
    write_plate(case, "jkrAdhesion",
                patches(f"yMin {{ {WALL} {LAYER} }}", LID),
                [fall(0.05, x=(0.65, 0.65),
                      n_particle=2*face/(np.pi/4*D*D)),
                 fall(3.0, tangential=2.0, n=50, x=(0.6, 0.7), start=3e-3),
                 fall(3.0, tangential=2.0, n=50, x=(0.1, 0.15), start=3e-3)],
                end=6e-3, step=1e-3, cells=(4, 2, 2),
                functions="impacts { type impactRecords; patches (yMin); }")
    spinning(case, 6e-3, 1e-3, 6, SIDES, (0.0, 0.0, 1e5))
    mesh(case)
    c = counters(solve(case))
    _, released, (U, w) = all_parcels(case, "0.006", "U", "omega")
    hits = [h for h in impacts(case) if float(h["Uy"]) < -1]
    bare, met = [], []
    for h in hits:
        (bare if float(h["x"]) < 0.5 else met).append(h)

    worst = 0
    for h in bare:
        V, omega = vector_of(h, "U#"), vector_of(h, "omega#")
        e = -float(h["UyOut"])/V[1]
        V1, omega1 = hard_sphere(V, omega, (0, 1, 0), D/2, e, 0.3)
        worst = largest(worst, np.abs(V1 - vector_of(h, "U#Out")).max()/3,
                        np.abs(omega1 - vector_of(h, "omega#Out")).max()*D/6)
    e_law = restitution(ALPHA, 3/separation_speed(D))
    verdict("spin_rebound", len(bare) == 50 and worst < 1e-12
            and abs(e - e_law) < 5e-5,
            f"{len(bare)} rebounds apart from friction's law by {worst:.1e},"
            f" e_n {e:.6f} of {e_law:.6f}")

    second = U[released]
    struck = np.array([vector_of(h, "U#Out") for h in met])
    turned = np.array([vector_of(h, "omega#Out") for h in met])
    give = 2.0 - struck[:, 0]
    gained = turned[:, 2] - 1e5
    verdict("spin_release", c["hits on adhered particles"] == [50]
            and released.sum() == 50 and len(U) == 150
            and np.allclose(second[:, 0], give, rtol=1e-12)
            and np.allclose(w[released][:, 2], gained, rtol=1e-9)
            and np.allclose(gained, -2.5/(D/2)*give, rtol=1e-9)
            and gained[0] < -1e4,
            f"{released.sum()} released at {second[0, 0]:.4f} m/s along the"
            f" wall, {w[released][0, 2]:.5g} rad/s")
    kinetic = (mass(D)*((second**2).sum(1)/2
                        + 0.05*D*D*(w[released]**2).sum(1))).sum()
    verdict("spin_releaseEnergy",
            abs(c["energy of the detached"][0]/kinetic - 1) < 1e-5,
            f"{kinetic:.4e} J with that of the spin")


# ------------------------------------------------------- ranks and restarts

def box(name, end=0.4):
    settings = patches(CLOSED) + " sizeClasses (1.5e-5);"
    case = closed(name, "jkrAdhesion", settings, functions="""
impacts { type impactRecords; patches (".*"); }
surface { type surfaceImpact; patches (".*"); threshold 0; }""")
    spinning(case, end, 4e-3, 50, WALLS)
    return case


def check_ranks():
    whole = box("spinStraight")
    log = solve(whole)
    reference = state(whole, spin="omega")
    told = [counters(log, w) for w in WALLS]
    met = sum(c["hits on adhered particles"][0] for c in told)
    released = reference[1].sum()
    total, held = total_mass(reference)
    injected = 900*N_LARGE*mass(D) + 450*N_SMALL*mass(1e-5)
    verdict("spin_box", met > 50 and released > 10 and layers_filled(reference)
            and abs(total/injected - 1) < 1e-12,
            f"{met:.0f} hits on adhered particles, {released} parcels from"
            f" the walls, missing mass {total/injected - 1:.1e}")

    # Every sphere arrives with the spin that it left with
    hits = impacts(whole)
    last, broken, chained, firsts = {}, 0, 0, []
    for h in sorted(hits, key=lambda h: float(h["time"])):
        key = h["origProc"], h["origId"]
        if h["firstImpact"] == "1":
            firsts.append(key)
        before = last.get(key, None if key[0] == RELEASED else SPIN)
        if before is not None:
            chained += 1
            broken += not np.allclose(vector_of(h, "omega#"), before,
                                      rtol=1e-9, atol=1e-3)
        last[key] = vector_of(h, "omega#Out")
    verdict("spin_arrives", chained > 1000 and not broken,
            f"{chained} impacts with the spin of the impact before,"
            f" {broken} otherwise")
    freed = {k for k in firsts if k[0] == RELEASED}
    everyone = {(h["origProc"], h["origId"]) for h in hits}
    verdict("released_firstImpacts", len(firsts) == len(set(firsts))
            and set(firsts) == everyone and len(freed) > 10,
            f"{len(firsts)} parcels, {len(freed)} of them released, hit for"
            f" the first time once in {len(hits)} impacts")
    table = glob.glob(f"{whole}/postProcessing/surface/{CLOUD}/*/byPatch.csv")
    with open(sorted(table)[-1]) as file:
        rows = list(csv.DictReader(file))
    counted = sum(float(r["firstIntensity"])*float(r["area"]) for r in rows)
    every = sum(float(r["intensity"])*float(r["area"]) for r in rows)
    number = [sum(float(h["nParticle"]) for h in hits
                  if h["firstImpact"] == "1" or some) for some in (0, 1)]
    verdict("released_surfaceImpact",
            abs(counted/every/(number[0]/number[1]) - 1) < 1e-9,
            f"first of all impacts {counted/every:.6f}")

    ranks = copy_case(whole, "spinRanks")
    for time in os.listdir(ranks):
        if re.fullmatch(r"0\.\d+|postProcessing", time):
            must(ranks, "rm", "-r", time)
    decompose(ranks)
    log2 = solve(ranks, 2)
    must(ranks, "reconstructPar", "-latestTime")
    for part in (0, 1):
        must(ranks, "rm", "-r", f"processor{part}")
    got = state(ranks, spin="omega")
    same = [np.array_equal(a, b) for a, b in zip(reference[:2], got[:2])]
    same += [all(same) and np.allclose(a, b, rtol=1e-9, atol=1e-9*scale)
             for a, b, scale in zip(reference[2], got[2], (1, 0, 0, 1e5))]
    fields = all(np.allclose(reference[3][k], got[3][k], rtol=1e-12, atol=0)
                 for k in reference[3])
    two = [counters(log2, w) for w in WALLS]
    verdict("spin_ranks", all(same) and fields
            and same_counters(told, two),
            f"parcels {same}, fields of the layer {fields}")
    verdict("released_impactsOfRanks",
            [(h["step"], h["origProc"], h["origId"], h["firstImpact"])
             for h in hits]
            == [(h["step"], h["origProc"], h["origId"], h["firstImpact"])
                for h in impacts(ranks)],
            f"{len(hits)} lines of the same parcels")

    half = box("spinHalfway", end=0.2)
    solve(half)
    edit(half, "system/controlDict", "endTime 0.2", "endTime 0.4")
    solve(half)
    names = [f"0.4/{n}" for n in os.listdir(f"{whole}/0.4")
             if os.path.isfile(f"{whole}/0.4/{n}")]
    folder = f"0.4/lagrangian/{CLOUD}"
    names += [f"{folder}/{n}" for n in os.listdir(f"{whole}/{folder}")]
    other = [n for n in names if not os.path.exists(f"{half}/{n}")
             or not filecmp.cmp(f"{whole}/{n}", f"{half}/{n}", False)]
    verdict("spin_restart_is_bitwise", not other
            and f"{folder}/omega" in names
            and f"0.4/{CLOUD}:layer1Mass" in names
            and same_impacts(hits, impacts(half)),
            f"{len(names)} files, different: {other}; and the impacts")

    # The stock utility counts parcels by processor, up to that of the wall's
    write_foam(whole, "constant/particleTrackProperties",
               f"cloud {CLOUD}; sampleFrequency 1; maxPositions 100;"
               " setFormat vtk; fields (U);")
    text = must(whole, "particleTracks")
    seen = [all_parcels(whole, time, "U") for time in ("0.2", "0.4")]
    expected = sum(1 + int(max(ids[freed == some].max()
                               for ids, freed, _ in seen))
                   for some in (False, True))
    found = re.search(r"Generating (\d+) particle tracks", text)
    verdict("released_particleTracks", found is not None
            and int(found.group(1)) == expected
            # (its folder, name and format depend on the release)
            and glob.glob(f"{whole}/**/*racks.vt[kp]", recursive=True),
            f"{expected} tracks expected, "
            + (found.group(0) if found else "none"))


if __name__ == "__main__":
    check_release()
    check_ranks()
