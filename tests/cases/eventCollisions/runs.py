# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Collisions of the spin-carrying cloud: two streams of different size, drag,
Magnus force and walls; stands in a temporary folder."""

import filecmp
import os
import re

import numpy as np

from caseTools import (box, complaint, copy_case, decompose, edit, largest,
                       must, read_field, refuses, run, solve, times_of,
                       verdict, write_block, write_case, write_field,
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


def make(case, motion, sides="wall", layers=0, change=lambda cloud: cloud,
         gas="frozen", corners=None, across="empty"):
    """layers: cells across; 0: two dimensions. across: type of the patches in
    front and back then."""
    write_case(
        case,
        {"endTime": 8e-6, "deltaT": 2e-7, "writeInterval": 4e-6,
         "libs": "(spinningParcel)"},
        {"mode": gas})
    types = {"xMin": "patch", "xMax": "wall", "yMin": sides, "yMax": sides}
    if layers:
        types.update({"zMin": "wall", "zMax": "wall"})
    elif across != "empty":
        types.update({"zMin": across, "zMax": across})
    write_block(case, corners or box(LENGTH), (*N[:2], max(layers, 1)), types)
    must(case, "blockMesh")
    fixed = {side: "type zeroGradient;"
             for side in ("xMin", "xMax", "yMin", "yMax")}
    if sides == "cyclic":
        fixed.update({side: "type cyclic;" for side in ("yMin", "yMax")})
    fixed.update({side: "type zeroGradient;" if layers else f"type {across};"
                  for side in ("zMin", "zMax")})
    write_field(case, "p", 3e4, fixed)
    write_field(case, "T", 250, fixed)

    # A gas whose spin is more than round-off, which the error control of the
    # motion would otherwise follow
    x = (np.arange(N[0]) + 0.5)*LENGTH[0]/N[0]
    y = (np.arange(N[1]) + 0.5)*LENGTH[1]/N[1]
    X, Y = np.meshgrid(x, y)
    plane = np.stack([200 + 5e4*X - 4e4*Y, 2e4*Y + 3e4*X, 0*X], axis=-1)
    write_field(case, "U", np.tile(plane.reshape(-1, 3), (max(layers, 1), 1)),
                fixed)
    write_foam(case, "constant/parcelClouds", "clouds (sand);")
    write_foam(case, "constant/sandProperties", change(CLOUD.replace("MOTION", motion)))


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

    # and it is none of those that the summary calls injected, and then lost
    refused = int(re.findall(r"upon others .* in all (\d+), refused", log)[-1])
    added = [int(n) for n in re.findall(r"- parcels added\s*= (\d+)", log)[-2:]]
    row = re.search(r"^    sand( +\S+){6}$", log, re.M)[0].split()
    verdict(motion + "_refused_are_not_injected",
            refused > 0 and int(row[2]) == sum(added) - refused
            and "1 x Parcels injected upon others" in log,
            f"{row[2]} of {sum(added)}, {refused} refused, with one warning")

    restarted = copy_case(motion, motion + "Restarted")
    edit(restarted, "system/controlDict", "endTime 8e-06", "endTime 4e-06")
    solve(restarted)
    edit(restarted, "system/controlDict", "endTime 4e-06", "endTime 8e-06")
    copy_case(restarted, motion + "Half")
    solve(restarted)
    folder = os.path.join(TIMES[1], "lagrangian", "sand")
    names = sorted(os.listdir(os.path.join(case, folder)))
    other = [n for n in names if not filecmp.cmp(
        os.path.join(case, folder, n), os.path.join(restarted, folder, n),
        False)]
    verdict(motion + "_restart_is_bitwise",
            "omega" in names and not other,
            f"{len(names)} files, different: {other}")



def states(case, time):
    """Identity -> velocity and spin, of all ranks; parcels of each rank."""
    found, sizes = {}, []
    ranks = [f for f in sorted(os.listdir(case)) if f.startswith("processor")]
    for folder in ranks or ["."]:
        cloud = os.path.join(case, folder, time, "lagrangian", "sand")
        if os.path.isdir(cloud):
            columns = [read_field(os.path.join(cloud, name))
                       for name in ("origId", "U", "omega")]
            sizes.append(len(columns[0]))
            found.update((i, (u, w)) for i, u, w in zip(*columns))
    return found, sizes


def step_counts(log):
    """Pair and boundary events, and refused injections, of each step."""
    return (re.findall(r"Pair, boundary events\s*= (.*); in all", log)
            + re.findall(r"Injections upon others\s*= (.*); in all", log))


def of_ranks(log, label):
    """Numbers of the ranks in the last line of the cloud."""
    line = re.findall(re.escape(label) + r"\s*= (.*)", log)[-1]
    return np.array([int(v) for v in line.split()])


def on_ranks(name, start, n):
    """Five steps from the same parcels on one rank and on several: the same
    events, and after the first step the same state."""
    logs, first, between, late, searched = {}, {}, 0, 0, {}
    for several in (False, True):
        case = copy_case(start, name + ("Ranks" if several else "One"))
        begin = float(times_of(case)[-1])
        edit(case, "system/controlDict", "endTime 8e-06",
             f"endTime {begin + 1e-6:g}")
        edit(case, "system/controlDict", "writeInterval 4e-06",
             "writeInterval 2e-07")
        if several:
            decompose(case, n)
        log = solve(case, int(np.prod(n)) if several else 1)
        logs[several] = step_counts(log)
        times = times_of(os.path.join(case, "processor0" if several else "."))
        time = next(t for t in times if float(t) > begin + 1e-12)
        first[several], sizes = states(case, time)
        if several:
            between = totals(log, "Pairs, hand-overs between ranks")
            late = log.count("Pairs searched out of order")
            own = of_ranks(log, "Parcels of each rank")
            halo = of_ranks(log, "Halo of each rank")
        searched[several] = of_ranks(log, "Pairs searched by each rank")
    worst = np.inf
    if first[False].keys() == first[True].keys() and first[False]:
        worst = largest(largest(np.abs(u - first[True][i][0]).max()/300,
                                np.abs(w - first[True][i][1]).max()/1e8)
                        for i, (u, w) in first[False].items())
    verdict(name + "_has_the_same_events",
            logs[False] == logs[True] and len(logs[True]) >= 5
            and np.all(between > 0) and not late,
            f"{logs[False]} {logs[True]}, between ranks {between}, {late} out"
            " of order")
    verdict(name + "_has_the_same_state", worst < 1e-10,
            f"parcels {sizes}, largest difference {worst:.2g}")
    return own, halo, searched[True], searched[False][0]


on_ranks("stock_2", "stockHalf", (1, 2, 1))
on_ranks("embeddedRK54_2", "embeddedRK54Half", (1, 2, 1))
on_ranks("embeddedRK54_4", "embeddedRK54Half", (2, 2, 1))

# In layers across the streams all ranks have about as much to do: none more
# than its own and its halo
own, halo, searched, alone = on_ranks("layers_4", "embeddedRK54Half", (1, 4, 1))
share = (own + halo)/own.sum()
verdict("ranks_share_the_search",
        np.all(halo > 0) and np.all(share < 1)
        and np.all(searched < 1.2*share*alone) and searched.sum() >= alone,
        f"parcels {own}, halo {halo}, pairs {searched}, of one rank {alone}")



def half(case, *args, **kwargs):
    """A case that has run half of its time."""
    make(case, *args, **kwargs)
    edit(case, "system/controlDict", "endTime 8e-06", "endTime 4e-06")
    solve(case)
    edit(case, "system/controlDict", "endTime 4e-06", "endTime 8e-06")
    return case


# The ends of a period on different ranks
on_ranks("periodic_3", half("periodic", "embeddedRK54", "cyclic"), (1, 3, 1))
on_ranks("space_2", half("space", "embeddedRK54", layers=3, change=lambda cloud:
                         cloud.replace("Fraction 3e-2", "Fraction 4e-3")),
         (1, 1, 2))
# Parcels that lose most of their energy, come to rest and are held
on_ranks("collapse_4", half("collapse", "embeddedRK54", change=lambda cloud:
                            cloud.replace("restitution 0.9; friction 0.2",
                                          "restitution 0.1; friction 0.5")
                            .replace("e 0.8; mu 0.1", "e 0.05; mu 0.4")),
         (2, 2, 1))
on_ranks("separate_2", half("separate", "stock", change=lambda cloud:
                            cloud.replace("eventDriven;", "eventDriven;"
                                          " overlappingInjection separate;")),
         (1, 2, 1))

# What the gas receives, wherever the parcels are that collide
on_ranks("coupled_2", half("coupled", "embeddedRK54", gas="transient",
                           change=lambda cloud: cloud.replace(
                               "coupled no", "coupled yes; sourceTerms"
                               " { schemes { U explicit 1; } }")), (1, 2, 1))


def given(parts):
    """Momentum that the gas has received in the first step."""
    name = next(t for t in times_of(parts[0]) if float(t) > 4.1e-6)
    return sum(read_field(os.path.join(part, name, "sand:UTrans"))
               .sum(axis=0) for part in parts)


total = [given(["coupled_2One"]), given(["coupled_2Ranks/processor0",
                                         "coupled_2Ranks/processor1"])]
verdict("ranks_give_the_gas_the_same",
        np.abs(total[0] - total[1]).max() < 1e-10*np.abs(total[0]).max(),
        f"{total} kg m/s")


# Parcels meet as circles in a plane and stand for the grains of one thickness:
# neither holds in a wedge, nor on a plate that grows thicker
def thicker(by):
    return [(x, y, z*(1 + by*x/LENGTH[0])) for x, y, z in box(LENGTH)]


def wedge():
    half, heights = np.radians(2), (2e-3, 2e-3 + LENGTH[1])
    return [(x, heights[k]*np.cos(half), side*heights[k]*np.sin(half))
            for side in (-1, 1)
            for x, k in ((0, 0), (LENGTH[0], 0), (LENGTH[0], 1), (0, 1))]


for name, corners, across in (
        ("wedge", wedge(), "wedge"),
        # So little that OpenFOAM takes it for two dimensions
        ("thicker", thicker(1.2e-5), "empty")):
    make(name, "embeddedRK54", corners=corners, across=across)
    refuses(f"collisions_refused_{name}", run(name, "rhoCentralParcelFoam"),
            ("collisions eventDriven", "off on a wedge", "varying thickness"))
    edit(name, "constant/sandProperties",
         "collisions { type eventDriven; restitution 0.9; friction 0.2; }",
         "collisions off;")
    edit(name, "system/controlDict", "endTime 8e-06", "endTime 4e-07")
    status, text = run(name, "rhoCentralParcelFoam")
    verdict(f"runs_without_collisions_{name}", status == 0, complaint(text))

# So much that OpenFOAM solves nothing along the plate: no gas for parcels
make("muchThicker", "embeddedRK54", corners=thicker(1e-2), across="empty")
status, text = run("muchThicker", "rhoCentralParcelFoam")
verdict("gas_refused_muchThicker", status and "not parallel" in text
        and "direction x" in text and "\nTime = " not in text,
        f"status {status}, {complaint(text)}")

straight = copy_case("embeddedRK54Half", "ranksStraight")
decompose(straight)
edit(straight, "system/controlDict", "endTime 8e-06", "endTime 6e-06")
edit(straight, "system/controlDict", "writeInterval 4e-06",
     "writeInterval 1e-06")
restarted = copy_case(straight, "ranksRestarted")
edit(restarted, "system/controlDict", "endTime 6e-06", "endTime 5e-06")
solve(straight, 2)
solve(restarted, 2)
edit(restarted, "system/controlDict", "endTime 5e-06", "endTime 6e-06")
solve(restarted, 2)
different = [
    f"{rank}/{name}" for rank in ("processor0", "processor1")
    for folder in [os.path.join(rank, "6e-06", "lagrangian", "sand")]
    for name in sorted(os.listdir(os.path.join(straight, folder)))
    if not filecmp.cmp(os.path.join(straight, folder, name),
                       os.path.join(restarted, folder, name), False)]
verdict("restart_on_two_ranks_is_bitwise", not different, str(different))
