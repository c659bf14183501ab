# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Bad edits: each must be refused before the first time step with a message
that names the file, the entry, its value and what would be valid."""

import os
import re

from caseTools import complaint, copy_case, edit, run, verdict
from dsmcTools import refuses, write_gas

TYPES = {"xMin": "patch", "xMax": "patch", "yMin": "wall", "yMax": "wall",
         "zMin": "symmetryPlane", "zMax": "symmetryPlane"}
GAS = "constant/dsmcProperties"

write_gas("good", TYPES, (2, 2, 2), weight=1e15, wall="MixedDiffuseSpecular",
          inflow="FreeStream",
          collisions="LarsenBorgnakkeVariableHardSphere",
          more="FreeStreamCoeffs { numberDensities { Ar 1e20; }"
          " patches (xMin); inflows { xMax { numberDensities { Ar 2e20; }"
          " temperature 400; velocity (-90 0 0); } } }\n"
          "MixedDiffuseSpecularCoeffs { diffuseFraction 0.5; }\n"
          "wallDiffuseFractions { yMin 0.25; }\n"
          "sampling { start 0; every 1; }\nrandomSeed 7;\nreportEvery 2;\n",
          control={"deltaT": 1e-6, "endTime": 1e-6})


def set_wall(name, old, new):
    """Change a field on the walls only."""
    def change(case):
        path = os.path.join(case, "0", name)
        with open(path) as file:
            text = file.read()
        text = re.sub(r"(yM\w+ \{[^}]*)" + re.escape(old), r"\g<1>" + new,
                      text)
        with open(path, "w") as file:
            file.write(text)
    return change


def replace(path, old, new):
    return lambda case: edit(case, path, old, new)


def remove(*paths):
    def change(case):
        for path in paths:
            os.remove(os.path.join(case, path))
    return change


EDITS = [   # name, change, texts that the message must hold
    ("weight", replace(GAS, "Particles 1000000000000000.0", "Particles -1"),
     ["dsmcProperties", "nEquivalentParticles -1", "valid range"]),
    ("weightTooSmall", replace(GAS, "Particles 1000000000000000.0",
                               "Particles 1e-25"),
     ["nEquivalentParticles 1e-25", "2147483647", "enter in a step"]),
    ("patchesWithoutDensities", replace(
        GAS, "{ numberDensities { Ar 1e20; } patches", "{ patches"),
     ["Unknown entry patches", "Valid: (numberDensities inflows)"]),
    ("noInflow", replace(
        GAS, "numberDensities { Ar 1e20; } patches (xMin); inflows { xMax"
        " { numberDensities { Ar 2e20; } temperature 400; velocity (-90 0 0);"
        " } }", "inflows {}"),
     ["Entry numberDensities is missing, and inflows names no patch"]),
    ("species", replace(GAS, "Ar {", "He {"),
     ["moleculeProperties", "Species Ar of typeIdList", "He"]),
    ("noSpecies", replace(GAS, "typeIdList (Ar)", "typeIdList ()"),
     ["dsmcProperties", "typeIdList is empty"]),
    ("speciesTwice", replace(GAS, "typeIdList (Ar)", "typeIdList (Ar Ar)"),
     ["typeIdList Ar", "different names"]),
    ("mass", replace(GAS, "mass 6.63e-26", "mass 0"),
     ["dsmcProperties", "Entry mass 0", "valid range"]),
    ("diameter", replace(GAS, "diameter 4.17e-10", "diameter -1"),
     ["Entry diameter -1", "valid range"]),
    ("omega", replace(GAS, "omega 0.81", "omega 2.5"),
     ["Entry omega 2.5", "[0.5, 1.5]"]),
    ("rotation", replace(GAS, "Freedom 0", "Freedom -1"),
     ["internalDegreesOfFreedom -1", "valid range"]),
    ("Tref", replace(GAS, "{ Tref 273; relax", "{ Tref 0; relax"),
     ["LarsenBorgnakkeVariableHardSphereCoeffs", "Entry Tref 0",
      "valid range"]),
    ("collisionNumber", replace(GAS, "CollisionNumber 5",
                                "CollisionNumber 0.2"),
     ["relaxationCollisionNumber 0.2", "valid range"]),
    ("collisionModel", replace(GAS, "Model LarsenB", "Model B"),
     ["Unknown BinaryCollisionModel BorgnakkeVariableHardSphere",
      "VariableHardSphere none"]),
    ("wallModel", replace(GAS, "Model MixedDiffuseSpecular", "Model Elastic"),
     ["Unknown WallInteractionModel Elastic", "MaxwellianThermal"]),
    ("inflowModel", replace(GAS, "Model FreeStream", "Model Jet"),
     ["Unknown InflowBoundaryModel Jet", "FreeStream none"]),
    ("accommodation", replace(GAS, "Fraction 0.5", "Fraction 1.5"),
     ["MixedDiffuseSpecularCoeffs", "diffuseFraction 1.5",
      "valid range"]),
    ("wallAccommodation", replace(GAS, "yMin 0.25", "yMin -0.25"),
     ["wallDiffuseFractions", "yMin -0.25", "valid range"]),
    ("wallName", replace(GAS, "yMin 0.25", "xMin 0.25"),
     ["Unknown wall xMin", "yMin yMax"]),
    ("inflowSpecies", replace(GAS, "{ Ar 1e20", "{ Xe 1e20"),
     ["Unknown species Xe", "Ar"]),
    ("inflowDensity", replace(GAS, "{ Ar 1e20", "{ Ar -1e20"),
     ["Entry Ar -1e+20", "valid range"]),
    ("inflowPatch", replace(GAS, "patches (xMin)", "patches (yMin)"),
     ["Unknown patches: open patch yMin", "xMin xMax"]),
    ("inflowsPatch", replace(GAS, "xMax {", "yMax {"),
     ["Unknown inflows: open patch yMax", "xMin xMax"]),
    ("inflowsTwice", replace(GAS, "xMax {", "\"x.*\" {"),
     ["Entry patches holds xMin", "patch xMin of inflows", "one gas"]),
    ("inflowsEntry", replace(GAS, "temperature 400", "T 400"),
     ["Unknown entry T", "numberDensities temperature velocity"]),
    ("inflowsTemperature", replace(GAS, "temperature 400", "temperature -4"),
     ["temperature -4", "valid range"]),
    ("inflowsSpecies", replace(GAS, "{ Ar 2e20", "{ Kr 2e20"),
     ["Unknown species Kr", "Ar"]),
    ("inflowsDensity", replace(GAS, "{ Ar 2e20", "{ Ar -2e20"),
     ["Entry Ar -2e+20", "valid range"]),
    ("inflowKeyword", replace(GAS, "patches (xMin)", "patch (xMin)"),
     ["Unknown entry patch", "numberDensities patches inflows"]),
    ("unknownEntry", replace(GAS, "randomSeed 7", "rndSeed 7"),
     ["Unknown entry rndSeed", "randomSeed"]),
    ("seed", replace(GAS, "randomSeed 7", "randomSeed -7"),
     ["randomSeed -7", "valid range"]),
    ("report", replace(GAS, "reportEvery 2", "reportEvery 0"),
     ["reportEvery 0", "valid range"]),
    ("sampling", replace(GAS, "every 1", "each 1"),
     ["Unknown entry each", "start every"]),
    ("samplingEvery", replace(GAS, "every 1", "every 0"),
     ["Entry every 0", "valid range"]),
    ("inflowTemperature", replace(
        "0/boundaryT", "xMin { type fixedValue; value uniform 300.0",
        "xMin { type fixedValue; value uniform 0"),
     ["boundaryT 0: valid range on patch xMin", "valid range"]),
    ("wallTemperature", set_wall("boundaryT", "300.0", "-5"),
     ["boundaryT", "diffuse wall yMin -5", "valid range"]),
    ("wallVelocity", set_wall("boundaryU", "(0 0 0)", "(1 2 0)"),
     ["boundaryU", "diffuse wall yMin (1 2 0)", "along the wall"]),
    ("noFields", remove("0/boundaryT", "0/boundaryU"),
     ["boundaryT and boundaryU"]),
    ("foreignType", replace(GAS, "InflowBoundaryModel FreeStream",
                            "InflowBoundaryModel 5"),
     ["InflowBoundaryModel"]),
]

status, text = run(copy_case("good", "unchanged"), "dsmcParcelFoam")
verdict("good_runs", status == 0, complaint(text))

# The annotated dictionary of our own entries, in place of those above
case = copy_case("good", "annotated")
with open(f"{os.environ['PARCEL_IMPACT_DIR']}/etc/caseDicts/annotated/"
          "dsmcProperties") as file:
    ours = file.read()
with open(f"{case}/{GAS}") as file:
    stock = re.sub(r"(?m)^(FreeStreamCoeffs|wallDiffuse|sampling|randomSeed|"
                   r"reportEvery|InflowBoundaryModel).*$", "", file.read())
with open(f"{case}/{GAS}", "w") as file:
    file.write(stock + ours)
status, text = run(case, "dsmcParcelFoam")
verdict("annotated_isRead", status != 0 and "Unknown wall z.*"
        in " ".join(text.split()), complaint(text))
edit(case, GAS, '"z.*"', '"y.*"')
status, text = run(case, "dsmcParcelFoam")
verdict("annotated_runs", status == 0, complaint(text))

for name, change, texts in EDITS:
    case = copy_case("good", "bad_" + name)
    change(case)
    refuses(f"refuses_{name}", case, texts)
