"""Collisions of the spin-carrying cloud: two streams of different size, drag,
Magnus force and walls; stands in a temporary folder."""

import filecmp
import os
import re

import numpy as np

from caseTools import (box, complaint, copy_case, decompose, edit, must, run,
                       solve, verdict, write_block, write_case, write_field,
                       write_foam)

N = (24, 12, 1)
LENGTH = (2.4e-3, 1.2e-3, 1e-4)
TIMES = ("4e-06", "8e-06")

CLOUD = """
type spinningKinematicCloud;
solution
{
    active yes; coupled no; transient yes; cellValueSourceCorrection off;
    maxCo 0.3;
    motion MOTION;
    collisions { type eventDriven; restitution 0.9; friction 0.2; }
    interpolationSchemes
    { rho cellPoint; U cellPoint; T cellPoint; thermo:mu cellPoint; }
    integrationSchemes { U Euler; }
}
constantProperties { rho0 2500; }
subModels
{
    particleForces { hendersonDrag; magnus; }
    rotationalTorqueModel rotationalTorque;
    injectionModels
    {
        fine
        {
            type crossSectionInjection; volumeFraction 3e-2; diameter 6e-6;
            U0 (300 30 0); patches (xMin); front (2e-3 0 0);
        }
        coarse
        {
            type crossSectionInjection; volumeFraction 3e-2; diameter 1.5e-5;
            U0 (100 -50 0); patches (xMin); front (2e-3 0 0);
        }
    }
    patchInteractionModel standardWallInteraction;
    standardWallInteractionCoeffs { type rebound; e 0.8; mu 0.1; }
    dispersionModel none; stochasticCollisionModel none;
    surfaceFilmModel none;
}
cloudFunctions {}
"""


def make(case, motion):
    write_case(
        case,
        {"endTime": 8e-6, "deltaT": 2e-7, "writeInterval": 4e-6,
         "libs": "(spinningParcel)"},
        {"mode": "frozen"})
    write_block(case, box(LENGTH), N,
                {"xMin": "patch", "xMax": "wall", "yMin": "wall",
                 "yMax": "wall"})
    must(case, "blockMesh")
    fixed = {side: "type zeroGradient;"
             for side in ("xMin", "xMax", "yMin", "yMax")}
    fixed.update({side: "type empty;" for side in ("zMin", "zMax")})
    write_field(case, "p", 3e4, fixed)
    write_field(case, "T", 250, fixed)
    write_field(case, "U", (200, 0, 0), fixed)
    write_foam(case, "constant/parcelClouds", "clouds (sand);")
    write_foam(case, "constant/sandProperties", CLOUD.replace("MOTION", motion))


def totals(log, label):
    """Numbers of the last line of the cloud, since the start of the run."""
    line = re.findall(re.escape(label) + r"\s*= .*; in all (.*)", log)[-1]
    return np.array([float(v) for v in line.split(",")])


for motion in ("stock", "embeddedRK54"):
    make(motion, motion)
    case = copy_case(motion, motion + "Straight")
    log = solve(case)
    events = totals(log, "Pair, boundary events")
    lost = totals(log, "Lost to restitution, friction")
    overlap = totals(log, "Deepest overlap")[0]
    verdict(motion + "_collides",
            events[0] > 1000 and events[1] > 100 and np.all(lost > 0),
            f"{events} events, lost {lost} J")

    # What is injected upon another is taken out before the step, so that all
    # overlaps of a step are those that its collisions have left
    verdict(motion + "_does_not_overlap",
            overlap < 1e-9*6e-6, f"{overlap:.3g} m")

    restarted = copy_case(motion, motion + "Restarted")
    edit(restarted, "system/controlDict", "endTime 8e-06", "endTime 4e-06")
    solve(restarted)
    edit(restarted, "system/controlDict", "endTime 4e-06", "endTime 8e-06")
    solve(restarted)
    folder = os.path.join(TIMES[1], "lagrangian", "sand")
    names = sorted(os.listdir(os.path.join(case, folder)))
    other = [n for n in names if not filecmp.cmp(
        os.path.join(case, folder, n), os.path.join(restarted, folder, n),
        False)]
    verdict(motion + "_restart_is_bitwise",
            "omega" in names and not other,
            f"{len(names)} files, different: {other}")

ranks = copy_case("embeddedRK54", "ranks")
decompose(ranks)
status, text = run(ranks, "mpirun", "--oversubscribe", "-np", "2",
                   "rhoCentralParcelFoam", "-parallel")
verdict("refuses_several_ranks",
        status != 0 and "(off, on several ranks)" in text, complaint(text))
