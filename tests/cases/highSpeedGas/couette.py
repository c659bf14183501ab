# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Compressible Couette flow against its exact solution; stands in a folder of
its own.

Between isothermal plates at equal temperature, one at rest, one moving with V,
the stress is uniform, and the heat flux balances its work. As the conductivity
of Sutherland's gas is proportional to its viscosity, lambda = k mu,

    T(u) = Tw + u (V - u)/(2 k),    y(u)/h = int_0^u mu dT / int_0^V mu du
"""

import numpy as np
from caseTools import (GAMMA, R_GAS, box, copy_case, decompose, largest,
                       last_fields, must, solve, verdict, write_block,
                       write_case, write_field)

V, TW, HEIGHT = 600.0, 300.0, 1e-3
CV = R_GAS/(GAMMA - 1)
K = 1.32*CV + 1.77*R_GAS

u = np.linspace(0, V, 20001)
mu = 1.458e-6*(TW + u*(V - u)/(2*K))**1.5/(TW + u*(V - u)/(2*K) + 110.4)
y = np.concatenate([[0], np.cumsum(0.5*(mu[1:] + mu[:-1])*np.diff(u))])
y /= y[-1]


def prepare(case, n, length=1e-4, lean=0):
    """n cells between the plates, whose lines lean by so many heights."""
    write_case(case, {"endTime": 1, "deltaT": 1, "writeInterval": 1},
               {"mode": "steady", "viscous": "yes", "residual": 1e-11,
                "maxCo": 1000, "maxIterations": 20000})
    corners = [(x + lean*y, y, z)
               for x, y, z in box((length, HEIGHT, 1e-4))]
    write_block(case, corners, (2, n, 1),
                {"xMin": "cyclic", "xMax": "cyclic", "yMin": "wall",
                 "yMax": "wall"})
    sides = {"xMin": "type cyclic;", "xMax": "type cyclic;",
             "zMin": "type empty;", "zMax": "type empty;"}
    fixed = "type fixedValue; value uniform "
    write_field(case, "p", 1e3, {**sides, "yMin": "type zeroGradient;",
                                 "yMax": "type zeroGradient;"})
    write_field(case, "T", TW, {**sides, "yMin": f"{fixed}{TW};",
                                "yMax": f"{fixed}{TW};"})
    write_field(case, "U", (0.5*V, 0, 0),
                {**sides, "yMin": "type noSlip;",
                 "yMax": f"{fixed}({V} 0 0);"})
    must(case, "blockMesh")


def error(case, n):
    """Largest error of u in V, and of T in Tw."""
    solve(case)
    T, U = last_fields(case, "T U")
    middle = (np.arange(2*n)//2 + 0.5)/n
    exact = np.interp(middle, y, u)
    return (abs(U[:, 0] - exact).max()/V,
            abs(T - TW - exact*(V - exact)/(2*K)).max()/TW)


errors = []
for n in 10, 20, 40:
    case = f"couette{n}"
    prepare(case, n)
    if n == 10:
        copy_case(case, "couetteRanks")
    errors.append(error(case, n))

worst = errors[-1]
verdict("couette", largest(worst) < 2e-4,
        f"largest error of u {worst[0]:.1e} V, of T {worst[1]:.1e} Tw,"
        " tolerance 2e-4")
order = np.log2(errors[0][0]/errors[-1][0])/2
verdict("couetteOrder", order > 1.8, f"order {order:.2f} in u, wanted 1.8")

for lean in 5, 15:
    prepare(f"couetteLeaning{lean}", 20, 100*HEIGHT, lean)
    leaning = error(f"couetteLeaning{lean}", 20)
    verdict(f"couetteLeaning{lean}",
            all(a < 1.01*b for a, b in zip(leaning, errors[1])),
            f"lines of cells lean by {lean} heights: errors "
            + " ".join(f"{e:.4e}" for e in leaning) + ", upright "
            + " ".join(f"{e:.4e}" for e in errors[1]) + ", may be 1.01 of it")

decompose("couetteRanks", (1, 2, 1))
solve("couetteRanks", 2)
must("couetteRanks", "reconstructPar", "-latestTime")
difference = largest(abs(a - b).max()/scale for a, b, scale in zip(
    last_fields("couetteRanks", "T U"), last_fields("couette10", "T U"),
    (TW, V)))
verdict("couetteTwoRanks", difference < 1e-7,
        f"differs from one rank by {difference:.1e}, tolerance 1e-7")
