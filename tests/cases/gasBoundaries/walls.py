# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Gas blown through a patch of type wall, a wall that moves along itself,
adiabatic walls of leaning cells, and the walls of a duct one cell across."""

import numpy as np
from caseTools import (GAMMA, R_GAS, box, edit, last_fields, must,
                       read_points, solve, verdict, write_block, write_case,
                       write_field, write_points)

P, T0, U0 = 1e5, 300.0, 60.0
A = np.sqrt(GAMMA*R_GAS*T0)
N, END = 400, 1.2e-3

# The gas that enters is a piston for that at rest: shock speed and pressure
# behind it (Rankine-Hugoniot, gas velocity behind the shock = that blown in)
b = (GAMMA + 1)/4*U0
shock = b + np.sqrt(b*b + A*A)
p2 = P*(1 + 2*GAMMA/(GAMMA + 1)*((shock/A)**2 - 1))

for patch in "wall", "patch":
    case = f"blowing_{patch}"
    write_case(case, {"endTime": END, "deltaT": 5e-7, "writeInterval": END},
               {"mode": "transient"})
    write_block(case, box((1, 0.1, 0.1)), (N, 1, 1),
                {"xMin": patch, "xMax": "wall"})
    sides = {s + e: "type empty;" for s in "yz" for e in ("Min", "Max")}
    zero = "type zeroGradient;"
    write_field(case, "p", P, {**sides, "xMin": zero, "xMax": zero})
    write_field(case, "T", T0, {
        **sides, "xMin": f"type fixedValue; value uniform {T0};",
        "xMax": zero})
    write_field(case, "U", (0, 0, 0), {
        **sides, "xMin": f"type fixedValue; value uniform ({U0} 0 0);",
        "xMax": "type slip;"})
    must(case, "blockMesh")
    solve(case)
    p, T, U, rho = last_fields(case)

    x = (np.arange(N) + 0.5)/N
    behind = x < shock*END - 0.03
    d = abs(p[behind]/p2 - 1).max()
    ahead = abs(p[x > shock*END + 0.03]/P - 1).max()
    verdict(f"{case}_pressure", d < 2e-3 and ahead < 1e-6,
            f"behind the shock within {d:.1e} of the exact {p2:.0f} Pa,"
            " tolerance 2e-3")
    # What has come in: density of the inflow at p2 and T0, up to the start-up
    gained = rho.mean() - P/(R_GAS*T0)
    entered = p2/(R_GAS*T0)*U0*END
    verdict(f"{case}_mass", abs(gained/entered - 1) < 3e-3,
            f"{gained:.5f} kg/m2 gained, {entered:.5f} blown in,"
            " tolerance 3e-3")

# A wall without flow through it is the same whatever the type of its patch,
# and one that moves along itself does no work on a gas without friction
results = {}
for name, patch, U in (("fixed", "wall", "type fixedValue; value uniform"
                        " (0 0 0);"),
                       ("onPatch", "patch", "type noSlip;"),
                       ("sliding", "wall", "type fixedValue; value uniform"
                        " (0 120 0);")):
    case = f"closed_{name}"
    write_case(case, {"endTime": 4e-4, "deltaT": 1e-6, "writeInterval": 2e-4},
               {"mode": "transient"})
    write_block(case, box((0.2, 0.1, 0.1)), (60, 2, 1),
                {"xMin": patch, "xMax": "wall", "yMin": "cyclic",
                 "yMax": "cyclic"})
    sides = {"yMin": "type cyclic;", "yMax": "type cyclic;",
             "zMin": "type empty;", "zMax": "type empty;"}
    bump = 1 + 0.3*np.exp(-((np.arange(60) - 30)/5)**2)
    for field, value in ("p", np.tile(1e5*bump, 2)), ("T", 300.0):
        write_field(case, field, value, {**sides, "xMin": zero, "xMax": zero})
    write_field(case, "U", (0, 0, 0), {**sides, "xMin": U,
                                       "xMax": "type slip;"})
    must(case, "blockMesh")
    solve(case)
    totals = []
    for time in "0.0002", "0.0004":
        p, T, U, rho = last_fields(case, time=time)
        totals.append((rho.mean(), (p/(GAMMA - 1)
                                    + 0.5*rho*(U*U).sum(axis=1)).mean()))
    results[name] = p
    mass, energy = np.divide(totals[1], totals[0]) - 1
    verdict(f"{case}_conserves",
            abs(mass) < 1e-12 and abs(energy) < 1e-9,
            f"mass kept to {mass:.1e}, energy to {energy:.1e}, tolerances"
            " 1e-12 and 1e-9 (R of the program differs by 1e-6)")
d = max(abs(results[n]/results["fixed"] - 1).max()
        for n in ("onPatch", "sliding"))
verdict("typeOfPatch", d < 1e-12,
        f"largest difference of the three {d:.1e}, tolerance 1e-12")

# Heat that gas without flow conducts stays in it, whichever way cells lean
case = "leaning"
write_case(case, {"endTime": 1e-4, "deltaT": 1e-6, "writeInterval": 1e-4},
           {"mode": "transient", "viscous": "yes"})
write_block(case, [(x + y, y, z) for x, y, z in box((0.01, 0.01, 0.01))],
            (20, 20, 1), {s + e: "wall" for s in "xy" for e in ("Min", "Max")})
cold = np.add.outer(np.arange(20), np.arange(20)).ravel()*5 + 300.0
for field, value, wall in (("p", 1e5, zero), ("T", cold, zero),
                           ("U", (0, 0, 0), "type noSlip;")):
    write_field(case, field, value, {
        "zMin": "type empty;", "zMax": "type empty;",
        **{s + e: wall for s in "xy" for e in ("Min", "Max")}})
edit(case, "constant/thermophysicalProperties", "As 1.458e-06", "As 1e-4")
must(case, "blockMesh")
solve(case)
p, T, U, rho = last_fields(case)
energy = (p/(GAMMA - 1) + 0.5*rho*(U*U).sum(axis=1)).mean()*(GAMMA - 1)/1e5 - 1
moved = abs(T/cold - 1).max()
verdict("leaning_cells_are_adiabatic", abs(energy) < 1e-10 and moved > 0.01,
        f"energy kept to {energy:.1e}, tolerance 1e-10, while temperatures"
        f" change by {100*moved:.0f} %")

# A duct one cell across that widens, along a curve to which the line of cells
# is a tangent nearly: the gas knows nothing of what changes across
LENGTH, HEIGHT, MACH = 0.2, 1e-3, 1.5
case = "oneAcross"
write_case(case, {"endTime": 1, "deltaT": 1, "writeInterval": 1,
                  "writeFormat": "ascii"}, {"mode": "steady"})
write_block(case, box((LENGTH, HEIGHT, HEIGHT)), (100, 1, 1),
            {"xMin": "patch", "xMax": "patch", "yMin": "wall",
             "yMax": "wall"})
sides = {"zMin": "type empty;", "zMax": "type empty;", "xMax": zero}
for field, value, wall in (("p", P, zero), ("T", T0, zero),
                           ("U", (MACH*A, 0, 0), "type slip;")):
    write_field(case, field, value, {
        **sides, "yMin": wall, "yMax": wall,
        "xMin": "type fixedValue; value $internalField;"})
must(case, "blockMesh")
points = read_points(case)
points[:, 1] *= 1 + (points[:, 0]/LENGTH)**2
write_points(case, points)
text = solve(case)
M = np.linspace(1, 5, 40001)
total = 1 + 0.5*(GAMMA - 1)*M**2
area = (2*total/(GAMMA + 1))**(0.5*(GAMMA + 1)/(GAMMA - 1))/M
wide = 1 + ((np.arange(100) + 0.5)/100)**2
ratio = np.interp(wide*np.interp(MACH, M, area), area, total)
exact = P*((1 + 0.5*(GAMMA - 1)*MACH**2)/ratio)**(GAMMA/(GAMMA - 1))
error = np.abs(last_fields(case, "p")[0]/exact - 1).mean()
verdict("duct_one_cell_across", "Gas: steady" in text and error < 2e-4,
        f"pressure within {100*error:.4f} % of the exact, bound 0.02 %")
