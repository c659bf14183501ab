# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Starts from the undisturbed stream; stands in a folder with the prepared
case 'half'."""

import bluntBody
import numpy as np
from bluntBody import P, SOUND, T, pitot
from caseTools import (GAMMA, R_GAS, box, comes_to_rest, complaint, copy_case,
                       edit, entries, last_fields, must, read_points, run,
                       undisturbed, verdict, write_block, write_case,
                       write_field, write_foam, write_points)
from riemann import riemann

FLUXES = "Kurganov", "SLAU2", "AUSMPlusUp", "HLLC"


def prepare(source, case, flux, mach, gas, **control):
    copy_case(source, case)
    edit(case, "system/fvSchemes", "HLLC;", flux + ";")
    edit(case, "0/U", "1797.172554", repr(mach*SOUND))
    write_foam(case, "system/fvSolution",
               "highSpeedGas\n{\n" + entries(gas) + "\n}")
    settings = {"application": "rhoCentralParcelFoam", "startTime": 0,
                "startFrom": "startTime", "stopAt": "endTime",
                "writeControl": "runTime", "writeFormat": "binary"}
    settings.update(control)
    write_foam(case, "system/controlDict", entries(settings))


def survives(case, mach):
    """Why the run is not what it should be, or nothing."""
    status, text = run(case, "rhoCentralParcelFoam")
    if status:
        return complaint(text)
    p, t, U, rho = last_fields(case)
    H = (GAMMA/(GAMMA - 1)*R_GAS*t + 0.5*(U**2).sum(axis=1)).max()
    if not (p.min() > 0 and t.min() > 0 and rho.min() > 0):
        return (f"smallest p {p.min():g}, T {t.min():g}, rho {rho.min():g}")
    if p.max() < 0.5*pitot(mach)*P:
        return f"no shock layer: largest p {p.max():g} Pa"
    if not np.isfinite(H):
        return "total enthalpy is not finite"
    return ""


for flux in FLUXES:
    for mach in 6, 20:
        # Time for the stream to cross 1.5 radii: some hundred steps
        case = f"transient_{flux}_{mach}"
        end = 0.045/(mach*SOUND)
        prepare("half", case, flux, mach, {"mode": "transient"},
                endTime=end, deltaT=end/10, writeInterval=end)
        trouble = survives(case, mach)
        verdict(case, not trouble, trouble or "started")

        case = f"steady_{flux}_{mach}"
        prepare("half", case, flux, mach,
                {"mode": "steady", "maxIterations": 300}, endTime=1, deltaT=1,
                writeInterval=1)
        trouble = survives(case, mach)
        verdict(case, not trouble, trouble or "started")

# Gas at rest that throws the stream back, above the pressure to which that
# comes to rest and below, ends as the gas that begins as the stream
sides = {"axis": "type symmetryPlane;", "front": "type empty;",
         "back": "type empty;", "outlet": "type zeroGradient;"}
ends = []
for case, pressure in ("stream", 0), ("dense", 1.3), ("cold", 0.5):
    bluntBody.prepare(case, "half", (40, 30), 4, 6)
    for name, value, inside in (
            ("p", P, pressure*pitot(6)*P), ("T", T, 300.0),
            ("U", (6*SOUND, 0, 0), (0, 0, 0))):
        body = "type slip;" if name == "U" else "type zeroGradient;"
        given = (f"({6*SOUND!r} 0 0)" if name == "U" else repr(float(value)))
        write_field(case, name, inside if pressure else value, {
            **sides, "body": body,
            "inlet": f"type fixedValue; value uniform {given};"})
    status, text = run(case, "rhoCentralParcelFoam")
    good = not status and "Gas: steady" in text
    ends += [last_fields(case, "p")[0] if good else np.full(1200, np.nan)]
    if pressure:
        apart = abs(ends[-1]/ends[0] - 1).max()
        verdict("rest_at_" + case, apart < 1e-5,
                f"{pressure} of the pitot pressure: p within {apart:.1e},"
                " tolerance 1e-5" if good else complaint(text))


def shake(case, share, seed=1):
    """Move the points of a plane mesh by up to a share of the way to their
    nearest neighbour, both planes alike."""
    points = read_points(case)
    planes = [np.flatnonzero(points[:, 2] == z)
              for z in np.unique(points[:, 2])]
    low, up = (plane[np.lexsort(points[plane, :2].T)] for plane in planes)
    assert len(planes) == 2 and np.allclose(points[low, :2], points[up, :2])
    xy = points[low, :2]
    way = np.full(len(xy), np.inf)
    for i, place in enumerate(xy):
        apart = np.hypot(*(xy - place).T)
        apart[i] = np.inf
        way[i] = apart.min()
    turn = np.random.default_rng(seed).uniform(-1, 1, xy.shape)
    moved = xy + share*way[:, None]*turn
    points[low, :2] = points[up, :2] = moved
    write_points(case, points)


# Full sector, where a carbuncle would have both sides to grow to, on cells in
# line with the shock, which it likes best, and shaken so that it may begin: the
# half sector on its aligned mesh beside its image, from the undisturbed stream
for flux, mach in ("HLLC", 6), ("HLLC", 20), ("Kurganov", 20):
    case = f"sector_{flux}_{mach}"
    prepare("half", case, flux, mach, {"mode": "steady"},
            endTime=1, deltaT=1, writeInterval=1, writeFormat="ascii",
            writePrecision=12)
    with undisturbed(case):
        must(case, "alignMeshToShock")
        write_foam(case, "system/mirrorMeshDict", "planeType pointAndNormal;"
                   " pointAndNormalDict { point (0 0 0); normal (0 1 0); }"
                   " planeTolerance 1e-9;")
        must(case, "mirrorMesh", "-overwrite")
    shake(case, 1e-4)
    if not comes_to_rest(case):
        continue
    must(case, "postProcess", "-func", "writeCellCentres", "-latestTime")
    # By side, column from the stagnation line and place from the wall outwards
    p, C = (field.reshape(2, 60, 40, *field.shape[1:])
            for field in last_fields(case, "p C"))
    p0 = pitot(mach)*P
    mirrored = np.abs(C[0] - C[1]*[1, -1, 1]).max() < 1e-6

    # A cell that the shock crosses takes all pressures on the way of the shock
    # through it: a thousandth of p0 there is a thousandth of the cell
    shock = np.abs(np.gradient(p, axis=2)) > 0.05*p
    d = np.abs(p[0] - p[1])[~shock.any(axis=0)].max()/p0
    verdict(case + "_symmetric", mirrored and d < 1e-3,
            f"largest difference between both sides {d:.1e} of p0 outside the"
            " cells of the shock, tolerance 1e-3")

    # Where the pressure passes through the mean before and behind the shock
    r = np.hypot(C[..., 0], C[..., 1])
    places = np.empty((2, 60))
    for side, j in np.ndindex(2, 60):
        line = p[side, j]
        i = np.argmax(line[:-1] - line[1:])
        middle = 0.5*(line[i - 2] + line[-1])
        i = np.flatnonzero(line > middle).max()
        places[side, j] = np.interp(-middle, -line[i:i + 2],
                                    r[side, j, i:i + 2])
    d = np.abs(places[0] - places[1]).max()/0.03
    verdict(case + "_shock_symmetric", d < 1e-4,
            f"places of the shock on both sides differ by at most {d:.1e} of"
            " the radius, tolerance 1e-4")
    d = abs(p[:, 0, 0].mean()/p0 - 1)
    verdict(case + "_pitot", d < 1e-2,
            f"stagnation pressure off by {d:.1e}, tolerance 1e-2")

# Tube with 1e5 Pa against 1 Pa, both at 300 K
N = 400
for flux in FLUXES:
    case = "vacuum_" + flux
    left, right = ((p/(R_GAS*300), 0.0, p) for p in (1e5, 1.0))
    end = 2.5e-4
    write_case(case, {"endTime": end, "deltaT": 1e-6, "writeInterval": end},
               {"mode": "transient"}, flux)
    write_block(case, box((1, 0.0025, 0.0025)), (N, 1, 1),
                {"xMin": "patch", "xMax": "patch"})
    sides = {s + e: "type empty;" for s in "yz" for e in ("Min", "Max")}
    zero = {**sides, "xMin": "type zeroGradient;",
            "xMax": "type zeroGradient;"}
    x = (np.arange(N) + 0.5)/N
    write_field(case, "p", np.where(x < 0.5, 1e5, 1.0), zero)
    write_field(case, "T", 300, zero)
    write_field(case, "U", (0, 0, 0), zero)
    must(case, "blockMesh")
    status, text = run(case, "rhoCentralParcelFoam")
    if status:
        verdict(case, False, complaint(text))
        continue
    p, t, rho = last_fields(case, "p T rho")
    exact = riemann(left, right, (x - 0.5)/end, GAMMA)
    e = abs(rho - exact[0]).mean()/left[0]
    # Second order has 0.7e-3 to 1.2e-3, first order 2.5e-3 to 5.0e-3
    good = min(p.min(), t.min(), rho.min()) > 0 and e < 2e-3
    verdict(case, good, f"mean density error {e:.1e} of the dense side,"
            f" tolerance 2e-3; smallest p {p.min():.3g} Pa,"
            f" T {t.min():.3g} K")
