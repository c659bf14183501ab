# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Sod's problem in a tube of 1 m with 400 cells."""

import numpy as np
from caseTools import (GAMMA, R_GAS, box, decompose, edit, largest,
                       last_fields, must, same_bits, solve, times_of, verdict,
                       write_block, write_case, write_field)
from riemann import riemann

N = 400
LEFT, RIGHT = (1.0, 0.0, 1e5), (0.125, 0.0, 1e4)    # rho, u, p
END = 6e-4
# Mean density error against the exact solution [kg/m3]. The four fluxes have
# 1.55e-3 to 1.88e-3 with the limiter vanAlbada, a first-order run 8.1e-3.
BOUND = 2.5e-3


def tube(case, flux="HLLC", limiter="vanAlbada", axis=0, closed=False,
         end=END, **control):
    lengths, cells = [0.0025]*3, [1]*3
    lengths[axis], cells[axis] = 1, N
    name = "xyz"[axis]
    kind = "wall" if closed else "patch"
    settings = {"endTime": end, "deltaT": 2e-6, "writeInterval": 0.5*end}
    settings.update(control)
    write_case(case, settings, {"mode": "transient"}, flux, limiter)
    write_block(case, box(lengths), cells,
                {name + "Min": kind, name + "Max": kind})
    sides = {s + e: "type empty;" for s in "xyz" if s != name
             for e in ("Min", "Max")}
    ends = name + "Min", name + "Max"
    zero = {**sides, **dict.fromkeys(ends, "type zeroGradient;")}
    slip = {**sides, **dict.fromkeys(ends, "type slip;")}
    x = (np.arange(N) + 0.5)/N
    rho, _, p = (np.where(x < 0.5, a, b) for a, b in zip(LEFT, RIGHT))
    write_field(case, "p", p, zero)
    write_field(case, "T", p/(rho*R_GAS), zero)
    write_field(case, "U", (0, 0, 0), slip if closed else zero)
    must(case, "blockMesh")
    return case


def error(case, axis=0):
    """Mean |rho - exact| over the tube; the exact solution is averaged over
    each cell."""
    inside = (np.arange(20) + 0.5)/20 - 0.5
    x = (np.arange(N)[:, None] + 0.5 + inside)/N
    exact = riemann(LEFT, RIGHT, (x - 0.5)/END, GAMMA)[0].mean(axis=1)
    p, U, rho = last_fields(case, "p U rho")
    across = np.delete(U, axis, axis=1)
    return abs(rho - exact).mean(), abs(across).max()


# The solver of this test against the star state of Sod's problem in the
# literature (Toro, Riemann Solvers and Numerical Methods, table 4.2)
star = riemann((1, 0, 1), (0.125, 0, 0.1), np.array([0.5, 1.2]), 1.4)
verdict("exactSolution",
        np.allclose(star[2], 0.30313, atol=6e-6)
        and np.allclose(star[1], 0.92745, atol=6e-6)
        and np.allclose(star[0], (0.42632, 0.26557), atol=6e-6),
        "star pressure, velocity and densities of Toro's table 4.2")

for flux in "Kurganov", "SLAU2", "AUSMPlusUp", "HLLC":
    solve(tube(flux, flux))
    e, _ = error(flux)
    verdict(f"sod_{flux}", e < BOUND,
            f"mean density error {e:.3e} kg/m3, bound {BOUND:g}")
solve(tube("upwind", limiter="upwind"))
e, _ = error("upwind")
verdict("boundTellsFirstOrder", e > 2*BOUND,
        f"a first-order run has {e:.3e}, more than twice the bound")

# The same along the other axes, and with the step chosen by the solver
first = last_fields("HLLC", "p rho")
for axis in 1, 2:
    name = "xyz"[axis]
    solve(tube(name, axis=axis))
    _, across = error(name, axis)
    d = max(abs(a/b - 1).max()
            for a, b in zip(last_fields(name, "p rho"), first))
    verdict(f"along_{name}", d < 1e-12 and across == 0,
            f"differs from the tube along x by {d:.1e}, tolerance 1e-12")
solve(tube("adjusted", adjustTimeStep="yes", writeControl="adjustable"))
e, _ = error("adjusted")
verdict("adjustTimeStep",
        e < BOUND and times_of("adjusted") == times_of("HLLC"),
        f"mean density error {e:.3e} kg/m3, writes at the wanted times"
        f" {times_of('adjusted')}")


# A closed tube, long enough for the shock to return twice. OpenFOAM has its
# own gas constant, which with the case's Cp also shifts gamma in its 7th digit
def contents(rho, U, p, cv_by_R):
    return rho.sum(), (p*cv_by_R + 0.5*rho*(U**2).sum(axis=1)).sum()


for flux in "Kurganov", "SLAU2", "AUSMPlusUp", "HLLC":
    case = "closed" + flux
    solve(tube(case, flux, closed=True, end=4e-3))
    p, T, U, rho = last_fields(case)
    R = np.mean(p/(rho*T))
    cv_by_R = GAMMA/(GAMMA - 1)*R_GAS/R - 1
    p0, T0, U0 = last_fields(case, "p T U", "0")
    start = contents(p0/(R*T0), np.zeros((N, 3)), p0, cv_by_R)
    d = [abs(a/b - 1) for a, b in zip(contents(rho, U, p, cv_by_R), start)]
    verdict(f"closedTube_{flux}", largest(d) < 1e-12,
            f"mass kept to {d[0]:.1e}, energy to {d[1]:.1e},"
            " tolerance 1e-12")

# Restart in the middle, two ranks
middle, end = times_of("HLLC")[1:]
tube("halves", endTime=middle)
solve("halves")
edit("halves", "system/controlDict", f"endTime {middle};", f"endTime {END};")
log = solve("halves")
bad = same_bits("HLLC", "halves", end)
verdict("restartBitwise", not bad and f"Time = {middle}\n" not in log,
        "straight run = restarted run; different: " + (", ".join(bad)
                                                       or "nothing"))

tube("two")
decompose("two")
solve("two", 2)
must("two", "reconstructPar")
d = max(abs(a/b - 1).max()
        for a, b in zip(last_fields("two", "p rho"), first))
verdict("twoRanks", d < 1e-12,
        f"largest relative difference {d:.1e}, tolerance 1e-12")
