# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""A stream through a wedge with weighting radial: as many parcels at each
distance from the axis, and the same stream of real particles as with equal
ones; restart, ranks, what is refused. Stands in a temporary folder."""

import numpy as np

from caseTools import (copy_case, decompose, edit, must, refuses, run, solve,
                       verdict, wedge_point, write_case, write_field,
                       write_foam)
from foamFiles import positions, read
from spinningCloud import write_cloud

RADIUS, INNER, LENGTH, SPEED = 0.05, 0.01, 0.1, 100.0
HALF = np.radians(2.5)
DIAMETER, SHARE = 1e-5, 1e-5
DENSITY = SHARE/(np.pi*DIAMETER**3/6)
RINGS, N, STEPS = 10, 40000, 20
END = 1.5*LENGTH/SPEED
CLOUD = "constant/dustProperties"


def write(case, inner, stream):
    """Gas and grains of one velocity in a wedge from the distance inner of the
    axis on."""
    write_case(case, {"endTime": END, "deltaT": END/STEPS,
                      "writeInterval": END, "timePrecision": 12,
                      "libs": "(spinningParcel parcelInjection)"},
               {"mode": "frozen"})
    axis = inner == 0
    points = [(x, r, side) for side in (-1, 1) for x, r in
              ((0, inner), (LENGTH, inner), (LENGTH, RADIUS), (0, RADIUS))
              if r > 0 or side == -1]
    name = {point[:2] + ((0,) if point[1] == 0 else point[2:]): i
            for i, point in enumerate(points)}

    def at(x, r, side):
        return str(name[x, r, 0 if r == 0 else side])

    low = [at(x, r, -1) for x, r in ((0, inner), (LENGTH, inner),
                                     (LENGTH, RADIUS), (0, RADIUS))]
    high = [at(x, r, 1) for x, r in ((0, inner), (LENGTH, inner),
                                     (LENGTH, RADIUS), (0, RADIUS))]
    faces = {"front": ("wedge", low), "back": ("wedge", high),
             "inlet": ("patch", [low[0], low[3], high[3], high[0]]),
             "outlet": ("patch", [low[1], low[2], high[2], high[1]]),
             "outer": ("patch", [low[3], low[2], high[2], high[3]]),
             "inner": ("empty" if axis else "patch",
                       [low[0], low[1], high[1], high[0]])}
    write_foam(
        case, "system/blockMeshDict", "scale 1; vertices ("
        + " ".join(wedge_point(p[:2], p[2], HALF) for p in points)
        + f"); blocks (hex ({' '.join(low + high)}) (20 {RINGS} 1)"
        " simpleGrading (1 1 1)); boundary ("
        + "\n".join(f"{n} {{ type {kind}; faces (({' '.join(f)})); }}"
                    for n, (kind, f) in faces.items()) + ");")
    must(case, "blockMesh")
    for field, value in (("p", 1e5), ("T", 300.0), ("U", (SPEED, 0.0, 0.0))):
        write_field(case, field, value, {
            n: f"type {'zeroGradient' if kind == 'patch' else kind};"
            for n, (kind, f) in faces.items()})
    area = 0.5*np.sin(2*HALF)*(RADIUS**2 - inner**2)
    write_cloud(case, "dust", f"""
    type crossSectionInjection; volumeFraction {SHARE!r};
    diameter {DIAMETER!r}; U0 ({SPEED!r} 0 0); patches (inlet); {stream}
    nParticle {float(DENSITY*area*LENGTH/N)!r};""")
    write_foam(case, "constant/parcelClouds", "clouds (dust);")


def grains(case):
    """Identities, places and real particles of the parcels."""
    folder = f"{case}/{END:g}/lagrangian/dust"
    who, number = (read(f"{folder}/{name}") for name in
                   ("origId", "nParticle"))
    order = np.argsort(who)
    return who[order], positions(folder)[0][order], number[order]


def rings(case, inner):
    """Parcels of rings of one width, over the mean of all, and the density of
    real particles in them, over that of the stream."""
    _, x, number = grains(case)
    # (the last step's are still to be placed)
    last = LENGTH - 2*SPEED*END/STEPS
    here = (x[:, 0] > 2*SPEED*END/STEPS) & (x[:, 0] < LENGTH)
    edges = np.linspace(inner, RADIUS, RINGS + 1)*np.cos(HALF)
    ring = np.clip(np.searchsorted(edges, x[:, 1]), 1, RINGS) - 1
    count = np.bincount(ring[here], minlength=RINGS)
    volume = np.tan(HALF)*np.diff(edges**2)*last
    real = np.bincount(ring[here], number[here], minlength=RINGS)
    return count/count.mean(), real/volume/DENSITY


for arrival in "random", "quiet":
    for inner in 0, INNER:
        case = f"{arrival}_{'axis' if inner == 0 else 'annulus'}"
        write(case, inner, f"arrival {arrival}; weighting radial;")
        solve(case)
        count, density = rings(case, inner)
        bound = 4/np.sqrt(0.9*N/RINGS) if arrival == "random" else 3e-3
        verdict(f"radial_{case}", np.abs(count - 1).max() < bound
                and np.abs(density - 1).max() < bound
                and abs(density.mean() - 1) < bound/2,
                f"parcels of a ring {count.min():.3f} to {count.max():.3f} of"
                f" the mean, density {density.min():.4f} to"
                f" {density.max():.4f} of the stream's")
    case = f"{arrival}_axis"

    copy_case(case, f"{case}_ranks")
    decompose(f"{case}_ranks", (2, 1, 1))
    solve(f"{case}_ranks", 2)
    must(f"{case}_ranks", "reconstructPar")
    copy_case(case, f"{case}_restart")
    edit(f"{case}_restart", "system/controlDict", f"endTime {END!r}",
         f"endTime {END/2!r}")
    edit(f"{case}_restart", "system/controlDict", f"writeInterval {END!r}",
         f"writeInterval {END/2!r}")
    solve(f"{case}_restart")
    edit(f"{case}_restart", "system/controlDict", f"endTime {END/2!r}",
         f"endTime {END!r}")
    solve(f"{case}_restart")

    alone = grains(case)
    for other in "ranks", "restart":
        who, x, number = grains(f"{case}_{other}")
        verdict(f"radial_{arrival}_{other}",
                np.array_equal(who, alone[0])
                and np.array_equal(number, alone[2])
                and np.abs(x - alone[1]).max() < 1e-9*LENGTH,
                f"{len(who)} parcels for {len(alone[0])}, or not the same")

base = "random_axis"
for name, old, new, words in (
        ("swirl", f"U0 ({SPEED!r} 0 0)", f"U0 ({SPEED!r} 1 0)",
         ("weighting", "radial", "along the axis")),
        ("prefill", "patches (inlet);",
         "patches (inlet); prefill { box (0 -1 -1) (0.05 1 1); }",
         ("weighting", "radial", "prefill")),
        ("word", "weighting radial", "weighting axial",
         ("weighting", "axial", "equal", "radial"))):
    copy_case(base, name)
    edit(name, CLOUD, old, new)
    refuses(f"radial_{name}", run(name, "rhoCentralParcelFoam"), words)
