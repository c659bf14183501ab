# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""What the case tests share: write a case, run it, read its fields."""

import contextlib
import os
import re
import shutil
import subprocess
import sys
import tempfile

import numpy as np

sys.path.append(os.environ["PARCEL_IMPACT_DIR"] + "/etc/python")
from checks import largest
from foamFiles import read as read_field, times as times_of

R_GAS = 287.05      # [J/(kg K)], from the molecular weight below
GAMMA = 1.4
MOL_WEIGHT = 8314.46261815324/R_GAS


def verdict(name, good, reason):
    """One line of the test's report; the reason also stands beside a pass."""
    print(f"PASS {name} ({reason})" if good else f"FAIL {name}: {reason}",
          flush=True)
    return good


def run(case, *command, log=None):
    """Run a program in a case; its exit status and all it said."""
    meshed = command == ("blockMesh",) and mesh_key(case)
    if meshed in MESHES:
        shutil.rmtree(f"{case}/constant/polyMesh", ignore_errors=True)
        shutil.copytree(MESHES[meshed], f"{case}/constant/polyMesh")
        return 0, ""
    # Ranks that wait for each other yield to any other process, and need
    # several times as long beside it: what has no ranks gives way to them
    way = () if command[0] == "mpirun" else ("nice", "-n", "19")
    done = subprocess.run((*way, *command), cwd=case, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True,
                          errors="replace")
    name = log or os.path.basename(command[0])
    with open(os.path.join(case, "log." + name), "w") as file:
        file.write(done.stdout)
    if meshed and not done.returncode:
        MESHES[meshed] = os.path.join(KEPT.name, str(len(MESHES)))
        shutil.copytree(f"{case}/constant/polyMesh", MESHES[meshed])
    return done.returncode, done.stdout


# Most cases of a test have the mesh of another: it is made once
KEPT = tempfile.TemporaryDirectory()
MESHES = {}


def mesh_key(case):
    """What the mesh depends on; nothing where other files come in."""
    text = []
    for name in "blockMeshDict", "controlDict":
        with open(f"{case}/system/{name}") as file:
            text.append(file.read())
    form = re.findall(r"write(?:Format|Precision|Compression)\s+\S+", text[1])
    return (None if re.search(r"#|geometry", text[0]) else (text[0], *form))


def must(case, *command, log=None):
    """Run a program that this test depends on."""
    status, text = run(case, *command, log=log)
    if status:
        print(f"FAIL {case}_{os.path.basename(command[0])}:"
              f" {complaint(text)}", flush=True)
        raise SystemExit(1)
    return text


def complaint(text):
    """What a program that stopped has said last, on one line."""
    at = text.find("FOAM FATAL")
    if at < 0 and "sigFpe" in text:
        frames = re.findall(r"#(?:[3-9]|1\d)\s+(Foam::[\w:]+)", text)
        return "floating-point exception in " + ", ".join(frames[:5])
    lines = text[at:].split("\n") if at >= 0 else text.split("\n")[-6:]
    return " ".join(" ".join(lines[:8]).split())[:300]


def refuses(name, result, words, start="\nTime = "):
    """Verdict on what run() gave: it stopped before its start, if that is not
    None, by an error whose message, wherever its lines break, has these
    words."""
    status, text = result
    at = text.find("FOAM FATAL")
    message = " ".join(text[max(at, 0):].split("\n    From ")[0].split())
    # (of blocks within blocks releases since v2006 write a/b for a.b)
    missing = [w for w in words if w not in message
               and w not in message.replace("/", ".")]
    wrong = ("accepted" if not status
             else "died without FOAM FATAL" if at < 0
             else "refused after the start" if start and start in text[:at]
             else f"the message lacks {missing}" if missing else "")
    said = complaint(text)
    return verdict(name, not wrong, f"{wrong}: {said}" if wrong else said[:120])


# How snappyHexMesh is to move points to surfaces, without layers
SNAPPY_CONTROLS = """
snapControls { nSmoothPatch 3; tolerance 2; nSolveIter 30; nRelaxIter 5; }
addLayersControls
{
    relativeSizes true; layers {} expansionRatio 1; finalLayerThickness 0.3;
    minThickness 0.1; nGrow 0; featureAngle 60; nRelaxIter 3;
    nSmoothSurfaceNormals 1; nSmoothNormals 3; nSmoothThickness 10;
    maxFaceThicknessRatio 0.5; maxThicknessToMedialRatio 0.3;
    minMedialAxisAngle 90; nBufferCellsNoExtrude 0; nLayerIter 50;
}
meshQualityControls
{
    maxNonOrtho 65; maxBoundarySkewness 20; maxInternalSkewness 4;
    maxConcave 80; minVol 1e-18; minTetQuality 1e-15; minArea -1;
    minTwist 0.02; minDeterminant 0.001; minFaceWeight 0.05;
    minVolRatio 0.01; minTriangleTwist -1; nSmoothScale 4; errorReduction 0.75;
}
mergeTolerance 1e-6;
"""


# ------------------------------------------------------------------- writing

def write_foam(case, path, body, kind="dictionary"):
    full = os.path.join(case, path)
    os.makedirs(os.path.dirname(full), exist_ok=True)
    with open(full, "w") as file:
        file.write("FoamFile\n{\n    version 2.0;\n    format ascii;\n"
                   f"    class {kind};\n    object {os.path.basename(path)};\n"
                   "}\n\n" + body + "\n")


def entries(settings):
    return "\n".join(f"{key} {value};" for key, value in settings.items())


def write_field(case, name, values, boundary, time="0"):
    """A volume field; values is a constant, or one row per cell."""
    dimensions, kind = {
        "p": ("[1 -1 -2 0 0 0 0]", "Scalar"),
        "T": ("[0 0 0 1 0 0 0]", "Scalar"),
        "U": ("[0 1 -1 0 0 0 0]", "Vector"),
        "k": ("[0 2 -2 0 0 0 0]", "Scalar"),
        "omega": ("[0 0 -1 0 0 0 0]", "Scalar"),
        "epsilon": ("[0 2 -3 0 0 0 0]", "Scalar"),
        "phit": ("[0 0 0 0 0 0 0]", "Scalar"),
        "f": ("[0 0 -1 0 0 0 0]", "Scalar"),
        "nut": ("[0 2 -1 0 0 0 0]", "Scalar"),
        "alphat": ("[1 -1 -1 0 0 0 0]", "Scalar")}[name]

    def number(v):
        return (repr(float(v)) if np.ndim(v) == 0
                else "(" + " ".join(repr(float(x)) for x in v) + ")")

    values = np.asarray(values, float)
    if values.ndim == (kind == "Vector"):
        internal = "uniform " + number(values)
    else:
        internal = (f"nonuniform List<{kind.lower()}>\n{len(values)}\n(\n"
                    + "\n".join(number(v) for v in values) + "\n)")
    write_foam(
        case, f"{time}/{name}",
        f"dimensions {dimensions};\ninternalField {internal};\n"
        "boundaryField\n{\n" + "\n".join(
            f"    {patch} {{ {text} }}" for patch, text in boundary.items())
        + "\n}", f"vol{kind}Field")


SIDES = {   # corner numbers of blockMesh's hex
    "xMin": "(0 4 7 3)", "xMax": "(1 2 6 5)", "yMin": "(0 1 5 4)",
    "yMax": "(3 7 6 2)", "zMin": "(0 3 2 1)", "zMax": "(4 5 6 7)"}


def write_block(case, corners, cells, types, grading="(1 1 1)"):
    """A mesh of one block. types: side -> patch type; sides not named are
    empty. A side of type 'cyclic' is joined to the opposite one. Cells are
    numbered with x fastest."""
    patches = []
    for side, face in SIDES.items():
        kind = types.get(side, "empty")
        more = ""
        if kind == "cyclic":
            other = side[0] + ("Max" if side.endswith("Min") else "Min")
            more = f" neighbourPatch {other};"
        patches.append(f"{side} {{ type {kind};{more} faces ({face}); }}")
    write_foam(
        case, "system/blockMeshDict",
        "scale 1;\nvertices ("
        + " ".join("(" + " ".join(repr(float(x)) for x in c) + ")"
                   for c in corners)
        + f");\nblocks (hex (0 1 2 3 4 5 6 7) ({' '.join(map(str, cells))})"
        f" simpleGrading {grading});\nedges ();\nboundary\n(\n"
        + "\n".join(patches) + "\n);")


def box(lengths, start=(0, 0, 0)):
    """Corners of a box for write_block."""
    a, b = np.asarray(start, float), np.add(start, lengths)
    return [(x, y, z) for z in (a[2], b[2])
            for x, y in ((a[0], a[1]), (b[0], a[1]), (b[0], b[1]),
                         (a[0], b[1]))]


def wedge_point(point, side, half):
    """A vertex (x, r) of a wedge about x of half an angle [rad], on its plane
    -1 or 1, or 0 on the axis."""
    x, r = point
    return (f"({float(x)!r} {float(r*np.cos(half))!r}"
            f" {float(side*r*np.sin(half))!r})")


HCONST = f"Cp {GAMMA*R_GAS/(GAMMA - 1)!r}; Hf 0;"


def write_case(case, control, gas, flux="HLLC", limiter="vanAlbada",
               thermo="hConst", thermodynamics=HCONST):
    """Everything of a gas case but mesh and fields. Without friction unless
    gas says 'viscous'."""
    gas = {"viscous": "no", **gas}
    settings = {
        "application": "rhoCentralParcelFoam", "startFrom": "latestTime",
        "startTime": 0, "stopAt": "endTime", "writeControl": "runTime",
        "writeFormat": "binary", "writePrecision": 16, "timePrecision": 10,
        "timeFormat": "general", "runTimeModifiable": "no"}
    settings.update(control)
    write_foam(case, "system/controlDict", entries(settings))
    write_foam(
        case, "system/fvSchemes",
        f"fluxScheme {flux};\ninterpolationSchemes\n{{\n    default linear;\n"
        f"    reconstruct {limiter};\n}}\nddtSchemes {{ default Euler; }}\n"
        "gradSchemes { default Gauss linear; }\n"
        "divSchemes { default none; }\nlaplacianSchemes { default none; }\n"
        "snGradSchemes { default corrected; }")
    write_foam(case, "system/fvSolution",
               "highSpeedGas\n{\n" + entries(gas) + "\n}")
    write_foam(
        case, "constant/thermophysicalProperties",
        "thermoType\n{\n    type hePsiThermo; mixture pureMixture;\n"
        f"    transport sutherland; thermo {thermo};\n"
        "    equationOfState perfectGas; specie specie;\n"
        "    energy sensibleInternalEnergy;\n}\nmixture\n{\n"
        f"    specie {{ molWeight {MOL_WEIGHT!r}; }}\n"
        f"    thermodynamics {{ {thermodynamics} }}\n"
        "    transport { As 1.458e-06; Ts 110.4; }\n}")


def edit(case, path, old, new):
    """Replace a text that must be there."""
    full = os.path.join(case, path)
    with open(full) as file:
        text = file.read()
    if old not in text:
        raise RuntimeError(f"{path} has no {old!r}")
    with open(full, "w") as file:
        file.write(text.replace(old, new))


def copy_case(source, case):
    shutil.copytree(source, case)
    return case


def decompose(case, n=(2, 1, 1), of_cells=None):
    """For n ranks in each direction, or with the ranks that cells are given."""
    count = int(np.prod(n)) if of_cells is None else int(max(of_cells)) + 1
    method = "simple" if of_cells is None else "manual"
    write_foam(case, "system/decomposeParDict",
               f"numberOfSubdomains {count};\nmethod {method};\n"
               f"simpleCoeffs {{ n ({' '.join(map(str, n))}); "
               'delta 0.001; }\nmanualCoeffs { dataFile "rankOfCells"; }')
    if of_cells is not None:
        write_foam(case, "constant/rankOfCells",
                   f"{len(of_cells)}\n(\n" + "\n".join(map(str, of_cells))
                   + "\n)", "labelList")
    must(case, "decomposePar", "-force")


def solve(case, ranks=1):
    """Run the solver; its log."""
    command = ["rhoCentralParcelFoam"]
    if ranks > 1:
        command = ["mpirun", "--oversubscribe", "-np", str(ranks), *command,
                   "-parallel"]
    return must(case, *command, log="rhoCentralParcelFoam")


# ------------------------------------------------------------------- reading

@contextlib.contextmanager
def undisturbed(case):
    """Whatever is done meanwhile, the case starts from its time 0 as it was."""
    shutil.copytree(f"{case}/0", f"{case}/undisturbed")
    yield
    for time in times_of(case):
        shutil.rmtree(f"{case}/{time}")
    os.rename(f"{case}/undisturbed", f"{case}/0")


def comes_to_rest(case):
    """Whether the gas of a case does, which is a verdict by itself."""
    status, text = run(case, "rhoCentralParcelFoam")
    steady = re.search(r"Gas: steady after (\d+)", text)
    return verdict(case, not status and steady is not None,
                   complaint(text) if status or not steady
                   else f"steady after {steady[1]} iterations")


def read_points(case):
    """Points of a mesh in ASCII."""
    with open(f"{case}/constant/polyMesh/points") as file:
        body = file.read().split("\n(\n")[1]
    return np.array([row.split() for row in
                     re.findall(r"^\(([^()]*)\)$", body, re.M)], float)


def write_points(case, points):
    """Others in their places."""
    path = f"{case}/constant/polyMesh/points"
    with open(path) as file:
        head = file.read().split("\n(\n")[0]
    with open(path, "w") as file:
        file.write(head + "\n(\n" + "\n".join(
            "({!r} {!r} {!r})".format(*map(float, x)) for x in points)
            + "\n)\n")


def last_fields(case, names="p T U rho", time=None):
    """Of numbers: others would pass where the largest is taken of several."""
    time = time or times_of(case)[-1]
    found = {n: read_field(os.path.join(case, time, n)) for n in names.split()}
    bad = [n for n, values in found.items() if not np.isfinite(values).all()]
    if bad:
        print(f"FAIL {case}: no numbers in {' '.join(bad)} at {time}",
              flush=True)
        raise SystemExit(1)
    return list(found.values())


def same_bits(case, other, time, names="p T U rho"):
    """Names of the fields that are not the same to the last bit."""
    return [n for n in names.split()
            if not np.array_equal(
                read_field(os.path.join(case, time, n)),
                read_field(os.path.join(other, time, n)))]


def summary_of(log):
    """What the end of a solver's log says: CPU seconds and shares by part,
    the columns of each kind of particles (nan: unknown), and the warnings as
    (how often, text)."""
    text = log[log.rindex("Summary of this run"):]
    parts = {name: (float(seconds), float(share)) for name, seconds, share in
             re.findall(r"(?m)^    (\S.*?) +([-\d.]+) +([-\d.]+) %$", text)}
    particles = {}
    table = re.search(r"(?m)^    particles +at start .*\n((?:    .*\n)+)", text)
    for line in table[1].splitlines() if table else ():
        name, *numbers = line.split()
        particles[name] = dict(zip(
            ("start", "injected", "flying", "escaped", "stuck", "lost"),
            (np.nan if n == "unknown" else int(n) for n in numbers)))
    warnings = [(int(n), what) for n, what in
                re.findall(r"(?m)^    (\d+) x (.*)$", text)]
    return parts, particles, warnings


# -------------------------------------------------------- laws written anew

def hard_sphere(V, w, n, r, e, f):
    """Page of the source in vectors; independent of the code under test."""
    V, w, n = (np.asarray(x, float) for x in (V, w, n))
    vn = V @ n
    slip = V - vn*n + np.cross(w, -r*n)
    slip -= (slip @ n)*n
    s = np.linalg.norm(slip)
    Jn = -(1 + e)*vn
    Jt = -f*Jn*slip/s if f*Jn < 2/7*s else -2/7*slip
    return V + Jn*n + Jt, w + 2.5/r**2*np.cross(-r*n, Jt)
