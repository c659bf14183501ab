# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Cases of the summary at the end of a log; stands in a folder with the case
'stock'."""

import collections
import csv
import glob
import os
import re
import resource
import shutil

from caseTools import (copy_case, decompose, edit, must, solve, summary_of,
                       verdict, write_foam)

# Parcels that the gas does not touch cross the channel: the plate takes half
# of them, the upper side the others
CLOUDS = {
    # Stock models, whose parcels stay on the wall where they stick
    "stock": """patchInteractionModel localInteraction;
        localInteractionCoeffs { patches (
            plate { type escape; } sides { type stick; }
            inlet { type escape; } ); }""",
    "standard": """patchInteractionModel standardWallInteraction;
        standardWallInteractionCoeffs { type escape; }""",
    "elastic": "patchInteractionModel rebound; reboundCoeffs { UFactor 1; }",
    # Ours, alone, in a nest of its own kind, and beside one that tells nothing
    "ours": """patchInteractionModel hardSphereWall;
        hardSphereWallCoeffs { patches (
            plate { type escape; } sides { type capture; }
            inlet { type escape; } ); }""",
    "nested": """patchInteractionModel multiInteraction;
        multiInteractionCoeffs { oneInteractionOnly true;
            model1 { patchInteractionModel hardSphereWall;
                hardSphereWallCoeffs { patches (
                    plate { type escape; } ); } }
            model2 { patchInteractionModel hardSphereWall;
                hardSphereWallCoeffs { patches (
                    sides { type capture; } inlet { type escape; } ); } } }""",
    "mixed": """patchInteractionModel multiInteraction;
        multiInteractionCoeffs { oneInteractionOnly true;
            model1 { patchInteractionModel hardSphereWall;
                hardSphereWallCoeffs { patches (
                    plate { type escape; } ); } }
            model2 { patchInteractionModel localInteraction;
                localInteractionCoeffs { patches (
                    plate { type none; } sides { type stick; }
                    inlet { type escape; } ); } } }"""}


def prepare(name, end, CLOUDS=CLOUDS, plate="wall"):
    case = copy_case("stock", name)
    shutil.copytree(os.path.join(case, "0.orig"), os.path.join(case, "0"))
    edit(case, "system/blockMeshDict", "plate  { type wall;",
         f"plate  {{ type {plate};")
    must(case, "blockMesh")
    # The last step is one that is written, and one that is not
    write_foam(case, "system/controlDict", f"""
application rhoCentralParcelFoam; startFrom latestTime; startTime 0;
stopAt endTime; endTime {end}; deltaT 2e-6; writeControl timeStep;
writeInterval 75; writeFormat binary; writePrecision 6; timePrecision 12;
runTimeModifiable no; libs (parcelInjection parcelWallInteraction);""")
    write_foam(case, "system/fvSolution", "highSpeedGas { mode frozen; }")
    shutil.copy(os.path.join(os.environ["tutorial"], "system/fvSchemes"),
                os.path.join(case, "system/fvSchemes"))
    write_foam(case, "constant/parcelClouds", f"clouds ({' '.join(CLOUDS)});")
    for cloud, wall in CLOUDS.items():
        write_foam(case, f"constant/{cloud}Properties", f"""
solution
{{
    active yes; coupled no; transient yes; cellValueSourceCorrection off;
    maxCo 0.5; interpolationSchemes {{ rho cell; U cell; thermo:mu cell; }}
    integrationSchemes {{ U Euler; }}
}}
constantProperties {{ rho0 2500; }}
subModels
{{
    particleForces {{}}
    injectionModels {{ beam {{ type crossSectionInjection;
        volumeFraction 1e-5; diameter 8e-6; U0 (600 120 0);
        patches (inlet); }} }}
    dispersionModel none; stochasticCollisionModel none;
    surfaceFilmModel none;
    {wall}
}}
cloudFunctions {{ hits {{ type surfaceImpact; patches (plate sides);
    threshold 0; }} }}""")
    return case


def struck(case, cloud):
    """Impacts on plate and sides since the start."""
    folder = os.path.join(case, "postProcessing/hits", cloud)
    with open(os.path.join(folder, max(os.listdir(folder), key=float),
                           "byPatch.csv")) as file:
        hits = {row["patch"]: int(row["nImpacts"])
                for row in csv.DictReader(file)}
    return hits["plate"], hits["sides"]


def seconds():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


case = prepare("straight", 4e-4)
# OpenFOAM warns where that is not the folder it runs in
os.environ["PWD"] = os.path.abspath(case)
before = seconds()
log = solve(case)
used = seconds() - before
parts, particles, warnings = summary_of(log)
whole = parts.pop("in all")
verdict("parts_add_up", set(parts) == {"gas", "writing", "rest"} | {
    "cloud " + c for c in CLOUDS}
        and abs(sum(p[0] for p in parts.values()) - whole[0]) < 0.006
        and abs(sum(p[1] for p in parts.values()) - 100) < 0.6
        and whole[1] == 100 and abs(whole[0] - used) < 0.1*used + 0.1,
        f"{whole[0]} CPU s of {used:.2f}, parts {parts}")
verdict("frozen_gas_takes_no_time", parts["gas"][0] == 0 and all(
    parts["cloud " + c][0] > 0 for c in CLOUDS), f"{parts['gas'][0]} s")


def balanced(p):
    return (p["start"] + p["injected"]
            == p["flying"] + p["escaped"] + p["stuck"] + p["lost"])


known = [c for c in CLOUDS if c != "mixed"]
verdict("parcels_balance", set(particles) == set(CLOUDS) and all(
    balanced(particles[c]) and particles[c]["lost"] == 0
    and particles[c]["start"] == 0 for c in known)
        and all(p["injected"] == particles["ours"]["injected"] > 1000
                for p in particles.values()), f"{particles}")
plate, sides = struck(case, "ours")
wrong = {c: particles[c] for c, escaped, stuck in (
    ("stock", plate, sides), ("ours", plate, sides), ("nested", plate, sides),
    ("standard", plate + sides, 0), ("elastic", 0, 0))
    if (particles[c]["escaped"], particles[c]["stuck"]) != (escaped, stuck)}
verdict("parcels_end_where_they_strike", not wrong and min(plate, sides) > 300,
        f"{plate} on the plate, {sides} on the sides; wrong: {wrong}")
p = particles["mixed"]
verdict("unknown_is_said", p["flying"] == particles["ours"]["flying"]
        and all(p[k] != p[k] for k in ("escaped", "stuck", "lost")), f"{p}")
verdict("no_warnings", not warnings and "\n    warnings: none\n" in log
        and "FOAM Warning" not in log, f"{warnings}")

# Where the plate is no wall and no model acts on it, parcels leave without a word
away = prepare("away", 4e-4, {"away": """patchInteractionModel localInteraction;
    localInteractionCoeffs { patches (
        plate { type none; } sides { type stick; }
        inlet { type escape; } ); }"""}, plate="patch")
log = solve(away)
_, told, warnings = summary_of(log)
p = told["away"]
verdict("lost_are_told", balanced(p) and p["lost"] == plate
        and p["stuck"] == sides and p["escaped"] == 0
        and any(what.startswith(f"Cloud away: {plate} parcels are gone")
                for _, what in warnings), f"{p}, {warnings}")

# In steps in which a stream at an angle flies from its patch through the wall
# beside it, all that enters is there
coarse = prepare("coarse", 4e-4, {"ours": CLOUDS["ours"]})
edit(coarse, "system/controlDict", "deltaT 2e-6", "deltaT 2e-5")
log = solve(coarse)
p = summary_of(log)[1]["ours"]
enter = float(re.search(r"beam: (\S+) parcels/s enter", log)[1])*(4e-4 - 2e-5)
verdict("all_that_enters", balanced(p) and p["lost"] == 0
        and abs(p["injected"] - enter) <= 1 + 1e-5*enter
        and p["stuck"] > 300, f"{p}, {enter:.2f} by the rate")

# A cloud that is switched off is none of the run's business
off = prepare("off", 1e-5, {"ours": CLOUDS["ours"],
                            "stock": CLOUDS["stock"]})
for cloud in "ours", "stock":
    edit(off, f"constant/{cloud}Properties", "active yes", "active no")
particles_off = summary_of(solve(off))[1]
verdict("switched_off", all(set(particles_off[c].values()) == {0}
                            for c in ("ours", "stock")), f"{particles_off}")

# A restart tells of its own part, and both together of the whole run, also
# where the last step is not written
first = prepare("restarted", 1.5e-4)
path = os.path.join(first, "constant/oursProperties")
with open(path) as file:
    text = file.read()
with open(path, "w") as file:
    file.write(text.replace("threshold 0;", "threshold 0; window { start 1; }"))
log = solve(first)
parts = [summary_of(log)[1]]
said = re.findall(r"--> FOAM Warning : (\S.*)", log)
verdict("warning_of_one_line", len(said) == 1
        and said[0].startswith("hits: the averaging window begins")
        and (1, said[0]) in summary_of(log)[2],
        f"{summary_of(log)[2]} of {said}")
must(first, "foamDictionary", "-entry", "endTime", "-set", "4e-4",
     "system/controlDict")
parts.append(summary_of(solve(first))[1])
wrong = [c for c in known if parts[1][c]["start"] != parts[0][c]["flying"]
         or not all(balanced(p[c]) and p[c]["lost"] == 0 for p in parts)
         or parts[1][c]["flying"] != particles[c]["flying"]
         or any(parts[0][c][k] + parts[1][c][k] != particles[c][k]
                for k in ("injected", "escaped", "stuck"))]
verdict("restart_balances", not wrong and parts[0]["ours"]["stuck"] > 0,
        f"{parts[1]['ours']} after {parts[0]['ours']}; wrong: {wrong}")

ranks = prepare("ranks", 4e-4)
decompose(ranks)
two = summary_of(solve(ranks, 2))
verdict("two_ranks_balance", {c: two[1][c] for c in known}
        == {c: particles[c] for c in known}
        and two[1]["mixed"]["flying"] == particles["mixed"]["flying"],
        f"{two[1]['ours']}")

# --------------------------------- warnings of two kinds, one of them again

case = copy_case("stock", "cold")
shutil.copytree(os.path.join(case, "0.orig"), os.path.join(case, "0"))
must(case, "blockMesh")
write_foam(case, "system/controlDict", """
application rhoCentralParcelFoam; startFrom startTime; startTime 0;
stopAt endTime; endTime 5e-6; deltaT 1e-6; writeControl timeStep;
writeInterval 1; writeFormat binary; runTimeModifiable no;""")
write_foam(case, "system/fvSolution", "highSpeedGas { mode transient; }")
shutil.copy(os.path.join(os.environ["tutorial"], "system/fvSchemes"),
            os.path.join(case, "system/fvSchemes"))
path = os.path.join(case, "constant/thermophysicalProperties")
with open(path) as file:
    text = file.read()
flat = "(3.5 0 0 0 0 0 0)"
with open(path, "w") as file:
    file.write(text.replace("hConst;", "janaf;").replace(
        "Cp 1004.675; Hf 0;", "Tlow 250; Thigh 6000; Tcommon 1000;"
        f" lowCpCoeffs {flat}; highCpCoeffs {flat};"))
for n in 1, 2:
    if n == 2:
        shutil.rmtree(os.path.join(case, "postProcessing"), True)
        decompose(case)
    if n == 1:
        log = solve(case)
    else:
        # Each rank into files of its own: in one, lines of both may be torn
        must(case, "mpirun", "--oversubscribe", "-np", "2",
             "--output-filename", "ranks", "rhoCentralParcelFoam", "-parallel")
        log = ""
        for path in sorted(glob.glob(f"{case}/ranks/**/std*", recursive=True),
                           reverse=True):
            with open(path) as file:
                log += file.read()
    log, end = log.split("Summary of this run")
    places = collections.Counter(re.findall(
        r"    in file (.*?at line \d+)", log))
    _, _, warnings = summary_of("Summary of this run" + end)
    told = {what[what.rindex("(") + 1:-1]: times for times, what in warnings}
    verdict(f"warnings_once_on_{n}", told == dict(places)
            and max(places.values()) >= 5
            and any("hotter or colder" in what for _, what in warnings),
            f"{warnings} of {dict(places)}")
