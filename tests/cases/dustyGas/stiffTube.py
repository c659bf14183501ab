# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Shock tubes full of fine grains that outweigh the gas ten times, at the steps
of the gas: against the exact solution of the gas that moves and heats as one
with its grains."""

import numpy as np

from caseTools import (GAMMA, R_GAS, box, last_fields, must, solve, verdict,
                       write_block, write_case, write_field, write_foam)
from riemann import riemann
from spinningCloud import write_cloud

CELLS, LENGTH, WIDTH, STEP = 200, 1.0, 0.01, 5e-6
T, LOW, CP_P, RHO_P = 300.0, 1e5, 800, 2500


def tube(case, ratio, load, d, per_cell, steps):
    write_case(case, {"endTime": steps*STEP, "deltaT": STEP,
                      "writeInterval": steps*STEP,
                      "libs": "(spinningParcel parcelInjection)"},
               {"mode": "transient"})
    ends = {"xMin": "wall", "xMax": "wall"}
    sides = {s + e: "empty" for s in "yz" for e in ("Min", "Max")}
    write_block(case, box((LENGTH, WIDTH, WIDTH)), (CELLS, 1, 1),
                {**ends, **sides})
    must(case, "blockMesh")
    boundary = {**{s: "type zeroGradient;" for s in ends},
                **{s: "type empty;" for s in sides}}
    x = (np.arange(CELLS) + 0.5)*LENGTH/CELLS
    p = np.where(x < 0.5*LENGTH, ratio*LOW, LOW)
    write_field(case, "p", p, boundary)
    write_field(case, "T", T, boundary)
    write_field(case, "U", (0.0, 0.0, 0.0), {
        **boundary, **dict.fromkeys(ends, "type slip;")})
    write_foam(case, "constant/parcelClouds", "clouds (dust);")
    n = CELLS//2*per_cell
    space = 0.5*LENGTH/n
    rakes = []
    for name, start, density in (("left", 0.0, ratio), ("right", 0.5, 1.0)):
        mass = load*density*LOW/(R_GAS*T)*0.5*LENGTH*WIDTH**2/n
        first, last = start + 0.5*space, start + 0.5*LENGTH - 0.5*space
        rakes.append(f"""
            type rakeInjection; nParcels {n}; diameter {d!r}; U0 (0 0 0);
            start ({first!r} {0.5*WIDTH} {0.5*WIDTH});
            end ({last!r} {0.5*WIDTH} {0.5*WIDTH});
            nParticle {mass/(RHO_P*np.pi/6*d**3)!r};""")
    write_cloud(case, "dust", rakes[0] + " } right { " + rakes[1],
                forces="sphereDrag;", coupled="yes",
                constants=f"rho0 {RHO_P}; T0 {T}; Cp0 {CP_P};",
                solution="heatTransfer on; sourceTerms"
                " { schemes { U explicit 1; } }")
    solve(case)
    cv = R_GAS/(GAMMA - 1)
    R = R_GAS/(1 + load)
    gamma = 1 + R*(1 + load)/(cv + load*CP_P)
    exact = riemann((ratio*LOW/(R*T), 0, ratio*LOW), (LOW/(R*T), 0, LOW),
                    (x - 0.5*LENGTH)/(steps*STEP), gamma)
    p, U = last_fields(case, "p U")
    error = np.abs(p - exact[2]).mean()/exact[2].mean()
    speed = np.abs(U[:, 0] - exact[1]).mean()/exact[1].max()
    verdict(case, error < 0.02 and speed < 0.03,
            f"pressure within {100*error:.2f} %, velocity within"
            f" {100*speed:.2f} % of its largest")


tube("tube_2_10", 2, 10, 1e-7, 10, 300)
tube("tube_10_10", 10, 10, 1e-7, 10, 300)
tube("tube_10_1", 10, 1, 1e-8, 10, 130)
