# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""An isentropic vortex carried through a periodic square whose halves are
joined by cyclicAMI patches, on meshes that match and that do not."""

import re

import numpy as np
from caseTools import (GAMMA, R_GAS, box, copy_case, decompose, last_fields,
                       must, solve, verdict, write_block, write_case,
                       write_field, write_foam)

SIDE, BETA = 10.0, 5.0
SCALE = np.sqrt(R_GAS*300)      # sqrt(p/rho) far away
TIME = 2.0/SCALE
YSIDES = {"yMin": "type cyclic;", "yMax": "type cyclic;",
          "zMin": "type empty;", "zMax": "type empty;"}


def state(x, y, shift):
    """T and velocity over those of the gas far away."""
    dx = (x - shift - 0.25*SIDE + 0.5*SIDE) % SIDE - 0.5*SIDE
    dy = (y - 0.5*SIDE) % SIDE - 0.5*SIDE
    swirl = BETA/(2*np.pi)*np.exp(0.5*(1 - dx*dx - dy*dy))
    return 1 - (GAMMA - 1)/(2*GAMMA)*swirl**2, 1 - dy*swirl, dx*swirl


def centres(first, last, n, m):
    x = first + (np.arange(n) + 0.5)*(last - first)/n
    y = (np.arange(m) + 0.5)*SIDE/m
    b, a = np.meshgrid(y, x, indexing="ij")
    return a.ravel(), b.ravel()


def fields(case, x, y, sides):
    t, u, v = state(x, y, 0)
    write_field(case, "p", 1e5*t**(GAMMA/(GAMMA - 1)), sides)
    write_field(case, "T", 300*t, sides)
    write_field(case, "U", SCALE*np.column_stack([u, v, 0*u]), sides)


def control(case, n):
    write_case(case, {"endTime": TIME, "deltaT": TIME*0.4/n,
                      "writeInterval": TIME}, {"mode": "transient"})


def error(case, x, y):
    p, T = last_fields(case, "p T")
    t, _, _ = state(x, y, 2.0)
    return abs(p/1e5/(T/300) - t**(1/(GAMMA - 1))).mean()


def ami(case, rows, period=True):
    """Left and right half, with a number of rows each; joined in the middle
    and across the period, if there is one."""
    xs = {"left": (0, SIDE/2), "right": (SIDE/2, SIDE)}
    vertices, blocks, patches = [], [], []
    for k, (name, (a, b)) in enumerate(xs.items()):
        vertices += [f"({x} {y} {z})" for z in (0, 0.1)
                     for x, y in ((a, 0), (b, 0), (b, SIDE), (a, SIDE))]
        o = [8*k + i for i in range(8)]
        blocks.append(f"hex ({' '.join(map(str, o))}) (32 {rows[k]} 1)"
                      " simpleGrading (1 1 1)")
        other = "right" if name == "left" else "left"

        def patch(side, face, kind, more, face_of=o):
            corners = " ".join(str(face_of[i]) for i in face)
            patches.append(f"{name}{side} {{ type {kind}; {more}"
                           f" faces (({corners})); }}")

        matching = "AMIMethod faceAreaWeightAMI; matchTolerance 1e-4;"
        shifted = ("transform translational;"
                   f" separationVector ({{}}{SIDE} 0 0);")
        inner, outer = (1, 0) if name == "left" else (0, 1)
        for side, face, joins in (("XMin", (0, 4, 7, 3), "XMax"),
                                  ("XMax", (1, 2, 6, 5), "XMin")):
            middle = (name == "left") == (side == "XMax")
            sign = "" if side == "XMin" else "-"
            if middle or period:
                patch(side, face, "cyclicAMI",
                      f"neighbourPatch {other}{joins}; {matching}"
                      + (" transform noOrdering;" if middle
                         else shifted.format(sign)))
            else:
                patch(side, face, "patch", "")
        patch("YMin", (0, 1, 5, 4), "cyclic", f"neighbourPatch {name}YMax;")
        patch("YMax", (3, 7, 6, 2), "cyclic", f"neighbourPatch {name}YMin;")
        patch("Z", (0, 3, 2, 1), "empty", "")
        patches[-1] = patches[-1].replace(
            "));", f") ({' '.join(str(o[i]) for i in (4, 5, 6, 7))}));")
    control(case, 64)
    write_foam(case, "system/blockMeshDict",
               "scale 1;\nvertices (" + " ".join(vertices) + ");\nblocks ("
               + "\n".join(blocks) + ");\nedges ();\nboundary\n(\n"
               + "\n".join(patches) + "\n);")
    sides = {}
    for name in xs:
        sides.update({f"{name}X{e}": "type cyclicAMI;" for e in ("Min", "Max")})
        sides.update({f"{name}Y{e}": "type cyclic;" for e in ("Min", "Max")})
        sides[f"{name}Z"] = "type empty;"
    parts = [centres(*xs[n], 32, r) for n, r in zip(xs, rows)]
    x, y = (np.concatenate(c) for c in zip(*parts))
    fields(case, x, y, sides)
    must(case, "blockMesh")
    return x, y


control("cyclic", 64)
write_block("cyclic", box((SIDE, SIDE, 0.1)), (64, 64, 1),
            {s + e: "cyclic" for s in "xy" for e in ("Min", "Max")})
x, y = centres(0, SIDE, 64, 64)
fields("cyclic", x, y, {**YSIDES, "xMin": "type cyclic;",
                        "xMax": "type cyclic;"})
must("cyclic", "blockMesh")
solve("cyclic")
reference = error("cyclic", x, y)

xa, ya = ami("matching", (64, 64))
copy_case("matching", "matchingRanks")
solve("matching")
p, = last_fields("cyclic", "p")
q, = last_fields("matching", "p")
order = np.lexsort((xa, ya))
d = abs(q[order]/p - 1).max()
verdict("matchingInterface", d < 1e-9,
        f"cyclicAMI differs from cyclic by {d:.1e}, tolerance 1e-9")

decompose("matchingRanks", (1, 2, 1))
solve("matchingRanks", 2)
must("matchingRanks", "reconstructPar")
d = abs(last_fields("matchingRanks", "p")[0]/q - 1).max()
verdict("interfaceTwoRanks", d < 1e-9,
        f"largest relative difference {d:.1e}, tolerance 1e-9")

xb, yb = ami("different", (64, 96))
solve("different")
e = error("different", xb, yb)
verdict("differentInterface", e < 1.3*reference,
        f"error {e:.2e} with 64 beside 96 rows, {reference:.2e} on one mesh of"
        " 64 rows, bound 1.3 times that")

# Steady supersonic streams, hotter from row to row: at the interface values are
# handed over, and what that does to the mass is said
for rows in (32, 32), (32, 20):
    case = f"through_{rows[1]}"
    ami(case, rows, period=False)
    write_case(case, {"endTime": 1, "deltaT": 1, "writeInterval": 1},
               {"mode": "steady"})
    hot = 300*(1 + 2*(np.arange(rows[0]) + 0.5)/rows[0])
    inlet = (f"nonuniform List<scalar> {rows[0]}("
             + " ".join(map(str, hot)) + ")")
    sides = {"leftXMax": "type cyclicAMI;", "rightXMin": "type cyclicAMI;",
             "rightXMax": "type zeroGradient;",
             **{f"{n}Y{e}": "type cyclic;" for n in ("left", "right")
                for e in ("Min", "Max")},
             "leftZ": "type empty;", "rightZ": "type empty;"}
    for name, value, text in (("p", 1e5, "uniform 1e5"), ("T", 300.0, inlet),
                              ("U", (2e3, 0, 0), "uniform (2e3 0 0)")):
        write_field(case, name, value, {
            **sides, "leftXMin": f"type fixedValue; value {text};"})
    with open(f"{case}/system/controlDict", "a") as file:
        file.write("functions {" + " ".join(
            f"{name} {{ type surfaceFieldValue; libs (fieldFunctionObjects);"
            f" fields (phi); operation sum; regionType patch; name {name};"
            " writeFields no; log no; writeControl writeTime; }"
            for name in ("leftXMin", "rightXMax")) + "}\n")
    log = solve(case)
    said = re.search(
        r"([-+.e\d]+) % of the mass that flows in is (lost|gained)", log)
    # Of the fluxes that the gas writes: leaving less entering, over entering
    phi = [np.loadtxt(f"{case}/postProcessing/{name}/0/surfaceFieldValue.dat",
                      ndmin=2)[-1, 1] for name in ("leftXMin", "rightXMax")]
    change = -100*(phi[1]/phi[0] + 1)
    told = float(said[1])*(1 if said[2] == "gained" else -1) if said else 0
    verdict(case + "_mass", "Gas: steady" in log
            and abs(told - change) < max(0.01*abs(change), 0.01)
            and (abs(change) > 0.02) == (rows[0] != rows[1]),
            f"{told:+.4f} % by the log, {change:+.4f} % by the fluxes")

# Shocks that meet gas nearly at rest, hot on one side of a cyclic face and
# cold on the other: both sides must have the same flux
n = 24
random = np.random.default_rng(1)
write_case("cyclicShocks", {"endTime": 5e-4, "deltaT": 1e-4,
                            "writeInterval": 5e-4}, {"mode": "transient"},
           "AUSMPlusUp", "vanLeer")
sides = {s + e: "type cyclic;" for s in "xy" for e in ("Min", "Max")}
sides.update(zMin="type empty;", zMax="type empty;")
write_block("cyclicShocks", box((1, 1, 0.1)), (n, n, 1),
            {s + e: "cyclic" for s in "xy" for e in ("Min", "Max")})
p0, T0 = (mean*np.exp(random.normal(0, spread, n*n))
          for mean, spread in ((1e5, 1.0), (300, 0.7)))
write_field("cyclicShocks", "p", p0, sides)
write_field("cyclicShocks", "T", T0, sides)
write_field("cyclicShocks", "U", (0.0, 0.0, 0.0), sides)
must("cyclicShocks", "blockMesh")
solve("cyclicShocks")
p, T, U = last_fields("cyclicShocks", "p T U")


def content(p, T, U=0):
    rho = p/(R_GAS*T)
    return np.array([rho.sum(),
                     (p/(GAMMA - 1) + 0.5*rho*np.sum(U**2, axis=-1)).sum()])


d = abs(content(p, T, U)/content(p0, T0, np.zeros((n*n, 3))) - 1).max()
verdict("cyclicShocks_lose_nothing", d < 1e-8,
        f"mass and energy within {d:.1e}, tolerance 1e-8 (of the gas constant"
        f" of OpenFOAM); gas at up to {np.linalg.norm(U, axis=1).max():.0f}"
        " m/s")
