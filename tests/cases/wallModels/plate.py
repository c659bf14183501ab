# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""A box of gas at rest over a plate, in a stock solver: parcels without forces
fall on the plate and fly off. Writes the case, reads the parcels."""

import csv
import glob
import os
import re

import numpy as np

from caseTools import box, must, run, write_block, write_field, write_foam

SOLVER = "icoUncoupledKinematicParcelFoam"
CLOUD = "kinematicCloud"
# Every side of the box but the plate lets parcels out
OPEN = '"[xyz]M.*" { type escape; }'
SIDES = {"xMin": "patch", "xMax": "patch", "yMin": "wall", "yMax": "patch",
         "zMin": "patch", "zMax": "patch"}


def injector(start, end, n, velocity, diameter, n_particle=1):
    def point(p):
        return "(" + " ".join(repr(float(x)) for x in p) + ")"
    return (f"type rakeInjection; start {point(start)}; end {point(end)};"
            f" nParcels {n}; diameter {diameter!r}; U0 {point(velocity)};"
            f" nParticle {n_particle};")


def write_plate(case, model, coeffs, injectors, *, end=4e-4, step=2e-4,
                write=None, lengths=(1, 0.1, 0.2), cells=(2, 2, 2),
                sides=None, wall_velocity=(0, 0, 0), functions="",
                libs="parcelInjection parcelWallInteraction", extra="",
                solution="", fmt="binary"):
    """A case in a new folder. coeffs: text of the model's dictionary."""
    sides = sides or SIDES
    write_foam(case, "system/controlDict", f"""
application {SOLVER}; startFrom latestTime; startTime 0; stopAt endTime;
endTime {end!r}; deltaT {step!r}; writeControl timeStep;
writeInterval {write or round(end/step)}; writeFormat {fmt};
writePrecision 17; timePrecision 12; runTimeModifiable no;
libs ({libs});""")
    write_foam(case, "system/fvSchemes",
               "ddtSchemes { default Euler; }\n"
               "gradSchemes { default Gauss linear; }\n"
               "divSchemes { default none; }\n"
               "laplacianSchemes { default none; }\n"
               "interpolationSchemes { default linear; }\n"
               "snGradSchemes { default none; }")
    write_foam(case, "system/fvSolution", "")
    write_foam(case, "constant/g",
               "dimensions [0 1 -2 0 0 0 0]; value (0 0 0);",
               "uniformDimensionedVectorField")
    write_foam(case, "constant/transportProperties",
               "transportModel Newtonian; nu 1e-5; rhoInf 1;")
    write_foam(case, "constant/turbulenceProperties",
               "simulationType laminar;")
    fixed = "type fixedValue; value uniform (%r %r %r);" % tuple(
        map(float, wall_velocity))
    write_field(case, "U", (0, 0, 0), {
        side: fixed if kind == "wall" else
        "type empty;" if kind == "empty" else "type zeroGradient;"
        for side, kind in sides.items()})
    write_block(case, box(lengths), cells, sides)
    models = "\n".join(f"r{i} {{ {text} }}"
                       for i, text in enumerate(injectors))
    write_foam(case, f"constant/{CLOUD}Properties", f"""
solution
{{
    active yes; coupled no; transient yes; cellValueSourceCorrection off;
    maxCo 1e6; {solution}
    interpolationSchemes {{ rho cell; U cell; mu cell; }}
    integrationSchemes {{ U Euler; }}
}}
constantProperties {{ rho0 2500; youngsModulus 1e9; poissonsRatio 0.3;
    alphaMax 0.9; }}
subModels
{{
    particleForces {{}}
    injectionModels
    {{
{models}
    }}
    dispersionModel none;
    patchInteractionModel {model};
    {model}Coeffs
    {{
{coeffs}
    }}
    stochasticCollisionModel none; surfaceFilmModel none;
    collisionModel none; radiation off;
    {extra}
}}
cloudFunctions
{{
{functions}
}}""")


def mesh(case):
    must(case, "blockMesh")


def solve(case, ranks=1, solver=SOLVER):
    command = [solver]
    if ranks > 1:
        command = ["mpirun", "--oversubscribe", "-np", str(ranks), *command,
                   "-parallel"]
    return must(case, *command, log=solver)


def _read(path):
    with open(path, "rb") as file:
        data = file.read()
    head = data.index(b"}") + 1
    binary = re.search(rb"format\s+binary", data[:head]) is not None
    kind = re.search(rb"class\s+(\w+)", data[:head]).group(1)
    body = re.sub(rb"//[^\n]*\n", b"", data[head:], count=1)
    width = 3 if kind.startswith(b"vector") else 1
    number = "<i4" if kind.startswith(b"label") else "<f8"
    uniform = re.match(rb"\s*(\d+)\s*\{([^}]*)\}", body)
    if uniform:
        value = uniform.group(2).replace(b"(", b" ").replace(b")", b" ")
        return np.tile(np.array(value.split(), float),
                       (int(uniform.group(1)), 1)).squeeze(-1 if width == 1
                                                           else None)
    count = re.match(rb"\s*(\d+)\s*\(", body)
    if not count:
        return np.zeros((0, 3) if width == 3 else 0)
    n = int(count.group(1))
    if binary:
        values = np.frombuffer(body, number, n*width, count.end())
    else:
        text = body[count.end():].replace(b"(", b" ").replace(b")", b" ")
        values = np.array(text.split()[:n*width], float)
    return values.reshape(n, 3) if width == 3 else values


def parcels(case, time, *fields):
    """Fields of the parcels, ordered by identity, over all ranks."""
    parts = sorted(glob.glob(f"{case}/processor*")) or [case]
    rows = []
    for part in parts:
        folder = f"{part}/{time}/lagrangian/{CLOUD}"
        if os.path.exists(f"{folder}/origId"):
            rows.append([_read(f"{folder}/{name}")
                         for name in ("origId", *fields)])
    columns = [np.concatenate(c) for c in zip(*rows)]
    order = np.argsort(columns[0], kind="stable")
    return [c[order] for c in columns]


def counters(text, patch="yMin"):
    """The last counters in a log."""
    at = text.rindex(f", patch {patch}\n")
    values = {}
    for line in text[at:].split("\n")[1:]:
        found = re.match(r"\s+- (.*?)\s*= (.*)", line)
        if not found:
            break
        values[found.group(1)] = [float(v) for v in
                                  found.group(2).split(",")]
    return values


def write_csv(path, rows):
    with open(path, "w", newline="") as file:
        csv.writer(file).writerows(rows)


__all__ = ["OPEN", "SIDES", "SOLVER", "counters", "injector", "mesh",
           "parcels", "run", "solve", "write_plate"]
