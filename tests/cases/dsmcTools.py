# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Cases of dsmcParcelFoam, and what it writes."""

import os
import re

import numpy as np

import caseTools
from caseTools import (SIDES, box, entries, must, read_field, run,
                       write_block, write_foam)
from foamFiles import positions

K = 1.380649e-23    # [J/K]

ARGON = {"mass": 66.3e-27, "diameter": 4.17e-10,
         "internalDegreesOfFreedom": 0, "omega": 0.81}
NITROGEN = {"mass": 46.5e-27, "diameter": 4.17e-10,
            "internalDegreesOfFreedom": 2, "omega": 0.74}


def block(text):
    return "{ " + text + " }"


def write_gas(case, types, cells=(10, 10, 10), lengths=(0.1, 0.1, 0.1),
              weight=1e12, density=1e20, T=300., U=(0, 0, 0), wallT=None,
              gas=None, collisions="VariableHardSphere",
              wall="MaxwellianThermal", inflow="none", more="", control=None,
              initialise=True):
    """A box of gas. types: side -> patch type; wallT: side -> temperature, T
    where nothing is said."""
    gas = gas or {"Ar": ARGON}
    write_block(case, box(lengths), cells, types)
    settings = {
        "application": "dsmcParcelFoam", "startFrom": "latestTime",
        "startTime": 0, "stopAt": "endTime", "writeControl": "timeStep",
        "writeFormat": "binary",
        "writePrecision": 16, "timePrecision": 12, "timeFormat": "general",
        "runTimeModifiable": "no"}
    settings.update(control or {})
    if "writeInterval" not in (control or {}):
        settings["writeInterval"] = round(settings["endTime"]
                                          / settings["deltaT"])
    write_foam(case, "system/controlDict", entries(settings))
    write_foam(case, "system/fvSchemes",
               "ddtSchemes {} gradSchemes {} divSchemes {}\n"
               "laplacianSchemes {} interpolationSchemes {} snGradSchemes {}")
    write_foam(case, "system/fvSolution", "")
    names = " ".join(gas)
    write_foam(
        case, "constant/dsmcProperties",
        f"nEquivalentParticles {weight!r};\n"
        f"WallInteractionModel {wall};\n"
        f"BinaryCollisionModel {collisions};\n"
        "VariableHardSphereCoeffs { Tref 273; }\n"
        "LarsenBorgnakkeVariableHardSphereCoeffs\n"
        "{ Tref 273; relaxationCollisionNumber 5; }\n"
        f"InflowBoundaryModel {inflow};\n"
        f"typeIdList ({names});\nmoleculeProperties\n{{\n"
        + "\n".join(f"{name} {block(entries(values))}"
                    for name, values in gas.items())
        + "\n}\n" + more)
    share = density/len(gas)
    write_foam(
        case, "system/dsmcInitialiseDict",
        "numberDensities { "
        + " ".join(f"{name} {share!r};" for name in gas)
        + f" }}\ntemperature {T!r};\nvelocity ({U[0]} {U[1]} {U[2]});")

    wallT = wallT or {}
    for name, kind, dims, value in (
            ("boundaryT", "Scalar", "[0 0 0 1 0 0 0]",
             lambda side: repr(float(wallT.get(side, T)))),
            ("boundaryU", "Vector", "[0 1 -1 0 0 0 0]",
             lambda side: "(0 0 0)" if types[side] == "wall"
             else f"({U[0]} {U[1]} {U[2]})")):
        patches = []
        for side in SIDES:
            patch = types.get(side, "empty")
            text = (f"type fixedValue; value uniform {value(side)};"
                    if patch in ("wall", "patch") else f"type {patch};")
            patches.append(f"    {side} {block(text)}")
        zero = "0" if kind == "Scalar" else "(0 0 0)"
        write_foam(case, f"0/{name}",
                   f"dimensions {dims};\ninternalField uniform {zero};\n"
                   "boundaryField\n{\n" + "\n".join(patches) + "\n}",
                   f"vol{kind}Field")
    must(case, "blockMesh")
    if initialise:
        must(case, "dsmcInitialise")
    return case


def solve(case, ranks=1):
    """Run the solver; its log."""
    command = ["dsmcParcelFoam"]
    if ranks > 1:
        command = ["mpirun", "--oversubscribe", "-np", str(ranks), *command,
                   "-parallel"]
    return must(case, *command, log="dsmcParcelFoam")


def refuses(name, case, texts):
    """Verdict: the solver stops before its first step, with these texts."""
    caseTools.refuses(name, run(case, "dsmcParcelFoam"), texts,
                      "Starting time loop")


# ------------------------------------------------------------------- reading

NUMBER = r"[-+0-9.eE]+"


def reported(text, pattern):
    """All numbers that a pattern's group matches in a log."""
    return np.array([float(x) for x in re.findall(pattern, text)])


def energies(text):
    return reported(text, rf"energy: ({NUMBER}) J")


def collisions(text):
    return reported(text, rf"Collisions: ({NUMBER}) in")[-1]


def momenta(text):
    return np.array([[float(x) for x in m.split()] for m in
                     re.findall(r"momentum: \(([^)]*)\)", text)])


def read_molecules(case, time):
    """Positions, cells and fields of the molecules, from binary files."""
    folder = os.path.join(case, time, "lagrangian/dsmc")

    x, cell = positions(folder)
    return x, cell, {name: read_field(os.path.join(folder, name))
                     for name in ("U", "Ei", "typeId")}


def read_wall(case, time, name, patch):
    """Values of a field on a patch."""
    return read_field(os.path.join(case, time, name), patch)
