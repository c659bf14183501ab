# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Meshes and cases of spheres and cylinders in supersonic flow, on uniform
cells between the body and a concentric circle, and what their stagnation
region is like."""

import re

import numpy as np
from caseTools import (GAMMA, R_GAS, last_fields, must, read_field, times_of,
                       wedge_point, write_case, write_field, write_foam)

P, T, RADIUS = 26500.0, 223.25, 0.03
SOUND = np.sqrt(GAMMA*R_GAS*T)
CP = GAMMA*R_GAS/(GAMMA - 1)
# From the converged, shock-fitted solutions: standoff, velocity gradient
EXACT = {("half", 3): (0.6981, 0.6313), ("half", 6): (0.44659, 0.5744),
         ("half", 20): (0.3829, 0.5542), ("sphere", 6): (0.14872, 0.6175)}


def pitot(M):
    """Stagnation over free-stream pressure behind a normal shock: Rayleigh's
    pitot formula."""
    g = GAMMA
    return ((0.5*(g + 1)*M*M)**(g/(g - 1))
            / (2*g/(g + 1)*M*M - (g - 1)/(g + 1))**(1/(g - 1)))


def mesh(case, body, cells, outer, last=90):
    """A sector from the stagnation line to the angle last; cells are numbered
    with the radius fastest."""
    half = np.radians(2.5)

    def at(radius, angle, side):
        angle = np.radians(angle)
        x, y = -radius*np.cos(angle), radius*np.sin(angle)
        if body == "sphere":
            return x, y*np.cos(half), side*y*np.sin(half)
        return x, y, side*0.0005

    def text(point):
        return "(" + " ".join(repr(float(x)) for x in point) + ")"

    first = -last if body == "whole" else 0
    far = outer*RADIUS
    corners = [at(r, a, s) for s in (1, -1)
               for r, a in ((RADIUS, first), (far, first), (far, last),
                            (RADIUS, last))]
    hexa = "0 1 2 3 0 1 6 7" if body == "sphere" else "0 1 2 3 4 5 6 7"
    low = "0 1" if body == "sphere" else "4 5"
    a, b = low.split()
    arcs = [(begin, end, r, s) for begin, end, r, s in
            (("0", "3", RADIUS, 1), ("1", "2", far, 1), (a, "7", RADIUS, -1),
             (b, "6", far, -1))]
    patches = {
        "body": ("wall", f"0 3 7 {a}"), "inlet": ("patch", f"1 {b} 6 2"),
        "outlet": ("patch", "2 3 7 6"),
        "axis": (("empty", "0 1 1 0") if body == "sphere" else
                 ("symmetryPlane", "0 1 5 4") if body == "half" else
                 ("patch", "0 1 5 4"))}
    sides = "wedge" if body == "sphere" else "empty"
    patches["front"] = sides, "0 1 2 3"
    patches["back"] = sides, f"{a} {b} 6 7"
    middle = 0.5*(first + last)
    write_foam(
        case, "system/blockMeshDict",
        "scale 1;\nvertices (\n" + "\n".join(map(text, corners))
        + f"\n);\nblocks (hex ({hexa}) ({cells[0]} {cells[1]} 1) "
        "simpleGrading (1 1 1));\nedges (\n"
        + "\n".join(f"arc {i} {j} {text(at(r, middle, s))}"
                    for i, j, r, s in arcs)
        + "\n);\nboundary (\n"
        + "\n".join(f"{name} {{ type {kind}; faces (({faces})); }}"
                    for name, (kind, faces) in patches.items()) + "\n);")
    return {name: kind for name, (kind, _) in patches.items()}


def between(case, body, outer, cells, M):
    """A steady case in a wedge: layers from the points (x, r) of a body, from
    the axis on, to as many of the outer boundary."""
    half = np.radians(2.5)

    def at(point, side):
        return wedge_point(point, side, half)

    def line(curve, side):
        return "(" + " ".join(at(point, side) for point in curve[-2:0:-1]) + ")"

    write_case(case, {"endTime": 1, "deltaT": 1, "writeInterval": 1},
               {"mode": "steady"})
    write_foam(case, "system/blockMeshDict", f"""
scale 1;
vertices ({at(body[0], 0)} {at(outer[0], 0)} {at(outer[-1], 1)}
    {at(body[-1], 1)} {at(outer[-1], -1)} {at(body[-1], -1)});
blocks (hex (3 0 1 2 5 0 1 4) ({cells[0]} {cells[1]} 1)
    simpleGrading (1 1 1));
edges (polyLine 3 0 {line(body, 1)} polyLine 2 1 {line(outer, 1)}
    polyLine 5 0 {line(body, -1)} polyLine 4 1 {line(outer, -1)});
boundary
(
    body {{ type wall; faces ((0 3 5 0)); }}
    inlet {{ type patch; faces ((1 2 4 1)); }}
    outlet {{ type patch; faces ((2 3 5 4)); }}
    front {{ type wedge; faces ((0 1 4 5)); }}
    back {{ type wedge; faces ((0 1 2 3)); }}
    axis {{ type empty; faces ((0 1 1 0)); }}
);""")
    must(case, "blockMesh")
    sides = {"front": "type wedge;", "back": "type wedge;",
             "axis": "type empty;", "outlet": "type zeroGradient;",
             "body": "type zeroGradient;"}
    for field, value in ("p", P), ("T", T), ("U", (M*SOUND, 0, 0)):
        given = f"({M*SOUND!r} 0 0)" if field == "U" else repr(value)
        write_field(case, field, value, dict(
            sides, inlet=f"type fixedValue; value uniform {given};",
            **({"body": "type slip;"} if field == "U" else {})))


def prepare(case, body, cells, outer, M, gas=None, flux="HLLC",
            limiter="vanAlbada", last=90):
    write_case(case, {"endTime": 1, "deltaT": 1, "writeInterval": 1},
               {"mode": "steady", **(gas or {})}, flux, limiter)
    kinds = mesh(case, body, cells, outer, last)
    must(case, "blockMesh")
    for name, value in ("p", P), ("T", T), ("U", (M*SOUND, 0, 0)):
        boundary = {}
        for patch, kind in kinds.items():
            if kind in ("empty", "wedge", "symmetryPlane"):
                boundary[patch] = f"type {kind};"
            elif patch == "inlet":
                boundary[patch] = "type fixedValue; value $internalField;"
            elif patch == "body" and name == "U":
                boundary[patch] = "type slip;"
            else:
                boundary[patch] = "type zeroGradient;"
        write_field(case, name, value, boundary)


def before(case, cells, M):
    """Of a case of between(): total pressure in the cell at the nose over the
    exact one less 1, and of all cells, layer by layer, the pressure, and the
    total enthalpy over the stream's less 1."""
    p, t, U = (x.reshape(cells[1], cells[0], -1)
               for x in last_fields(case, "p T U"))
    p, t, uu = p[..., 0], t[..., 0], (U**2).sum(axis=2)
    nose = 0, -1
    rest = (p[nose]*(1 + 0.2*uu[nose]/(GAMMA*R_GAS*t[nose]))**3.5
            / (P*pitot(M)) - 1)
    return rest, p, (CP*t + 0.5*uu)/(CP*T + 0.5*(M*SOUND)**2) - 1


def told_at_nose(case, text, M):
    """What a log warns of, the total pressure of gas that has come nearly to
    rest at the body: (per cent above that behind a normal shock, or nothing;
    is it that of the fields, at as many faces?)."""
    said = re.search(r"At (\d+) faces of walls .* total pressure is (\S+) %"
                     r" (above|below) that behind a normal shock", text)
    if not said:
        return None, True
    with open(f"{case}/constant/polyMesh/boundary") as file:
        n, start = map(int, re.search(
            r"\bbody\s*\{[^}]*nFaces\s+(\d+);\s*startFace\s+(\d+);",
            file.read()).groups())
    wall = read_field(f"{case}/constant/polyMesh/owner")[start:start + n]
    p, t, U = (f[wall] for f in last_fields(case, "p T U"))
    MM = (U**2).sum(axis=1)/(GAMMA*R_GAS*t)
    there = (p > 0.8*P*pitot(M)) & (MM < 0.04)
    total = p*(1 + 0.5*(GAMMA - 1)*MM)**(GAMMA/(GAMMA - 1))
    own = 100*(total[there].mean()/(P*pitot(M)) - 1)
    told = float(said[2])*(1 if said[3] == "above" else -1)
    return told, (int(said[1]) == there.sum()
                  and abs(told/own - 1) < 1e-3)


def flow(case, cells, M):
    """Of the flow before the body: stagnation pressure over the exact one less
    1, largest deviation of the total enthalpy in the front half of the layer,
    standoff over radius, velocity gradient of the wall at the stagnation point
    over the stream's speed, and the pressure of the wall over the exact
    stagnation pressure with the angles."""
    must(case, "postProcess", "-func", "writeCellCentres", "-latestTime")
    C = read_field(f"{case}/{times_of(case)[-1]}/C")
    p, t, U = [f.reshape(cells[1], cells[0], *f.shape[1:])
               for f in last_fields(case, "p T U")]
    C = C.reshape(cells[1], cells[0], 3)
    away = np.hypot(C[..., 1], C[..., 2])
    r = np.hypot(C[..., 0], away)/RADIUS
    theta = np.arctan2(away, -C[..., 0])
    angle = theta[:, 0]

    def wall(q):
        return np.array([np.polyfit(r[j, :3] - 1, q[j, :3], 2)[2]
                         for j in range(cells[1])])

    H = (CP*t + 0.5*(U**2).sum(axis=2))/(CP*T + 0.5*(M*SOUND)**2)
    pressure = wall(p)/(P*pitot(M))
    p0 = np.polyfit(angle[:4]**2, pressure[:4], 1)[1] - 1
    # (a wedge lies in y > 0)
    along = (U[..., 0]*np.sin(theta)
             + (U[..., 1]*C[..., 1] + U[..., 2]*C[..., 2])/away*np.cos(theta))
    gradient = np.polyfit(angle[:5]**2, wall(along)[:5]/angle[:5],
                          1)[1]/(M*SOUND)
    mean = 0.5*P*(2 + 2*GAMMA/(GAMMA + 1)*(M*M - 1))
    stand = []
    for j in range(4):
        i = np.where(p[j] > mean)[0].max()
        share = (p[j, i] - mean)/(p[j, i] - p[j, i + 1])
        stand.append(r[j, i] + share*(r[j, i + 1] - r[j, i]) - 1)
    standoff = np.polyfit(angle[:4]**2, stand, 1)[1]
    enthalpy = np.abs(H[:cells[1]//2, :i - 4] - 1).max()
    return p0, enthalpy, standoff, gradient, angle, pressure
