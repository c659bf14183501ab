# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Rows of the benchmark: rows.py TABLE.csv"""

import math
import os
import re
import shutil
import sys

import numpy as np

from caseTools import (box, decompose, must, write_block, write_case,
                       write_field, write_foam)

RADIUS = 2.5e-6
CELLS = (60, 60, 1)
SPEED = 300.0

CLOUD = """
type spinningKinematicCloud;
solution
{
    active yes; coupled no; transient yes; cellValueSourceCorrection off;
    rotation off;
    motion { type embeddedRK54; tolerance 1e-4; }
    COLLISIONS
    interpolationSchemes
    { rho cellLinear; U cellLinear; T cellLinear; thermo:mu cellLinear; }
    integrationSchemes { U Euler; }
}
constantProperties { rho0 2500; }
subModels
{
    particleForces { hendersonDrag; }
    rotationalTorqueModel none;
    injectionModels
    {
        up
        {
            type crossSectionInjection; volumeFraction FRACTION;
            diameter 5e-6; U0 (300 150 0); patches (xMin yMin);
            prefill { box (0 0 -1) (SIDE SIDE 1); }
        }
        down
        {
            type crossSectionInjection; volumeFraction FRACTION;
            diameter 5e-6; U0 (300 -150 0); patches (xMin yMax); seed 1;
            prefill { box (0 0 -1) (SIDE SIDE 1); }
        }
    }
    patchInteractionModel hardSphereWall;
    hardSphereWallCoeffs { patches ( ".*" { type escape; } ); }
    dispersionModel none; stochasticCollisionModel none;
    surfaceFilmModel none;
}
cloudFunctions {}
"""
SIDES = ("xMin", "xMax", "yMin", "yMax")


def measured(*args):
    """CPU seconds per parcel and step, pairs per parcel and step, peak MiB:
    without the first step, which fills the domain"""
    steps = max(5, min(100, 2000000//args[0]))
    first, all_ = run(1, *args), run(1 + steps, *args)
    cpu, count, pairs = (b - a for a, b in zip(first, all_[:3]))
    return cpu/count, pairs/count, all_[3]


def run(steps, n, fraction, collisions, ranks=1):
    """CPU seconds, parcel-steps, pairs, peak MiB"""
    side = math.sqrt(n*2*math.pi*RADIUS**2/(3*fraction))
    dt = 0.1*side/CELLS[0]/SPEED
    shutil.rmtree("case", ignore_errors=True)
    os.mkdir("case")
    write_case("case", {"endTime": steps*dt, "deltaT": dt,
                        "writeInterval": steps*dt,
                        "libs": "(spinningParcel)"}, {"mode": "frozen"})
    write_block("case", box((side, side, 1e-4)), CELLS,
                {name: "patch" for name in SIDES})
    must("case", "blockMesh")
    fixed = {name: "type zeroGradient;" for name in SIDES}
    fixed.update({name: "type empty;" for name in ("zMin", "zMax")})
    write_field("case", "p", 1e5, fixed)
    write_field("case", "T", 300, fixed)
    x = (np.arange(CELLS[0]) + 0.5)/CELLS[0]
    X, Y = np.meshgrid(x, x)
    wave = 4*math.pi
    write_field("case", "U", np.stack(
        [SPEED*(1 + 0.5*np.sin(wave*Y)), 0.5*SPEED*np.sin(wave*X), 0*X],
        axis=-1).reshape(-1, 3), fixed)
    write_foam("case", "constant/parcelClouds", "clouds (sand);")
    write_foam("case", "constant/sandProperties",
               CLOUD.replace("FRACTION", repr(0.5*fraction))
               .replace("SIDE", repr(side))
               .replace("COLLISIONS", f"collisions {collisions};"
                        if collisions == "off" else
                        f"collisions {{ type {collisions}; }}"))
    measure = os.path.join(os.environ["PARCEL_IMPACT_DIR"],
                           "tests/benchmarks/measure")
    command = ["rhoCentralParcelFoam"]
    if ranks > 1:
        decompose("case", (1, ranks, 1))
        command = ["mpirun", "--oversubscribe", "-np", str(ranks), *command,
                   "-parallel"]
    log = must("case", "python3", measure, "out", *command)
    count, cpu = re.search(r"parcels, (\d+) parcel-steps in (\S+) CPU s",
                           log).groups()
    pairs = re.findall(r"Pair, boundary events.*in all ([^,]+),", log)
    with open("case/out") as file:
        peak = float(file.read().split()[2])
    return float(cpu), float(count), float(pairs[-1]) if pairs else 0, peak


with open(sys.argv[1], "w") as table:
    def line(text):
        print(text, file=table, flush=True)
        print(text, flush=True)

    line("N,fraction,ranks,collisions,cpu_us,over_off,pairs,bytes")
    for fraction, numbers in ((1e-5, (10000, 100000)),
                              (1e-4, (10000, 100000, 300000))):
        base, off = {}, {}
        for n in numbers:
            for way in ("off", "eventDriven"):
                cpu, pairs, peak = measured(n, fraction, way)
                base.setdefault(way, (n, peak))
                off[n] = off.get(n, cpu)
                n0, peak0 = base[way]
                size = (f"{(peak - peak0)*2**20/(n - n0):.0f}"
                        if n > n0 else "")
                line(f"{n},{fraction:g},1,{way},{1e6*cpu:.3g},"
                     f"{cpu/off[n]:.2f},{pairs:.2g},{size}")
    for way in ("off", "eventDriven"):
        cpu, pairs, _ = measured(100000, 1e-4, way, 2)
        line(f"100000,0.0001,2,{way},{1e6*cpu:.3g},{cpu/off[100000]:.2f},"
             f"{pairs:.2g},")
