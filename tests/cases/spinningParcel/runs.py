# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Restart, ranks and bad input of the spin-carrying cloud in a gas of linear
velocity; stands in a temporary folder."""

import filecmp
import os
import shutil

import numpy as np

from caseTools import (GAMMA, R_GAS, box, copy_case, decompose, edit, largest,
                       last_fields, must, refuses, run, solve, verdict,
                       write_block, write_case, write_field, write_foam)
from foamFiles import parcels as parcel_fields

HERE = os.path.dirname(os.path.abspath(__file__))
N = (24, 12, 1)
LENGTH = (0.048, 0.024, 0.002)

CLOUD = """
type spinningKinematicCloud;
solution
{
    active yes; coupled no; transient yes; cellValueSourceCorrection off;
    maxCo 0.3;
    rotation on;
    MOTION
    interpolationSchemes
    { rho SCHEME; U SCHEME; T SCHEME; thermo:mu SCHEME; }
    integrationSchemes { U Euler; }
}
constantProperties { rho0 2500; omega0 (0 0 2e6); }
subModels
{
    particleForces { hendersonDrag; magnus; }
    rotationalTorqueModel rotationalTorque;
    injectionModels
    {
        stream { diameter 4e-6; U0 (500 30 0); STREAM }
    }
    patchInteractionModel standardWallInteraction;
    standardWallInteractionCoeffs { type rebound; e 0.8; mu 0.1; }
    dispersionModel none; stochasticCollisionModel none;
    surfaceFilmModel none;
}
cloudFunctions {}
"""
STREAM = ("type crossSectionInjection; volumeFraction 2e-5; patches (xMin);"
          " front (0.02 0 0);")
RAKE = "type rakeInjection; start (0.01 0.004 0); end (0.03 0.02 0);"
MOTIONS = {"stock": "motion stock;",
           "embedded": "motion { type embeddedRK54; tolerance 1e-6; }"}
MOTIONS["linear"] = MOTIONS["embedded"]
TIMES = ("5e-05", "0.0001")


def make(case, motion, stream=STREAM):
    write_case(
        case,
        {"endTime": 1e-4, "deltaT": 2e-6, "writeInterval": 5e-5,
         "libs": "(spinningParcel)"},
        {"mode": "frozen"})
    write_block(case, box(LENGTH), N,
                {"xMin": "patch", "xMax": "patch", "yMin": "wall",
                 "yMax": "wall"})
    must(case, "blockMesh")
    x = (np.arange(N[0]) + 0.5)*LENGTH[0]/N[0]
    y = (np.arange(N[1]) + 0.5)*LENGTH[1]/N[1]
    X, Y = np.meshgrid(x, y)
    u = np.stack([300 + 4e3*X, 2e3*Y - 20, 0*X], axis=-1).reshape(-1, 3)
    T = (250 + 1000*X).reshape(-1)
    fixed = {side: "type zeroGradient;"
             for side in ("xMin", "xMax", "yMin", "yMax")}
    fixed.update({side: "type empty;" for side in ("zMin", "zMax")})
    write_field(case, "p", 3e4, fixed)
    write_field(case, "T", T, fixed)
    write_field(case, "U", u, fixed)
    write_foam(case, "constant/parcelClouds", "clouds (sand);")
    write_foam(case, "constant/sandProperties",
               CLOUD.replace("MOTION", MOTIONS[motion]).replace(
                   "STREAM", stream).replace(
                   "SCHEME", "cellLinear" if motion == "linear"
                   else "cellPoint"))


def state(case, time):
    """Identity -> velocity and spin."""
    return {i: (u, w) for i, u, w in zip(*parcel_fields(
        case, time, "sand", "U", "omega"))}


for motion in MOTIONS:
    make(motion, motion)

    case = copy_case(motion, motion + "Straight")
    log = solve(case)
    parcels = state(case, TIMES[1])
    spins = np.array([w[2] for _, w in parcels.values()])
    verdict(motion + "_moves_and_spins",
            len(parcels) > 200 and np.all(np.isfinite(spins))
            and np.all(np.abs(spins) < 2.1e6) and np.std(spins) > 1e3,
            f"{len(parcels)} parcels, spins {spins.min():.3g} to "
            f"{spins.max():.3g} rad/s")

    restarted = copy_case(motion, motion + "Restarted")
    edit(restarted, "system/controlDict", "endTime 0.0001", "endTime 5e-05")
    solve(restarted)
    edit(restarted, "system/controlDict", "endTime 5e-05", "endTime 0.0001")
    solve(restarted)
    folder = os.path.join(TIMES[1], "lagrangian", "sand")
    names = sorted(os.listdir(os.path.join(case, folder)))
    other = [n for n in names if not filecmp.cmp(
        os.path.join(case, folder, n), os.path.join(restarted, folder, n),
        False)]
    verdict(motion + "_restart_is_bitwise",
            "omega" in names and not other, f"{len(names)} files, "
            f"different: {other}")

    ranks = copy_case(motion, motion + "Ranks")
    decompose(ranks)
    solve(ranks, 2)
    must(ranks, "reconstructPar", "-latestTime")
    there = state(ranks, TIMES[1])
    worst = 1.0
    if there.keys() == parcels.keys():
        worst = largest(largest(np.abs(parcels[i][0] - there[i][0]).max()/500,
                                np.abs(parcels[i][1] - there[i][1]).max()/2e6)
                        for i in parcels)
    verdict(motion + "_two_ranks", worst < 1e-10,
            f"largest difference {worst:.2g}")

# A directory that a run on v1912 has left goes on, on any release, as it did
case = "kept"
make(case, "linear", RAKE + " nParcels 8; nParticle 1;")
shutil.copytree(os.path.join(HERE, "v1912"), f"{case}/1e-05")
for name in "p", "T", "U":
    shutil.copy(f"{case}/0/{name}", f"{case}/1e-05/{name}")
edit(case, "system/controlDict", "endTime 0.0001", "endTime 2e-05")
edit(case, "system/controlDict", "writeInterval 5e-05", "writeInterval 1e-05")
solve(case)
expected = np.loadtxt(os.path.join(HERE, "v1912", "expected.csv"),
                      delimiter=",", skiprows=1)
found = np.array([[i, *u[:2], w[2]] for i, (u, w) in
                  state(case, "2e-05").items()])
same = np.array_equal(found[:, 0], expected[:, 0])
worst = np.abs(found[:, 1:]/expected[:, 1:] - 1).max() if same else 1.0
verdict("parcels_of_v1912_go_on", worst < 1e-11,
        f"{len(found)} parcels, largest relative difference {worst:.2g}")

# A closed box: what the spinning grains lose is what the gas gains, without
# the stock entry sourceTerms
case = "box"
make(case, "embedded", RAKE + " nParcels 40; nParticle 1e5;")
write_foam(case, "system/fvSolution",
           "highSpeedGas { mode transient; maxCo 0.4; }")
slip = {side: "type slip;" for side in ("xMin", "xMax", "yMin", "yMax")}
still = {side: "type zeroGradient;" for side in slip}
for fields in (slip, still):
    fields.update({side: "type empty;" for side in ("zMin", "zMax")})
write_block(case, box(LENGTH), N,
            {side: "wall" for side in ("xMin", "xMax", "yMin", "yMax")})
must(case, "blockMesh")
write_field(case, "p", 3e4, still)
write_field(case, "T", 250, still)
write_field(case, "U", (0, 0, 0), slip)
for old, new in (
        ("coupled no;", "coupled yes;"),
        ("rebound; e 0.8; mu 0.1", "rebound; e 1; mu 0")):
    edit(case, "constant/sandProperties", old, new)
solve(case)


def energies(time):
    """Of the gas, of the parcels' motion, of their spin [J]."""
    rho, u, p, T = last_fields(case, "rho U p T", time)
    cp = GAMMA*R_GAS/(GAMMA - 1)    # of the case; R is that of the release
    gamma = cp/(cp - np.mean(p/(rho*T)))
    volume = np.prod(LENGTH)/np.prod(N)
    gas = volume*np.sum(p/(gamma - 1) + 0.5*rho*np.sum(u**2, axis=1))
    states = state(case, time).values()
    mass = 1e5*2500*np.pi/6*4e-6**3
    return (gas, 0.5*mass*sum(v @ v for v, _ in states),
            0.05*mass*4e-6**2*sum(w @ w for _, w in states))


first, last = energies(TIMES[0]), energies(TIMES[1])
given = sum(first[1:]) - sum(last[1:])
verdict("closed_box_keeps_its_energy",
        abs(sum(last) - sum(first)) < 1e-12*sum(first)
        and given > 1e-6*sum(first) and first[2] > last[2] > 0,
        f"change {sum(last) - sum(first):.2g} of {sum(first):.6g} J, "
        f"exchanged {given:.3g} J")

# Each must be refused before the first step, with these words
for name, old, new, words in (
        ("motion", "motion stock;", "motion leapFrog;",
         ["motion", "leapFrog", "stock", "embeddedRK54"]),
        ("tolerance", "motion stock;",
         "motion { type embeddedRK54; tolerance 2; }",
         ["tolerance 2", "[1e-14, 0.1]"]),
        ("scheme", "{ rho cellPoint; U cellPoint; T cellPoint;",
         "{ rho cellPoint; U cellPoint; T cell;",
         ["T cell", "cellPoint"]),
        ("torque", "rotationalTorqueModel rotationalTorque",
         "rotationalTorqueModel stokes",
         ["Unknown rotationalTorqueModel stokes", "rotationalTorque"]),
        ("rotation", "rotation on", "rotation maybe", ["maybe"]),
        ("force", "magnus;", "magnuss;", ["magnuss", "magnus", "sphereDrag"]),
        ("density", "rho0 2500", "rho0 0", ["rho0 0"]),
        ("diameter", "diameter 4e-6", "diameter -1",
         ["diameter -1", "[1e-10, 100]"]),
        ("omega0", "omega0 (0 0 2e6)", "omega0 (0 0)", ["omega0"])):
    case = copy_case("embedded" if name == "scheme" else "stock", "bad")
    edit(case, "constant/sandProperties", old, new)
    refuses("refuses_" + name, run(case, "rhoCentralParcelFoam"), words)
    must(".", "rm", "-rf", case)
