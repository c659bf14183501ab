# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Settings that are seldom used together: many periods in a step, a rerun over
an earlier one, parcels that rest while they have temperatures, heat that no
gas gives; and what is refused."""

import os
import re

import numpy as np

from caseTools import (complaint, copy_case, decompose, edit, must, read_field,
                       run, solve, times_of, verdict, write_block, write_case,
                       write_field, write_foam)
from caseTools import box as corners
from foamFiles import positions
from spinningCloud import write_cloud, write_cube

LIBS = "(spinningParcel parcelInjection parcelForces)"
CLOUD = "constant/dustProperties"
SIDES = [s + e for s in "xyz" for e in ("Min", "Max")]
STEP = 1e-6


def rake(*, d, start, end, n=1, velocity=(0, 0, 0), more=""):
    def text(v):
        return "(%r %r %r)" % tuple(map(float, v))
    return (f"type rakeInjection; start {text(start)}; end {text(end)};"
            f" nParcels {n}; diameter {d!r}; U0 {text(velocity)}; {more}")


def control(steps, step=STEP, **more):
    return {"endTime": steps*step, "deltaT": step, "writeInterval":
            steps*step, "writeFormat": "ascii", "libs": LIBS,
            "timePrecision": 12, **more}


def last(case, name):
    return read_field(f"{case}/{times_of(case)[-1]}/lagrangian/dust/{name}")


# A grain that is pressed onto a wall rests there: its drag, which depends on
# temperatures, is that of one that has none where they are the same
speeds = []
for name, more, constants in (
        ("restsCold", "", "rho0 2500;"),
        ("restsHeated", "heatTransfer on;", "rho0 2500; T0 300; Cp0 1e9;")):
    write_cube(name, 1e-2, 4, control(5))
    must(name, "foamDictionary", "constant/polyMesh/boundary", "-entry",
         "entry0/yMin/type", "-set", "wall")
    plain = dict.fromkeys(SIDES, "type zeroGradient;")
    write_field(name, "U", (100.0, 0.0, 0.0), plain)
    write_field(name, "p", 1e3, plain)
    write_foam(name, "constant/g",
               "dimensions [0 1 -2 0 0 0 0]; value (0 -1e5 0);",
               "uniformDimensionedVectorField")
    write_cloud(name, "dust", rake(d=1e-6, start=(1e-3, 1e-12, 5e-3),
                                   end=(1e-3, 1e-12, 5e-3)),
                forces="singhDrag; gravity;", constants=constants,
                solution=more + " collisions { type eventDriven;"
                " contactDuration 1e-6; }",
                walls="patchInteractionModel standardWallInteraction;"
                " standardWallInteractionCoeffs"
                " { type rebound; e 0.1; mu 0; }")
    solve(name)
    speeds.append(last(name, "U")[0][0])
verdict("rest_with_temperature", speeds[0] > 1
        and abs(speeds[1]/speeds[0] - 1) < 1e-6,
        "%r m/s without and %r m/s with temperatures" % tuple(speeds))

# 55 periods in one step, on one rank and two
period, speed = 2e-3, 100.0
for ranks in 1, 2:
    name = f"periods_{ranks}"
    write_case(name, control(1, 55.5*period/speed), {"mode": "frozen"})
    kinds = {**dict.fromkeys(SIDES, "patch"), "xMin": "cyclic",
             "xMax": "cyclic"}
    write_block(name, corners((period,)*3), (4, 2, 2), kinds)
    plain = {side: "type cyclic;" if side[0] == "x" else "type zeroGradient;"
             for side in SIDES}
    write_field(name, "p", 1e5, plain)
    write_field(name, "T", 300.0, plain)
    write_field(name, "U", (speed, 0.0, 0.0), plain)
    write_foam(name, "constant/parcelClouds", "clouds (dust);")
    place = (0.3*period, 0.5*period, 0.3*period)
    write_cloud(name, "dust", rake(d=1e-5, start=place, end=place,
                                   velocity=(speed, 0, 0)),
                forces="sphereDrag;")
    must(name, "blockMesh")
    if ranks > 1:
        decompose(name)
    solve(name, ranks)
    if ranks > 1:
        must(name, "reconstructPar")
    x = positions(f"{name}/{times_of(name)[-1]}/lagrangian/dust")[0][0]
    verdict(name, abs(x[0]/period - 0.8) < 1e-6,
            f"at {x[0]/period:.7f} of the period after 55.5")

def plane(case, control, thickness):
    """A plane mesh in which the gas is frozen."""
    write_case(case, control, {"mode": "frozen"})
    write_block(case, corners((0.1, 0.01, thickness)), (10, 2, 1),
                {s: "empty" if s[0] == "z" else "patch" for s in SIDES})
    plain = {side: "type empty;" if side[0] == "z" else "type zeroGradient;"
             for side in SIDES}
    for name, value in ("p", 1e5), ("T", 300.0), ("U", (0.0, 0.0, 0.0)):
        write_field(case, name, value, plain)
    write_foam(case, "constant/parcelClouds", "clouds (dust);")
    must(case, "blockMesh")


def with_parcels(case):
    return [time for time in times_of(case) if os.path.exists(
        f"{case}/{time}/lagrangian/dust/U")]


# What a rerun leaves of the run before
for case in "rerun", "anew":
    write_cube(case, 1e-2, 2, control(4, writeInterval=STEP,
                                      startFrom="startTime"))
    write_cloud(case, "dust", rake(d=1e-5, start=(2e-3,)*3, end=(8e-3,)*3,
                                   n=8))
solve("rerun")
before = with_parcels("rerun")
for case in "rerun", "anew":
    edit(case, CLOUD, "nParcels 8;", f"nParcels 8; startTime {1.5*STEP!r};")
    solve(case)
verdict("rerun_leaves_nothing", with_parcels("rerun") == with_parcels("anew")
        and len(before) > len(with_parcels("anew")) > 0,
        f"parcels at {with_parcels('rerun')}, before at {before}")

# Losses of collisions are of all particles that parcels stand for
case = "losses"
plane(case, control(20, 1e-5), 1e-3)
write_cloud(case, "dust", rake(
    d=1e-4, start=(4e-3, 5e-3, 5e-4), end=(5e-3, 5e-3, 5e-4), n=2,
    more="nParticle 10;"),
    solution="collisions { type eventDriven; restitution 0.5; friction 0; }")
edit(case, CLOUD, "injectionModels {", "injectionModels { fast { "
     + rake(d=1e-4, start=(3e-3, 5e-3, 5e-4), end=(3e-3, 5e-3, 5e-4),
            velocity=(10, 0, 0), more="nParticle 10;") + " }")
log = solve(case)
lost = float(re.findall(r"Lost to restitution.*in all (\S+),", log)[-1])
whole = 0.5*10*2500*np.pi/6*1e-4**3*10**2
kept = whole*(last(case, "U")**2).sum()/10**2
verdict("losses_of_all_particles", abs((kept + lost)/whole - 1) < 1e-5
        and lost > 0.1*whole,
        f"kept {kept:g} and lost {lost:g} J of {whole:g} J")

# Spheres one in another, looked at by a function while collisions begin
case = "overlap"
write_cube(case, 1e-2, 4, control(1))
write_cloud(case, "dust", rake(d=1e-4, start=(5e-3,)*3, n=2,
                               end=(5.05e-3, 5e-3, 5e-3)),
            solution="collisions off;")
edit(case, CLOUD, "cloudFunctions {}",
     "cloudFunctions { f { type voidFraction; } }")
solve(case)
edit(case, CLOUD, "collisions off;", "collisions { type eventDriven; }")
edit(case, "system/controlDict", f"endTime {STEP!r}", f"endTime {3*STEP!r}")
verdict("overlap_is_said", "Spheres overlap by 5e-05 m" in solve(case),
        "two spheres half in each other")

# Molecules that give no heat
case = "noHeat"
write_cube(case, 1e-2, 2, control(2))
write_cloud(case, "dust", rake(d=1e-7, start=(4e-3,)*3, end=(4e-3,)*3,
                               more="nParticle 1e6;"),
            forces="sphereDrag;", coupled="yes", constants="rho0 2500;"
            " T0 1000; Cp0 800;", solution="heatTransfer on; sourceTerms"
            " { schemes { U explicit 1; } }",
            models="heatTransferModel { type freeMolecular;"
            " accommodation 0; }")
edit(case, "system/fvSolution", "frozen", "transient")
status, text = run(case, "rhoCentralParcelFoam")
T = last(case, "T") if not status else np.zeros(1)
verdict("no_heat_from_the_gas", status == 0 and abs(T[0]/1000 - 1) < 1e-12,
        f"{T[0]!r} K" if not status else complaint(text))

# Refused, or accepted as what it says
for name, old, new, words in (
        ("misspeltBlock", "dispersionModel none;", "dispersionModel"
         " stochasticDispersionRAS; stochasticDispersionRasCoeffs"
         " { seed 3; }",
         ["stochasticDispersionRasCoeffs", "stochasticDispersionRASCoeffs"]),
        ("noHeatModel", "surfaceFilmModel none;", "surfaceFilmModel none;"
         " heatTransferModel none;", None),
        ("tooFew", "injectionModels {", "injectionModels { few { type"
         " manualInjection; massTotal 0; parcelBasisType fixed; nParticle 0.5;"
         " SOI 0; positionsFile places; U0 (0 0 0); sizeDistribution { type"
         " fixedValue; fixedValueDistribution { value 1e-5; } } }",
         ["nParticle 0.5", "minParticlesPerParcel"])):
    case = copy_case("rerun", "rerun_" + name)
    edit(case, CLOUD, old, new)
    status, text = run(case, "rhoCentralParcelFoam")
    good = status == 0 if words is None else (
        status and "FATAL IO ERROR" in text
        and all(word in text for word in words))
    verdict(("refuses_" if words else "accepts_") + name, good,
            complaint(text) if status else "runs")

case = copy_case("rerun", "steadyCoupled")
write_cloud(case, "dust", """
    type manualInjection; massTotal 0; massFlowRate 1e-6; SOI 0;
    parcelBasisType mass; positionsFile places; U0 (0 0 0);
    sizeDistribution
        { type fixedValue; fixedValueDistribution { value 1e-5; } }""",
            coupled="yes", solution="maxTrackTime 1; calcFrequency 1;"
            " sourceTerms { schemes { U explicit 1; } }")
edit(case, CLOUD, "transient yes", "transient no")
write_foam(case, "constant/places", "1((5e-3 5e-3 5e-3))", "vectorField")
status, text = run(case, "rhoCentralParcelFoam")
verdict("refuses_steadyCoupled", status and "Entry coupled yes" in text
        and "feedback" in text, complaint(text))

case = "plane"
plane(case, control(1), 1e-3)
write_cloud(case, "dust", "type crossSectionInjection; patches (xMin);"
            " U0 (100 0 100); volumeFraction 1e-4; diameter 1e-5;")
status, text = run(case, "rhoCentralParcelFoam")
verdict("refuses_acrossPlane", status and "U0 (100 0 100)" in text
        and "across the plane" in text, complaint(text))
