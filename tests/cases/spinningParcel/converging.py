# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Fine grains where the gas of two cells points to the face between them: they
slide along it, whatever their size, at no more cost than others, and do not
carry momentum to and fro between the cells."""

import re

import numpy as np

from caseTools import (box, decompose, edit, last_fields, must, read_field,
                       solve, times_of, verdict, write_block, write_case,
                       write_field, write_foam)
from foamFiles import positions
from spinningCloud import write_cloud

LENGTH, N, P, T = 0.04, 4, 1e5, 300.0
FACE = 0.5*LENGTH
START = np.array((FACE - 1e-5, FACE - 5e-6))
# On both sides of the middle face +-7.5 m/s across; along it 1.25 and 2.75 m/s,
# whose mean is what a grain slides at
GAS = np.array([(0, 2, 0), (10, 1, 0), (-10, 3, 0), (0, 2, 0)], float)


def prepare(case, mode, dt, diameter, load, coupled, velocity=GAS, more="",
            start=START):
    write_case(case, {"endTime": dt, "deltaT": dt, "writeInterval": dt,
                      "writeFormat": "ascii",
                      "libs": "(spinningParcel parcelInjection)"},
               {"mode": mode})
    # (between two walls there is no velocity across them)
    kind = "patch" if mode == "frozen" else "wall"
    sides = {s + e: kind for s in "xyz" for e in ("Min", "Max")}
    write_block(case, box((LENGTH, 0.1*LENGTH, 0.1*LENGTH)), (N, 1, 1), sides)
    must(case, "blockMesh")
    plain = dict.fromkeys(sides, "type zeroGradient;")
    write_field(case, "p", P, plain)
    write_field(case, "T", T, plain)
    write_field(case, "U", velocity, dict.fromkeys(
        sides, "type zeroGradient;" if kind == "patch" else "type slip;"))
    write_foam(case, "constant/parcelClouds", "clouds (dust);")
    gas = P/(287.05*T)*LENGTH**3*0.01/N
    number = 0.5*load*gas/(2500*np.pi/6*diameter**3)
    write_cloud(case, "dust", f"""
        type rakeInjection; start ({start[0]} {0.04*LENGTH} {0.05*LENGTH});
        end ({start[1]} {0.04*LENGTH} {0.05*LENGTH}); nParcels 2;
        nParticle {number!r}; diameter {diameter!r}; U0 (0 0 0);""",
                forces="sphereDrag;" + more, coupled=coupled,
                solution="sourceTerms { schemes { U explicit 1; } }")


dt = 1e-4
for diameter, ranks in (3e-7, 1), (1e-7, 1), (1e-8, 1), (1e-9, 1), (1e-8, 2):
    case = f"slides_{diameter:g}_{ranks}"
    prepare(case, "frozen", dt, diameter, 1e-3, "no")
    if ranks > 1:
        # The face is that between the ranks
        decompose(case)
    log = solve(case, ranks)
    if ranks > 1:
        must(case, "reconstructPar")
    folder = f"{case}/{times_of(case)[-1]}/lagrangian/dust"
    x, u = positions(folder)[0], read_field(f"{folder}/U")
    steps = float(re.findall(r"Sub-steps, .*= (\S+),", log)[-1])
    away = np.abs(x[:, 0] - FACE).max()/LENGTH
    late = np.abs((x[:, 1] - 0.04*LENGTH)/(2*dt) - 1).max()
    verdict(case, away < 1e-4 and late < 0.02 and steps < 100
            and np.abs(u[:, 1]/2 - 1).max() < 1e-3,
            f"{away:.1e} of the length off the face, along it within"
            f" {100*late:.2f} %, {steps:g} sub-steps of two grains")

# Gas that points to an edge from all four cells around it: they slide along
# the edge, between faces at right angles or not, and between ranks
SIZE = 0.01
for skew, diameter, ranks in ((0, 1e-6, 1), (0, 1e-8, 1), (0.5, 1e-6, 1),
                              (-0.5, 1e-8, 1), (0.5, 1e-8, 2), (0, 1e-8, 4)):
    case = f"edge_{skew:g}_{diameter:g}_{ranks}"
    prepare(case, "frozen", dt, diameter, 1e-3, "no")
    shear = [(x, y + skew*z, z) for x, y, z in box((SIZE, SIZE, SIZE))]
    write_block(case, shear, (4, 4, 4),
                {s + e: "patch" for s in "xyz" for e in ("Min", "Max")})
    must(case, "blockMesh")
    quarter = np.arange(4) < 2
    inward = np.where(quarter, 10., -10.)
    v, w = np.meshgrid(inward, inward, indexing="xy")
    U = np.zeros((4, 4, 4, 3))
    U[..., 0] = 2
    U[..., 1] = (v + skew*w)[:, :, None]
    U[..., 2] = w[:, :, None]
    write_field(case, "U", U.reshape(-1, 3), dict.fromkeys(
        (s + e for s in "xyz" for e in ("Min", "Max")), "type zeroGradient;"))
    edge = 0.5*SIZE*np.array([1 + skew, 1])
    write_cloud(case, "dust", "type rakeInjection;"
                f" start (1e-3 {edge[0] - 2e-5} {edge[1] - 1e-5});"
                f" end (4e-3 {edge[0] + 1e-5} {edge[1] + 3e-5}); nParcels 2;"
                f" diameter {diameter!r}; U0 (2 0 0);", forces="sphereDrag;")
    if ranks > 1:
        decompose(case, (1, 2, ranks//2))
    log = solve(case, ranks)
    if ranks > 1:
        must(case, "reconstructPar")
    x = positions(f"{case}/{times_of(case)[-1]}/lagrangian/dust")[0]
    steps = float(re.findall(r"Sub-steps, .*= (\S+),", log)[-1])
    away = np.abs(x[:, 1:] - edge).max()/SIZE
    late = np.abs(np.sort(x[:, 0]) - (1e-3, 4e-3) - 2*dt).max()/(2*dt)
    verdict(case, len(x) == 2 and away < 1e-4 and late < 1e-3 and steps < 100,
            f"{away:.1e} of the size off the edge, along it within"
            f" {100*late:.2f} %, {steps:g} sub-steps of two grains")

# The axis of a pipe, in which as many cells meet as there are slices: grains
# that come to it go along it as fast as the gas, between ranks, too
LONG, SLICES = 0.1, 16
turn = 2*np.pi/SLICES*np.arange(SLICES)
rim = [(x, 0.05*np.cos(a), 0.05*np.sin(a)) for a in turn for x in (0, LONG)]
slices = [(2 + 2*i, 2 + 2*((i + 1) % SLICES)) for i in range(SLICES)]


def corners(points):
    return "(" + " ".join(map(str, points)) + ")"


for diameter, ranks in (2e-6, 1), (2e-7, 1), (1e-8, 1), (2e-7, 2):
    case, dt = f"axis_{diameter:g}_{ranks}", 0.01
    prepare(case, "frozen", dt, diameter, 1e-3, "no")
    edit(case, "system/controlDict", "deltaT 0.01;", "deltaT 1e-5;")
    write_foam(case, "system/blockMeshDict", "scale 1; vertices ("
               + " ".join(f"({x!r} {y!r} {z!r})" for x, y, z in
                          [(0.0, 0.0, 0.0), (LONG, 0.0, 0.0), *rim])
               + "); edges (); blocks ("
               + " ".join(f"hex (0 1 {p + 1} {p} 0 1 {q + 1} {q}) (10 5 1)"
                          " simpleGrading (1 1 1)" for p, q in slices)
               + "); boundary (ends { type patch; faces ("
               + " ".join(corners((0, p, q, 0)) + corners((1, p + 1, q + 1, 1))
                          for p, q in slices)
               + "); } side { type patch; faces ("
               + " ".join(corners((p, p + 1, q + 1, q)) for p, q in slices)
               + "); });")
    must(case, "blockMesh")
    plain = dict.fromkeys(("ends", "side"), "type zeroGradient;")
    for name, value in ("p", P), ("T", T), ("U", (0, 0, 0)):
        write_field(case, name, value, plain)
    must(case, "postProcess", "-func", "writeCellCentres", "-time", "0")
    y, z = read_field(f"{case}/0/C")[:, 1:].T
    inward = -1e3*(1 - 1e4*(y**2 + z**2))
    write_field(case, "U", np.column_stack(
        (np.full(len(y), 5.0), inward*y, inward*z)), plain)
    write_cloud(case, "dust", "type rakeInjection; start (0.01 0.002 0.001);"
                " end (0.04 0.004 0.003); nParcels 10;"
                f" diameter {diameter!r}; U0 (5 0 0);", forces="sphereDrag;")
    if ranks > 1:
        decompose(case, (1, 2, 1))
    log = solve(case, ranks)
    if ranks > 1:
        must(case, "reconstructPar")
    x = positions(f"{case}/{times_of(case)[-1]}/lagrangian/dust")[0]
    steps = float(re.findall(r"Sub-steps, .*= (\S+),", log)[-1])
    away = np.hypot(x[:, 1], x[:, 2]).max()/LONG
    late = np.abs((np.sort(x[:, 0]) - np.linspace(0.01, 0.04, 10))
                  / (5*dt) - 1).max()
    verdict(case, len(x) == 10 and away < 1e-9 and late < 1e-3
            and steps < 3e5,
            f"{away:.1e} of the length off the axis, along it within"
            f" {100*late:.2f} %, {steps:g} sub-steps of ten grains")

# A grain that settles through gas that hardly moves does not stop at the face
case = "settles"
drift = np.array([(0, 0, 0), (1, 0, 0), (-1, 0, 0), (0, 0, 0)], float)
prepare(case, "frozen", 0.01, 15e-6, 1e-3, "no", 1e-4*drift, "gravity;")
write_foam(case, "constant/g", "dimensions [0 1 -2 0 0 0 0]; value (9.81 0 0);",
           "uniformDimensionedVectorField")
solve(case)
x = positions(f"{case}/{times_of(case)[-1]}/lagrangian/dust")[0][:, 0]
rate = 18*1.846e-5/(2500*15e-6**2)
way = 9.81/rate*(0.01 - 1/rate)
gone = (x - START)/way
# One per cent is the drag beyond Stokes'
verdict(case, np.all(np.abs(gone - 1) < 0.02) and np.all(x > FACE),
        f"{gone} of the way of {way:.3g} m without gas that moves")

across = GAS*(1, 0, 0)
prepare("alone", "transient", 2e-5, 1e-6, 1e-9, "no", across)
solve("alone")
(clean,) = last_fields("alone", "U")
for load in 1e-3, 1e-2, 0.1:
    for diameter in 1e-6, 1e-7, 1e-8:
        case = f"gas_{load:g}_{diameter:g}"
        prepare(case, "transient", 2e-5, diameter, load, "yes", across)
        solve(case)
        (U,) = last_fields(case, "U")
        change = np.abs(U[1:3, 0]/clean[1:3, 0] - 1).max()
        verdict(case, change < 1e-4,
                f"gas of {clean[1, 0]:.3f} m/s is changed by"
                f" {100*change:.3f} % by a loading of {load:g}")

# In the middle of a cell they take its momentum
case, load = "gas_acts", 0.1
prepare(case, "transient", 2e-5, 1e-6, load, "yes", across,
        start=START - LENGTH/8)
solve(case)
momentum = [np.sum(rho*U[:, 0]) for rho, U in (
    last_fields(name, "rho U") for name in (case, "alone"))]
u = read_field(f"{case}/{times_of(case)[-1]}/lagrangian/dust/U")[:, 0]
gained = load*P/(287.05*T)*np.mean(u)
lost = momentum[1] - momentum[0]
verdict(case, gained > 0.2 and abs(lost/gained - 1) < 0.01,
        f"grains of {u} m/s have gained {gained:.4g} and the gas has lost"
        f" {lost:.4g} kg m/s to the m3 of a cell")
