# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Bad entries of solidParticleProperties stop the run before the first time
step, with the file, the entry, its value and what would be valid."""

import os
import re
import shutil

from caseTools import complaint, copy_case, edit, run, verdict
from dsmcTools import refuses, write_gas
from solidTools import PROPERTIES, fill, write_solids

GAS = "constant/dsmcProperties"
TYPES = {"xMin": "patch", "xMax": "patch", "yMin": "wall", "yMax": "wall",
         "zMin": "symmetryPlane", "zMax": "symmetryPlane"}

write_gas("good", TYPES, (2, 2, 2), weight=1e15, inflow="FreeStream",
          U=(100, 0, 0),
          more="FreeStreamCoeffs { numberDensities { Ar 1e20; }"
          " patches (xMin); }\n",
          control={"deltaT": 1e-6, "endTime": 1e-6})
write_solids(
    "good", fill(1e-3)
    + "realPerSimulator 1000;\n"
    "inflows { xMin { massLoading 0.5; velocity gas; temperature 900; } }\n"
    "sampling { start 0; every 1; fields (U); }\nrandomSeed 7;\n"
    "deflection exact;\n")


def replace(old, new):
    return lambda case: edit(case, PROPERTIES, old, new)


EDITS = [   # name, change, texts that the message must hold
    ("density", replace("density 2700.0", "density 0"),
     ["material", "Entry density 0", "valid range"]),
    ("heat", replace("Heat 900.0", "Heat -1"),
     ["specificHeat -1", "valid range"]),
    ("diameter", replace("(3e-06 6e-06)", "(3e-06 -6e-06)"),
     ["groups", "diameters -6e-06", "valid range"]),
    ("fractions", replace("(1.0 1.0)", "(1.0)"),
     ["number of massFractions 1", "2"]),
    ("fractionsZero", replace("(1.0 1.0)", "(0 0)"),
     ["massFractions 0", "(0, 1e30]"]),
    ("groupType", replace("type list", "type array"),
     ["Unknown type array", "list lognormal"]),
    ("accommodation", replace("accommodation 1.0", "accommodation 1.5"),
     ["solidParticleProperties", "accommodation 1.5", "[0, 1]"]),
    ("accommodationNegative",
     replace("accommodation 1.0", "accommodation -0.1"),
     ["accommodation -0.1", "[0, 1]"]),
    ("exchange", replace("exchange perCell", "exchange perPair"),
     ["Unknown exchange perPair", "perCell perCollision none"]),
    ("deflection", replace("deflection exact", "deflection fit"),
     ["Unknown deflection fit", "exact polynomial"]),
    ("weight", replace("realPerSimulator 1000", "realPerSimulator 0"),
     ["realPerSimulator 0", "valid range"]),
    ("weightNegative", replace("realPerSimulator 1000",
                               "realPerSimulator (10 -3)"),
     ["realPerSimulator -3", "valid range"]),
    ("weights", replace("realPerSimulator 1000", "realPerSimulator (1 2 3)"),
     ["(1 2 3)", "2 groups"]),
    ("noWeight", replace("realPerSimulator 1000;", ""),
     ["simulatorsPerStep", "realPerSimulator"]),
    ("simulators", replace("simulators 100", "simulators 0"),
     ["simulators 0", "valid range"]),
    ("concentration", replace("concentration 0.001", "concentration -1"),
     ["concentration -1", "valid range"]),
    ("fillTemperature", replace("temperature 300.0", "temperature 0"),
     ["temperature 0", "valid range"]),
    ("region", replace("region all", "region sphere"),
     ["Unknown region sphere", "all box zone"]),
    ("emptyBox", replace("region all", "region box; box (2 2 2) (3 3 3)"),
     ["region box", "a region with cells"]),
    ("zone", replace("region all", "region zone; zone cloud"),
     ["Unknown zone cloud"]),
    ("inflowPatch", replace("xMin { mass", "yMin { mass"),
     ["Unknown inflows: open patch yMin", "xMin xMax"]),
    ("inflowWithoutGas", replace("xMin { mass", "xMax { mass"),
     ["outside patch xMax", "mass flux is 0", "an inflow of gas"]),
    ("loading", replace("massLoading 0.5", "massLoading 0"),
     ["massLoading 0", "valid range"]),
    ("twoFlows", replace("massLoading 0.5", "massLoading 0.5; massFlow 1"),
     ["one of the entries massFlow and massLoading"]),
    ("inflowVelocity", replace("velocity gas", "velocity (-100 0 0)"),
     ["Entry velocity (-100 0 0)", "into the domain"]),
    ("inflowTemperature", replace("temperature 900", "temperature -900"),
     ["temperature -900", "valid range"]),
    ("noWalls", replace('walls { ".*" { type specular; } }', ""),
     ["No entry of walls is for the wall yMin"]),
    ("wallName", replace('".*" { type specular; }', 'xMin { type specular; }'),
     ["Unknown wall xMin", "yMin yMax"]),
    ("wallType", replace("type specular", "type sticky"),
     ["Unknown type sticky", "specular hardSphereWall"]),
    ("wallPatterns", replace('".*" {', '"y.*" { type stick; } ".*" {'),
     ["Entry walls", "one pattern for the wall y"]),
    ("wallVelocity", lambda case: (
        edit(case, GAS, "MaxwellianThermal;", "SpecularReflection;"),
        edit(case, "0/boundaryU",
             "yMax { type fixedValue; value uniform (0 0 0)",
             "yMax { type fixedValue; value uniform (0 5 0)")),
     ["boundaryU", "wall of solid particles yMax (0 5 0)", "along the wall"]),
    ("tooMany", lambda case: (
        edit(case, PROPERTIES, "simulators 100;", ""),
        edit(case, PROPERTIES, "realPerSimulator 1000",
             "realPerSimulator 1e-3")),
     ["Of diameter", "simulated particles come in at once", "[0, 1e9]"]),
    ("deviation", replace(
        "type list; diameters (3e-06 6e-06); massFractions (1.0 1.0);",
        "type lognormal; radius 1e-6; deviation 20; weighting mass;"
        " classes 3;"),
     ["deviation 20", "(1, 10]"]),
    ("wallLaw", replace("type specular",
                        "type hardSphereWall; restitution 1.2; friction 0"),
     ["restitution 1.2", "[0, 1]"]),
    ("correction", replace("randomSeed 7",
                           "randomSeed 7; knudsenCorrection on"),
     ["knudsenCorrection on", "off"]),
    ("correctionDrag", replace(
        "randomSeed 7;", "randomSeed 7; knudsenCorrection { drag"
        " haiderLevenspielDrag; heat kavanau; }"),
     ["drag haiderLevenspielDrag", "singhDrag"]),
    ("correctionHeat", replace(
        "randomSeed 7;", "randomSeed 7; knudsenCorrection { drag singhDrag;"
        " heat ranzMarshall; }"),
     ["heat ranzMarshall", "kavanau"]),
    ("correctionScale", replace(
        "randomSeed 7;", "randomSeed 7; knudsenCorrection { drag singhDrag;"
        " heat kavanau; densityScale 0; }"),
     ["densityScale 0", "(0, 1e12]"]),
    ("correctionAccommodation", replace(
        "accommodation 1.0;", "accommodation 0.9; knudsenCorrection { drag"
        " singhDrag; heat kavanau; }"),
     ["accommodation 0.9", "Knudsen"]),
    ("unknownEntry", replace("randomSeed 7", "seed 7"),
     ["Unknown entry seed", "randomSeed"]),
    ("unknownFillEntry", replace("simulators 100", "simulator 100"),
     ["Unknown entry simulator"]),
    ("field", replace("fields (U)", "fields (V)"),
     ["Unknown fields V", "numberDensity concentration U T"]),
    ("trials", replace("every 1", "every 1; trials 0"),
     ["trials 0", "[1, 1000]"]),
    ("trialsPerCollision", lambda case: (
        edit(case, PROPERTIES, "every 1", "every 1; trials 2"),
        edit(case, PROPERTIES, "exchange perCell", "exchange none")),
     ["trials 2", "perCell"]),
    ("sampling", replace("every 1", "every 0"),
     ["Entry every 0", "valid range"]),
    ("interfacePatches", replace(
        "randomSeed 7", "interface { patches (); } randomSeed 7"),
     ["patches ()", "one open patch"]),
    ("wordForBlock", replace("randomSeed 7", "interface yes; randomSeed 7"),
     ["Entry interface is no block", "interface { ... }"]),
    ("report", replace("reportEvery 1", "reportEvery 0"),
     ["reportEvery 0", "valid range"]),
    ("seed", replace("randomSeed 7", "randomSeed -7"),
     ["randomSeed -7", "valid range"]),
    ("species", lambda case: edit(case, "constant/dsmcProperties",
                                  "omega 0.81;", ""),
     ["omega"]),
]

status, text = run(copy_case("good", "unchanged"), "dsmcParcelFoam")
verdict("good_runs", status == 0
        and "of 8 cells are less" not in text, complaint(text))

case = copy_case("good", "late")
edit(case, PROPERTIES, "start 0", "start 1")
status, text = run(case, "dsmcParcelFoam")
verdict("lateStart_warns", status == 0 and "Block sampling begins at 1 s" in
        " ".join(text.split()) and "it adds nothing" in text, complaint(text))

# A table of the walls, in which a name goes before patterns
case = copy_case("good", "walls")
edit(case, PROPERTIES, '".*" {', 'yMin { type stick; } ".*" {')
status, text = run(case, "dsmcParcelFoam")
verdict("walls_areListed", status == 0 and "Walls of the solid particles:\n"
        "    yMin: stick\n    yMax: specular\n" in text, complaint(text))

# Groups of which none is simulated are warned of, by fill and by inflow
case = copy_case("good", "none")
edit(case, PROPERTIES, "simulators 100;", "")
edit(case, PROPERTIES, "realPerSimulator 1000", "realPerSimulator 1e20")
status, text = run(case, "dsmcParcelFoam")
told = re.findall(r"Of diameter (\S+) m \S+ simulated particles come in, in"
                  r" what is left of the run: fewer than one. Lower"
                  r" realPerSimulator, now"
                  r" 1e\+20, or set (\w+)\n", text)
verdict("noneAtAll_isWarnedOf", status == 0 and sorted(told) == [
    (d, entry) for d in ("3e-06", "6e-06")
    for entry in ("simulators", "simulatorsPerStep")], told)

# What the run has written goes on as what it was
for name, file, old, new, texts in (
        ("sizes", PROPERTIES, "(3e-06 6e-06)", "(6e-06 3e-06)",
         ["groups", "3e-06 m", "6e-06 m"]),
        ("density", PROPERTIES, "density 2700.0", "density 2600",
         ["density 2600", "2700"]),
        ("weight", GAS, "nEquivalentParticles 1000000000000000.0",
         "nEquivalentParticles 2e15", ["nEquivalentParticles", "dsmcInit"]),
        ("molecule", GAS, "mass 6.63e-26", "mass 6.7e-26",
         ["mass_Ar 6.63e-26", "6.7e-26"])):
    case = copy_case("unchanged", "restart_" + name)
    edit(case, "system/controlDict", "endTime 1e-06", "endTime 2e-06")
    edit(case, file, old, new)
    refuses(f"refuses_other_{name}", case, texts)

case = copy_case("good", "interface")
edit(case, PROPERTIES, "randomSeed 7",
     "interface { patches (xMax); } randomSeed 7")
run(case, "dsmcParcelFoam")
for name, new, texts in (
        ("patches", "patches (xMax xMin)",
         ["interface", "patches", "(xMin xMax)", "time 1e-06", "(xMax)"]),
        ("start", "patches (xMax); start 1e-06",
         ["interface", "start 1e-06", "time 1e-06", "0"])):
    case = copy_case("interface", "restart_interface_" + name)
    edit(case, "system/controlDict", "endTime 1e-06", "endTime 2e-06")
    edit(case, PROPERTIES, "patches (xMax)", new)
    refuses(f"refuses_other_interface_{name}", case, texts)

# Where the disk is full the run ends, with file and reason
case = copy_case("interface", "full")
shutil.rmtree("full/1e-06")
folder = "full/postProcessing/particleInterface/1e-06"
os.remove(folder + "/interface.csv")
os.symlink("/dev/full", folder + "/interface.csv.unfinished")
status, text = run(case, "dsmcParcelFoam")
verdict("interface_onAFullDisk", status != 0
        and "particleInterface/1e-06/interface.csv" in text
        and "No space left on device" in text
        and not os.path.exists(folder + "/interface.csv"), complaint(text))

case = copy_case("good", "large")
edit(case, PROPERTIES, "(3e-06 6e-06)", "(3e-06 0.06)")
status, text = run(case, "dsmcParcelFoam")

# Once when it happens, and once in the summary at the end
verdict("large_warnsOnce", status == 0
        and text.count("of 8 cells are less") == 2
        and "    1 x The largest particles" in text
        and "0.06 m. 8 of 8 cells are less" in text and "0.05 m" in text,
        complaint(text))

# The annotated dictionary, on patches with the names that it has; then with
# its other choices
with open(f"{os.environ['PARCEL_IMPACT_DIR']}/etc/caseDicts/annotated/"
          "solidParticleProperties") as file:
    annotated = file.read()
write_gas("annotated", dict(TYPES, zMin="wall", zMax="wall"), (4, 2, 2),
          (2e-3, 1e-4, 1e-4), weight=1e10, density=1e22, inflow="FreeStream",
          U=(100, 0, 0),
          more="FreeStreamCoeffs { numberDensities { Ar 1e22; }"
          " patches (xMin); }\n",
          control={"deltaT": 1e-8, "endTime": 1e-8})
with open(f"annotated/{PROPERTIES}", "w") as file:
    file.write("FoamFile { version 2.0; format ascii; class dictionary;"
               " object solidParticleProperties; }\n" + annotated)
status, text = run("annotated", "dsmcParcelFoam")
verdict("annotated_runs", status == 0, complaint(text))

lognormal = re.search(r"\n// groups\n(// .*\n)*", annotated).group(0)
other = annotated.replace(lognormal, "") \
    .replace(re.search(r"\ngroups\n\{.*?\n\}", annotated, re.S).group(0),
             lognormal.replace("\n// ", "\n")) \
    .replace("(1e3 2e2)", "1e3").replace("exchange        perCell",
                                         "exchange        perCollision") \
    .replace(re.search(r"\nknudsenCorrection\n\{.*?\n\}", annotated,
                       re.S).group(0), "\nknudsenCorrection off;") \
    .replace("deflection      exact", "deflection      polynomial") \
    .replace("massLoading     0.5;", "massFlow     1e-6;") \
    .replace("region          box;", "region          all;") \
    .replace("        box             (0 0 0) (1e-3 1e-4 1e-4);\n", "") \
    .replace("// simulators   1000", "simulators   1000") \
    .replace("// simulatorsPerStep   2", "simulatorsPerStep   2") \
    .replace("type            specular", "type            stick")
shutil.rmtree("annotated/1e-08")
with open(f"annotated/{PROPERTIES}", "w") as file:
    file.write("FoamFile { version 2.0; format ascii; class dictionary;"
               " object solidParticleProperties; }\n" + other)
status, text = run("annotated", "dsmcParcelFoam")
verdict("annotated_otherChoices", status == 0
        and "5 groups" in text, complaint(text))

for name, change, texts in EDITS:
    case = copy_case("good", "bad_" + name)
    change(case)
    refuses(f"refuses_{name}", case, texts)
