# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""The whole nose of a sphere in three dimensions, no plane of symmetry to lean
on, on cells in line with the shock, which a carbuncle likes best, and shaken so
that it may begin."""

import numpy as np
from bluntBody import P, RADIUS, SOUND, T, pitot
from caseTools import (box, comes_to_rest, copy_case, edit, largest,
                       last_fields, must, read_points, undisturbed, verdict,
                       write_block, write_case, write_field, write_points)

# Radially, and across: the front side of a cube on the sphere
LAYERS, ACROSS, OUTER = 30, 16, 1.6


def prepare(case, M):
    write_case(case, {"endTime": 1, "deltaT": 1, "writeInterval": 1,
                      "writeFormat": "ascii"},
               {"mode": "steady"}, "HLLC", "vanAlbada")
    sides = {"yMin": "patch", "yMax": "patch", "zMin": "patch",
             "zMax": "patch"}
    write_block(case, box((1, 1, 1)), (LAYERS, ACROSS, ACROSS),
                {"xMin": "wall", "xMax": "patch", **sides})
    must(case, "blockMesh")
    cube = read_points(case)
    a, b = np.tan(np.radians(90)*(0.5 - cube[:, 1:])).T
    way = np.stack([-np.ones_like(a), a, -b], axis=1)
    way /= np.linalg.norm(way, axis=1)[:, None]
    r = RADIUS*(1 + (OUTER - 1)*cube[:, :1])
    write_points(case, r*way)
    for name, value in ("p", P), ("T", T), ("U", (M*SOUND, 0, 0)):
        outlet = {side: "type zeroGradient;" for side in sides}
        write_field(case, name, value, {
            "xMin": "type slip;" if name == "U" else "type zeroGradient;",
            "xMax": "type fixedValue; value $internalField;", **outlet})


def shake(case, share):
    """Move all points by up to a share of the shortest edge at each."""
    points = read_points(case)
    grid = points.reshape(ACROSS + 1, ACROSS + 1, LAYERS + 1, 3)
    edge = np.full(grid.shape[:3], np.inf)
    for axis in range(3):
        length = np.linalg.norm(np.diff(grid, axis=axis), axis=-1)
        at = [slice(None)]*3
        for part in slice(None, -1), slice(1, None):
            at[axis] = part
            edge[tuple(at)] = np.minimum(edge[tuple(at)], length)
    turn = np.random.default_rng(1).uniform(-1, 1, points.shape)
    write_points(case, points + share*edge.reshape(-1, 1)*turn)


def cases():
    """Both fluxes on the mesh that follows the shock of one."""
    for M in 6, 20:
        case = f"nose_HLLC_{M}"
        prepare(case, M)
        with undisturbed(case):
            must(case, "alignMeshToShock")
        shake(case, 1e-4)
        other = copy_case(case, f"nose_Kurganov_{M}")
        edit(other, "system/fvSchemes", "HLLC", "Kurganov")
        yield case, M
        yield other, M


for case, M in cases():
    if not comes_to_rest(case):
        continue
    p = last_fields(case, "p")[0].reshape(ACROSS, ACROSS, LAYERS)
    p0 = pitot(M)*P

    # The eight images of a square. A cell that the shock crosses takes all
    # pressures on the way of the shock through it
    shock = (np.abs(np.gradient(p, axis=2)) > 0.05*p).any(axis=(0, 1))
    images = [image for q in (p, p.transpose(1, 0, 2))
              for image in (q, q[::-1], q[:, ::-1], q[::-1, ::-1])]
    askew = largest(np.abs(image - p)[..., ~shock].max()
                    for image in images)/p0
    nose = p[ACROSS//2 - 1:ACROSS//2 + 1, ACROSS//2 - 1:ACROSS//2 + 1, 0]
    verdict(case + "_symmetric", askew < 1e-3 and (~shock).sum() > LAYERS/3,
            f"largest difference between images {askew:.1e} of p0 outside the"
            f" {shock.sum()} layers of the shock, tolerance 1e-3")
    error = nose.mean()/p0 - 1
    verdict(case + "_stagnation_pressure", abs(error) < 0.015,
            f"{100*error:+.2f} % of Rayleigh's")
