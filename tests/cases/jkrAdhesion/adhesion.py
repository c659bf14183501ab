# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Runs and checks of jkrAdhesion; stands in an empty folder."""

import csv
import math
import os
import re
import shutil

import numpy as np

from caseTools import (complaint, copy_case, decompose, edit, largest, must,
                       read_field, refuses, run, verdict)
from adhesionCurve import (ALPHA, MODULUS, WORK, mass, restitution,
                           separation_speed)
from plate import (SOLVER, counters, injector, mesh, solve, write_plate)

PAIR_MODULUS, PAIR_WORK = 36.55648e9, 0.0607
D = 20e-6
WALL = (f"contact {{ modulus {MODULUS}; workOfAdhesion {WORK}; }}"
        f" alpha {ALPHA}; friction 0.3;")
LAYER = (f"layer {{ modulus {PAIR_MODULUS}; workOfAdhesion {PAIR_WORK}; }}")
LID = '"[xz]M.*" { type escape; } yMax { type escape; }'
CLOUD = "kinematicCloud"


def patches(*items):
    return "patches ( " + " ".join(items) + " );"


def new(name):
    shutil.rmtree(name, ignore_errors=True)
    os.mkdir(name)
    return name


def all_parcels(case, time, *fields):
    """Fields of the parcels, ordered by their whole identity, and which of
    them the wall released."""
    from plate import parcels
    rows = parcels(case, time, "origProcId", *fields)
    order = np.lexsort((rows[0], rows[1]))
    rows = [r[order] for r in rows]
    return rows[0], rows[1] == 1000000, rows[2:]


def patch_field(case, time, name, patch):
    """Values of a field on a patch."""
    return np.atleast_1d(
        read_field(f"{case}/{time}/{CLOUD}:{name}", patch))


def fall(speed, *, tangential=0.0, n=1, d=D, x=(0.3, 0.7), y=1e-4,
         n_particle=1, start=0.0):
    more = f" startTime {start!r};" if start else ""
    return injector((x[0], y, 0.06), (x[1], y, 0.06), n,
                    (tangential, -speed, 0), d, n_particle) + more


# ------------------------------------------------------------------ bare wall

def check_bare():
    sizes = (1e-6, 1e-5, 2e-5, 5e-5)
    times = (0.5, 0.99, 1.01, 1.3, 4.0, 100.0)
    # V_cap from the integration here: where it first rebounds
    low, high = 1.0, 60.0
    for _ in range(40):
        mid = 0.5*(low + high)
        low, high = ((low, mid) if restitution(ALPHA, mid) > 0
                     else (mid, high))
    capture = 0.5*(low + high)
    rows = [(d, t, t*capture*separation_speed(d))
            for d in sizes for t in times]
    case = new("bare")
    end = 4e-3
    # Each starts so that it strikes in the middle of the run
    write_plate(case, "jkrAdhesion", patches(f"yMin {{ {WALL} }}", LID),
                [injector((0.3, V*end/2, 0.1), (0.3, V*end/2, 0.1), 1,
                          (0.4*V, -V, 0), d) for d, t, V in rows],
                end=end, step=end/4, lengths=(4, 10, 0.2))
    mesh(case)
    log = solve(case)
    ids, _, (U,) = all_parcels(case, "0.004", "U")
    index = {i: k for k, i in enumerate(ids.astype(int))}
    worst, missing, slip = 0, [], 0
    for i, (d, t, V) in enumerate(rows):
        if (t > 1) != (i in index):
            missing.append((d, t))
        elif t > 1:
            e = restitution(ALPHA, t*capture)
            u = U[index[i]]
            worst = largest(worst, abs(u[1]/V - e))
            stick = 2/7*0.4*V
            slip = largest(slip, abs(0.4*V - u[0]
                                     - min(0.3*(1 + u[1]/V)*V, stick))/V)
    c = counters(log)
    captured = [(d, t) for d, t, V in rows if t < 1]
    held = sum(mass(d) for d, t in captured)
    verdict("bare_captures", not missing, f"V_cap/v_st {capture:.4f}, sizes"
            f" {sizes}, wrong: {missing}")
    verdict("bare_restitution", worst < 5e-5,
            f"{len(U)} impacts, e_n within {worst:.1e}")
    verdict("bare_friction", slip < 1e-12, f"within {slip:.1e}")
    verdict("bare_counters", c["hits"] == [len(rows)]
            and c["rebounded"] == [len(U)]
            and c["captured (number, mass)"][0] == len(captured)
            and abs(c["captured (number, mass)"][1]/held - 1) < 1e-5
            and "adhered (number, mass)" in log, str(c))


def check_overlap():
    """Impacts too fast for a contact that is small against the sphere."""
    density = mass(1)*6/math.pi
    for share in (0.095, 0.13):
        V = math.sqrt(share**2.5*MODULUS/(1.25*math.pi*density))
        case = new("overlap")
        write_plate(case, "jkrAdhesion", patches(f"yMin {{ {WALL} }}", LID),
                    [fall(V, d=1e-6), fall(0.5*V, start=1e-6)], end=1e-3)
        mesh(case)
        said = re.findall(r"overlap of an impact is (\S+) of", solve(case))
        verdict(f"overlap_{share}",
                len(said) == (share > 0.1)
                and all(abs(float(s)/share - 1) < 1e-3 for s in said),
                f"at {V:.0f} m/s, said: {said}")

    # Not on the wall, but on a particle of the layer that is much smaller
    case = new("overlap")
    d = 1e-6
    n_cover = 2*0.25*0.1/(math.pi/4*d*d)
    write_plate(case, "jkrAdhesion",
                patches(f"yMin {{ {WALL} {LAYER} }}", LID),
                [fall(0.05, d=d, x=(0.65, 0.65), n_particle=n_cover),
                 fall(10.0, x=(0.6, 0.7), start=3e-3)],
                end=6e-3, step=1e-3, cells=(4, 2, 2))
    mesh(case)
    log = solve(case)
    said = re.findall(r"overlap of an impact is (\S+) of", log)
    # All of the energy in two springs of Hertz, a few per cent of adhesion
    stiff = (PAIR_MODULUS*math.sqrt(d*D/(d + D)/2), MODULUS*math.sqrt(d/2))
    soft = sum((4/3*k)**(-2/3) for k in stiff)
    force = (1.25*mass(D)*100/soft)**0.6
    want = max((force/(4/3*k))**(2/3)/r for k, r in
               zip(stiff, (d*D/(d + D)/2, d/2)))
    verdict("overlap_onAdhered",
            counters(log)["hits on adhered particles"] == [1]
            and len(said) == 1 and abs(float(said[0])/want - 1) < 0.05,
            f"said: {said}, two springs {want:.3f}")


# ------------------------------------------------------------------ the layer

def check_layer():
    """Slow parcels cover a face, fast ones hit what is there."""
    face = 0.25
    small, large = 1e-5, 2e-5
    # In one face of four: 0.1 and 0.3 of its area
    def number(share, d, n):
        return share*face*0.1/(math.pi/4*d*d)/n

    n = 4000
    # All arrive in the middle of one step
    layer = [fall(0.05, n=20, d=small, x=(0.6, 0.7), y=1.25e-4,
                  n_particle=number(0.1, small, 20)),
             fall(0.05, n=20, d=large, x=(0.6, 0.7), y=1.25e-4,
                  n_particle=number(0.3, large, 20))]
    case = new("layer")
    options = dict(end=6e-3, step=1e-3, write=3, cells=(4, 2, 2))
    beam = fall(3.0, n=n, x=(0.6, 0.7), d=large, start=3e-3)
    settings = patches(f"yMin {{ {WALL} {LAYER} }}", LID)
    write_plate(case, "jkrAdhesion", settings + " sizeClasses (1.5e-5);",
                [*layer, beam], **options)
    mesh(case)
    log = solve(case)
    early = log[:log.index("\nTime = 0.004")]
    cover = patch_field(case, "0.003", "coverage", "yMin")
    numbers = patch_field(case, "0.003", "layer0Number", "yMin")
    masses = patch_field(case, "0.003", "adheredMass", "yMin")
    fields = cover.max(), numbers.max()*face*0.1, masses.sum()*face*0.1
    want = (0.4, number(0.1, small, 1),
            number(0.1, small, 1)*mass(small)
            + number(0.3, large, 1)*mass(large))
    verdict("layer_fields", np.allclose(fields, want, rtol=1e-12, atol=0)
            and (cover > 0).sum() == 1
            and counters(early)["hits on adhered particles"] == [0],
            f"coverage {fields[0]:.12f}, number and mass as deposited")

    c = counters(log)
    hits = c["hits on adhered particles"][0]
    sigma = math.sqrt(n*0.4*0.6)
    verdict("layer_hitsByCoverage", abs(hits - 0.4*n) < 5*sigma,
            f"{hits:.0f} of {n} at coverage 0.4")

    # All that meet one leave by the chain: the utility says how
    ids, released, (U, d, N) = all_parcels(case, "0.006", "U", "d",
                                           "nParticle")
    speeds = {}
    for other in (small, large):
        m = mass(large)*mass(other)/(mass(large) + mass(other))
        r = large*other/(large + other)/2
        os.makedirs("chain/system", exist_ok=True)
        with open("chain/system/jkrImpactDict", "w") as file:
            wall = (f"radius {other/2}; modulus {MODULUS}; mass"
                    f" {mass(other)}; workOfAdhesion {WORK};")
            file.write(f"""
contact {{ {wall} }}
alpha {ALPHA}; speeds (3); tolerance 1e-10;
chain {{ particle {{ radius {r}; modulus {PAIR_MODULUS}; mass {m};
    workOfAdhesion {PAIR_WORK}; }} wall {{ {wall} }}
    coupling twoWay; }}
""")
        must("chain", "jkrImpact", "-noPlot")
        with open("chain/postProcessing/jkrImpact/chain.csv") as file:
            row = next(csv.DictReader(file))
        speeds[other] = float(row["vP1"]), float(row["vP2"])
    first, second = U[~released], U[released]
    from_large = np.abs(first[:, 1] - speeds[large][0]) < 1e-5
    from_small = np.abs(first[:, 1] - speeds[small][0]) < 1e-5
    bare = np.abs(first[:, 1]/3 - restitution(
        ALPHA, 3/separation_speed(large))) < 5e-5
    share = from_large.sum()/max(hits, 1)
    verdict("layer_outcomes", (from_large | from_small | bare).all()
            and from_large.sum() + from_small.sum() == hits,
            f"{bare.sum()} off the wall, {from_large.sum()} and"
            f" {from_small.sum()} off the two sizes")
    verdict("layer_shareOfSizes",
            abs(share - 0.75) < 5*math.sqrt(0.75*0.25/hits),
            f"{share:.3f} of the hits on the larger, 0.75 of the area")
    out = np.where(np.abs(d[released] - large) < 1e-12, speeds[large][1],
                   speeds[small][1])
    detach = {k: v[1] > 0 for k, v in speeds.items()}
    expected = (from_large.sum()*detach[large]
                + from_small.sum()*detach[small])
    verdict("layer_released", released.sum() == expected
            and np.abs(second[:, 1] - out).max() < 1e-5
            and np.allclose(N[released], 1, rtol=1e-12)
            and np.abs(np.minimum(np.abs(d[released] - large),
                                  np.abs(d[released] - small))).max() < 1e-15
            and c["detached particles"] == [expected],
            f"{released.sum()} released, {expected} expected")
    total = (number(0.1, small, 1)*mass(small)
             + number(0.3, large, 1)*mass(large) + n*mass(large))
    area = face*0.1
    late = patch_field(case, "0.006", "adheredMass", "yMin").sum()*area
    air = (N*mass(1)*d**3).sum()
    verdict("layer_mass", abs((late + air)/total - 1) < 1e-13
            and abs(c["detached mass"][0]
                    / (N[released]*mass(1)*d[released]**3).sum() - 1) < 1e-5,
            f"injected {total:.6e} kg, missing"
            f" {(late + air)/total - 1:.1e} of it")
    kinetic = (N*mass(1)*d**3*(U**2).sum(1)/2)[released].sum()
    # The spin of a parcel that carries none is not there
    verdict("layer_energy",
            abs(c["energy of the detached"][0]/kinetic - 1) < 1e-5,
            f"kinetic energy of the detached {kinetic:.4e} J")


def check_oblique():
    """Momentum along the wall, of both that leave, is what came."""
    case = new("oblique")
    face = 0.25*0.1
    n_cover = 2*face/(math.pi/4*D*D)
    write_plate(case, "jkrAdhesion",
                patches(f"yMin {{ {WALL} {LAYER} }}", LID),
                [fall(0.05, x=(0.65, 0.65), n_particle=n_cover),
                 fall(3.0, tangential=2.0, n=50, x=(0.6, 0.7), start=3e-3)],
                end=6e-3, step=1e-3, cells=(4, 2, 2),
                solution="rotation on;")
    mesh(case)
    log = solve(case)
    ids, released, (U, L) = all_parcels(case, "0.006", "U",
                                        "angularMomentum")
    p = U[:, 0].sum()
    c = counters(log)
    verdict("oblique_momentum", c["hits on adhered particles"] == [50]
            and released.sum() == 50 and abs(p/100 - 1) < 1e-12,
            f"{p:.12f} of 100")
    w = L[:, 2]/(0.1*mass(D)*D*D)
    # The impulse turns both the same way: equal spheres, equal spins
    # It takes 2/7 of the slip of 2 m/s, of which either has half
    exact = -2.5/(D/2)*2/7*2/2
    verdict("oblique_spin", len(w) == 100
            and np.allclose(w, exact, rtol=1e-6, atol=0),
            f"{w[0]:.7g} of {exact:.7g} 1/s")
    overfill = patch_field(case, "0.006", "overfill", "yMin").max()
    verdict("overfill", 0.99 < overfill < 1 and patch_field(
        case, "0.006", "coverage", "yMin").max() == 1, f"{overfill:.6f}")


# ------------------------------------------------------- ranks and restarts

def closed(name, model, settings, **more):
    """A closed box of adhesive walls, hit often, at speeds about those of
    capture and detachment; layers that are hit."""
    case = new(name)
    # The slow ones arrive in the middle of a step: at its end, round-off would
    # say which layer they meet
    sides = {side + end: "wall" for side in "xyz" for end in ("Min", "Max")}
    options = dict(end=0.4, step=4e-3, write=50, lengths=(0.1, 0.1, 0.1),
                   cells=(6, 5, 4), sides=sides)
    options.update(more)
    write_plate(case, model, settings, [
        injector((0.01, 0.03, 0.04), (0.09, 0.08, 0.06), 600, (6, -4, 5), D,
                 N_LARGE),
        injector((0.01, 0.01, 0.01), (0.09, 0.02, 0.03), 300, (-5, 3, -6),
                 1e-5, N_SMALL),
        injector((0.005, 1.1e-3, 0.005), (0.095, 1.1e-3, 0.095), 300,
                 (0.1, -0.05, 0.1), D, N_LARGE),
        injector((0.005, 1.1e-3, 0.006), (0.095, 1.1e-3, 0.094), 150,
                 (0.1, -0.05, 0.1), 1e-5, N_SMALL)], **options)
    mesh(case)
    return case


N_LARGE, N_SMALL = 5e4, 1e5
CLOSED = ('"[xyz]M.*" { contact { modulus 50e9; workOfAdhesion 0.1528; }'
          " alpha 0.3; friction 0.1; layer { modulus 36.55648e9;"
          " workOfAdhesion 0.0607; } }")
FIELDS = [f"layer{k}{q}" for k in (0, 1)
          for q in ("Number", "Mass", "Area", "Volume")] + [
              "adheredNumber", "adheredMass", "coverage", "overfill"]
WALLS = [side + end for side in "xyz" for end in ("Min", "Max")]


def state(case, time="0.4", spin="angularMomentum"):
    ids, released, fields = all_parcels(case, time, "U", "d", "nParticle",
                                        spin)
    layers = {(name, wall): patch_field(case, time, name, wall)
              for name in FIELDS for wall in WALLS}
    return ids, released, fields, layers


def layers_filled(s):
    """Have parcels of both classes of sizes stuck, somewhere?"""
    return all(any(s[3][f"layer{k}Number", w].any() for w in WALLS)
               for k in (0, 1))


def same_counters(a, b):
    """Of all walls; the log has six digits."""
    return all(np.allclose(p[k], q[k], rtol=1e-5, atol=0)
               for p, q in zip(a, b) for k in p)


def total_mass(s):
    N, d = s[2][2], s[2][1]
    area = {"x": 0.01/20, "y": 0.01/24, "z": 0.01/30}
    held = sum(s[3]["adheredMass", w].sum()*area[w[0]]
               * (1 if s[3]["adheredMass", w].size > 1 else
                  {"x": 20, "y": 24, "z": 30}[w[0]]) for w in WALLS)
    return (N*mass(1)*d**3).sum() + held, held


def check_ranks():
    settings = patches(CLOSED) + " sizeClasses (1.5e-5);"
    whole = closed("straight", "jkrAdhesion", settings)
    log = solve(whole)
    reference = state(whole)
    told = [counters(log, w) for w in WALLS]
    hits = sum(c["hits"][0] for c in told)
    met = sum(c["hits on adhered particles"][0] for c in told)
    free = sum(c["detached particles"][0] for c in told)
    caught = sum(c["captured (number, mass)"][0] for c in told)
    n = len(reference[0])
    injected = 900*N_LARGE*mass(D) + 450*N_SMALL*mass(1e-5)
    total, held = total_mass(reference)
    verdict("box_runs", hits > 2000 and met > 50 and free > 0 and caught > 100
            and reference[1].any() and layers_filled(reference),
            f"{hits:.0f} hits, {met:.0f} on adhered particles, {caught:.0f}"
            f" captured, {free:.3g} particles set free, {n} parcels left,"
            f" {reference[1].sum()} of them from the walls")
    verdict("box_mass", abs(total/injected - 1) < 1e-12,
            f"{held/injected:.3f} of the mass on the walls, missing"
            f" {total/injected - 1:.1e}")

    ranks = copy_case("straight", new("ranks") + "/case")
    for time in os.listdir(ranks):
        if re.fullmatch(r"0\.\d+", time):
            shutil.rmtree(f"{ranks}/{time}")
    decompose(ranks)
    log2 = solve(ranks, 2)
    must(ranks, "reconstructPar", "-latestTime")
    for part in (0, 1):
        shutil.rmtree(f"{ranks}/processor{part}")
    got = state(ranks)
    same = [len(reference[0]) == len(got[0])
            and np.array_equal(reference[0], got[0])
            and np.array_equal(reference[1], got[1])]
    same += [same[0] and np.allclose(a, b, rtol=1e-9,
                                     atol=1e-12*np.abs(a).max())
             for a, b in zip(reference[2], got[2])]
    fields = all(np.allclose(reference[3][k], got[3][k], rtol=1e-12, atol=0)
                 for k in reference[3])
    verdict("ranks", all(same) and fields,
            f"parcels {same}, fields of the layer {fields}")
    two = [counters(log2, w) for w in WALLS]
    verdict("ranks_counters", same_counters(told, two), "the same")

    half = closed("halfway", "jkrAdhesion", settings, end=0.2)
    solve(half)
    edit(half, "system/controlDict", "endTime 0.2", "endTime 0.4")
    log3 = solve(half)
    got = state(half)
    same = ([np.array_equal(a, b) for a, b in
             zip(reference[:2], got[:2])]
            + [np.array_equal(a, b) for a, b in zip(reference[2], got[2])])
    fields = all(np.array_equal(reference[3][k], got[3][k])
                 for k in reference[3])
    verdict("restart", all(same) and fields,
            f"parcels bit by bit {same}, fields of the layer {fields}")
    again = [counters(log3, w) for w in WALLS]
    verdict("restart_counters", same_counters(told, again), "the same")

    nested = closed("nested", "multiInteraction", f"""
oneInteractionOnly true;
first {{ patchInteractionModel jkrAdhesion; jkrAdhesionCoeffs {{
    {settings.replace('[xyz]M.*', '[xy]M.*')} }} }}
second {{ patchInteractionModel jkrAdhesion; jkrAdhesionCoeffs {{
    {settings.replace('[xyz]M.*', 'zM.*')} }} }}""")
    log4 = solve(nested)
    got = state(nested)
    same = (np.array_equal(reference[0], got[0])
            and np.array_equal(reference[2][0], got[2][0])
            and all(np.array_equal(reference[3][k], got[3][k])
                    for k in reference[3]))
    four = [counters(log4, w) for w in WALLS]
    verdict("multiInteraction", same and same_counters(told, four),
            f"two models of one layer: parcels and layer the same {same}")

    # Other classes than those of the layer that is read
    edit("halfway", f"constant/{CLOUD}Properties", "sizeClasses (1.5e-5)",
         "sizeClasses ()")
    edit("halfway", "system/controlDict", "endTime 0.4", "endTime 0.5")
    status, text = run("halfway", SOLVER)
    said = complaint(text)
    verdict("refuses_otherClasses", status and "sizeClasses" in said
            and "layer of time" in said, said)


# ------------------------------------------------------------------ bad input

def check_bad_input():
    def wall(old="", change="", more=""):
        assert old in WALL
        return patches(f"yMin {{ {WALL.replace(old, change)} {more} }}", LID)

    rows = [
        ("work", wall("workOfAdhesion 0.1528", "workOfAdhesion -1"),
         ["workOfAdhesion -1", "[0, 1e6]"]),
        ("noWork", wall("workOfAdhesion 0.1528", "workOfAdhesion 0"),
         ["workOfAdhesion", "(0, inf)"]),
        ("modulus", wall("modulus 50000000000.0", "modulus -1"),
         ["modulus -1", "[1e-3, 1e14]"]),
        ("radius", wall("contact {", "contact { radius 1e-5;"),
         ["Unknown entry radius", "(modulus workOfAdhesion)"]),
        ("alpha", wall("alpha 1.1891", "alpha -1"),
         ["alpha -1", "[0, 10]"]),
        ("noAlpha", wall("alpha 1.1891;"), ["alpha"]),
        ("friction", wall("friction 0.3", "friction -0.1"),
         ["friction -0.1", "[0, 1e6]"]),
        ("unloading", wall(more="unloading late;"),
         ["unloading late", "hard"]),
        ("outside", wall(more="outside guess;"), ["outside guess", "hold"]),
        ("nu", patches("yMin { particle { E 7e10; nu 0.5; } wall { E 2e11;"
                       " nu 0.3; } workOfAdhesion 0.1; alpha 1; friction"
                       " 0.1; }", LID), ["nu", "0.5", "(-1, 0.5)"]),
        ("range", wall("alpha 1.1891;", "alpha { type polynomial; coeffs"
                       " (1 -0.5); range (0.2 0.9); }"),
         ["restitution of alpha(e) 0.2", "capture"]),
        ("calibrated", wall("alpha 1.1891;", "alpha { type calibrated; file"
                            ' "data"; }'), ["diameter"]),
        ("layerWork", wall(more="layer { modulus 1e10; }"),
         ["workOfAdhesion"]),
        ("layerModulus", wall(more="layer { workOfAdhesion 0.1; }"),
         ["modulus"]),
        ("layerNegative", wall(more="layer { modulus 1e10; workOfAdhesion"
                               " -2; }"), ["workOfAdhesion", "-2"]),
        ("coupling", wall(more="layer { modulus 1e10; workOfAdhesion 0.1;"
                          " coupling none; }"), ["coupling none", "oneWay"]),
        ("hardLayer", wall(more="unloading hard; layer { modulus 1e10;"
                           " workOfAdhesion 0.1; }"),
         ["unloading hard", "soft"]),
        ("layerAlpha", wall("alpha 1.1891;", "alpha { type polynomial;"
                            " coeffs (1 -0.5); }",
                            "layer { modulus 1e10; workOfAdhesion 0.1; }"),
         ["alpha"]),
        ("classes", wall() + " sizeClasses (2e-5 1e-5);",
         ["sizeClasses 1e-05", "(2e-05, inf)"]),
        ("seed", wall() + " seed 0.5;", ["seed 0.5", "[0, 9e15]"]),
        ("twoClasses", None, ["sizeClasses"]),
        ("steady", wall(), ["transient", "yes"]),
    ]
    for name, coeffs, words in rows:
        case = new("bad")
        if name == "twoClasses":
            write_plate(case, "multiInteraction", f"""
oneInteractionOnly true;
a {{ patchInteractionModel jkrAdhesion; jkrAdhesionCoeffs {{
    {patches(f'yMin {{ {WALL} }}')} }} }}
b {{ patchInteractionModel jkrAdhesion; jkrAdhesionCoeffs {{
    {patches('yMax { type escape; }')} sizeClasses (1e-5); }} }}""",
                        [fall(1.0)])
        else:
            write_plate(case, "jkrAdhesion", coeffs,
                        [] if name == "steady" else [fall(1.0)])
        if name == "steady":
            edit(case, f"constant/{CLOUD}Properties", "transient yes;",
                 "transient no; calcFrequency 1; maxTrackTime 1;")
        mesh(case)
        refuses(f"refuses_{name}", run(case, SOLVER), words)

    # A speed beyond the data of alpha(e) comes up during the run only
    law = ("alpha { type polynomial; coeffs (0.5 -0.2); range (0 0.3); }"
           " outside %s;")
    for outside in ("refuse", "hold"):
        case = new("beyond")
        write_plate(case, "jkrAdhesion",
                    wall("alpha 1.1891;", law % outside), [fall(50.0)],
                    end=4e-4)
        mesh(case)
        status, text = run(case, SOLVER)
        good = (status == 0 if outside == "hold" else status
                and "up to e = 0.3" in complaint(text)
                and "50 m/s" in complaint(text))
        if outside == "hold" and good:
            U = all_parcels(case, "0.0004", "U")[2][0]
            e = restitution(0.44, 50/separation_speed(D))
            good = abs(U[0, 1]/50 - e) < 5e-5
        verdict(f"beyondData_{outside}", good, complaint(text)
                if outside == "refuse" else "keeps the last alpha")


if __name__ == "__main__":
    check_bare()
    check_overlap()
    check_layer()
    check_oblique()
    check_ranks()
    check_bad_input()
