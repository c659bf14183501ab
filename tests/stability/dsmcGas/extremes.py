# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Near vacuum, single molecules and cells, great Mach numbers and steps."""

import math
import re

import numpy as np

from caseTools import complaint, read_field, run, times_of
from dsmcTools import (ARGON, K, NITROGEN, collisions, energies, momenta,
                       read_wall, write_gas)

PERIODIC = dict.fromkeys(("xMin", "xMax", "yMin", "yMax", "zMin", "zMax"),
                         "cyclic")
WALLS = dict.fromkeys(PERIODIC, "wall")
OPEN = dict.fromkeys(PERIODIC, "patch")
HYDROGEN = {"mass": 3.34e-27, "diameter": 2.92e-10,
            "internalDegreesOfFreedom": 2, "omega": 0.67}
XENON = {"mass": 218e-27, "diameter": 5.74e-10,
         "internalDegreesOfFreedom": 0, "omega": 0.85}
MEANS = "sampling { start 0; }\n"
LB = "LarsenBorgnakkeVariableHardSphere"


def row(name, expected, check, *args, **settings):
    """Run a box; check gives a verdict and what was seen from case and log.
    Means must be finite, and the balance of molecules closes by itself."""
    case = re.sub(r"\W+", "_", name)
    write_gas(case, *args, **settings)
    status, text = run(case, "dsmcParcelFoam")
    good, seen = status == 0, complaint(text)
    if good:
        end = times_of(case)[-1]
        good, seen = check(case, end, text)
        for field in ("rhoNMean", "overallT", "UMean", "internalT"):
            good &= bool(np.all(np.isfinite(read_field(
                f"{case}/{end}/{field}"))))
    print(f"{name} | {expected} | exit status {status}, {seen} | "
          f"{'ok' if good else 'FAILED'}", flush=True)


def now(text):
    return int(re.search(r"= (\d+) now", text).group(1))


def drift(text):
    e = energies(text)
    return np.ptp(e)/e[0]


def kept(case, end, text):
    return (drift(text) < 1e-11,
            f"{now(text)} molecules, {collisions(text):.0f} collisions,"
            f" energy drift {drift(text):.1e}")


def alone(case, end, text):
    good, seen = kept(case, end, text)
    return good and collisions(text) == 0 and now(text) > 0, seen


def rate(step, steps, weight, fixed=1):
    """Collision rate against kinetic theory; fixed: that at the one relative
    speed of two molecules over that of a Maxwellian of their energy."""
    def check(case, end, text):
        n = now(text)
        mass = n*weight*ARGON["mass"]
        p = momenta(text)[-1]
        T = (energies(text)[-1] - 0.5*np.dot(p, p)/mass)/(
            1.5*K*weight*(n - 1))
        nu = (4*ARGON["diameter"]**2*n*weight/1e-3
              * np.sqrt(np.pi*K*273/ARGON["mass"])
              * (T/273)**(1 - ARGON["omega"]))
        ratio = collisions(text)/(0.5*(n - 1)*nu*step*steps*fixed)
        good, seen = kept(case, end, text)
        error = 1/np.sqrt(collisions(text))
        return (good and abs(ratio - 1) < 5*error + 0.005,
                f"{ratio:.4f} of the rate, {seen}")
    return check


row("one cell of 1000 molecules, periodic",
    "collision rate of kinetic theory, 5 deviations + 0.5 %; energy to 1e-11",
    rate(8e-6, 1000, 1e14), PERIODIC, (1, 1, 1), weight=1e14, more=MEANS,
    control={"deltaT": 8e-6, "endTime": 8e-3})
half = 1 - ARGON["omega"] + 0.5     # sigma c ~ (c^2)^(half - 1/2)
row("two molecules in a cell",
    "collision rate of two, 5 deviations + 0.5 %; energy to 1e-11",
    rate(8e-6, 4000, 5e16, 1.5**(half - 0.5)*math.gamma(1.5)
         / math.gamma(1 + half)), PERIODIC, (1, 1, 1), weight=5e16, more=MEANS,
    control={"deltaT": 8e-6, "endTime": 3.2e-2})
row("one molecule in a box of 1000 cells", "flies on, energy to 1e-11", alone,
    dict(PERIODIC, yMin="wall", yMax="wall"), (10, 10, 10), weight=5e16,
    wall="SpecularReflection", more=MEANS,
    control={"deltaT": 1e-5, "endTime": 1e-2})
row("100 real molecules in a box of 512 cells", "no collisions", alone,
    WALLS, (8, 8, 8), weight=1, density=1e5, wall="SpecularReflection",
    more=MEANS, control={"deltaT": 1e-4, "endTime": 1e-1})


def trickle(case, end, text):
    entered = int(re.search(r"\+ (\d+) entered", text).group(1))
    expected = 1e13*np.sqrt(8*K*300/np.pi/ARGON["mass"])/4*0.06*0.1/1e10
    rho = np.mean(read_field(f"{case}/{end}/rhoNMean"))
    # Means start with the empty box and hold each molecule for 30 steps
    return (abs(entered/expected - 1) < 5/np.sqrt(expected)
            and abs(rho/1e13 - 1) < 5*np.sqrt(8/expected) + 0.01,
            f"{entered} entered in 10000 steps, {expected:.0f} expected,"
            f" density {rho/1e13:.3f}")


row("near vacuum: a molecule in 30 steps, 1000 cells",
    "flux and density within 5 deviations (+ 1 %)", trickle, OPEN,
    weight=1e10, density=1e13, inflow="FreeStream", initialise=False,
    more=MEANS + "FreeStreamCoeffs { numberDensities { Ar 1e13; } }",
    control={"deltaT": 1e-5, "endTime": 1e-1})


def nothing(case, end, text):
    return (now(text) == 0 and "0 entered" in text,
            f"{now(text)} molecules")


row("no gas: flux of one molecule in 1e6 steps", "an empty box", nothing,
    OPEN, weight=1e20, density=1e13, inflow="FreeStream", initialise=False,
    more=MEANS + "FreeStreamCoeffs { numberDensities { Ar 1e6; } }",
    control={"deltaT": 1e-5, "endTime": 1e-2})


def jet(case, end, text):
    rho = read_field(f"{case}/{end}/rhoNMean").reshape(10, 10, 10)
    ahead = np.count_nonzero(rho[:, :, 9])
    first = rho[2:8, 2:8, 0].mean()/1e20
    return (ahead == 0 and rho.max() < 1.2e20 and 0.8 < first < 1.1,
            f"{ahead} cells of the last hundred met, {first:.2f} of the"
            " density of the exit next to it")


MACH20 = 20*np.sqrt(5/3*K*100/ARGON["mass"])
row("jet of Mach 20 into vacuum, 1000 cells",
    "empty cells ahead of it; the density of the exit next to it", jet,
    OPEN, weight=2e11, inflow="FreeStream", initialise=False,
    more=MEANS + "FreeStreamCoeffs { inflows { xMin { numberDensities"
    f" {{ Ar 1e20; }} temperature 100; velocity ({MACH20!r} 0 0); }} }} }}",
    control={"deltaT": 2e-7, "endTime": 1.8e-5})


def plate(case, end, text):
    m, T, wall, steps = ARGON["mass"], 100., 300., 400
    c = np.sqrt(2*K*T/m)
    s = MACH20/c
    flux = 1e20*c*s
    exact = [1e20*K*T*(1 + 2*s*s) + flux*np.sqrt(np.pi*m*K*wall/2),
             1e20*K*T*np.sqrt(K*T/(2*np.pi*m))*2*np.sqrt(np.pi)*s
             * (s*s + 2.5) - flux*2*K*wall]
    found = [-np.mean(read_wall(case, end, "fDMean", "zMin"), axis=0)[2],
             np.mean(read_wall(case, end, "qMean", "zMin"))]
    ratio = np.array(found)/exact
    error = 1/np.sqrt(flux*0.01*steps*1e-6/2e11)
    return (bool(np.all(np.abs(ratio - 1) < 5*error)),
            f"pressure {ratio[0]:.4f}, heat flux {ratio[1]:.4f}, deviation"
            f" {error:.4f}")


row("plate across a free-molecular stream of Mach 20",
    "pressure and heat flux of Schaaf and Chambre, 5 deviations", plate,
    dict(OPEN, zMin="wall"), weight=2e11, T=100., U=(0, 0, -MACH20),
    wallT={"zMin": 300.}, collisions="none", inflow="FreeStream",
    more=MEANS + "FreeStreamCoeffs { numberDensities { Ar 1e20; } }",
    control={"deltaT": 1e-6, "endTime": 4e-4})


def finite(case, end, text):
    T = read_field(f"{case}/{end}/overallT")
    return (T.max() < 1e6 and now(text) > 0,
            f"{now(text)} molecules, T {T.min():.0f} .. {T.max():.0f} K")


row("the same with collisions, plate at 5000 K", "finite", finite,
    dict(OPEN, zMin="wall"), weight=4e11, T=100., U=(0, 0, -MACH20),
    wallT={"zMin": 5000.}, inflow="FreeStream",
    more=MEANS + "FreeStreamCoeffs { numberDensities { Ar 1e20; } }",
    control={"deltaT": 1e-6, "endTime": 4e-4})
row("step of 50 mean collision times, flights of 150 cells",
    "energy to 1e-11", kept, PERIODIC, (10, 10, 10), weight=1e13, more=MEANS,
    control={"deltaT": 3.5e-3, "endTime": 3.5e-2})
row("between specular walls, flights of 100 box lengths", "energy to 1e-11",
    kept, WALLS, (5, 5, 5), weight=1e14, collisions="none",
    wall="SpecularReflection", more=MEANS,
    control={"deltaT": 2.5e-2, "endTime": 0.25})


def equipartition(case, end, text):
    Tt, Ti = (np.mean(read_field(f"{case}/{end}/{f}"))
              for f in ("translationalT", "internalT"))
    good, seen = kept(case, end, text)
    return (good and abs(Tt/Ti - 1) < 0.05,
            f"T {Tt:.0f} K, rotation {Ti:.0f} K, {seen}")


row("hydrogen in xenon (masses 1 to 65), 20000 K",
    "rotation and translation within 5 %; energy to 1e-11", equipartition,
    PERIODIC, (3, 3, 3), weight=1e13, density=1e20, T=20000.,
    gas={"H2": HYDROGEN, "Xe": XENON}, collisions=LB,
    more="sampling { start 1e-3; }",
    control={"deltaT": 2e-6, "endTime": 4e-3})
row("nitrogen at 0.1 K",
    "rotation and translation within 5 %; energy to 1e-11", equipartition,
    PERIODIC, (3, 3, 3), weight=1e13, density=1e20, T=0.1,
    gas={"N2": NITROGEN}, collisions=LB, more="sampling { start 0.2; }",
    control={"deltaT": 5e-4, "endTime": 0.7})


def between(case, end, text):
    q = [np.mean(read_wall(case, end, "qMean", side))
         for side in ("xMin", "xMax")]
    T = read_field(f"{case}/{end}/overallT")
    return (q[0] < 0 < q[1] and T.max() < 1e5,
            f"T {T.min():.0f} .. {T.max():.0f} K, heat fluxes"
            f" {q[0]:.3g} and {q[1]:.3g} W/m2")


row("diffuse walls at 1 K and 1e5 K", "heat from hot to cold, below 1e5 K",
    between, dict(PERIODIC, xMin="wall", xMax="wall"), (20, 2, 2),
    weight=2e13, T=300., wallT={"xMin": 1e5, "xMax": 1.}, more=MEANS,
    control={"deltaT": 1e-7, "endTime": 2e-4})
