# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Runs and checks of the wall models; stands in an empty folder. Knows nothing
of the code under test: the laws of a sphere are written down here once more,
the distributions come from scatteringIndicatrix."""

import math
import os
import shutil
import sys

import numpy as np

from caseTools import (complaint, copy_case, decompose, edit, hard_sphere,
                       largest, refuses, run, times_of, verdict)
from indicatrices import (BOX, BOX_D, LAW, LID, ROUGH, SPEED, beam,
                          check_indicatrices, check_lay, direction, new,
                          patches)
from plate import SOLVER, counters, injector, mesh, parcels, solve, write_plate

# ------------------------------------------------------- laws of one sphere

def falcon(v, e0, v0):
    return 1 - (1 - e0)*(v/v0)**0.2 if v <= v0 else e0*(v/v0)**-0.25


def check_hard_sphere():
    d, e, f = 30e-6, 0.7, 0.2
    r = d/2
    I = 0.1*2500*math.pi/6*d**3*d*d
    angles = (1, 10, 30, 50, 80)
    # Down to the plate, up to the lid, down again: with and without spin
    for rotation in ("off", "on"):
        case = new("sphere")
        write_plate(case, "hardSphereWall",
                    patches(f'"yM.*" {{ restitution {e}; friction {f}; }}',
                            '"[xz]M.*" { type escape; }'),
                    [injector((0.3 + 0.01*i, 0.005, 0.1),
                              (0.3 + 0.01*i, 0.005, 0.1), 1,
                              direction(a), d) for i, a in enumerate(angles)],
                    lengths=(1, 0.01, 0.2), end=2e-3,
                    solution=f"rotation {rotation};")
        mesh(case)
        log = solve(case)
        ids, U, L = parcels(case, "0.002", "U", "angularMomentum")
        worst, impacts, slides = 0, 0, 0
        for a, u, spin in zip(angles, U, L/I):
            V, w, y, t = np.array(direction(a)), np.zeros(3), 0.005, 2e-3
            while True:
                need = (0.01 - y if V[1] > 0 else -y)/V[1]
                if need > t:
                    break
                up = V[1] > 0
                n = (0, -1, 0) if up else (0, 1, 0)
                V, w = hard_sphere(V, w, n, r, e, f)
                slides += abs(V[0] + r*w[2]*n[1]) > 1e-6
                if rotation == "off":
                    w = np.zeros(3)
                y, t, impacts = 0.01 if up else 0, t - need, impacts + 1
            worst = largest(worst, np.abs(u - V).max(),
                            r*np.abs(spin - w).max())
        verdict(f"hardSphere_bounces_rotation_{rotation}", worst < 1e-10,
                f"{impacts} impacts of 5 parcels, largest difference"
                f" {worst:.1e}")
    c, lid = counters(log), counters(log, "yMax")
    verdict("hardSphere_counters",
            c["hits"][0] + lid["hits"][0] == impacts
            and c["sliding impacts"][0] + lid["sliding impacts"][0] == slides,
            f"{c['hits'][0]:.0f} + {lid['hits'][0]:.0f} hits of {impacts},"
            f" {slides} slide")
    m = 2500*math.pi/6*d**3
    lost = (len(angles)*m*SPEED**2/2
            - (m*(U**2).sum()/2 + I*((L/I)**2).sum()/2))
    told = sum(c["energy lost (transl., rot.)"]
               + lid["energy lost (transl., rot.)"])
    verdict("hardSphere_energy", abs(told/lost - 1) < 1e-12,
            f"lost {lost:.6e} J, reported {told:.6e} J")

    # A moving plate, restitution that depends on speed
    case = new("moving")
    Uw = (30.0, 0.0, -20.0)
    write_plate(case, "hardSphereWall",
                patches("yMin { restitutionModel McNamaraFalcon; restitution"
                        " 0.7; restitutionSpeed 0.3; friction 0.2; }", LID),
                [beam(20, 3, d)], wall_velocity=Uw)
    mesh(case)
    solve(case)
    U = parcels(case, "0.0004", "U")[1]
    V0 = np.array(direction(20))
    V = hard_sphere(V0 - Uw, np.zeros(3), (0, 1, 0), r,
                    falcon(-V0[1], 0.7, 0.3), 0.2)[0] + Uw
    verdict("hardSphere_movingWall", np.abs(U - V).max() < 1e-11,
            f"largest difference {np.abs(U - V).max():.1e}")


def check_local_law():
    """Restitution from a file, friction by a polynomial, a fit, a law of the
    normal speed: functions of angle and speed."""
    d = 30e-6
    r = d/2
    angles = (2, 8, 25, 40, 70, 90)
    case = new("local")
    laws = {
        "yMin": '{ restitution { type table; file "constant/e.csv"; }'
                " friction { type polynomial; coefficients (0.3 -0.1); } }",
        "yMax": "{ restitution { type McNamaraFalcon; restitution 0.7;"
                " speed 0.3; } friction { type table; angles (0 90);"
                " values (0.1 0.4); } }"}
    write_plate(case, "hardSphereWall",
                patches(*(f"{k} {v}" for k, v in laws.items()),
                        '"[xz]M.*" { type escape; }'),
                [injector((0.3 + 0.01*i, 0.005, 0.1),
                          (0.3 + 0.01*i, 0.005, 0.1), 1, direction(a), d)
                 for i, a in enumerate(angles)],
                lengths=(1, 0.01, 0.2), end=1e-3)
    with open(f"{case}/constant/e.csv", "w") as file:
        file.write("angle,speed,e\n5,20,0.95\n5,200,0.9\n30,20,0.8\n"
                   "30,200,0.7\n90,20,0.6\n90,200,0.3\n")
    mesh(case)
    log = solve(case)
    U, L = parcels(case, "0.001", "U", "angularMomentum")[1:]
    I = 0.1*2500*math.pi/6*d**3*d*d
    worst, impacts, outside = 0, 0, 0
    for a, u, spin in zip(angles, U, L/I):
        V, w, y, t = np.array(direction(a)), np.zeros(3), 0.005, 1e-3
        while True:
            need = (0.01 - y if V[1] > 0 else -y)/V[1]
            if need > t:
                break
            up = V[1] > 0
            n = np.array((0, -1 if up else 1, 0))
            v = np.linalg.norm(V - r*np.cross(w, n))
            beta = math.degrees(math.asin(abs(V[1])/v))
            if up:
                e, f = falcon(abs(V[1]), 0.7, 0.3), 0.1 + 0.3*beta/90
            else:
                at = [np.interp(v, (20, 200), row) for row in
                      ((0.95, 0.9), (0.8, 0.7), (0.6, 0.3))]
                e = np.interp(beta, (5, 30, 90), at)
                f = 0.3 - 0.1*math.radians(beta)
                outside += beta < 5 or v < 20
            V, w = hard_sphere(V, w, n, r, e, f)
            y, t, impacts = 0.01 if up else 0, t - need, impacts + 1
        worst = largest(worst, np.abs(u - V).max(), r*np.abs(spin - w).max())
    c, lid = counters(log), counters(log, "yMax")
    verdict("localLaw_formulae", worst < 1e-10 and impacts > 8,
            f"{impacts} impacts, largest difference {worst:.1e}")
    verdict("localLaw_outside",
            c["outside of coefficients"] == [outside] and outside > 0
            and lid["outside of coefficients"] == [0], str(c))


def check_semi_empirical():
    d = 30e-6
    r = d/2
    table = ("{ type table; angles (5 30 90); speeds (100 300);"
             " values ((0.95 0.9) (0.8 0.75) (0.7 0.6)); }")
    eT = "{ type polynomial; coefficients (0.9 -0.3 0.05); }"
    angles = (3, 10, 24, 26, 60, 90)
    case = new("empirical")
    write_plate(case, "semiEmpiricalRebound",
                patches(f"yMin {{ normal {table}; tangential {eT};"
                        " criticalAngle 25; }".replace("};", "}"), LID),
                [injector((0.4, 0.005, 0.08 + 0.01*i),
                          (0.4, 0.005, 0.08 + 0.01*i), 1, direction(a), d)
                 for i, a in enumerate(angles)], end=6e-4)
    mesh(case)
    log = solve(case)
    U, L = parcels(case, "0.0006", "U", "angularMomentum")[1:]
    I = 0.1*2500*math.pi/6*d**3*d*d
    worst = 0
    for a, u, w in zip(angles, U, L/I):
        beta = math.radians(a)
        eN = [np.interp(a, (5, 30, 90), row)
              for row in ((0.95, 0.8, 0.7), (0.9, 0.75, 0.6))]
        eN = (eN[0] + eN[1])/2
        et = 0.9 - 0.3*beta + 0.05*beta**2
        vx, vy = SPEED*math.cos(beta), SPEED*math.sin(beta)
        spin = 2.5/r*(et - 1)*vx if a < 25 else -et*vx/r
        worst = largest(worst, abs(u[0] - et*vx), abs(u[1] - eN*vy),
                        r*abs(w[2] - spin))
    c = counters(log)
    verdict("semiEmpirical_formulae", worst < 1e-10,
            f"6 angles, largest difference {worst:.1e}")
    verdict("semiEmpirical_counters",
            c["hits"] == [6] and c["rolling impacts"] == [3]
            and c["outside of coefficients"] == [1], str(c))


# -------------------------------------------------- ranks, restarts, counters

ALL_WALLS = '"[xyz]M.*"'
NON_SPHERICAL = f"{BOX} {ROUGH} {LAW}"


def closed(name, model, settings, velocity=(150, -80, 60), **more):
    """Parcels in a closed box, several impacts each."""
    case = new(name)
    sides = {side + end: "wall" for side in "xyz" for end in ("Min", "Max")}
    options = dict(end=2e-3, step=1e-4, write=10, lengths=(0.1, 0.1, 0.1),
                   cells=(6, 5, 4), sides=sides)
    options.update(more)
    write_plate(case, model, settings,
                [injector((0.02, 0.03, 0.04), (0.07, 0.08, 0.06), 400,
                          velocity, BOX_D)], **options)
    mesh(case)
    return case


def check_ranks(*cases):
    """A closed box on two ranks, and restarted, bit for bit as on one; returns
    the counters of the last."""
    for name, model, settings in cases:
        whole = closed("straight", model,
                       patches(f"{ALL_WALLS} {{ {settings} }}"))
        log = solve(whole)
        reference = parcels(whole, "0.002", "U", "angularMomentum")
        hits = sum(counters(log, side)["hits"][0] for side in
                   ("xMin", "xMax", "yMin", "yMax", "zMin", "zMax"))

        ranks = copy_case("straight", new("ranks") + "/case")
        for time in times_of(ranks):
            if time != "0":
                shutil.rmtree(f"{ranks}/{time}")
        decompose(ranks)
        log2 = solve(ranks, 2)
        got = parcels(ranks, "0.002", "U", "angularMomentum")
        same = [np.array_equal(a, b) for a, b in zip(reference, got)]
        verdict(f"ranks_{name}", all(same) and hits > 1000,
                f"{hits:.0f} impacts; identities, U, spin the same: {same}")
        a, b = counters(log), counters(log2)
        verdict(f"ranks_counters_{name}",
                all(np.allclose(a[k], b[k], rtol=1e-12, atol=0) for k in a),
                str(b))

        half = closed("halfway", model,
                      patches(f"{ALL_WALLS} {{ {settings} }}"), end=1e-3)
        solve(half)
        edit(half, "system/controlDict", "endTime 0.001", "endTime 0.002")
        log3 = solve(half)
        got = parcels(half, "0.002", "U", "angularMomentum")
        same = [np.array_equal(a, b) for a, b in zip(reference, got)]
        verdict(f"restart_{name}", all(same),
                f"identities, U, spin bit by bit: {same}")
        c = counters(log3)
        verdict(f"restart_counters_{name}",
                all(np.allclose(a[k], c[k], rtol=1e-12, atol=0) for k in a),
                str(c))
    return c


def check_fates():
    case = closed("fates", "hardSphereWall", patches(
        "zMax { type capture; }", '"yM.*" { restitution 0.5; friction 0; }',
        "xMax { type escape; }",
        '"(xMin|zMin)" { restitution 1; friction 0; }'), end=9e-4, write=9,
        velocity=(70, -80, 60))
    log = solve(case)
    left = parcels(case, "0.0009", "U")[0]
    c, e = counters(log, "zMax"), counters(log, "xMax")
    n = c["captured (number, mass)"]
    x = e["escaped (number, mass)"]
    m = 2500*math.pi/6*BOX_D**3
    verdict("fates_sum", n[0] + x[0] + len(left) == 400 and n[0] > 0
            and x[0] > 0 and c["hits"][0] == n[0]
            and abs(n[1] + x[1] - m*(n[0] + x[0])) < 1e-12*m*400,
            f"400 = {n[0]:.0f} captured + {x[0]:.0f} escaped + {len(left)}")

    # The same with the settings spread over members of multiInteraction
    case = closed("multi", "multiInteraction", """
oneInteractionOnly true;
first { patchInteractionModel hardSphereWall; hardSphereWallCoeffs {
    patches ( zMax { type capture; } "yM.*" { restitution 0.5; friction 0; }
    xMax { type escape; } ); } }
second { patchInteractionModel localInteraction; localInteractionCoeffs {
    patches ( ".*" { type rebound; e 1; mu 0; } ); } }""", end=5e-4, write=1,
        velocity=(70, -80, 60))
    solve(case)
    edit(case, "system/controlDict", "endTime 0.0005", "endTime 0.0009")
    log2 = solve(case)
    ids, U = parcels(case, "0.0009", "U")
    U0 = parcels("fates", "0.0009", "U")[1]
    same = np.array_equal(ids, left) and np.allclose(U, U0, atol=1e-10)
    told = all(np.allclose(a[k], b[k], rtol=1e-12, atol=0)
               for a, b in ((c, counters(log2, "zMax")),
                            (e, counters(log2, "xMax"))) for k in a)
    verdict("multiInteraction", same and told,
            f"the same parcels {same}, the same counters after a restart"
            f" {told}")


def check_plane():
    """In a plane case the velocity across it is taken off, or the speed is
    kept; the direction in the plane is that of the law."""
    sides = {"xMin": "patch", "xMax": "patch", "yMin": "wall",
             "yMax": "patch"}
    at = injector((0.4, 0.005, 0.1), (0.4, 0.005, 0.1), 1, direction(15),
                  BOX_D)
    settings = patches(f"yMin {{ {NON_SPHERICAL} }}",
                       "yMax { type escape; }", '"xM.*" { type escape; }')
    flat = {}
    n = 2000
    line = injector((0.35, 0.005, 0.1), (0.4, 0.005, 0.1), n, direction(15),
                    BOX_D)
    for name, more in (("project", ""),
                       ("keepSpeed", "reducedDimensions keepSpeed;")):
        case = new("plane")
        write_plate(case, "nonSphericalRebound", settings + more, [line],
                    sides=sides, cells=(2, 2, 1))
        mesh(case)
        flat[name] = (parcels(case, "0.0004", "U")[1] if solve(case) else at)
    case = new("space")
    write_plate(case, "nonSphericalRebound",
                patches(f"yMin {{ {NON_SPHERICAL} }}", LID), [line])
    mesh(case)
    solve(case)
    space = parcels(case, "0.0004", "U")[1]
    a, b = flat["project"], flat["keepSpeed"]
    verdict("plane_project", np.abs(a[:, 2]).max() == 0
            and np.abs(a[:, :2] - space[:, :2]).max() < 1e-9,
            "Ux, Uy of the case in space, Uz zero")
    verdict("plane_keepSpeed", np.abs(b[:, 2]).max() == 0 and np.allclose(
        np.linalg.norm(b, axis=1), np.linalg.norm(space, axis=1), rtol=1e-12)
        and np.abs(np.cross(a[:, :2], b[:, :2])).max() < 1e-8,
        "speed of the case in space, direction as projected")


def check_sliding():
    """Without restitution parcels slide in the planes of the walls, where the
    stock tracker may not end."""
    velocity, end = (150, -80, 60), 2e-3
    case = closed("sliding", "hardSphereWall",
                  patches(f"{ALL_WALLS} {{ restitution 0; friction 0.2; }}"),
                  velocity, end=end)
    status, log = run(case, "timeout", "200", SOLVER)
    U = parcels(case, "0.002", "U")[1] if status == 0 else np.zeros((0, 3))
    rake = np.linspace((0.02, 0.03, 0.04), (0.07, 0.08, 0.06), len(U))
    worst, slides = 0, 0
    for x, u in zip(rake, U):
        V, w, t = np.array(velocity, float), np.zeros(3), end
        while True:
            need = np.divide(np.where(V > 0, 0.1 - x, -x), V,
                             out=np.full(3, np.inf), where=abs(V) > 1e-9)
            k = need.argmin()
            if need[k] > t:
                break
            x, t = x + need[k]*V, t - need[k]
            V, w = hard_sphere(V, w, -np.sign(V[k])*np.eye(3)[k], BOX_D/2, 0,
                               0.2)
        worst = largest(worst, np.abs(u - V).max())
        slides += np.count_nonzero(np.abs(V) > 1e-9) == 2
    verdict("slidingParcels", status == 0 and len(U) == 400 and worst < 1e-9
            and slides > 300, f"exit status {status}, {slides} slide in the"
            f" plane of a wall, largest difference {worst:.1e} m/s")


# ------------------------------------------------------------------ bad input

def tabulated(table):
    """Entries of a wall that draws from a table."""
    return (f'{NON_SPHERICAL} method tabulated; table "{table}";'
            " incidenceRange (15 21);")


def check_bad_input():
    good_sphere = "yMin { restitution 0.7; friction 0.2; }"
    lid = LID
    table = os.path.abspath("table.csv")
    tab = tabulated(table)
    H, S, N = ("hardSphereWall", "semiEmpiricalRebound",
               "nonSphericalRebound")

    def ns(text):
        return patches(f"yMin {{ {text} }}", lid)

    def se(**change):
        values = dict(normal="0.8", tangential="0.7", criticalAngle="25")
        values.update(change)
        return patches("yMin { " + " ".join(
            f"{k} {v}" + ("" if v.endswith("}") else ";")
            for k, v in values.items()) + " }", lid)

    rows = [
        ("restitution", H, patches("yMin { restitution 1.2; friction 0.2; }",
                                   lid), ["restitution 1.2", "[0, 1]"]),
        ("friction", H, patches("yMin { restitution 1; friction -0.2; }",
                                lid), ["friction -0.2", "[0, 1e6]"]),
        ("missing", H, patches("yMin { restitution 1; }", lid),
         ["friction"]),
        ("speed", H, patches("yMin { restitutionModel McNamaraFalcon;"
                             " restitution 1; restitutionSpeed 0;"
                             " friction 0; }", lid),
         ["restitutionSpeed 0", "(0, 3e8)"]),
        ("model", H, patches("yMin { restitutionModel Falcon; restitution 1;"
                             " friction 0; }", lid),
         ["restitutionModel Falcon", "McNamaraFalcon"]),
        ("fate", H, patches("yMin { type stick; }", lid),
         ["type stick", "capture"]),
        ("name", H, patches(good_sphere, lid, "plate { type escape; }"),
         ["plate", "yMin"]),
        ("empty", H, "patches ();", ["patches", "at least one"]),
        ("overlap", H, patches(good_sphere, lid, '"y.*" { type escape; }'),
         ["yMin", "twice"]),
        ("unlisted", H, patches(good_sphere, "yMax { type escape; }"),
         ["lacks", "xMin", "zMax", "multiInteraction"]),
        ("reduced", H, patches(good_sphere, lid)
         + " reducedDimensions none;", ["reducedDimensions none",
                                        "keepSpeed"]),
        ("twoModels", "multiInteraction", "oneInteractionOnly true; a {"
         " patchInteractionModel hardSphereWall; hardSphereWallCoeffs { "
         + patches(good_sphere) + " } } b { patchInteractionModel"
         " semiEmpiricalRebound; semiEmpiricalReboundCoeffs { "
         + patches("yMin { type capture; }") + " } }",
         ["yMin", "one law to a patch", "hardSphereWall"]),
        ("eN", S, se(normal="1.5"), ["normal 1.5", "[0, 1]"]),
        ("fit", S, se(tangential="corundumOnSteel"),
         ["tangential corundumOnSteel"]),
        ("grid", S, se(normal="{ type table; angles (10 5);"
                              " values (0.5 0.6); }"), ["must increase"]),
        ("polynomial", S, se(normal="{ type polynomial; coefficients"
                                    " (0.9 -2); }"),
         ["normal coefficients: the polynomial", "[0, 1]"]),
        ("critical", S, se(criticalAngle="91"), ["criticalAngle 91",
                                                 "[0, 90]"]),
        ("shape", N, ns(f"shape {{ type cone; }} {ROUGH} {LAW}"),
         ["type cone", "truncatedBox"]),
        ("shapeSize", N, ns("shape { type box; size (1e-5 0 1e-5); }"
                            f" {ROUGH} {LAW}"), ["size", "0"]),
        ("relief", N, ns(f"{BOX} {LAW} wall {{ type rough; meanSpacing"
                         " 80e-6; sigmaSpacing 30e-6; sigmaHeight 1e-6; }"),
         ["sigmaSpacing 3e-05", "meanSpacing/3"]),
        ("law", N, ns(f"{BOX} {ROUGH} law {{ type restitution;"
                      " normal 2; }"), ["normal 2", "[0, 1]"]),
        ("lawFit", N, ns(f"{BOX} {ROUGH} law {{ type restitution;"
                         " tangential corundumOnSteel; }"),
         ["tangential corundumOnSteel", "GrantTabakoff"]),
        ("lawFile", N, ns(f"{BOX} {ROUGH} law {{ type friction; friction"
                          ' { type table; file "/nowhere"; } }'),
         ["friction file", "/nowhere", "cannot be read"]),
        ("lawTable", H, patches(
            "yMin { restitution { type table; angles (10 20); speeds (1 2);"
            " values (0.1 0.2); } friction 0; }", lid), ["need 4 values"]),
        ("lawSpeed", H, patches(
            "yMin { restitution { type McNamaraFalcon; restitution 0.5;"
            " speed 0; } friction 0; }", lid), ["speed 0", "(0, 3e8)"]),
        ("lawFriction", H, patches(
            "yMin { restitution 1; friction { type McNamaraFalcon;"
            " restitution 0.5; speed 1; } }", lid),
         ["type McNamaraFalcon", "polynomial"]),
        ("maxImpacts", N, ns(f"{NON_SPHERICAL} maxImpacts 0;"),
         ["maxImpacts 0", "[1, 1e9]"]),
        ("seed", N, patches(f"yMin {{ {NON_SPHERICAL} }}", lid)
         + " seed -1;", ["seed -1", "[0, 9e15]"]),
        ("lay", N, ns(f"{NON_SPHERICAL} lay along;"),
         ["lay along", "acrossMotion"]),
        ("layDirection", N, ns(f"{NON_SPHERICAL} lay fixed;"
                               " layDirection (0 0 0);"),
         ["layDirection", "zero"]),
        ("layNormal", N, ns(f"{NON_SPHERICAL} lay fixed;"
                            " layDirection (0 -2 0);"),
         ["layDirection (0 -2 0)", "along the wall"]),
        ("method", N, ns(f"{NON_SPHERICAL} method sampled;"),
         ["method sampled", "tabulated"]),
        ("tableFile", N, ns(tab.replace(table, "/nowhere.csv")),
         ["/nowhere.csv", "cannot be read"]),
        ("tableShape", N, ns(tab.replace("32e-6", "30e-6")), ["shape"]),
        ("tableLaw", N, ns(tab.replace("normal 0.8", "normal 0.7")),
         ["law restitution 0.8 0", "law restitution 0.7 0"]),
        ("tableRelief", N, ns(tab.replace("sigmaHeight 20e-6",
                                          "sigmaHeight 10e-6")),
         ["wall rough", "2e-05", "1e-05"]),
        ("tableSize", N, ns(tab.replace("32e-6 25.6e-6 25.6e-6",
                                        "64e-6 51.2e-6 51.2e-6")), ["size"]),
        ("tableRange", N, ns(tab.replace("(15 21)", "(5 21)")),
         ["15 to 21", "5 to 21"]),
        ("tableLay", N, ns(tab + " lay fixed; layDirection (0 0 1);"),
         ["lay fixed", "direct"]),
        ("tableLaySmooth", N, ns(
            f"method tabulated; table {table}; incidenceRange (15 21); {BOX}"
            f" {LAW} wall {{ type smooth; }} lay acrossFlow;"),
         ["lay acrossFlow", "direct"]),
        ("tableOrientation", N, ns(tab + " orientation uniformEuler;"),
         ["orientation"]),
    ]
    check_refusals(rows)


def check_while_running():
    """What the first impact shows: a parcel of another size than the table's,
    a mesh that is too coarse for the relief."""
    N = "nonSphericalRebound"
    case = new("bad")
    entries = tabulated(os.path.abspath("table.csv"))
    write_plate(case, N, patches(f"yMin {{ {entries} }}", LID),
                [beam(18, 2, 1.1*BOX_D)])
    mesh(case)
    status, text = run(case, SOLVER)
    verdict("refuses_parcelSize", status
            and "diameterTolerance" in complaint(text), complaint(text))

    case = new("coarse")
    at = (0.4, 0.005, 5e-5)
    write_plate(case, N,
                patches(f"yMin {{ {NON_SPHERICAL} }}", LID),
                [injector(at, at, 1, direction(18), BOX_D)],
                cells=(10000, 1, 1), lengths=(1, 0.1, 1e-4))
    mesh(case)
    status, text = run(case, SOLVER)
    verdict("warnsOfCoarseRelief", status == 0 and "0.00016" in text
            and text.count("mean pitch of the relief") == 1,
            complaint(text) if status else "one warning with the numbers")


def check_refusals(rows):
    """Name, model, its dictionary, and words that its refusal must have."""
    for name, model, coeffs, words in rows:
        case = new("bad")
        write_plate(case, model, coeffs, [beam(18, 2)])
        mesh(case)
        refuses(f"refuses_{name}", run(case, SOLVER), words)


def main():
    n = int(sys.argv[1]) if len(sys.argv) > 1 else 25000
    check_hard_sphere()
    check_local_law()
    check_semi_empirical()
    check_indicatrices(n)
    check_lay()
    table = (f'method tabulated; table "{os.path.abspath("table.csv")}";'
             " incidenceRange (15 21);")
    check_ranks(
        ("direct", "nonSphericalRebound", NON_SPHERICAL),
        ("tabulated", "nonSphericalRebound", NON_SPHERICAL + table),
        ("hardSphere", "hardSphereWall", "restitution 0.8; friction 0.3;"))
    check_fates()
    check_plane()
    check_sliding()
    check_bad_input()
    check_while_running()


if __name__ == "__main__":
    main()
