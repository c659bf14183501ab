# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""The recipes of README.md as a user takes them: each fenced block that begins
with // and a file name becomes that file, the others are run by bash. The cases
that README.md names as the user's own are stock tutorials. Stands in a
temporary folder; README.md is the argument."""

import csv
import glob
import os
import re
import shutil
import subprocess
import sys

import numpy as np

import foamFiles
from caseTools import must, verdict

PLACES = (os.environ.get("FOAM_TUTORIALS", ""),
          "/usr/share/doc/openfoam-examples/examples")


def recipes(text):
    """Of each recipe its blocks (language, text), in order."""
    text = text[text.index("\n## Recipes"):text.index("\n## What is there")]
    return [re.findall(r"^```(\S+)\n(.*?)^```$", part, re.M | re.S)
            for part in text.split("\n### ")[1:]]


def follow(case, blocks):
    """The folder in which the blocks end, and what they print."""
    printed = ""
    at = os.path.abspath(".folder")
    for language, text in blocks:
        if language == "sh":
            done = subprocess.run(
                ["bash", "-ec", text + '\npwd > "$0"', at], cwd=case,
                stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
            printed += done.stdout
            if done.returncode:
                logs = sorted(glob.glob(os.path.join(case, "**", "log.*"),
                                        recursive=True), key=os.path.getmtime)
                if logs:
                    with open(logs[-1]) as file:
                        printed += file.read()[-2000:]
                raise RuntimeError(" ".join(printed[-2000:].split()))
            with open(at) as file:
                case = file.read().strip()
        else:
            name, text = re.match(r"// (\S+)\n(.*)", text, re.S).groups()
            with open(os.path.join(case, name), "w") as file:
                file.write(text)
    return case, printed


def stock(path, name, coarser=1):
    """A meshed copy of a stock tutorial, with so many times fewer cells in each
    direction; its files may be compressed."""
    for root in filter(None, PLACES):
        for sub in (path, os.path.join("tutorials", path)):
            if os.path.isdir(os.path.join(root, sub)):
                shutil.copytree(os.path.join(root, sub), name)
                must(".", "chmod", "-R", "u+w", name)
                for zipped in glob.glob(os.path.join(name, "**", "*.gz"),
                                        recursive=True):
                    must(".", "gunzip", "-f", zipped)
                mesh = os.path.join(name, "system/blockMeshDict")
                with open(mesh) as file:
                    text = file.read()
                with open(mesh, "w") as file:
                    file.write(re.sub(
                        r"(?m)^( *\()(\d+) (\d+) 1\)$",
                        lambda cells: f"{cells[1]}{int(cells[2])//coarser}"
                                      f" {int(cells[3])//coarser} 1)", text))
                must(name, "blockMesh")
                return os.path.abspath(name)
    raise RuntimeError(f"no tutorial {path} in {' or '.join(PLACES)}: install"
                       " Debian's openfoam-examples, or set FOAM_TUTORIALS")


def entries(case, file, **values):
    for name, value in values.items():
        must(case, "foamDictionary", file, "-entry", name.replace("__", "/"),
             "-set", value)


def air(case):
    """The wedge's normalised gas becomes air of 300 K, as a user has it."""
    for name, old, new in (("U", "(5 0 0)", "(1736 0 0)"),
                           ("T", "uniform 1;", "uniform 300;"),
                           ("p", "uniform 1;", "uniform 1e4;")):
        path = os.path.join(case, "0", name)
        with open(path) as file:
            text = file.read()
        with open(path, "w") as file:
            file.write(text.replace(old, new))
    entries(case, "constant/thermophysicalProperties",
            mixture__specie__molWeight="28.96",
            mixture__thermodynamics__Cp="1004.5",
            mixture__transport__mu="1.8e-5", mixture__transport__Pr="0.71")


def percents(log, end):
    """How often a log says how far the run is, how many tenths of it have
    passed, and where what it says is wrong."""
    said, wrong, time = 0, [], None
    for line in log.split("\n"):
        found = re.match(r"Time = (\S+)$", line)
        time = float(found.group(1)) if found else time
        found = re.match(r"(\d+) % of the run, about \d+ (s|min|h) left$", line)
        if found:
            said += 1
            if int(found.group(1)) != int(100*time/end + 1e-6):
                wrong.append((time, line))
    return said, int(10*time/end + 1e-6), wrong


def table(case, name):
    """The only row of the last table by patches."""
    path = max(glob.glob(os.path.join(case, "postProcessing", name, "*", "*",
                                      "byPatch.csv")), key=os.path.getmtime)
    with open(path) as file:
        row, = csv.DictReader(file)
    return {key: float(value) for key, value in row.items()
            if key != "patch" and value}


def error(row, result):
    return row[result + "Error"]/row[result]


def check(name, what):
    """WHAT gives a verdict and what it rests on, or the recipe does not run."""
    try:
        good, reason = what()
    except RuntimeError as failure:
        good, reason = False, str(failure)
    verdict(name, good, reason)


def at_target(printed, row, result):
    """Whether a run has ended at the error it was to end at."""
    good = ("the target is met" in printed and row["nImpacts"] > 100
            and error(row, result) <= 0.0505)
    return good, (f"{row['nImpacts']:.0f} impacts, error of {result}"
                  f" {100*error(row, result):.2f} %" if good
                  else "it ends with: " + " ".join(printed.split()))


def wear_is_said(printed, row):
    """Whether the end of a log gives the wear as the table has it."""
    said = re.search(r"wear of upperWall: (\S+) \+- (\S+) mm/year,"
                     r" (\S+) \+- (\S+) mm3/kg$", printed, re.M)
    return bool(said) and np.allclose(
        list(map(float, said.groups())),
        [row[name] for name in (
            "wearRate_mm_per_year", "wearRateError_mm_per_year",
            "specificErosion_mm3_per_kg", "specificErosionError_mm3_per_kg")],
        rtol=1e-4)


def wear_by_hand(row):
    """Whether the wear is Oka's (erosionLaw.H) at the mean impact, from which
    impacts differ little here, and mm/year the mass flux times mm3/kg."""
    speed = np.sqrt(2*row["specificPowerIncident"]/row["massFlux"])
    sine, hardness = row["meanNormalSpeed"]/speed, 1.8
    oka = (65*hardness**-0.12*(speed/104)**(2.3*hardness**0.038)
           * (50/326)**0.19*sine**(0.71*hardness**0.14)
           * (1 + hardness*(1 - sine))**(2.4*hardness**-0.94))
    hand = (oka/row["specificErosion_mm3_per_kg"],
            1e-6*365.25*86400*row["massFlux"]
            * row["specificErosion_mm3_per_kg"]/row["wearRate_mm_per_year"])
    return (abs(hand[0] - 1) < 0.03 and abs(hand[1] - 1) < 1e-6,
            f"by hand {hand[0]:.4f} of the mm3/kg, bound 3 %, {hand[1]:.7f} of"
            " the mm/year, bound 1e-6")


def goes_on(gas, log):
    """Whether a solver with the cloud as its function object has written the
    map and, in its last time, the parcels as they were after the last step,
    and goes on from there."""
    last = must(gas, "foamListTimes", "-latestTime").split()[-1]
    wear = glob.glob(os.path.join(gas, "[0-9]*",
                                  "kinematicCloud:wear:wearRate"))
    written = len(foamFiles.parcels(gas, last, "kinematicCloud")[0])
    step = float(re.findall(r"(?m)^deltaT = (.*)", log)[-1])
    entries(gas, "system/controlDict", stopAt="endTime",
            endTime=repr(float(last) + 3.5*step))
    entries(gas, "constant/kinematicCloudProperties",
            cloudFunctions__wear__stopAtError__target="1e-9")
    text = must(gas, "pimpleFoam")
    parcels, there = (re.findall(r"number of parcels\s+= (\d+)", t)
                      for t in (log, text))
    added, after = (re.findall(r"parcels added += (\d+)", t)
                    for t in (log, text))
    rise = int(after[0]) - int(added[-1]) if after else -1
    return (len(wear) > 0 and written == int(parcels[-1]) and 0 <= rise < 100
            and abs(int(there[0]) - written) < 100,
            f"{len(wear)} maps written, {written} of {parcels[-1]} parcels;"
            f" {added[-1]} added, then {there[:1]} and {after[:1]}")


def main():
    with open(sys.argv[1]) as file:
        erosion, dust, scattering = recipes(file.read())
    unsteady = erosion.pop()
    cases = {}

    def erosion_map():
        gas = stock("incompressible/simpleFoam/pitzDaily", "pitzDaily")
        must(gas, "simpleFoam")
        cases["sand"], printed = follow(gas, erosion)
        row = table(cases["sand"], "wear")
        good, reason = at_target(printed, row, "erosionRate")
        right, hand = wear_by_hand(row)
        return good and right and wear_is_said(printed, row), (
            f"{reason}; {hand}")

    def erosion_unsteady():
        gas = stock("incompressible/pimpleFoam/RAS/pitzDaily", "unsteady", 2)
        for name in ("g", "wallModel", "kinematicCloudProperties"):
            shutil.copy(os.path.join(cases["sand"], "constant", name),
                        os.path.join(gas, "constant"))
        entries(gas, "system/controlDict", maxCo="20")
        _, printed = follow(gas, [unsteady])
        row = table(gas, "wear")
        good, reason = at_target(printed, row, "erosionRate")
        with open(os.path.join(gas, "log.pimpleFoam")) as file:
            log = file.read()
        rate, = re.findall(r"(\S+) parcels/s enter", log)
        added = re.findall(r"parcels added += (\d+)", log)[-1]
        # A parcel appears at the beginning of the step after its entry
        expected = float(rate)*float(re.findall(r"(?m)^Time = (.*)", log)[-2])
        # Each impact is that of one grain
        span = float(re.findall(r"averaged over (\S+) s", log)[-1])
        struck = row["massFlux"]*row["area"]*span
        grains = struck/(2650*np.pi/6*50e-6**3)
        again, restarted = goes_on(gas, log)
        good &= again
        reason += "; " + restarted
        return (good and wear_is_said(printed, row)
                and abs(int(added) - expected) < 2
                and abs(grains/row["nImpacts"] - 1) < 1e-4,
                f"{reason}; {added} parcels, {expected:.1f} are to enter;"
                f" {grains:.2f} grains have struck")

    def dust_cloud():
        gas = stock("compressible/rhoCentralFoam/wedge15Ma5", "wedge15Ma5")
        air(gas)
        case, printed = follow(gas, dust)
        row = table(case, "impacts")
        good, reason = at_target(printed, row, "intensity")
        last = os.path.join(case, must(case, "foamListTimes",
                                       "-latestTime").split()[-1])
        with open(os.path.join(case, "log.dust")) as file:
            said, tenths, wrong = percents(file.read(), 5e-3)
        good &= said >= tenths >= 1 and not wrong
        missing = [f for f in ("dust:dust:concentration",
                               "dust:impacts:intensity")
                   if not os.path.isfile(os.path.join(last, f))]
        return good and not missing, (
            f"{reason}; not written: {missing}; wrong percent: {wrong},"
            f" of {said}")

    def scattering_table():
        smooth = table(cases["sand"], "wear")
        case, printed = follow(cases["sand"], scattering)
        rough = table(case, "wear")
        good, reason = at_target(printed, rough, "erosionRate")
        # The same sand on its first way to the wall
        differ = abs(rough["massFlux"]/smooth["massFlux"] - 1)
        allowed = 4*np.hypot(error(rough, "massFlux"),
                             error(smooth, "massFlux"))
        return good and differ < allowed, (
            f"{reason}; mass flux differs by {100*differ:.1f} % from that on"
            f" the smooth wall, allowed {100*allowed:.1f} %")

    check("recipeErosionMap", erosion_map)
    check("recipeErosionUnsteady", erosion_unsteady)
    check("recipeDust", dust_cloud)
    check("recipeScatteringTable", scattering_table)


if __name__ == "__main__":
    main()
