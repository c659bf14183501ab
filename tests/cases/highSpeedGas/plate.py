# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Laminar layer on an adiabatic flat plate at Mach 2 against the self-similar
solution of the compressible boundary-layer equations; stands in a folder of
its own.

With eta = sqrt(Ue/(2 nu_e x)) int rho/rho_e dy and C = rho mu/(rho_e mu_e),

    (C f'')' + f f'' = 0,   (C/Pr g')' + f g' + C (gamma - 1) M^2 f''^2 = 0,

u = Ue f', T = Te g (Stewartson, The Theory of Laminar Boundary Layers in
Compressible Fluids, 1964).
"""

import numpy as np
from caseTools import (GAMMA, R_GAS, box, last_fields, must, run, verdict,
                       write_block, write_case, write_field)

MACH, TE, LENGTH, HEIGHT, REYNOLDS = 2.0, 300.0, 0.1, 0.02, 1e5
CP = GAMMA*R_GAS/(GAMMA - 1)
PR = CP/(1.32*CP/GAMMA + 1.77*R_GAS)


def viscosity(T):
    return 1.458e-6*T**1.5/(T + 110.4)


UE = MACH*np.sqrt(GAMMA*R_GAS*TE)
RHO = REYNOLDS*viscosity(TE)/(UE*LENGTH)


def rates(s):
    """State f, f', C f'', g, (C/Pr) g'."""
    f, fp, tau, g, q = s
    c = viscosity(g*TE)/viscosity(TE)/g
    fpp = tau/c
    return np.array([fp, fpp, -f*fpp, q*PR/c,
                     -f*q*PR/c - c*(GAMMA - 1)*MACH**2*fpp**2])


def layer(tau_wall, g_wall, h=0.01, end=8.0):
    s = np.array([0, 0, tau_wall, g_wall, 0.0])
    rows = [s]
    for _ in range(int(end/h)):
        a = rates(s)
        b = rates(s + 0.5*h*a)
        c = rates(s + 0.5*h*b)
        s = s + h/6*(a + 2*b + 2*c + rates(s + h*c))
        rows.append(s)
    return np.array(rows)


def miss(x):
    end = layer(*x)[-1]
    return np.array([end[1] - 1, end[3] - 1])


x = np.array([0.47, 1 + 0.85*0.5*(GAMMA - 1)*MACH**2])
for _ in range(12):
    m = miss(x)
    J = np.column_stack([(miss(x + d) - m)/1e-6
                         for d in np.eye(2)*1e-6])
    x = x - np.linalg.solve(J, m)
exact = layer(*x)
eta = 0.01*np.arange(len(exact))
stretch = np.concatenate(
    [[0], np.cumsum(0.5*(exact[1:, 3] + exact[:-1, 3])*np.diff(eta))])

NX, NY = 60, 50
write_case("plate", {"endTime": 1, "deltaT": 1, "writeInterval": 1},
           {"mode": "steady", "viscous": "yes", "residual": 1e-5})
write_block("plate", box((LENGTH, HEIGHT, 1e-3)), (NX, NY, 1),
            {"xMin": "patch", "xMax": "patch", "yMin": "wall",
             "yMax": "patch"}, "(1 30 1)")
free = "type zeroGradient;"
for name, value, wall in (("p", RHO*R_GAS*TE, free), ("T", TE, free),
                          ("U", (UE, 0, 0), "type noSlip;")):
    stream = ("type fixedValue; value uniform "
              + (f"({UE!r} 0 0)" if name == "U" else repr(float(value))) + ";")
    write_field("plate", name, value,
                {"xMin": stream, "xMax": free, "yMin": wall, "yMax": free,
                 "zMin": "type empty;", "zMax": "type empty;"})
must("plate", "blockMesh")
status, text = run("plate", "rhoCentralParcelFoam")
must("plate", "postProcess", "-func", "writeCellCentres", "-latestTime")
T, U, C = last_fields("plate", "T U C")
verdict("plateSteady", status == 0 and "Gas: steady after" in text,
        "marched to an imbalance of 1e-5")

column = int(0.8*NX) + NX*np.arange(NY)
where = C[column]
scale = np.sqrt(2*viscosity(TE)/RHO*where[0, 0]/UE)
u = UE*np.interp(where[:, 1]/scale, stretch, exact[:, 1])
t = TE*np.interp(where[:, 1]/scale, stretch, exact[:, 3])
inside = where[:, 1]/scale < stretch[-1]
du = abs(U[column, 0] - u)[inside].max()/UE
dt = abs(T[column] - t)[inside].max()/TE
verdict("plateVelocity", du < 0.02, f"largest error {du:.2e} Ue at"
        f" x = {where[0, 0]/LENGTH:.2f} L, tolerance 2e-2 (displacement)")
verdict("plateTemperature", dt < 0.02,
        f"largest error {dt:.2e} Te, tolerance 2e-2 (displacement)")
