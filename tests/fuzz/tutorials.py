# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""The cases of the tutorials as they are before our programs run, and the
dictionaries of ours in them."""

import os
import re
import shutil
import subprocess
import sys

from mutations import bare, entries

ROOT = os.environ["PARCEL_IMPACT_DIR"]
HERE = os.path.dirname(os.path.abspath(__file__))

PROGRAMS = ("scatteringIndicatrix", "jkrImpact", "freeMolecularPlume",
            "rhoCentralParcelFoam", "dsmcParcelFoam",
            "icoUncoupledKinematicParcelFoam")
STOCK_SOLVER = PROGRAMS[-1]
BEFORE = ("dsmcInitialise", "simpleFoam")

# Models that stock clouds take; all else in their dictionaries is the stock's
MODELS = ("hardSphereWall", "semiEmpiricalRebound", "nonSphericalRebound",
          "jkrAdhesion", "surfaceImpact", "impactRecords", "dispersedPhase",
          "rakeInjection", "crossSectionInjection", "hendersonDrag")


def names():
    found = []
    for folder, folders, files in os.walk(f"{ROOT}/tutorials"):
        if "Allrun" in files:
            found.append(os.path.relpath(folder, f"{ROOT}/tutorials"))
            folders.clear()
    return sorted(found)


def capture(name, folder):
    """Run a tutorial with short runs; the folders of its cases."""
    folder = os.path.abspath(folder)
    shims = f"{folder}/shims"
    os.makedirs(shims)
    for program in PROGRAMS + BEFORE:
        os.symlink(f"{HERE}/shortened", f"{shims}/{program}")
    os.symlink(sys.executable, f"{shims}/python3")
    tutorial = f"{folder}/tutorial"
    shutil.copytree(f"{ROOT}/tutorials/{name}", tutorial)
    subprocess.run([f"{tutorial}/Allclean"], cwd=tutorial,
                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    with open(f"{tutorial}/Allrun") as file:
        quick = ["-quick"] if "-quick" in file.read() else []
    # Its plots fail, with so few particles: that is no concern here
    subprocess.run([f"{tutorial}/Allrun", *quick], cwd=tutorial,
                   env={**os.environ, "FUZZ_CAPTURED": f"{folder}/captured",
                        "FUZZ_TUTORIAL": tutorial,
                        "PATH": shims + ":" + os.environ["PATH"]},
                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                   timeout=1800)
    shutil.rmtree(tutorial)
    if not os.path.isdir(f"{folder}/captured"):
        return []
    return sorted(f"{folder}/captured/{c}"
                  for c in os.listdir(f"{folder}/captured"))


def with_included(tree, path, found):
    """A file and those that it includes, by their paths in the tree."""
    path = os.path.normpath(path)
    full = f"{tree}/{path}"
    if path in found or not os.path.isfile(full):
        return
    with open(full, errors="replace") as file:
        text = bare(file.read())
    found[path] = text
    for name in re.findall(r'#include\w*\s+"([^"]*)"', text):
        name = name.replace("<constant>", "constant").replace(
            "<system>", "system").replace("$FOAM_CASE/", "")
        for start in (os.path.dirname(path), ""):
            with_included(tree, os.path.join(start, name), found)


def dictionaries(tree, case, program):
    """Text of each dictionary of ours that a run reads, by its path."""
    found = {}
    constant, system = (f"{case}/{f}".lstrip("/")
                        for f in ("constant", "system"))
    if program in PROGRAMS[:3]:
        with_included(tree, f"{system}/{program}Dict", found)
    elif program == "dsmcParcelFoam":
        with_included(tree, f"{constant}/dsmcProperties", found)
        with_included(tree, f"{constant}/solidParticleProperties", found)
    elif program == "rhoCentralParcelFoam":
        with_included(tree, f"{system}/fvSolution", found)
        clouds = {}
        with_included(tree, f"{constant}/parcelClouds", clouds)
        found.update(clouds)
        for name in re.findall(r"clouds\s*\(([^)]*)", "".join(
                clouds.values())):
            for cloud in name.split():
                with_included(tree, f"{constant}/{cloud}Properties", found)
    else:
        with_included(tree, f"{constant}/kinematicCloudProperties", found)
    return found


def everything(entry):
    return True


def chooser(path, program, text):
    """Which entries of a dictionary are ours."""
    if path.endswith("fvSolution"):
        return lambda e: "highSpeedGas" in e.path + (e.key,)
    if program != STOCK_SOLVER:
        return everything
    types = {}
    for e in entries(text):
        if e.key == "type":
            types[e.path] = text[e.valueStart:e.end - 1].strip()
    return lambda e: (
        any(types.get(e.path[:i + 1]) in MODELS or part.replace("Coeffs", "")
            in MODELS for i, part in enumerate(e.path)))
