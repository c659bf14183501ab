# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Collisions in the cloud at their edge, in a closed box of 1 mm: rows for
doc/stability.md."""

import math
import os
import re
import shutil
import sys

import numpy as np

from caseTools import (box, complaint, decompose, must, run, write_block,
                       write_case, write_field, write_foam)

SIZE = 1e-3
SIDES = ("xMin", "xMax", "yMin", "yMax")

CLOUD = """
type spinningKinematicCloud;
solution
{{
    active yes; coupled no; transient yes; cellValueSourceCorrection off;
    motion embeddedRK54;
    collisions {{ type eventDriven; {pairs} }}
    interpolationSchemes
    {{ rho cellPoint; U cellPoint; T cellPoint; thermo:mu cellPoint; }}
    integrationSchemes {{ U Euler; }}
}}
constantProperties {{ rho0 2500; }}
subModels
{{
    particleForces {{ {forces} }}
    rotationalTorqueModel none;
    injectionModels {{ {injectors} }}
    patchInteractionModel hardSphereWall;
    hardSphereWallCoeffs {{ patches ( ".*" {{ {walls} }} ); }}
    dispersionModel none; stochasticCollisionModel none;
    surfaceFilmModel none;
}}
cloudFunctions {{}}
"""
ELASTIC = "restitution 1; friction 0;"
LAZY = "restitution 0.1; friction 0.2;"


def rake(name, start, end, n, U, d=1e-5):
    def triple(v):
        return "(" + " ".join(repr(float(x)) for x in (*v, 5e-5)[:3]) + ")"
    return (f"{name} {{ type rakeInjection; start {triple(start)};"
            f" end {triple(end)}; nParcels {n}; nParticle 1;"
            f" diameter {d:.9g}; U0 ({U[0]!r} {U[1]!r} 0); }}")


def number(log, label, last=True):
    """Numbers behind a label of the log: of the run, or of each step."""
    lines = re.findall(re.escape(label) + r"\s*= (.*)", log)
    if last:
        return [float(v) for v in re.split(r"[ ,]+", lines[-1].strip())
                if re.fullmatch(r"[-+.\deE]+", v)]
    return lines


def of_run(log, label):
    lines = re.findall(re.escape(label) + r"\s*= .*; in all (.*)", log)
    return [float(v) for v in lines[-1].split(", ")[:2]
            if re.fullmatch(r"[-+.\de]+", v)] if lines else []


def row(name, expected, right, injectors, steps, dt, pairs=ELASTIC,
        walls=ELASTIC, forces="", g=(0, 0), limit=300, ranks=1):
    """One case. right(n, E, events, lost, overlap, log): energy of each step,
    what happened in the run."""
    shutil.rmtree("case", ignore_errors=True)
    os.mkdir("case")
    write_case("case", {"endTime": steps*dt, "deltaT": dt,
                        "writeInterval": dt,
                        "libs": "(spinningParcel)"}, {"mode": "frozen"})
    write_block("case", box((SIZE, SIZE, 1e-4)), (10, 10, 1),
                {side: "wall" for side in SIDES})
    must("case", "blockMesh")
    sides = {side: "type zeroGradient;" for side in SIDES}
    sides.update({side: "type empty;" for side in ("zMin", "zMax")})
    write_field("case", "p", 1e5, sides)
    write_field("case", "T", 300, sides)
    write_field("case", "U", (0, 0, 0), sides)
    write_foam("case", "constant/parcelClouds", "clouds (sand);")
    write_foam("case", "constant/g", "dimensions [0 1 -2 0 0 0 0];\nvalue"
               f" ({g[0]} {g[1]} 0);", "uniformDimensionedVectorField")
    write_foam("case", "constant/sandProperties", CLOUD.format(
        pairs=pairs, walls=walls, forces=forces, injectors=injectors))
    command = ["timeout", str(limit)]
    if ranks > 1:
        decompose("case", (ranks, 1, 1))
        command += ["mpirun", "--oversubscribe", "-np", str(ranks),
                    "rhoCentralParcelFoam", "-parallel"]
    else:
        command += ["rhoCentralParcelFoam"]
    status, log = run("case", *command)
    good, seen = False, f"exit status {status}: {complaint(log)[:100]}"
    if status == 0:
        n = int(number(log, "Current number of parcels")[-1])
        E = np.array([float(v) for v in
                      number(log, "Linear kinetic energy", False)])
        events = of_run(log, "Pair, boundary events")
        lost = sum(of_run(log, "Lost to restitution, friction"))
        overlap = of_run(log, "Deepest overlap")[0]
        finite = bool(np.all(np.isfinite(E)) and math.isfinite(lost))
        good = finite and right(n, E, events, lost, overlap, log)
        cpu = re.search(r"parcel-steps in (\S+) CPU s", log).group(1)
        held = of_run(log, "Held parcels, their energy")
        seen = (f"{n} parcels, {events[0]:.0f} pair and {events[1]:.0f}"
                f" boundary events, energy {E[0]:.3g} to {E[-1]:.3g} J,"
                f" lost in pairs {lost:.3g} J, deepest overlap {overlap:.2g}"
                f" m, held {held[0] if held else 0:.0f} times,"
                f" {float(cpu):.1f} CPU s")
    print(f"{name} | {expected} | {seen} | {'ok' if good else 'FAILED'}",
          flush=True)


only = sys.argv[1:]


ran = []


def case(name, *args, **kwargs):
    if not only or any(word in name for word in only):
        ran.append(name)
        row(name, *args, **kwargs)


def elastic(pairs):
    """All parcels are there, energy is kept, and that many pairs met."""
    def right(n, E, events, lost, overlap, log):
        return (pairs(events[0]) and lost == 0 and overlap < 1e-14
                and abs(E[-1]/E[0] - 1) < 1e-10)
    return right


case("diameter ratio 100: a grain of 10 um through 400 of 0.1 um",
     "energy kept, hundreds of pairs meet", elastic(lambda n: n > 100),
     rake("large", (3e-4, 5e-4), (3e-4, 5e-4), 1, (100., 0.))
     + rake("small", (3.06e-4, 4.951e-4), (3.06e-4, 5.049e-4), 20, (-20., 0.),
            1e-7)
     + " ".join(rake(f"s{i}", (3.1e-4 + 2e-6*i, 4.951e-4),
                     (3.1e-4 + 2e-6*i, 5.049e-4), 20, (-20., 0.), 1e-7)
                for i in range(19)), 10, 5e-7)
for speed in (1e-9, 1e5):
    case(f"relative speed {speed:g} m/s", "one pair meets, energy kept",
         elastic(lambda n: n == 1),
         rake("a", (4e-4, 5e-4), (4e-4, 5e-4), 1, (speed, 0.))
         + rake("b", (4.2e-4, 5e-4), (4.2e-4, 5e-4), 1, (0., 0.)),
         2, 1e-5/speed)


def piled(n, bound, d=1e-5):
    """All parcels are there, and at rest but for what the forces of two steps
    make of their speed: bound. Overlap below 1e-9 d."""
    def right(count, E, events, lost, overlap, log):
        mass = 2500*math.pi/6*1e-15
        return (count == n and events[0] > n and lost > 0
                and E[-10:].max() < 0.5*n*mass*bound**2
                and overlap < 1e-9*d)
    return right


def pile(n, rows, x, y, U):
    return " ".join(rake(f"r{i}", (x, y + 1.1e-5*i),
                         (x + 1.1e-5*(n - 1), y + 1.1e-5*i), n, U)
                    for i in range(rows))


case("24 grains with e = 0.1 pressed into a corner by 1e6 m/s2",
     "they come to rest, overlap below 1e-9 d", piled(24, 2),
     pile(6, 4, 1e-5, 1e-5, (0., 0.)), 60, 1e-6, LAZY, LAZY, "gravity;",
     (-1e6, -1e6))
case("24 grains with e = 0 pressed into a corner by 1e6 m/s2",
     "they come to rest, overlap below 1e-9 d", piled(24, 2),
     pile(6, 4, 1e-5, 1e-5, (0., 0.)), 60, 1e-6,
     "restitution 0; friction 0.2;", "restitution 0; friction 0.2;",
     "gravity;", (-1e6, -1e6))
case("three layers of 40 grains with e = 0.1 on a wall, 1e6 m/s2",
     "they come to rest, overlap below 1e-9 d", piled(120, 2),
     pile(40, 3, 2e-4, 1e-5, (0., 0.)),
     60, 1e-6, LAZY, LAZY, "gravity;", (0, -1e6))
case("120 grains with e = 0.9 in a corner, 1e6 m/s2",
     "they come to rest, overlap below 1e-9 d", piled(120, 2),
     pile(12, 10, 1e-5, 1e-5, (0., 0.)), 60, 1e-6,
     "restitution 0.9; friction 0.2;", LAZY, "gravity;", (-1e6, -1e6))
case("120 grains with e = 0.9 on a wall, 1e6 m/s2, across two ranks",
     "they come to rest, overlap below 1e-9 d", piled(120, 2),
     pile(12, 10, 4.6e-4, 1e-5, (0., 0.)), 60, 1e-6,
     "restitution 0.9; friction 0.2;", LAZY, "gravity;", (1e5, -1e6),
     ranks=2)
case("sand at the volume fraction 1e-3 against a wall, drag",
     "all that was injected is there, energy is lost in pairs, overlap below"
     " 1e-9 d",
     lambda n, E, events, lost, overlap, log:
     n == sum(int(v) for v in re.findall(
         r"added\s+= (\d+)", log)[-1:]) and n > 100
     and events[0] > 50 and events[1] > 50 and lost > 0 and overlap < 5e-15,
     "stream { type crossSectionInjection; volumeFraction 1e-3;"
     " diameter 5e-6; U0 (300 0 0); patches (xMin); front (5e-4 0 0); }",
     100, 2e-7, "restitution 0.5; friction 0.2;", LAZY, "hendersonDrag;")
for way, left in (("refuse", 10), ("separate", 20)):
    case(f"grains injected upon others, overlappingInjection {way}",
         "refused and reported" if left == 10 else "separated and reported",
         lambda n, E, events, lost, overlap, log: n == left
         and overlap < 1e-14 and "Injections upon others" in log,
         rake("a", (3e-4, 5e-4), (6e-4, 5e-4), 10, (1., 0.))
         + rake("b", (3e-4 + 2e-6, 5e-4), (6e-4 - 2e-6, 5e-4), 10, (1., 0.)),
         2, 1e-7, f"restitution 0.9; overlappingInjection {way};")
if not ran:
    sys.exit(f"extremes.py: no case has {' or '.join(only)} in its name")
