# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Spreading of parcels in homogeneous turbulence at rest."""

import os

import numpy as np

from caseTools import (copy_case, decompose, edit, largest, must, read_field,
                       refuses, run, solve, times_of, verdict)
from turbulence import (END, EPSILON, K, LIFE, MU, N, RHO, SIZE, age, parcels,
                        prepare)


def simulation(d, density, end, rng):
    """The same spheres with short steps and other random numbers: variances
    of place and velocity in one direction."""
    def rate(w):
        Re = RHO*np.linalg.norm(w, axis=1)*d/MU
        CdRe = np.where(Re > 1000, 0.424*Re,
                        24*(1 + Re**(2/3)/6))
        return 0.75*MU*CdRe/(density*d*d)

    dt = LIFE/40
    x, v, u = (np.zeros((5*N, 3)) for _ in range(3))
    left = np.zeros(5*N)
    for _ in range(round(end/dt)):
        new = left <= 1e-9*LIFE
        n = np.count_nonzero(new)
        k = rate(-v[new])
        u[new] = np.sqrt(2*K/3)*rng.normal(size=(n, 3))
        w = np.linalg.norm(u[new] - v[new], axis=1)
        share = np.minimum(SIZE*k/w, 1 - 1e-15)
        cross = np.where(SIZE*k < w, -np.log1p(-share)/k, np.inf)
        left[new] = np.minimum(LIFE, cross)

        # Over the end of an eddy the two that a step sees come one by one
        rest = np.full(5*N, dt)
        while np.any(rest > 0):
            t = np.minimum(rest, left)
            k = rate(u - v)
            e = np.exp(-k*t)[:, None]
            x += u*t[:, None] + (v - u)*(1 - e)/k[:, None]
            v = u + (v - u)*e
            left -= t
            rest -= t
            over = (left <= 1e-9*LIFE) & (rest > 0)
            m = np.count_nonzero(over)
            if m:
                kk = rate(-v[over])
                u[over] = np.sqrt(2*K/3)*rng.normal(size=(m, 3))
                w = np.linalg.norm(u[over] - v[over], axis=1)
                share = np.minimum(SIZE*kk/w, 1 - 1e-15)
                cross = np.where(SIZE*kk < w, -np.log1p(-share)/kk, np.inf)
                left[over] = np.minimum(LIFE, cross)
    return np.mean(x**2), np.mean(v**2)


# What follows the gas: exact. A variance of 3 x 4000 numbers has 1.3 %
TRACER = dict(d=1e-7, density=1000.)
for name, dt in (("short", LIFE/10), ("long", 3*LIFE), ("whole", END)):
    case = prepare("tracer_" + name, dt=dt, **TRACER)
    log = solve(case)
    x, _ = parcels(case)
    exact = 2*0.1*K**2/EPSILON*age(case)
    ratio = np.mean(x**2)/exact
    verdict(f"tracersSpread_{name}",
            len(x) == N and abs(ratio - 1) < 0.05
            and np.abs(x.mean(axis=0)).max() < 4*np.sqrt(exact/N),
            f"variance {ratio:.3f} of 2 D t, mean"
            f" {np.abs(x.mean(axis=0)).max()/np.sqrt(exact/N):.2f} of its"
            " standard deviation")
    if name == "short":
        eddies = float(log[log.rindex("Eddies met"):].split("=")[1]
                       .split(",")[0])
        verdict("eddiesAreCounted", abs(eddies/N - age(case)/LIFE) <= 1,
                f"{eddies/N:.3f} of each parcel in {age(case)/LIFE:.1f} lives")

# Heavy spheres
HEAVY = dict(d=1e-5, density=1500.)
heavy = prepare("heavy", dt=LIFE/5, **HEAVY)
solve(heavy)
x, v = parcels(heavy)
xx, vv = simulation(end=age(heavy), rng=np.random.default_rng(1), **HEAVY)
verdict("heavySpheresSpread",
        abs(np.mean(x**2)/xx - 1) < 0.05 and abs(np.mean(v**2)/vv - 1) < 0.05,
        f"variance of place {np.mean(x**2)/xx:.3f}, of velocity"
        f" {np.mean(v**2)/vv:.3f} of those of a simulation written anew")

# One by one
watched = copy_case(heavy, "watched")
for time in times_of(watched)[1:]:
    os.system(f"rm -r {watched}/{time}")
edit(watched, "constant/dustProperties", "cloudFunctions {}",
     "cloudFunctions { tracks { type particleTracks; trackInterval 1000000;"
     " maxSamples 1; resetOnWrite yes; } }")
solve(watched)
a = parcels(watched)
scale = [np.sqrt(np.mean(q**2)) for q in (x, v)]
off = largest(np.abs(p - q).max()/s for p, q, s in zip(a, (x, v), scale))
verdict("oneByOneAsInArrays", off < 1e-8, f"they differ by {off:.1e}")

# From the half on: on one rank, and on two, among which parcels go to and fro
again = copy_case(heavy, "again")
os.system(f"rm -r {again}/{times_of(again)[-1]}")
ranks = copy_case(again, "ranks")
solve(again)
decompose(ranks)
solve(ranks, 2)
must(ranks, "reconstructPar", "-latestTime")
off = largest(np.abs(p - q).max()/s
              for p, q, s in zip(parcels(ranks), (x, v), scale))
verdict("twoRanksAsOne", off < 1e-8, f"they differ by {off:.1e}")

end = times_of(heavy)[-1]
different = [
    name for name in ("U", "UTurb", "tTurb", "nEddies", "exactPosition")
    if not np.array_equal(
        *(read_field(f"{c}/{end}/lagrangian/dust/{name}")
          for c in (heavy, again)))]
verdict("restartIsBitwise", not different, f"differing: {different}")


# Right or refused
def refused(name, path, old, new, *said, start="\nTime = "):
    case = copy_case("tracer_whole", "refused")
    for time in times_of(case)[1:]:
        os.system(f"rm -r {case}/{time}")
    edit(case, path, old, new)
    refuses("refuses_" + name, run(case, "rhoCentralParcelFoam"), said, start)
    os.system(f"rm -r {case}")


CLOUDS = "constant/dustProperties"
# (the gas is known in the first step only)
refused("laminarGas", "constant/turbulenceProperties", "simulationType RAS",
        "simulationType laminar", "dustProperties", "dispersionModel",
        "simulationType RAS", start=None)
refused("motionStock", CLOUDS, "motion { type embeddedRK54; tolerance 1e-4; }",
        "motion stock;", "dispersionModel",
        "embeddedRK54")
refused("seed", CLOUDS, "seed 3", "seed -3", "dustProperties", "seed",
        "[0, 2147483647]")
refused("entry", CLOUDS, "seed 3", "sead 3", "sead", "seed")
refused("otherModel", CLOUDS, "dispersionModel stochasticDispersionRAS",
        "dispersionModel gradientDispersionRAS", "gradientDispersionRAS",
        "stochasticDispersionRAS")
refused("collisions", CLOUDS, "rotation off;",
        "rotation off; collisions { type eventDriven; restitution 1; friction 0; }",
        "dispersionModel stochasticDispersionRAS: valid range none")
