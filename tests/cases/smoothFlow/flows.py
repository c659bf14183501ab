# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Smooth exact solutions and the thermally perfect gas."""

import numpy as np
from caseTools import (GAMMA, R_GAS, box, copy_case, edit, largest,
                       last_fields, must, solve, verdict, write_block,
                       write_case, write_field, write_foam)


def orders(errors):
    """Observed orders of errors on meshes that are halved each time."""
    e = np.array(errors)
    return np.log2(e[:-1]/e[1:])


def said(errors):
    return (" ".join(f"{e:.2e}" for e in errors) + ", orders "
            + " ".join(f"{o:.2f}" for o in orders(errors)))


# ------------------------------------------------- entropy wave, one period

def entropy_wave(case, n, flux, limiter):
    """Mean density error after one period of a wave carried by the gas."""
    u, p = 300.0, 1e5
    write_case(case, {"endTime": 1/u, "deltaT": 1/u/(2*n),
                      "writeInterval": 1/u},
               {"mode": "transient", "maxCo": 0.5}, flux, limiter)
    write_block(case, box((1, 0.1, 0.1)), (n, 1, 1),
                {"xMin": "cyclic", "xMax": "cyclic"})
    sides = {s + e: "type empty;" for s in "yz" for e in ("Min", "Max")}
    sides.update(xMin="type cyclic;", xMax="type cyclic;")
    k = 2*np.pi
    x = np.arange(n)/n
    # Cell averages of 1 + 0.2 sin(k x)
    rho = 1 + 0.2*(np.cos(k*x) - np.cos(k*(x + 1/n)))*n/k
    write_field(case, "p", p, sides)
    write_field(case, "T", p/(rho*R_GAS), sides)
    write_field(case, "U", (u, 0, 0), sides)
    must(case, "blockMesh")
    solve(case)
    now, = last_fields(case, "rho")
    return abs(now/now.mean() - rho/rho.mean()).mean()


for flux, limiter in (("HLLC", "vanAlbada"), ("SLAU2", "vanAlbada"),
                      ("AUSMPlusUp", "vanAlbada"), ("Kurganov", "vanAlbada"),
                      ("HLLC", "vanLeer"), ("HLLC", "MUSCL")):
    errors = [entropy_wave(f"wave_{flux}_{limiter}_{n}", n, flux, limiter)
              for n in (40, 80, 160)]
    verdict(f"entropyWave_{flux}_{limiter}", orders(errors)[-1] >= 1.9,
            said(errors) + ", wanted 1.9")


# ---------------------------------------------------------- isentropic vortex

def vortex(case, n):
    """Mean density error of a vortex in free flight across a periodic square
    (Shu's vortex: isentropic, an exact steady solution in the moving frame).
    Cells hold the values of their centres, which is second-order too."""
    side, beta = 10.0, 5.0
    scale = np.sqrt(R_GAS*300)      # sqrt(p/rho) far away
    time = 1.0/scale
    write_case(case, {"endTime": time, "deltaT": time*0.8/n,
                      "writeInterval": time}, {"mode": "transient"})
    write_block(case, box((side, side, 0.1)), (n, n, 1),
                {s + e: "cyclic" for s in "xy" for e in ("Min", "Max")})
    sides = {s + e: "type cyclic;" for s in "xy" for e in ("Min", "Max")}
    sides.update(zMin="type empty;", zMax="type empty;")
    c = (np.arange(n) + 0.5)*side/n
    y, x = (a.ravel() for a in np.meshgrid(c, c, indexing="ij"))

    def state(shift):
        dx = (x - shift - 0.5*side + 0.5*side) % side - 0.5*side
        dy = (y - shift - 0.5*side + 0.5*side) % side - 0.5*side
        r2 = dx*dx + dy*dy
        swirl = beta/(2*np.pi)*np.exp(0.5*(1 - r2))
        t = 1 - (GAMMA - 1)/(2*GAMMA)*swirl**2
        return t, 1 - dy*swirl, 1 + dx*swirl

    t, u, v = state(0)
    write_field(case, "p", 1e5*t**(GAMMA/(GAMMA - 1)), sides)
    write_field(case, "T", 300*t, sides)
    write_field(case, "U", scale*np.column_stack([u, v, 0*u]), sides)
    must(case, "blockMesh")
    solve(case)
    p, T = last_fields(case, "p T")
    t, u, v = state(1.0)
    return abs(p/1e5/(T/300) - t**(1/(GAMMA - 1))).mean()


errors = [vortex(f"vortex_{n}", n) for n in (32, 64, 128)]
verdict("vortex", orders(errors)[-1] >= 1.9, said(errors) + ", wanted 1.9")


# ------------------------------------------------ spherical source, on a wedge

def source_mach(area):
    """Supersonic Mach number at the area ratio to the throat."""
    g = GAMMA
    low, high = np.ones_like(area), np.full_like(area, 50.0)
    for _ in range(100):
        m = 0.5*(low + high)
        a = (2/(g + 1)*(1 + 0.5*(g - 1)*m*m))**(0.5*(g + 1)/(g - 1))/m
        low, high = np.where(a < area, m, low), np.where(a < area, high, m)
    return m


def source(r):
    """p, T and speed of the steady source with its sonic sphere at r = 1."""
    m = source_mach(np.asarray(r, float)**2)
    t = 1/(1 + 0.5*(GAMMA - 1)*m*m)
    T = 1000*t
    return 1e6*t**(GAMMA/(GAMMA - 1)), T, m*np.sqrt(GAMMA*R_GAS*T)


def spherical_source(case, n):
    """Largest mean error of p, T and speed of the steady source on a wedge
    from its axis to a cone of 30 degrees, radius 1.2 to 2.4."""
    r1, r2, top = 1.2, 2.4, np.radians(30)
    half = np.radians(1.0)

    def at(r, angle, side):
        h = r*np.sin(angle)
        return (r*np.cos(angle), h*np.cos(half), side*h*np.sin(half))

    def text(q):
        return "(" + " ".join(repr(float(v)) for v in q) + ")"

    points = [at(r1, 0, 0), at(r2, 0, 0), at(r2, top, -1), at(r1, top, -1),
              at(r2, top, 1), at(r1, top, 1)]
    arcs = [f"arc {a} {b} {text(at(r, 0.5*top, s))}"
            for a, b, r, s in ((0, 3, r1, -1), (1, 2, r2, -1),
                               (0, 5, r1, 1), (1, 4, r2, 1))]
    write_case(case, {"endTime": 1, "deltaT": 1, "writeInterval": 1},
               {"mode": "steady", "residual": 1e-9, "maxIterations": 3000})
    write_foam(case, "system/blockMeshDict", f"""
scale 1;
vertices ({' '.join(map(text, points))});
blocks (hex (0 1 2 3 0 1 4 5) ({n} {n} 1) simpleGrading (1 1 1));
edges ({' '.join(arcs)});
boundary
(
    inlet {{ type patch; faces ((0 3 5 0)); }}
    outlet {{ type patch; faces ((1 2 4 1)); }}
    cone {{ type wall; faces ((3 2 4 5)); }}
    axis {{ type empty; faces ((0 1 1 0)); }}
    back {{ type wedge; faces ((0 1 2 3)); }}
    front {{ type wedge; faces ((0 1 4 5)); }}
);""")
    common = {"axis": "type empty;", "back": "type wedge;",
              "front": "type wedge;", "outlet": "type zeroGradient;"}
    p, T, u = source(np.array([r1]))
    angle = (np.arange(n) + 0.5)*top/n
    flow = "\n".join(text((u[0]*np.cos(a), u[0]*np.sin(a), 0)) for a in angle)
    write_field(case, "p", p[0], {**common, "cone": "type zeroGradient;",
                                  "inlet": f"type fixedValue; value uniform"
                                           f" {p[0]!r};"})
    write_field(case, "T", T[0], {**common, "cone": "type zeroGradient;",
                                  "inlet": f"type fixedValue; value uniform"
                                           f" {T[0]!r};"})
    write_field(case, "U", (u[0], 0, 0), {
        **common, "cone": "type slip;",
        "inlet": "type fixedValue; value nonuniform List<vector>"
                 f" {n}({flow});"})
    must(case, "blockMesh")
    log = solve(case)
    must(case, "postProcess", "-func", "writeCellCentres", "-latestTime")
    p, T, U, C = last_fields(case, "p T U C")
    exact = source(np.sqrt((C**2).sum(axis=1)))
    speed = np.sqrt((U**2).sum(axis=1))
    return ("Gas: steady after" in log,
            largest(abs(a/b - 1).mean() for a, b in zip((p, T, speed), exact)),
            abs((U[:, 0]*C[:, 1] - U[:, 1]*C[:, 0])
                / (speed*np.hypot(C[:, 0], C[:, 1]))).max())


rows = [spherical_source(f"source_{n}", n) for n in (20, 40)]
verdict("wedgeSource_steady", all(row[0] for row in rows),
        "marched to a mass imbalance of 1e-9")
errors = [row[1] for row in rows]
verdict("wedgeSource", errors[-1] < 1e-3 and orders(errors)[-1] >= 1.8,
        "largest mean relative error of p, T, speed " + said(errors)
        + ", wanted 1e-3 and 1.8")
verdict("wedgeSource_radial", rows[-1][2] < 5e-3,
        f"largest angle off the radius {rows[-1][2]:.1e} rad,"
        " tolerance 5e-3")


# ------------------------------------------------------ thermally perfect gas

# Nitrogen-like polynomials of cp/R in T, below and above 1000 K; the test
# integrates whatever stands here
LOW = (3.53100528, -1.23660988e-4, -5.02999433e-7, 2.43530612e-9,
       -1.40881235e-12, -1046.97628, 2.96747038)
HIGH = (2.95257637, 1.39690040e-3, -4.92631603e-7, 7.86010195e-11,
        -4.60755204e-15, -923.948688, 5.87188762)


def janaf(low, high):
    def row(a):
        return "(" + " ".join(repr(float(v)) for v in a) + ")"
    return (f"Tlow 100; Thigh 6000; Tcommon 1000; lowCpCoeffs {row(low)};"
            f" highCpCoeffs {row(high)};")


def tube(case, thermo, thermodynamics, left, right, n, end, wall):
    """States (p, T, u) on both halves of a tube of 1 m."""
    write_case(case, {"endTime": end, "deltaT": end/100,
                      "writeInterval": end}, {"mode": "transient"},
               thermo=thermo, thermodynamics=thermodynamics)
    write_block(case, box((1, 0.01, 0.01)), (n, 1, 1),
                {"xMin": "patch", "xMax": "wall" if wall else "patch"})
    sides = {s + e: "type empty;" for s in "yz" for e in ("Min", "Max")}
    zero = {**sides, "xMin": "type zeroGradient;",
            "xMax": "type zeroGradient;"}
    x = (np.arange(n) + 0.5)/n
    p, T, u = (np.where(x < 0.5, a, b) for a, b in zip(left, right))
    write_field(case, "p", p, zero)
    write_field(case, "T", T, zero)
    write_field(case, "U", np.column_stack([u, 0*u, 0*u]),
                {**zero, "xMax": "type slip;"} if wall else zero)
    must(case, "blockMesh")
    solve(case)
    return last_fields(case)


sod = (1e5, 348.4, 0.0), (1e4, 278.7, 0.0)
cp = GAMMA*R_GAS/(GAMMA - 1)
plain = tube("hConst", "hConst", f"Cp {cp!r}; Hf 0;", *sod, 200, 6e-4, False)
R = np.mean(plain[0]/(plain[3]*plain[1]))   # with OpenFOAM's gas constant
flat = (cp/R, 0, 0, 0, 0, 0, 0)
table = tube("flat", "janaf", janaf(flat, flat), *sod, 200, 6e-4, False)
d = largest(abs(a/b - 1).max() for a, b in
            ((plain[0], table[0]), (plain[1], table[1]), (plain[3], table[3])))
verdict("janafConstantCp", d < 1e-9,
        f"constant polynomials against hConst: {d:.1e}, tolerance 1e-9")


# A gas colder than its model is good for, to begin with and after a restart
cold = tube("cold", "janaf", janaf(LOW, HIGH), (1e4, 60.0, 0.0),
            (1e4, 60.0, 0.0), 10, 1e-5, False)
copy_case("cold", "coldAgain")
edit("coldAgain", "system/controlDict", "endTime 1e-05;", "endTime 2e-05;")
solve("coldAgain")
d = largest(abs(f[1]/60 - 1).max() for f in (cold, last_fields("coldAgain")))
verdict("janafColderThanItsModel", d < 1e-12,
        f"temperature changed by {d:.1e}, tolerance 1e-12")


def energy(T):
    """Internal energy over R, integrated from the common temperature."""
    a = np.array((LOW if T < 1000 else HIGH)[:5])
    k = np.arange(1, 6)
    return (a/k*(T**k - 1000.0**k)).sum() - (T - 1000)


def reflected(p1, T1, u1):
    """State behind the shock that brings the stream to rest at a wall."""
    rho1, e1 = p1/(R*T1), energy(T1)*R

    def surplus(s):
        rho2 = rho1*(u1 + s)/s
        p2 = p1 + rho1*(u1 + s)*u1
        T2 = p2/(R*rho2)
        return (energy(T2)*R - e1 - 0.5*(p1 + p2)*(1/rho1 - 1/rho2), p2, T2)

    # More specific heat makes the gas denser and the shock slower than those
    # of constant specific heat
    m = 0.25*(GAMMA + 1)*u1
    high = m + np.sqrt(m*m + GAMMA*R*T1) - u1
    low, high = 0.3*high, 1.05*high
    for _ in range(200):
        s = 0.5*(low + high)
        # A faster shock leaves the gas hotter than its energy allows
        if surplus(s)[0] > 0:
            high = s
        else:
            low = s
    return surplus(s)[1:] + (s,)


for speed in 500.0, 2000.0:
    p1, T1 = 1e4, 300.0
    p2, T2, s = reflected(p1, T1, speed)
    end = 0.4/s
    p, T, U, rho = tube(f"reflected_{speed:g}", "janaf", janaf(LOW, HIGH),
                        (p1, T1, speed), (p1, T1, speed), 200, end, True)
    x = (np.arange(200) + 0.5)/200
    plateau = (x > 0.68) & (x < 0.92)   # off the shock and the wall's heating
    d = [abs(np.mean(a[plateau])/b - 1) for a, b in ((p, p2), (T, T2))]
    # What a gas of constant specific heat would do tells the test's worth
    m = 0.25*(GAMMA + 1)*speed
    cold = m + np.sqrt(m*m + GAMMA*R*T1)
    wrong = p1 + p1/(R*T1)*cold*speed
    T_wrong = wrong/(R*p1/(R*T1)*cold/(cold - speed))
    verdict(f"janafShock_{speed:g}", largest(d) < 2e-3,
            f"p off by {d[0]:.1e}, T by {d[1]:.1e} from p = {p2:.6g} Pa,"
            f" T = {T2:.6g} K, tolerance 2e-3 (constant cp: T ="
            f" {T_wrong:.5g} K)")
