# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Stock tutorials under rhoCentralParcelFoam, beside the stock solver and the
exact solutions; stands in a temporary folder.

A row says where a tutorial is, its stock solver, when the short and the full
run end, what is compared, and the bound of it. Nothing else of the tutorial is
changed, unless the row says so."""

import glob
import os
import re
import resource
import shutil
import sys

import numpy as np

from caseTools import (complaint, must, read_field, refuses, run, times_of,
                       verdict)
from riemann import riemann

FULL = "-full" in sys.argv[1:]
SOLVER = "rhoCentralParcelFoam"
PLACES = (os.environ.get("FOAM_TUTORIALS", ""),
          "/usr/share/doc/openfoam-examples/examples")
R_UNIVERSAL = 8314.47       # of OpenFOAM v1912 [J/(kmol K)]


# ------------------------------------------------------------ exact solutions

def weak_shock(mach, deflection, gamma=1.4):
    """Angle of the weak oblique shock (bisection on theta-beta-M), and the
    pressure ratio and Mach number behind it."""
    def turn(beta):
        m2 = (mach*np.sin(beta))**2
        return np.arctan(2/np.tan(beta)*(m2 - 1)
                         / (mach**2*(gamma + np.cos(2*beta)) + 2))
    betas = np.linspace(np.arcsin(1/mach), np.pi/2, 2001)
    low, high = betas[0], betas[np.argmax(turn(betas))]
    for _ in range(100):
        beta = 0.5*(low + high)
        if turn(beta) < deflection:
            low = beta
        else:
            high = beta
    m2 = (mach*np.sin(beta))**2
    ratio = 1 + 2*gamma/(gamma + 1)*(m2 - 1)
    behind = np.sqrt((1 + 0.5*(gamma - 1)*m2)
                     / (gamma*m2 - 0.5*(gamma - 1)))/np.sin(beta - deflection)
    return beta, ratio, behind


def reflected_shock(x, y, time):
    """Mach 2.9, turned downwards at the top left corner, and back by its
    reflection at y = 0. The deflection is that of the tutorial's top."""
    deflection = np.arctan(0.50632/2.61933)
    beta, ratio, behind = weak_shock(2.9, deflection)
    again, ratio2, _ = weak_shock(behind, deflection)
    foot = 1/np.tan(beta)
    first = y > (foot - x)*np.tan(beta)
    second = first & (y < (x - foot)*np.tan(again - deflection))
    return np.where(second, ratio*ratio2, np.where(first, ratio, 1.0))


def wedge(x, y, time):
    """Mach 5 over a wedge of 15 degrees that begins at the origin."""
    beta, ratio, _ = weak_shock(5.0, np.radians(15))
    return np.where((x > 0) & (y < x*np.tan(beta)), ratio, 1.0)


def shock_tube(x, y, time):
    """The states of setFieldsDict, with the gas of the tutorial."""
    R = R_UNIVERSAL/28.96
    gamma = 1004.5/(1004.5 - R)
    return tube(x, time, R, gamma)


def sonic_tube(x, y, time):
    R = R_UNIVERSAL/28.9
    return tube(x, time, R, 1005/(1005 - R))


def tube(x, time, R, gamma):
    left = (1e5/(R*348.432), 0.0, 1e5)
    right = (1e4/(R*278.746), 0.0, 1e4)
    return riemann(left, right, x/time, gamma)[2]


# ----------------------------------------------------------------------- rows

C = "compressible/rhoCentralFoam/"

BICONIC = (
    "datToFoam grid256.dat",
    "cat constant/pointsHeader constant/points.tmp > constant/polyMesh/points",
    "collapseEdges -overwrite",
    "sed -i -f constant/wedgeScr constant/polyMesh/boundary")
RESOLVED = (
    "cd system && ln -s blockMeshDict.resolvedBlocks blockMeshDict.caseBlocks"
    " && ln -s blockMeshDict.resolvedBoundary blockMeshDict.caseBoundary",
    "blockMesh")
ROWS = (
    # exact: solution from which p may differ, in relative L1, by no more than
    # the stock solver's, and by no more than the bound. stock: largest relative
    # L1 difference of p from the stock solver's, in the short run and the full
    # one. schemes: tutorial whose schemes and solution the stock solver is
    # given, where that of the tutorial is none for shocks. end: of the short
    # run and the full one; None leaves it out (in the Helmholtz resonator sound
    # crosses a cell in a fiftieth of the stock solver's time step). slip: the
    # walls of the stock solver let an inviscid gas slip (noSlip makes it take
    # the walls' velocity into its gradients, which changes p by 9 %). mesh:
    # commands between blockMesh and the solver. steady: the gas is to be, and
    # ends when it is; the stock solver when its residualControl says so.
    # goesOn: the stock solver starts from our steady fields and ends at this
    # time.
    dict(name="obliqueShock", path=C + "obliqueShock", solver="rhoCentralFoam",
         end=(5, 10), exact=reflected_shock, bound=0.0195),
    dict(name="wedge15Ma5", path=C + "wedge15Ma5", solver="rhoCentralFoam",
         end=(0.1, 0.2), exact=wedge, bound=0.027),
    dict(name="shockTube", path=C + "shockTube", solver="rhoCentralFoam",
         end=(0.007, 0.007), exact=shock_tube, bound=0.0072),
    dict(name="forwardStep", path=C + "forwardStep", solver="rhoCentralFoam",
         end=(0.4, 4), stock=(0.015, 0.05)),
    dict(name="LadenburgJet60psi", path=C + "LadenburgJet60psi",
         solver="rhoCentralFoam", end=(4e-6, 2e-5), stock=(0.005, 0.02)),
    dict(name="sonicShockTube", path="compressible/sonicFoam/laminar/shockTube",
         solver="sonicFoam", end=(0.007, 0.007), exact=sonic_tube,
         bound=0.002),
    dict(name="sonicForwardStep",
         path="compressible/sonicFoam/laminar/forwardStep",
         solver="rhoCentralFoam", schemes=C + "forwardStep", slip=True,
         end=(5, 10), stock=(0.05, 0.05)),
    dict(name="helmholtzResonance",
         path="compressible/rhoPimpleFoam/laminar/helmholtzResonance",
         solver="rhoPimpleFoam", mesh=RESOLVED, end=(None, 1e-3),
         stock=(None, 0.01)),
    dict(name="aerofoilNACA0012",
         path="compressible/rhoSimpleFoam/aerofoilNACA0012",
         solver="rhoSimpleFoam", mesh=("transformPoints -scale '(1 0 1)'",
                                       "extrudeMesh"),
         end=(None, 1000), steady=True, stock=(None, 0.005)),
    # The fields of the tutorial's start are not at rest: their p, 24 % from
    # ours (L1), is 19 % from it after 5500 local steps of the stock solver
    dict(name="biconic", path=C + "biconic25-55Run35", solver="rhoCentralFoam",
         mesh=BICONIC, end=(None, 1), steady=True, goesOn="5e-5",
         stock=(None, 0.02)),
    dict(name="sineWaveDamping",
         path="compressible/rhoPimpleFoam/laminar/sineWaveDamping",
         refused=("fvOptions", "acousticDampingSource")),
    dict(name="movingCone", path="compressible/rhoCentralDyMFoam/movingCone",
         refused=("dynamicFvMesh", "meshes at rest")),
)


# ---------------------------------------------------------------------- steps

def place(path):
    """The folder of a tutorial; its files may be compressed."""
    for root in PLACES:
        for sub in (path, os.path.join("tutorials", path)):
            full = os.path.join(root, sub)
            if root and os.path.isdir(full):
                return full
    return None


def prepare(row, case, schemes=None):
    """A meshed copy of the tutorial that ends when the row says."""
    shutil.copytree(place(row["path"]), case)
    must(".", "chmod", "-R", "u+w", case)
    for name in glob.glob(os.path.join(case, "**", "*.gz"), recursive=True):
        must(".", "gunzip", "-f", name)
    if os.path.isdir(os.path.join(case, "0.orig")):
        shutil.rmtree(os.path.join(case, "0"), ignore_errors=True)
        shutil.copytree(os.path.join(case, "0.orig"), os.path.join(case, "0"))
    if "end" in row and not row.get("steady"):
        control = os.path.join(case, "system/controlDict")
        with open(control) as file:
            text = file.read()
        end = row["end"][FULL]
        for key in ("endTime", "writeInterval"):
            text = re.sub(rf"(?m)^{key}\s.*", f"{key} {end};", text)
        # Written in time, not in steps
        text = re.sub(r"(?m)^writeControl\s+timeStep;",
                      "writeControl runTime;", text)
        with open(control, "w") as file:
            file.write(text)
    if schemes:
        for name in ("fvSchemes", "fvSolution"):
            shutil.copy(os.path.join(place(schemes), "system", name),
                        os.path.join(case, "system", name))
    if row.get("mesh") is not RESOLVED:
        must(case, "blockMesh")
    for command in row.get("mesh", ()):
        must(case, "bash", "-c", command)
    if os.path.isfile(os.path.join(case, "system/setFieldsDict")):
        must(case, "setFields")


def timed(case, solver):
    """Exit status, output and processor seconds."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    status, text = run(case, solver)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return status, text, after.ru_utime - before.ru_utime


def seek_steady(case):
    """What a case of a SIMPLE solver needs besides the name. Its fvOptions
    limit the temperature."""
    with open(os.path.join(case, "system/fvSolution"), "a") as file:
        file.write("highSpeedGas { mode steady; }\n")
    if os.path.isfile(os.path.join(case, "system/fvOptions")):
        os.remove(os.path.join(case, "system/fvOptions"))


def go_on(case, start, end):
    """Start a case from the last fields of another, and end it at a time."""
    for name in ("p", "T", "U"):
        shutil.copy(os.path.join(start, times_of(start)[-1], name),
                    os.path.join(case, "0", name))
    must(case, "sed", "-i", f"s/^endTime .*/endTime {end};/",
         "system/controlDict")


def pressure(case, row):
    """Pressure at the end, if that was reached."""
    time = times_of(case)[-1]
    if not row.get("steady") and abs(float(time)/row["end"][FULL] - 1) > 1e-6:
        return None
    return read_field(os.path.join(case, time, "p"))


def geometry(case):
    must(case, "postProcess", "-func", "writeCellVolumes", "-latestTime",
         log="V")
    must(case, "postProcess", "-func", "writeCellCentres", "-latestTime",
         log="C")
    folder = os.path.join(case, times_of(case)[-1])
    V = read_field(os.path.join(folder, "V"))
    C = read_field(os.path.join(folder, "C"))
    return np.broadcast_to(V, len(C)), C


def distance(V, p, q):
    """Of p from q, in the mean of q."""
    return np.sum(V*np.abs(p - q))/np.sum(V*q)


def check(row):
    name = row["name"]
    if place(row["path"]) is None:
        verdict(name, False, f"no tutorial {row['path']} in "
                + " or ".join(filter(None, PLACES))
                + ": install Debian's openfoam-examples, or set"
                " FOAM_TUTORIALS")
        return

    ours = name
    prepare(row, ours)
    if row.get("steady"):
        seek_steady(ours)
    status, text, seconds = timed(ours, SOLVER)
    if row.get("steady") and "Gas: steady after" not in text:
        status = 1

    if "refused" in row:
        refuses(f"{name}_is_refused", (status, text), row["refused"])
        return

    p = pressure(ours, row) if status == 0 else None
    if p is None:
        verdict(f"{name}_runs", False, complaint(text))
        return
    V, C = geometry(ours)

    theirs = name + "Stock"
    prepare(row, theirs, row.get("schemes"))
    if row.get("slip"):
        must(theirs, "sed", "-i", "s/noSlip;/slip;/", "0/U")
    if "goesOn" in row:
        go_on(theirs, ours, row["goesOn"])
    status, text, stock_seconds = timed(theirs, row["solver"])
    q = pressure(theirs, row) if status == 0 else None
    if q is None:
        verdict(f"{name}_stock_solver_runs", False, complaint(text))
        return
    cost = f"{seconds:.2f} s, {row['solver']} {stock_seconds:.2f} s"

    if "exact" in row:
        exact = row["exact"](C[:, 0], C[:, 1], row["end"][FULL])
        error, stock = distance(V, p, exact), distance(V, q, exact)
        bound = min(row.get("bound", stock), stock)
        verdict(name, error <= bound,
                f"error of p {100*error:.3f} %, bound {100*bound:.3f} %,"
                f" {row['solver']} {100*stock:.3f} %; {cost}")
    else:
        # (newer releases start the jet from fields of its end)
        with open(f"{theirs}/0/p") as file:
            developed = "internalField   nonuniform" in file.read()
        error, bound = distance(V, p, q), row["stock"][FULL or developed]
        verdict(name, error <= bound,
                f"p differs by {100*error:.3f} % from {row['solver']}, bound"
                f" {100*bound:.1f} %; {cost}")


if __name__ == "__main__":
    only = [a for a in sys.argv[1:] if not a.startswith("-")]
    for row in ROWS:
        if only and row["name"] not in only:
            continue
        if "end" not in row or row["end"][FULL] is not None:
            check(row)
