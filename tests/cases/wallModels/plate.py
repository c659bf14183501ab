# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""A box of gas at rest over a plate, in a stock solver: parcels without forces
fall on the plate and fly off. Writes the case, reads the parcels."""

import csv
import re

from caseTools import box, must, run, write_block, write_field, write_foam
import foamFiles

SOLVER = "icoUncoupledKinematicParcelFoam"
CLOUD = "kinematicCloud"
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
        f"type {kind};" if kind in ("empty", "cyclic") else
        "type zeroGradient;"
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


def parcels(case, time, *fields):
    """Fields of the parcels, ordered by identity, over all ranks."""
    return foamFiles.parcels(case, time, CLOUD, *fields)


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


__all__ = ["SIDES", "SOLVER", "counters", "injector", "mesh",
           "parcels", "run", "solve", "write_plate"]
