# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Small cases, each with a dictionary of ours that runs as it is annotated."""

import os
import re
import shutil

from bluntBody import prepare
from caseTools import must, write_block, box, write_case, write_field, \
    write_foam
from dsmcTools import write_gas
from mutations import bare

ROOT = os.environ["PARCEL_IMPACT_DIR"]


def annotated(name):
    with open(f"{ROOT}/etc/caseDicts/annotated/{name}") as file:
        return bare(file.read())


def change(text, *pairs):
    for old, new in pairs:
        text, n = re.subn(old, new, text)
        if not n:
            raise RuntimeError(f"nothing matches {old}")
    return text


class Subject:
    """free: parents of names that anyone may choose; stock: parents of
    entries that the stock models read."""

    def __init__(self, name, file, build, command, free=(), stock=()):
        self.name, self.file, self.build = name, file, build
        self.command, self.free, self.stock = command, free, stock


def utility(name, *pairs):
    file = f"system/{name}Dict"

    def build(case):
        os.makedirs(f"{case}/system")
        with open(f"{case}/{file}", "w") as out:
            out.write(change(annotated(name + "Dict"), *pairs))
    return Subject(name, file, build, [name, "-noPlot"], free=("grids",))


def gas_case(case, gas, end=1):
    """A box of 4 x 4 cells with the patches of the annotated files."""
    write_case(case, {"endTime": end*1e-6, "deltaT": 1e-6,
                      "writeInterval": end*1e-6,
                      "libs": "(spinningParcel)"}, gas)
    write_block(case, box((0.1, 0.1, 0.01), (0, 0, -0.005)), (4, 4, 1),
                {"xMin": "patch", "xMax": "patch", "yMin": "wall",
                 "yMax": "wall"})
    path = f"{case}/system/blockMeshDict"
    with open(path) as file:
        text = file.read()
    text = change(text, (r"xMax \{[^}]*\}", ""), (r"xMin \{[^}]*\}",
                  "inlet { type patch; faces ((0 4 7 3) (1 2 6 5)); }"),
                  ("yMin ", "plate "), ("yMax ", "sides "))
    with open(path, "w") as file:
        file.write(text)
    sides = {"inlet": "type zeroGradient;", "plate": "type zeroGradient;",
             "sides": "type zeroGradient;", "zMin": "type empty;",
             "zMax": "type empty;"}
    slip = dict(sides, plate="type slip;", sides="type slip;")
    write_field(case, "p", 1e5, sides)
    write_field(case, "T", 300, sides)
    write_field(case, "U", (100, 0, 0), slip)
    must(case, "blockMesh")


def gas(mode):
    def build(case):
        gas_case(case, {})
        body = change(annotated("highSpeedGas"), (r"(?s)FoamFile\s*\{.*?\}",
                                                  ""))
        pairs = [("10000", "3"), (r"\bsteady", mode)]
        if mode != "steady":
            pairs += [("implicit", "RK3"), (r"maxCo\s+100", "maxCo 0.5")]
        write_foam(case, "system/fvSolution", change(body, *pairs))
    return Subject(f"highSpeedGas-{mode}", "system/fvSolution", build,
                   ["rhoCentralParcelFoam"])


def blunt_body(case):
    prepare(case, "half", (12, 6), 4, 6, {"residual": 1e-3})
    shutil.copy(f"{ROOT}/etc/caseDicts/annotated/alignMeshToShockDict",
                f"{case}/system")


BASE = """
type spinningKinematicCloud;
solution
{
    active yes; coupled no; transient yes; cellValueSourceCorrection off;
    maxCo 0.5;
    interpolationSchemes { rho cellPoint; U cellPoint; thermo:mu cellPoint;
        T cellPoint; curlUcDt cellPoint; }
    integrationSchemes { U Euler; }
}
constantProperties { rho0 2500; }
subModels
{
    particleForces { hendersonDrag; magnus; }
    injectionModels {}
    dispersionModel none;
    surfaceFilmModel none;
    stochasticCollisionModel none;
    WALL
}
"""


def cloud_text(wall, *others):
    """Properties of a cloud, of annotated parts that suit gas_case."""
    text = BASE.replace("WALL", annotated(wall))
    if "surfaceImpact" in others:       # which asks for the heat of impacts
        text = change(
            text, (r"maxCo 0.5;", "maxCo 0.5; motion embeddedRK54;"
                   " heatTransfer on;"),
            (r"rho0 2500;", "rho0 2500; T0 300; Cp0 800;"))
    for name in others:
        text += annotated(name)
    for old, new in (
            (r"\(0\.01 0\.01 0\)", "(0.03 0.02 0)"),
            (r"\(0\.01 0\.03 0\)", "(0.03 0.04 0)"),
            (r"patches(\s+)\((freestream|inlet)\)", r"patches\1(inlet)"),
            (r"front(\s+)\([^)]*\)", r"front\1(0 0 0)"),
            (r"origin(\s+)\(0 0 0\)", r"origin\1(0.05 -0.05 0)"),
            (r"slabThickness(\s+)\S+;", r"slabThickness\1 0.01;"),
            (r"nParticle(\s+)[^;]+;", r"nParticle\1 1;"),
            (r"box(\s+)\([^;]*;", r"box\1(0 0 0) (1e-5 1e-5 1e-5);")):
        text = re.sub(old, new, text)
    return text


def cloud(wall, *others, pairs=(), name=None, forces=True):
    """pairs: changes of the text; forces: are they the stock's?"""
    def build(case):
        gas_case(case, {"mode": "frozen"}, 3)
        write_foam(case, "constant/parcelClouds", "clouds (dust);")
        write_foam(case, "constant/dustProperties",
                   change(cloud_text(wall, *others), *pairs))
    return Subject(name or "-".join((wall,) + others),
                   "constant/dustProperties", build, ["rhoCentralParcelFoam"],
                   free=("cloudFunctions", "injectionModels"),
                   stock=("interpolationSchemes", "integrationSchemes")
                   + (("particleForces",) if forces else ()))


def drag(name):
    """The drag law alone, whose entries are ours."""
    return cloud("hardSphereWall", name, "rakeInjection", name=name,
                 pairs=((r"hendersonDrag; magnus;", "magnus;"),),
                 forces=False)


def clouds(case):
    gas_case(case, {"mode": "frozen"})
    write_foam(case, "constant/parcelClouds", "clouds (dust);")
    write_foam(case, "constant/dustProperties",
               BASE.replace("WALL", annotated("hardSphereWall")))


def feedback(case):
    gas_case(case, {}, 3)
    body = change(annotated("steadyFeedback"), (r"(?s)FoamFile\s*\{.*?\}", ""),
                  ("2e-4", "1e-6"))
    write_foam(case, "system/fvSolution",
               "highSpeedGas { mode steady; " + body + "}")
    write_foam(case, "constant/parcelClouds", "clouds (dust);")
    write_foam(case, "constant/dustProperties", change(
        cloud_text("hardSphereWall", "rakeInjection"),
        ("coupled no;", "coupled yes; motion embeddedRK54;"),
        (r"nParticle\s+1;", "nParticle 1e-6;"),
        ("cellPoint", "cellLinear")))


TYPES = {"xMin": "patch", "xMax": "patch", "yMin": "wall", "yMax": "wall",
         "zMin": "wall", "zMax": "wall"}


def rarefied(file):
    def build(case):
        write_gas(case, TYPES, (2, 2, 2), weight=1e15, U=(100, 0, 0),
                  control={"deltaT": 1e-6, "endTime": 2e-6})
        with open(f"{case}/constant/dsmcProperties", "a") as out:
            out.write(annotated("dsmcProperties"))
        if file != "dsmcProperties":
            text = change(annotated("solidParticleProperties"),
                          (r"box(\s+)\(0 0 0\) \([^)]*\)",
                           r"box\1(0 0 0) (1 1 1)"),
                          (r"\(1e3 2e2\)", "(1e5 2e4)"))
            with open(f"{case}/constant/solidParticleProperties", "w") as out:
                out.write(text)
    return Subject(file, f"constant/{file}", build, ["dsmcParcelFoam"],
                   free=("fills", "moleculeProperties", "cloudFunctions"))


SUBJECTS = [
    utility("scatteringIndicatrix", (r"nParticles\s+1000000", "nParticles 50")),
    utility("jkrImpact"),
    utility("freeMolecularPlume", (r"nParticles\s+[^;]+", "nParticles 50")),
    gas("steady"), gas("transient"),
    Subject("alignMeshToShock", "system/alignMeshToShockDict", blunt_body,
            ["alignMeshToShock"]),
    # (without the coefficients of a model that is not chosen)
    cloud("hardSphereWall", "spinningKinematicCloud", "rakeInjection",
          pairs=((r"stochasticDispersionRASCoeffs\s*\{[^}]*\}", ""),)),
    cloud("hardSphereWall", "eventDrivenCollisions", "rakeInjection"),
    cloud("semiEmpiricalRebound", "crossSectionInjection"),
    cloud("nonSphericalRebound", "surfaceImpact", "rakeInjection"),
    cloud("jkrAdhesion", "impactRecords", "dispersedPhase", "rakeInjection"),
    *(drag(f"{law}Drag") for law in ("henderson", "loth", "singh",
                                     "haiderLevenspiel", "holzerSommerfeld",
                                     "ganser")),
    Subject("steadyFeedback", "system/fvSolution", feedback,
            ["rhoCentralParcelFoam"]),
    Subject("parcelClouds", "constant/parcelClouds", clouds,
            ["rhoCentralParcelFoam"]),
    rarefied("dsmcProperties"), rarefied("solidParticleProperties"),
]
