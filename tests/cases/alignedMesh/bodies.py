# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""The layers around bodies follow the bow shock, from uniform cells between
the body and a concentric circle, and nothing known of the shock."""

import filecmp
import math
import os
import re
import shutil

import numpy as np
from bluntBody import EXACT, P, RADIUS, SOUND, flow, prepare
from caseTools import (GAMMA, complaint, copy_case, decompose, edit,
                       last_fields, must, read_field, read_points, run, solve,
                       times_of, verdict, write_field, write_foam,
                       write_points)

ROOT = os.environ["PARCEL_IMPACT_DIR"]


def align(case):
    """Move the mesh to the shock; the log."""
    text = must(case, "alignMeshToShock", log="alignMeshToShock")
    verdict(case + "_follows", "Mesh: follows the shock after" in text,
            (re.findall(r"Mesh: follows.*|The shock still.*", text)
             or ["said nothing"])[0])
    return text


CELLS = 40, 60
FINE = 80, 120
for body, M, outer, cells in (
        ("half", 3, 5, CELLS), ("half", 6, 4, CELLS), ("half", 20, 4, CELLS),
        ("sphere", 6, 2.5, CELLS), ("half", 6, 4, FINE),
        ("sphere", 6, 2.5, FINE)):
    fine = cells == FINE
    case = f"{body}_{M}" + ("_fine" if fine else "")
    bound = 1e-3/3 if fine else 1e-3
    prepare(case, body, cells, outer, M)
    shutil.copytree(f"{case}/0", f"{case}.stream")
    align(case)
    text = solve(case)
    verdict(case + "_steady", "Gas: steady after 0 iterations" in text,
            (re.findall(r"Gas: steady after \d+ iterations", text)
             or ["not steady"])[0] + " from the fields that were written")
    standoff0, gradient0 = EXACT[body, M]
    p0, H, standoff, gradient, angle, pressure = flow(case, cells, M)
    verdict(case + "_stagnation_pressure", abs(p0) < bound,
            f"{100*p0:+.3f} % of Rayleigh's")
    verdict(case + "_total_enthalpy", H < bound, f"within {100*H:.3f} %")
    verdict(case + "_standoff", abs(standoff - standoff0) < bound,
            f"{standoff:.5f} of the radius, exact {standoff0}")
    verdict(case + "_velocity_gradient",
            abs(gradient/gradient0 - 1) < 10*bound,
            f"{gradient:.4f}, exact {gradient0}")
    if case == "half_6":
        exact = np.genfromtxt(
            f"{ROOT}/tutorials/rhoCentralParcelFoam/dustyCylinderMach6/"
            "reference.dat", delimiter=",", skip_header=4)[1:9]
        # (of fits to the four cells around each place)
        near = [np.argsort(np.abs(angle - phi))[:4]
                for phi in np.radians(exact[:, 0])]
        ours = [np.polyval(np.polyfit(angle[i], pressure[i], 2), phi)
                for i, phi in zip(near, np.radians(exact[:, 0]))]
        error = np.sqrt(np.mean((ours - exact[:, 1])**2))
        verdict(case + "_wall_pressure", error < 1e-3,
                f"L2 {100*error:.3f} % of p0, 10 to 80 degrees")

# The moved mesh is that of every later step: the fields that were written are
# steady on ranks, too, and in time gas goes the same way from the stream on
STEP = 5e-4*RADIUS/SOUND
for source in "half_6", "sphere_6":
    case, one, two = (copy_case(source, source + name)
                      for name in ("_ranks", "_time", "_timeRanks"))
    for name in case, one, two:
        for time in times_of(name)[1:]:
            shutil.rmtree(f"{name}/{time}")
    decompose(case, (1, 2, 1))
    text = solve(case, 2)
    must(case, "reconstructPar", "-latestTime")
    apart = np.abs(last_fields(case)[0]/last_fields(source)[0] - 1).max()
    verdict(case, "Gas: steady after 0 iterations" in text and apart < 1e-5,
            f"steady as it was written, pressures within {apart:.1e}")
    for name in one, two:
        shutil.rmtree(f"{name}/0")
        shutil.copytree(f"{source}.stream", f"{name}/0")
        edit(name, "system/fvSolution", "mode steady", "mode transient")
        for old, new in (("deltaT 1;", f"deltaT {STEP};"),
                         ("endTime 1;", f"endTime {20*STEP};"),
                         ("writeInterval 1;", f"writeInterval {20*STEP};")):
            edit(name, "system/controlDict", old, new)
    solve(one)
    decompose(two, (1, 2, 1))
    solve(two, 2)
    must(two, "reconstructPar", "-latestTime")
    p = last_fields(one, "p")[0]
    apart = np.abs(last_fields(two, "p")[0]/p - 1).max()
    verdict(two, apart < 1e-10 and p.max() > 2*P,
            f"pressures differ by {apart:.1e}, tolerance 1e-10, where gas has"
            f" come to {p.max()/P:.1f} times that of the stream")

# Gas at rest stays so in a wedge, whose faces have the areas of arcs
case = "rest"
prepare(case, "sphere", (12, 8), 2.5, 0, {"mode": "transient"})
edit(case, "system/controlDict", "deltaT 1;", "deltaT 1e-6;")
edit(case, "system/controlDict", "endTime 1;", "endTime 5e-5;")
edit(case, "system/controlDict", "writeInterval 1;", "writeInterval 5e-5;")
solve(case)
fastest = np.abs(last_fields(case, "U")[0]).max()
verdict(case, fastest < 1e-9*SOUND, f"no faster than {fastest:.1e} m/s")

# A whole body at an incidence, of which the mesh knows nothing: the half body,
# turned
case, turn = "incidence", np.radians(20)
prepare(case, "whole", (40, 120), 4, 6)
write_field(case, "U", (6*SOUND*np.cos(turn), 6*SOUND*np.sin(turn), 0),
            {"body": "type slip;", "axis": "type zeroGradient;",
             "inlet": "type fixedValue; value $internalField;",
             "outlet": "type zeroGradient;", "front": "type empty;",
             "back": "type empty;"})
align(case)
solve(case)
must(case, "postProcess", "-func", "writeCellCentres", "-latestTime")
C = read_field(f"{case}/{times_of(case)[-1]}/C").reshape(120, 40, 3)
p = last_fields(case, "p")[0].reshape(120, 40)
r = np.hypot(C[..., 0], C[..., 1])/RADIUS - 1
angle = np.arctan2(C[..., 1], -C[..., 0])[:, 0] + turn
mean = 0.5*P*(2 + 2*GAMMA/(GAMMA + 1)*35)
near = np.argsort(np.abs(angle))[:9]
stand = []
for j in near:
    i = np.where(p[j] > mean)[0].max()
    stand.append(r[j, i] + (p[j, i] - mean)/(p[j, i] - p[j, i + 1])
                 * (r[j, i + 1] - r[j, i]))
fit = np.polyfit(angle[near], stand, 2)
place = np.degrees(-0.5*fit[1]/fit[0])
verdict(case + "_standoff", abs(fit[2] - 0.44659) < 1e-3 and abs(place) < 0.2,
        f"{fit[2]:.5f} of the radius, exact 0.44659, least at {place:+.3f} "
        "degrees from the stream's direction")

# A mesh that follows the shock is left as it is, nearly
case = copy_case("half_6", "again")
for time in times_of(case)[1:]:
    shutil.rmtree(f"{case}/{time}")
text = align(case)
moves = int(re.search(r"after (\d+) moves", text)[1])
far = np.linalg.norm(
    read_field(f"{case}/constant/polyMesh/points")
    - read_field("half_6/constant/polyMesh/points"), axis=1).max()/RADIUS
verdict("again", moves <= 2 and far < 2e-3,
        f"{moves} moves of an aligned mesh, by {far:.1e} of the radius at most,"
        " bound 2e-3")

# Also one that a run has written to its end: the solver goes on from it
case = "late"
prepare(case, "half", CELLS, 4, 6)
solve(case)
align(case)
edit(case, "system/controlDict", "endTime 1;", "endTime 2;")
text = solve(case)
verdict(case, "mode steady, steady since an earlier run" in text,
        "goes on from the fields that were written")

# The annotated dictionary is that of the defaults
case = "annotated"
prepare(case, "half", CELLS, 4, 6)
shutil.copy(f"{ROOT}/etc/caseDicts/annotated/alignMeshToShockDict",
            f"{case}/system")
align(case)
verdict("annotated", filecmp.cmp(f"{case}/constant/polyMesh/points",
                                 "half_6/constant/polyMesh/points", False),
        "the annotated dictionary is that of the defaults")

# Points that stand in a time, as moveDynamicMesh leaves them, are moved there
case = "moved"
prepare(case, "half", (16, 12), 4, 6)
os.makedirs(f"{case}/0/polyMesh")
shutil.copy(f"{case}/constant/polyMesh/points", f"{case}/0/polyMesh")
align(case)
text = solve(case)
verdict(case, "Gas: steady after 0 iterations" in text,
        (re.findall(r"Gas: steady after \d+ iterations", text)
         or ["not steady"])[0] + " from what was written")

# What cannot be
def refused(name, wanted, cells=(12, 8), body="half", M=6, edits=None,
            dictionary=None, gas=None):
    prepare(name, body, cells, 4, M, gas)
    if dictionary is not None:
        write_foam(name, "system/alignMeshToShockDict", dictionary)
    if edits:
        edits(name)
    status, text = run(name, "alignMeshToShock")
    verdict("refused_" + name, status != 0 and wanted in text,
            complaint(text))


def parcels(case):
    os.makedirs(f"{case}/0/lagrangian/dust")


refused("misspelt", "Did you mean bandWidth?", dictionary="bandwidht 0.1;")
refused("far", "Entry outer 20: valid range [1.02, 10]",
        dictionary="outer 20;")
refused("shares", "Entry wallShare 0.6: valid range",
        dictionary="wallShare 0.6;")
refused("nobody", "matches no patch", dictionary="body (nose);")
refused("between", "stands between two faces of the body",
        dictionary="body (body inlet);")
refused("few", "The mesh has 6 layers", cells=(6, 8))
refused("subsonic", "There is no shock before the body", M=0.3)
refused("unsteady", "The gas has not come near a steady state",
        gas={"maxIterations": 1})


def open_body(case):
    edit(case, "0/U", "type slip;", "type zeroGradient;")


refused("nowhere", "There is no shock before face", edits=open_body)


def cone(case):
    """A half angle of 35 degrees, at which the shock stays on the tip."""
    edit(case, "system/controlDict", "binary", "ascii")
    must(case, "blockMesh")
    x, y, z = read_points(case).T
    radius = np.hypot(np.hypot(x, y), z)
    along = 3*RADIUS*np.arccos(-x/radius)/np.radians(90)
    depth = radius/RADIUS - 1
    away = along*(np.tan(np.radians(35)) + 0.87*depth/3)
    turn = np.arctan2(z, y)
    write_points(case, np.stack(
        [along - 0.5*depth/3*(RADIUS - along/3), away*np.cos(turn),
         away*np.sin(turn)], axis=1))


refused("sharp", "Layers can follow the detached shock", cells=(24, 24),
        body="sphere", M=8, edits=cone, gas={"maxIterations": 500})
for layers, tolerance in (40, lambda h: 40*h*h), (160, lambda h: h/16):
    refused(f"transient{layers}", "Set 'mode steady;'", (layers, 4),
            gas={"mode": "transient"})
    with open(f"transient{layers}/log.alignMeshToShock") as log:
        said = float(re.search(r"moves by less than (\S+) %", log.read())[1])
    # 60 % of the cells up to 1.15, 40 % in exp(-((x - 1)/0.03)^4)
    h = 1/layers/(0.6/1.15 + 0.4/(0.06*math.gamma(1.25)))
    verdict(f"tolerance{layers}", abs(said/(100*tolerance(h)) - 1) < 0.02,
            f"{said:.5f} %, {100*tolerance(h):.5f} % by the cell at the shock")


def files_of_start(case):
    """What stands in folder 0 and in that of the mesh."""
    return {os.path.join(folder, name): open(os.path.join(folder, name),
                                                "rb").read()
            for start in (f"{case}/0", f"{case}/constant/polyMesh")
            for folder, _, names in os.walk(start) for name in names}


# Gas that breaks down (its stream overflows) leaves the fields and the mesh
# of the start
prepare("broken", "half", (30, 40), 2, 6)
edit("broken", "0/U", "value $internalField", "value uniform (1e200 0 0)")
before = files_of_start("broken")
status, text = run("broken", "alignMeshToShock")
verdict("broken", status and "whose files stay as they were" in text
        and files_of_start("broken") == before, complaint(text))
refused("parcels", "There are parcels at time 0", edits=parcels)
decompose("parcels")
status, text = run("parcels", "mpirun", "--oversubscribe", "-np", "2",
                   "alignMeshToShock", "-parallel")
verdict("refused_ranks",
        status != 0 and "Run it without -parallel before decomposePar" in text,
        complaint(text))
