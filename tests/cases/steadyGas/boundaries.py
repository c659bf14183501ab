# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""What boundaries decide in mode steady: a stream along an outer boundary is no
layer of friction, and the mass of gas that is shut in is told; the shock of a
ramp in time beside it. Heat and motion between plates. Stands in a folder of
its own."""

import re

import numpy as np
from caseTools import (GAMMA, R_GAS, box, largest, last_fields, must,
                       read_points, solve, verdict, write_block, write_case,
                       write_field, write_points)

MACH, P, T = 8, 1e5, 300.0
CORNER, LENGTH, HEIGHT, ANGLE = 0.2, 1.0, 1.2, np.radians(28)
U = MACH*np.sqrt(GAMMA*R_GAS*T)


def ramp(case, top, mode="steady"):
    """Slip along a ramp, with viscosity; a condition on U at the top."""
    end = 1 if mode == "steady" else 3*LENGTH/U
    write_case(case, {"endTime": end, "deltaT": end if mode == "steady"
                      else end/200, "writeInterval": end,
                      "writeFormat": "ascii"},
               {"mode": mode, "viscous": "yes"})
    write_block(case, box((LENGTH, HEIGHT, 0.1)), (60, 60, 1),
                {"xMin": "patch", "xMax": "patch", "yMin": "wall",
                 "yMax": "patch"})
    for name, value in ("p", P), ("T", T), ("U", (U, 0, 0)):
        text = f"({U!r} 0 0)" if name == "U" else repr(value)
        inflow = f"type fixedValue; value uniform {text};"
        write_field(case, name, value, {
            "xMin": inflow, "xMax": "type zeroGradient;",
            "yMin": "type slip;" if name == "U" else "type zeroGradient;",
            "yMax": inflow if top == "fixedValue" else "type zeroGradient;",
            "zMin": "type empty;", "zMax": "type empty;"})
    must(case, "blockMesh")
    points = read_points(case)
    rise = np.maximum(points[:, 0] - CORNER, 0)*np.tan(ANGLE)
    points[:, 1] += rise*(1 - points[:, 1]/HEIGHT)
    write_points(case, points)


def behind_shock():
    """Angle of the oblique shock, pressure and temperature behind it over
    those before, by theory."""
    beta = ANGLE
    for _ in range(200):    # of the two the weaker one: from below
        n = (MACH*np.sin(beta))**2
        turn = np.arctan(2/np.tan(beta)*(n - 1)
                         / (MACH**2*(GAMMA + np.cos(2*beta)) + 2))
        beta += 0.5*(ANGLE - turn)
    p = 1 + 2*GAMMA/(GAMMA + 1)*(n - 1)
    return beta, p, p*(2 + (GAMMA - 1)*n)/((GAMMA + 1)*n)


beta, *exact = behind_shock()
for case, top, mode in (("along_zeroGradient", "zeroGradient", "steady"),
                        ("along_fixedValue", "fixedValue", "steady"),
                        ("inTime", "zeroGradient", "transient")):
    ramp(case, top, mode)
    text = solve(case)
    must(case, "postProcess", "-func", "writeCellCentres", "-latestTime")
    C, p, t = last_fields(case, "C p T")
    x = C[:, 0] - CORNER
    y = C[:, 1] - x*np.tan(ANGLE)
    inside = (x > 0.4) & (x < 0.75) \
        & (y < x*(np.tan(beta) - np.tan(ANGLE)) - 0.05)
    e = [np.sqrt(np.mean((f[inside]/f0/e - 1)**2))
         for f, f0, e in zip((p, t), (P, T), exact)]
    bound = 0.01 if mode == "steady" else 0.02
    verdict(case, ("Gas: steady" in text) == (mode == "steady")
            and inside.sum() > 50 and largest(e) < bound,
            f"{inside.sum()} cells behind the shock differ from theory by"
            f" {100*e[0]:.2f} % in p and {100*e[1]:.2f} % in T,"
            f" bound {100*bound:g} %")

# Gas that is shut in, and warmed by its walls


def shut(case, cold, hot, conditions, start=T, n=10, size=0.01):
    write_case(case, {"endTime": 1, "deltaT": 1, "writeInterval": 1},
               {"mode": "steady", "viscous": "yes"})
    write_block(case, box((size, size, 0.01)), (4, n, 1),
                {"xMin": "cyclic", "xMax": "cyclic", "yMin": "wall",
                 "yMax": "wall"})
    for name, value in ("p", P), ("T", start), ("U", (0, 0, 0)):
        walls = {"p": ["type zeroGradient;"]*2, "U": conditions,
                 "T": [f"type fixedValue; value uniform {t};"
                       for t in (cold, hot)]}[name]
        write_field(case, name, value, {
            "xMin": "type cyclic;", "xMax": "type cyclic;", "yMin": walls[0],
            "yMax": walls[1], "zMin": "type empty;", "zMax": "type empty;"})
    must(case, "blockMesh")
    return solve(case), *last_fields(case, "p T U")


log, p, t, _ = shut("shut", 400, 400, ["type noSlip;"]*2)
gain = 100*((p/t).mean()/(P/T) - 1)
told = re.search(r"its mass has changed by (\S+) %", log)
verdict("shut_mass_is_told", told and abs(float(told[1]) - gain)
        < 1e-3*abs(gain), f"{told[1] if told else 'nothing'} % by the log,"
        f" {gain:.4g} % by the fields")

# Between plates, from a start that is in balance but for the cells at them: the
# integral of the conductivity over the temperature grows linearly
COLD, HOT, N = 300.0, 400.0, 20
nodes = np.linspace(COLD, HOT, 2001)
mean = 0.5*(nodes[1:] + nodes[:-1])
integral = np.append(0, np.cumsum(mean**1.5/(mean + 110.4)))
exact = np.interp((np.arange(N) + 0.5)/N, integral/integral[-1], nodes)
for condition in "noSlip", "slip":
    log, _, t, _ = shut("between_" + condition, COLD, HOT,
                        [f"type {condition};"]*2, 350, N)
    t = np.broadcast_to(t, 4*N).reshape(N, 4)
    far = abs(t/exact[:, None] - 1).max()
    verdict("heat_between_plates_" + condition,
            "Gas: steady" in log and far < 1e-3, f"T differs by {far:.1e} from"
            " that of conduction, bound 1e-3")

# Between a plate at rest and one that moves at a tenth of the speed of sound
log, _, _, u = shut("moving", T, T, [
    "type noSlip;", "type fixedValue; value uniform (30 0 0);"], n=N,
                    size=0.001)
u = u[:, 0].reshape(N, 4)
far = abs(u/30 - (np.arange(N)[:, None] + 0.5)/N).max()
verdict("motion_between_plates", "Gas: steady" in log and far < 1e-3,
        f"U differs by {far:.1e} of the plate's from a straight line, bound"
        " 1e-3")


def periodic(case, ends, upper, residual):
    """Gas between periods, and between walls or periods."""
    write_case(case, {"endTime": 1, "deltaT": 1, "writeInterval": 1},
               {"mode": "steady", "viscous": "yes", "residual": residual})
    kinds = {"xMin": "cyclic", "xMax": "cyclic", "yMin": ends, "yMax": ends}
    write_block(case, box((0.004, 0.004, 0.01)), (8, 8, 1), kinds)
    for name, value, wall in (("p", P, "type zeroGradient;"),
                              ("T", T, f"type fixedValue; value uniform {T};"),
                              ("U", (2.5, 0, 0), "type noSlip;")):
        sides = {side: "type cyclic;" if kind == "cyclic" else wall
                 for side, kind in kinds.items()}
        if name == "U" and ends == "wall":
            sides["yMax"] = ("type fixedValue; value uniform"
                             f" ({upper!r} 0 0);")
        write_field(case, name, value, {
            **sides, "zMin": "type empty;", "zMax": "type empty;"})
    must(case, "blockMesh")
    return solve(case)


# Gas without walls, and gas sheared between walls of one temperature, have no
# heat to wait for
log = periodic("noWalls", "cyclic", 0.0, 1e-6)
verdict("no_walls", "Gas: steady after 0 iterations" in log,
        (re.findall(r"Gas: steady.*|not steady after \d+", log) or [""])[0])
log = periodic("sheared", "wall", 5.0, 1e-6)
after = re.findall(r"Gas: steady after (\d+)", log)
verdict("sheared", after and int(after[0]) < 1000, f"steady after {after}")
