# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""An octant of a sphere in supersonic flow on tetrahedra: cells without lines,
through which a shock runs as it likes."""

import itertools
import os
import re

import numpy as np
from bluntBody import CP, P, RADIUS, SOUND, T, pitot, told_at_nose
from caseTools import (R_GAS, copy_case, decompose, edit, last_fields, must,
                       read_field, solve, times_of, verdict, write_case,
                       write_field)

PATCHES = {"body": "patch", "inlet": "patch", "outlet": "patch",
           "sides": "symmetry"}


def octant(case, n, layers, outer, seed=1):
    """Write sphere.msh: triangles of a subdivided face of an octahedron,
    blown up to layers of prisms of growing thickness, the points inside
    shaken by up to a tenth of a cell, the prisms cut into three."""
    places = [(i, j, n - i - j) for i in range(n + 1)
              for j in range(n + 1 - i)]
    number = {place: k for k, place in enumerate(places)}
    # (x from 0 on the far side to 1 on the stagnation line)
    unit = np.array(places, float)
    unit = np.sin(0.5*np.pi*unit/n)
    unit /= np.linalg.norm(unit, axis=1)[:, None]
    share = np.arange(layers + 1)/layers
    radius = RADIUS*(1 + (outer - 1)*(0.5*share + 0.5*share**2))
    points = radius[:, None, None]*unit[None]*[-1, 1, 1]

    shake = np.random.default_rng(seed).uniform(-0.1, 0.1, points.shape)
    shake *= np.gradient(radius)[:, None, None]
    shake[[0, -1]] = 0
    shake[:, (unit < 1e-12).any(axis=1)] = 0
    points = (points + shake).reshape(-1, 3)

    triangles = []
    for i, j, k in places:
        for corners in (((i, j, k), (i + 1, j, k - 1), (i, j + 1, k - 1)),
                        ((i, j, k), (i + 1, j - 1, k), (i + 1, j, k - 1))):
            if all(c in number for c in corners):
                triangles.append([number[c] for c in corners])

    # Cuts from the corner of the lowest number fit those of the neighbours
    cells = []
    for layer, triangle in itertools.product(range(layers), triangles):
        a, b, c = (layer*len(places) + k for k in sorted(triangle))
        d, e, f = (k + len(places) for k in (a, b, c))
        cells += [(a, b, c, f), (a, b, e, f), (a, d, e, f)]
    cells = [(a, b, c, d) if np.linalg.det(points[[b, c, d]] - points[a]) > 0
             else (b, a, c, d) for a, b, c, d in cells]

    seen = {}
    for cell in cells:
        for face in itertools.combinations(sorted(cell), 3):
            seen[face] = seen.get(face, 0) + 1
    names = list(PATCHES)
    boundary = []
    for face in (f for f, count in seen.items() if count == 1):
        layer, place = np.divmod(face, len(places))
        if (layer == 0).all() or (layer == layers).all():
            patch = 0 if layer[0] == 0 else 1
        else:
            # Planes: x = 0 behind, y = 0 and z = 0 beside the stagnation line
            plane = np.where((unit[place] < 1e-12).all(axis=0))[0][0]
            patch = 2 if plane == 0 else 3
        boundary.append((face, patch + 1))

    with open(f"{case}/sphere.msh", "w") as file:
        print("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames",
              len(names) + 1, sep="\n", file=file)
        for k, name in enumerate(names):
            print(f'2 {k + 1} "{name}"', file=file)
        print(f'3 {len(names) + 1} "gas"\n$EndPhysicalNames\n$Nodes',
              len(points), sep="\n", file=file)
        for k, point in enumerate(points):
            print(k + 1, *point, file=file)
        print("$EndNodes\n$Elements", len(boundary) + len(cells), sep="\n",
              file=file)
        for k, (face, tag) in enumerate(boundary):
            print(k + 1, 2, 2, tag, tag, *(p + 1 for p in face), file=file)
        for k, cell in enumerate(cells):
            print(len(boundary) + k + 1, 4, 2, len(names) + 1, 1,
                  *(p + 1 for p in cell), file=file)
        print("$EndElements", file=file)


def retype(case):
    """Give the patches of a mesh from elsewhere their types."""
    path = f"{case}/constant/polyMesh/boundary"
    with open(path) as file:
        text = file.read()
    for name, kind in PATCHES.items():
        text = re.sub(rf"(\b{name}\s*\{{\s*type\s+)\w+;(\s*physicalType "
                      r"+\w+;)?", rf"\g<1>{kind};", text)
    with open(path, "w") as file:
        file.write(text)


def fields(case, M):
    for name, value in ("p", P), ("T", T), ("U", (M*SOUND, 0, 0)):
        write_field(case, name, value, {
            "inlet": "type fixedValue; value $internalField;",
            "outlet": "type zeroGradient;",
            "sides": "type symmetry;",
            "body": "type slip;" if name == "U" else "type zeroGradient;"})


def stagnation(case, M, outer=1.06):
    """Of the cells near the stagnation point: mean total pressure over the
    exact one less 1, and the least and largest total temperature likewise.
    The cell between the body and both planes of symmetry is left out: it has
    one neighbour, and keeps the temperature that the start has left there."""
    must(case, "postProcess", "-func", "writeCellCentres", "-latestTime")
    C = read_field(f"{case}/{times_of(case)[-1]}/C")
    p, t, U = last_fields(case, "p T U")
    uu = (U**2).sum(axis=1)
    near = ((np.linalg.norm(C, axis=1) < outer*RADIUS)
            & (np.hypot(C[:, 1], C[:, 2]) < -0.25*C[:, 0]))
    total = p*(1 + 0.5*uu/(CP*t))**3.5/(P*pitot(M)) - 1
    H = (CP*t + 0.5*uu)/(CP*T + 0.5*(M*SOUND)**2) - 1
    near[np.argmin(np.linalg.norm(C + [RADIUS, 0, 0], axis=1))] = False
    return total[near].mean(), H[near].min(), H[near].max(), near.sum()


def judge(case, text):
    """The bounds of such a flow at Mach 6."""
    steady = re.search(r"Gas: steady after (\d+) iterations, imbalance of .*",
                       text)
    verdict(case + "_steady", steady is not None,
            steady[0] if steady else "does not say that it is steady")
    p0, least, most, n = stagnation(case, 6)
    verdict(case + "_stagnation_pressure", abs(p0) < 0.02,
            f"total pressure {100*p0:+.2f} % in {n} cells at the nose")
    verdict(case + "_total_temperature", -0.03 < least and most < 0.03,
            f"{100*least:+.2f} to {100*most:+.2f} %")


def warns(case, text):
    """Says by how much the nose of a steady gas has lost total pressure?"""
    told, right = told_at_nose(case, text, 6)
    verdict(case + "_nose", told is not None and told < 0 and right,
            f"warns of {told} % of total pressure,"
            f" {'as' if right else 'not what'} the fields have"
            if told is not None else "does not warn of lost total pressure")


def main():
    # Cells too large for the gas between the shock and the body: steady, with
    # a plausible flow whose stagnation pressure is 6 % too low
    case = "tetCoarse"
    write_case(case, {"endTime": 1, "deltaT": 1, "writeInterval": 1},
               {"mode": "steady"}, "HLLC", "vanAlbada")
    octant(case, 16, 12, 1.8)
    must(case, "gmshToFoam", "sphere.msh")
    retype(case)
    fields(case, 6)
    warns(case, solve(case))

    case = "tetrahedra"
    write_case(case, {"endTime": 1, "deltaT": 1, "writeInterval": 1},
               {"mode": "steady", "residual": 1e-8}, "HLLC", "vanAlbada")
    # (flat cells at the wall, where gradients could feed on themselves)
    octant(case, 12, 30, 1.8)
    must(case, "gmshToFoam", "sphere.msh")
    retype(case)
    fields(case, 6)
    copy_case(case, "tetRanks")
    copy_case(case, "tetWall")
    text = solve(case)
    judge(case, text)
    warns(case, text)

    # A shock that crosses the cells as it likes may come to rest in more than
    # one way: on ranks the same bounds hold from the start, the steady state
    # of one rank is one, and in time the gas goes on from it the same way
    copy_case(case, "tetAgain")
    last = times_of("tetAgain")[-1]
    os.remove(f"tetAgain/{last}/uniform/highSpeedGas")
    decompose("tetRanks", (1, 2, 1))
    text = solve("tetRanks", 2)
    must("tetRanks", "reconstructPar", "-latestTime")
    judge("tetRanks", text)
    edit("tetAgain", "system/controlDict", "endTime 1;", "endTime 2;")
    decompose("tetAgain", (1, 2, 1))
    text = solve("tetAgain", 2)
    verdict("tetAgain_steady", "steady after 0 iterations" in text,
            "steady after 0 iterations")

    for name in "tetTime", "tetTimeRanks":
        copy_case(case, name)
        edit(name, "system/fvSolution", "mode steady;", "mode transient;")
        for old, new in (("endTime 1;", "endTime 1.0000005;"),
                         ("deltaT 1;", "deltaT 1e-7;"),
                         ("writeInterval 1;", "writeInterval 5e-7;")):
            edit(name, "system/controlDict", old, new)
    solve("tetTime")
    decompose("tetTimeRanks", (1, 2, 1))
    solve("tetTimeRanks", 2)
    must("tetTimeRanks", "reconstructPar", "-latestTime")
    before, one, two = (last_fields(name)[0]
                        for name in (case, "tetTime", "tetTimeRanks"))
    moved = np.abs(one/before - 1).max()
    apart = np.abs(two/one - 1).max()
    verdict("tetrahedra_ranks", apart < 1e-9 < 1e-4 < moved,
            f"pressures differ by {apart:.1e}, tolerance 1e-9, where they"
            f" change by {moved:.1e}")

    # A wall that slow gas flows against stops it by the acoustic wave that it
    # sends back: its first impulse is that of the pressure rho a u.n
    case, M, step = "tetWall", 0.01, 1e-9
    octant(case, 14, 3, 1.6)
    must(case, "gmshToFoam", "sphere.msh")
    retype(case)
    edit(case, "system/fvSolution", "mode steady;", "mode transient;")
    for entry in "endTime", "deltaT", "writeInterval":
        edit(case, "system/controlDict", f"{entry} 1;", f"{entry} {step};")
    fields(case, M)
    solve(case)
    must(case, "postProcess", "-func", "writeCellVolumes", "-latestTime")
    V = read_field(f"{case}/{times_of(case)[-1]}/V")
    U, rho = last_fields(case, "U rho")
    impulse = (V*rho*(M*SOUND - U[:, 0])).sum()
    # (of n_x^2 over the octant)
    wave = P/(R_GAS*T)*SOUND*M*SOUND*step*np.pi*RADIUS**2/6
    verdict("tetWall_stops_the_gas", abs(impulse/wave - 1) < 0.03,
            f"{impulse/wave:.4f} of the acoustic impulse, tolerance 3 %")


if __name__ == "__main__":
    main()
