# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Clouds of non-spherical parcels against scatteringIndicatrix, and what the
checks of the wall models share."""

import math
import os
import re
import shutil

import numpy as np

from caseTools import must, verdict, write_foam
from plate import counters, injector, mesh, parcels, solve, write_plate

BOX = "shape { type box; size (32e-6 25.6e-6 25.6e-6); }"
BOX_D = (6*32e-6*25.6e-6**2/math.pi)**(1/3)
ROUGH = ("wall { type rough; meanSpacing 80e-6; sigmaSpacing 10e-6;"
         " sigmaHeight 20e-6; }")
LAW = "law { type restitution; normal 0.8; tangential 0; }"
LID = '"[xz]M.*" { type escape; } yMax { type escape; }'
SPEED = 200.0


def patches(*items):
    return "patches ( " + " ".join(items) + " );"


def direction(incidence, speed=SPEED, turn=0):
    """Velocity, turned about the normal of the plate [deg]."""
    a, t = np.radians((incidence, turn))
    return speed*np.array((math.cos(a)*math.cos(t), -math.sin(a),
                           -math.cos(a)*math.sin(t)))


def beam(incidence, n, diameter=BOX_D, **more):
    """Parcels side by side in the middle of the box, that all hit the plate
    in the first half of the run."""
    return injector((0.4, 0.005, 0.09), (0.4, 0.005, 0.11), n,
                    direction(incidence, **more), diameter)


def new(name):
    shutil.rmtree(name, ignore_errors=True)
    os.mkdir(name)
    return name


def indicatrix(name, wall, incidences, n, table=0, law=LAW):
    case = new(name)
    write_foam(case, "system/scatteringIndicatrixDict", f"""
{BOX} {wall} {law}
incidence ({' '.join(map(str, incidences))}); speed 50; nParticles {n};
seed 7; {f'tableSamples {table};' if table else ''}""")
    must(case, "scatteringIndicatrix", "-noPlot",
         *(["-table"] if table else []))
    counts, energy = {}, {}
    for a in incidences:
        folder = "postProcessing/scatteringIndicatrix"
        if len(incidences) > 1:
            folder += f"/incidence_{a}"
        F = np.loadtxt(f"{case}/{folder}/F.csv", delimiter=",", skiprows=1)
        counts[a] = F[:, 1]*math.radians(1)*n
        with open(f"{case}/{folder}/summary.csv") as file:
            energy[a] = float(re.search("keTranslationalRatio,(.*)",
                                        file.read())[1])
    return counts, energy


def excess(a, na, b, nb, width=4):
    """Chi squared of two histograms of alpha2 by degree, less its degrees of
    freedom, over its standard deviation."""
    a, b = (x.reshape(-1, width).sum(1) for x in (a, b))
    both = a + b
    use = both > 30
    x = (a*nb - b*na)[use]
    chi2 = (x**2/(na*nb*both[use])).sum()
    return (chi2 - use.sum())/math.sqrt(2*use.sum())


def slower(U, ratio, n, reference):
    """Translational energy over that of the arrival against the ratio that so
    many particles have shown, in standard errors of the difference; n is the
    number of independent parcels."""
    e = (U**2).sum(axis=1)/SPEED**2
    return (ratio - e.mean())/(e.std()*math.sqrt(1/n + 1/reference))


def by_degree(U):
    alpha = np.degrees(np.arctan2(U[:, 1], U[:, 0]))
    return np.histogram(alpha, bins=180, range=(0, 180))[0].astype(float)


def fly(name, settings, incidence, n, turn=0, **more):
    case = new(name)
    write_plate(case, "nonSphericalRebound",
                patches(f"yMin {{ {settings} }}", LID),
                [beam(incidence, n, turn=turn)], **more)
    mesh(case)
    log = solve(case)
    return parcels(case, "0.0004", "U"), counters(log)


def check_indicatrices(n):
    samples = 100000
    reference, energy = indicatrix("utility", ROUGH, (15, 18, 21), 4*n,
                                   samples)
    shutil.copy("utility/postProcessing/scatteringIndicatrix/"
                "responseTable.csv", "table.csv")
    table = (f'method tabulated; table "{os.path.abspath("table.csv")}";'
             " incidenceRange (15 21);")
    for name, settings, incidence in (
            ("direct", "method direct;", 15),
            ("direct", "method direct;", 18),
            ("tabulated", table, 15), ("tabulated", table, 18)):
        (ids, U), c = fly("beam", f"{BOX} {ROUGH} {LAW} {settings}",
                          incidence, n)
        # The table is a sample itself
        weight = n if name == "direct" else 1/(1/n + 1/samples)
        counts = by_degree(U)
        x = excess(counts*weight/n, weight, reference[incidence], 4*n)
        verdict(f"indicatrix_rough_{name}_{incidence}",
                x < 5 and len(U) == n and c["hits"][0] >= n,
                f"{len(U)} parcels, chi squared {x:.1f} deviations above its"
                " mean")
        off = slower(U, energy[incidence], weight, 4*n)
        verdict(f"indicatrix_speed_{name}_{incidence}", abs(off) < 5
                and abs(U[:, 2].mean()) < 5*U[:, 2].std()/n**0.5,
                f"energy of {energy[incidence]:.4f} less {off:.1f} standard"
                f" errors, mean Uz {U[:, 2].mean():.2f} m/s")
    (ids, U), c = fly("beam", f"{BOX} {ROUGH} {LAW}", 25, n)
    x = excess(by_degree(U), n, reference[15], 4*n)
    verdict("indicatrix_hasPower", x > 10,
            f"25 deg against 15 deg: {x:.1f} deviations")

    smooth = "wall { type smooth; }"
    reference, energy = indicatrix("utilitySmooth", smooth, (15,), 4*n)
    (ids, U), c = fly("beam", f"{BOX} {smooth} {LAW}", 15, n)
    x = excess(by_degree(U), n, reference[15], 4*n)
    off = slower(U, energy[15], n, 4*n)
    verdict("indicatrix_smooth", x < 5 and abs(off) < 5,
            f"chi squared {x:.1f} deviations above its mean, energy"
            f" {off:.1f} standard errors too low")

    # Coefficients of the local angle, which a table can hold too
    fit = "law { type restitution; normal GrantTabakoff; tangential" \
        " GrantTabakoff; }"
    reference, energy = indicatrix("utilityFit", ROUGH, (15, 18), 2*n,
                                   samples, fit)
    file = os.path.abspath("utilityFit/postProcessing/scatteringIndicatrix/"
                           "responseTable.csv")
    for name, settings, weight in (
            ("direct", "", n),
            ("tabulated", f'method tabulated; table "{file}"; incidenceRange'
             " (15 18);", 1/(1/n + 1/samples))):
        U = fly("beam", f"{BOX} {ROUGH} {fit} {settings}", 15, n)[0][1]
        x = excess(by_degree(U)*weight/n, weight, reference[15], 2*n)
        off = slower(U, energy[15], weight, 2*n)
        verdict(f"indicatrix_fit_{name}", x < 5 and abs(off) < 5,
                f"chi squared {x:.1f} deviations above its mean, energy"
                f" {off:.1f} standard errors too low")
    x = excess(by_degree(fly("beam", f"{BOX} {ROUGH} {LAW}", 15, n)[0][1]),
               n, reference[15], 2*n)
    verdict("indicatrix_fit_hasPower", x > 10,
            f"constant coefficients: {x:.1f} deviations")

    # Parcels of half the size on relief half as coarse are the same
    half = ("wall { type rough; meanSpacing 40e-6; sigmaSpacing 5e-6;"
            " sigmaHeight 10e-6; }")
    case = new("half")
    write_plate(case, "nonSphericalRebound",
                patches(f"yMin {{ {BOX} {half} {LAW} }}", LID),
                [beam(15, 2000, BOX_D/2)])
    mesh(case)
    solve(case)
    small = parcels(case, "0.0004", "U")[1]
    full = fly("beam", f"{BOX} {ROUGH} {LAW}", 15, 2000)[0][1]
    same = (np.abs(small - full).max(1) < 1e-4).mean()
    verdict("sizeScales", same > 0.98, f"{100*same:.1f} % the same")


def check_lay():
    """Crests along the motion leave a sphere on average in its plane of
    incidence and slow it along that by the smooth law; across they do not.
    What lies across the motion turns with it."""
    sphere = "shape { type sphere; diameter 3e-5; }"
    n = 20000
    mean = {}
    for lay in ("acrossMotion", "fixed; layDirection (1 0 0)",
                "fixed; layDirection (0 0 1)", "acrossFlow"):
        U = fly("beam", f"{sphere} {ROUGH} {LAW} lay {lay};", 15, n)[0][1]
        mean[lay] = U
    along = mean["fixed; layDirection (1 0 0)"]
    # Motion along the crests: nothing pushes along them but friction, which
    # for a_t = 0 stops the contact: 5/7 of the speed
    # those that meet the crests once more are slower
    slip = along[:, 0] - 5/7*direction(15)[0]
    once = (np.abs(slip) < 1e-9).mean()
    verdict("lay_along", 0.95 < once < 0.98 and slip.max() < 1e-9,
            f"{100*once:.1f} % at 5/7 of the speed along the crests, none"
            " faster")
    verdict("lay_across", np.array_equal(
        mean["acrossMotion"], mean["fixed; layDirection (0 0 1)"]),
            "crests across, fixed: as acrossMotion to the bit")
    same = np.array_equal(mean["acrossFlow"], mean["acrossMotion"])
    verdict("lay_flowAtRest", same, "gas at rest: as acrossMotion")
    plain, turned = (fly("beam", f"{BOX} {ROUGH} {LAW}", 15, 2000, turn)[0][1]
                     for turn in (0, 30))
    c, s = math.cos(math.pi/6), math.sin(math.pi/6)
    off = np.abs(plain @ [[c, 0, -s], [0, 1, 0], [s, 0, c]] - turned).max()
    # Round-off, larger where several impacts follow each other
    verdict("lay_turnsWithMotion", off < 1e-6,
            f"a beam 30 deg about the normal comes back turned as much, to"
            f" {off:.1e} m/s")
