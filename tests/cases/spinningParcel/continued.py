# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Runs that go on with other injection, with parcels that other programs have
changed, or on a mesh that one has; stands in a temporary folder."""

import re

import numpy as np

from caseTools import (complaint, copy_case, decompose, edit, must, read_field,
                       run, solve, verdict, write_foam)
from spinningCloud import write_cloud, write_cube

DIAMETER, SHARE, LENGTH, N, SPEED = 1e-3, 2e-4, 0.1, 10, 20.0
DT, HALF = 1e-4, 4e-3
CLOUD = "constant/dustProperties"
RATE = SHARE/(np.pi*DIAMETER**3/6)*SPEED*LENGTH**2
STREAM = f"""
    type crossSectionInjection; volumeFraction {SHARE!r};
    diameter {DIAMETER!r}; U0 ({SPEED!r} 0 0); patches (xMin);
    nParticle 0.2;"""
MORE = """
        rake
        {
            type rakeInjection; start (0.02 0.02 0.05); end (0.02 0.08 0.05);
            nParcels 5; diameter 1e-3; U0 (5 0 0);
        }
        manual
        {
            type manualInjection; massTotal 1e-6; parcelBasisType fixed;
            nParticle 1; SOI 0; positionsFile places; U0 (0 0 0);
            sizeDistribution
            {
                type fixedValue;
                fixedValueDistribution { value 1e-3; }
            }
        }"""


def prepare(case, end, collisions=False, **control):
    write_cube(case, LENGTH, N, {"libs": "(spinningParcel parcelInjection)",
                                 "endTime": end, "deltaT": DT,
                                 "writeInterval": HALF, **control})
    write_cloud(case, "dust", STREAM, solution="collisions { type eventDriven;"
                " restitution 1; friction 0; }" if collisions else "")
    places = [(0.05, y, z) for y in (0.03, 0.05, 0.07) for z in (0.03, 0.06)]
    write_foam(case, "constant/places",
               f"{len(places)} (\n" + "\n".join(
                   "(%r %r %r)" % place for place in places) + "\n)",
               kind="vectorField")


def extend(case, end):
    edit(case, "system/controlDict", f"endTime {HALF!r}", f"endTime {end!r}")


def lagrangian(case, time, name):
    return read_field(f"{case}/{time:g}/lagrangian/dust/{name}")


def repeated(case, time):
    """Parcels at a time whose identity others have too."""
    pairs = np.stack([lagrangian(case, time, name)
                      for name in ("origProcId", "origId")], axis=1)
    return len(pairs) - len(np.unique(pairs, axis=0)), len(pairs)


def added(log):
    return float(re.findall(r"parcels added *= *(\S+)", log)[-1])


# Other entries: what comes in the second half is the stream that they describe
prepare("begun", HALF)
solve("begun")
come = RATE/0.2*(HALF - DT)
for name, old, new, rate, begin in (
        ("more", "nParticle 0.2", "nParticle 0.1", 2, HALF - DT),
        ("fewer", "nParticle 0.2", "nParticle 0.4", 0.5, HALF - DT),
        ("faster", f"U0 ({SPEED!r}", f"U0 ({1.5*SPEED!r}", 1.5, HALF - DT),
        ("later", "nParticle 0.2;", f"nParticle 0.2; startTime {1.5*HALF!r};",
         1, 1.5*HALF),
        ("same", "nParticle 0.2;", "nParticle 0.20; duration 1; seed 0;",
         1, HALF - DT)):
    copy_case("begun", name)
    extend(name, 2*HALF)
    edit(name, CLOUD, old, new)
    log = solve(name)
    due = come + rate*RATE/0.2*(2*HALF - DT - begin)
    verdict(f"entries_{name}", abs(added(log) - due) < 3
            and ("entries are not those" in log) == (name not in
                                                     ("same", "later")),
            f"{added(log):.0f} parcels came in, {due:.1f} are due")
    twice, n = repeated(name, 2*HALF)
    verdict(f"identities_{name}", twice == 0 and n > 500,
            f"{twice} of {n} parcels have the identity of others")

# A stream that was over and is to last longer goes on now
prepare("over", HALF)
edit("over", CLOUD, "nParticle 0.2;",
     f"nParticle 0.2; duration {0.5*HALF!r};")
solve("over")
extend("over", 2*HALF)
edit("over", CLOUD, f"duration {0.5*HALF!r};", "")
log = solve("over")
due = RATE/0.2*1.5*HALF
verdict("stream_that_was_over", abs(added(log) - due) < 3,
        f"{added(log):.0f} parcels came in, {due:.1f} are due")

# A model that is out of one run and in the next begins anew
OTHER = STREAM.replace("nParticle 0.2", "nParticle 0.5")
MORE_OF_IT = ("injectionModels {",
              f"injectionModels {{ other {{ {OTHER} }}")
prepare("outAndIn", HALF)
edit("outAndIn", CLOUD, *MORE_OF_IT)
solve("outAndIn")
edit("outAndIn", CLOUD, *MORE_OF_IT[::-1])
extend("outAndIn", 2*HALF)
solve("outAndIn")
edit("outAndIn", CLOUD, *MORE_OF_IT)
edit("outAndIn", "system/controlDict", f"endTime {2*HALF!r}",
     f"endTime {3*HALF!r}")
solve("outAndIn")
twice, n = repeated("outAndIn", 3*HALF)
young = (lagrangian("outAndIn", 3*HALF, "age") < HALF).sum()
due = RATE*(1/0.2 + 1/0.5)*HALF
verdict("model_out_and_in", twice == 0 and abs(young/due - 1) < 0.03,
        f"{twice} of {n} parcels have the identity of others, {young} came in"
        f" the third run, {due:.0f} are due")

# A run that starts late: no stream has filled the mesh before
prepare("late", 0.5 + 3*DT, startTime=0.5, writeInterval=DT)
must("late", "mv", "0", "0.5")
log = solve("late")
due = RATE/0.2*2*DT
verdict("late_start", abs(added(log) - due) < 2,
        f"{added(log):.0f} parcels came in, {due:.1f} are due")

# Its duration counts from there; what fills a box waits for startTime
prepare("lateEnd", 0.5 + 10*DT, startTime=0.5, writeInterval=DT)
must("lateEnd", "mv", "0", "0.5")
edit("lateEnd", CLOUD, "nParticle 0.2;", f"nParticle 0.2; duration {3*DT!r};")
log = solve("lateEnd")
due = RATE/0.2*3*DT
verdict("late_end", abs(added(log) - due) < 2,
        f"{added(log):.0f} parcels came in, {due:.1f} are due")
prepare("boxLater", HALF)
edit("boxLater", CLOUD, "nParticle 0.2;", "nParticle 0.2; prefill { box (0 0 0)"
     f" (0.1 0.1 0.1); }} startTime {1.5*HALF!r};")
solve("boxLater")
extend("boxLater", 2*HALF)
edit("boxLater", CLOUD, "nParticle 0.2;", "nParticle 0.1;")
log = solve("boxLater")
due = 2*RATE/0.2*(LENGTH/SPEED + 0.5*HALF - DT)
verdict("box_still_to_fill", abs(added(log) - due) < 3,
        f"{added(log):.0f} parcels came in, {due:.1f} are due")

# Other models beside, with collisions on two ranks, which tell parcels by
# their identity
prepare("collisions", HALF, True)
edit("collisions", CLOUD, "nParticle 0.2", "nParticle 1")
solve("collisions")
extend("collisions", 2*HALF)
edit("collisions", CLOUD, "injectionModels { dust",
     f"injectionModels {{ {MORE} dust")
decompose("collisions")
log = solve("collisions", 2)
deepest = float(re.findall(r"Deepest overlap.*in all (\S+)", log)[-1])
verdict("models_added", deepest < 1e-9*DIAMETER
        and re.search(r"dust +\d+ ", log) is not None,
        f"spheres overlap by {deepest:.1e} m, tolerance 1e-9 diameters")
must("collisions", "reconstructPar", "-latestTime")
twice, n = repeated("collisions", 2*HALF)
first = lagrangian("collisions", 2*HALF, "origProcId")
verdict("identities_models", twice == 0 and len(np.unique(first)) > 1,
        f"{twice} of {n} parcels have the identity of others; ranks of origin"
        f" {np.unique(first)}")

# Collisions in a cloud that flew without: some begin one in another
prepare("switchedOn", HALF)
edit("switchedOn", CLOUD, f"volumeFraction {SHARE!r}", "volumeFraction 2e-3")
edit("switchedOn", CLOUD, "nParticle 0.2", "nParticle 1")
solve("switchedOn")
extend("switchedOn", 1.25*HALF)
edit("switchedOn", CLOUD, "solution\n{", """solution
{
    collisions { type eventDriven; restitution 1; friction 0; }""")
overlap = re.search(r"Spheres overlap by (\S+) m", solve("switchedOn"))
verdict("overlaps_are_said", "Spheres overlap" not in log
        and overlap is not None and 1e-3 < float(overlap[1])/DIAMETER < 1,
        overlap[0] if overlap else "nothing is said")

# Identities that a program has taken away
copy_case("begun", "unnamed")
extend("unnamed", 2*HALF)
must("unnamed", "rm", f"{HALF:g}/uniform/complete")
must("unnamed", "foamFormatConvert", "-latestTime")
names = lagrangian("unnamed", HALF, "origId")
path = f"unnamed/{HALF:g}/lagrangian/dust/origId"
with open(path, "rb") as file:      # (newer releases keep them)
    head = file.read().split(b"\n}\n")[0].decode()
with open(path, "w") as file:
    file.write(re.sub("format +binary", "format ascii", head)
               + f"\n}}\n{len(names)}{{-1}}\n")
lost = lagrangian("unnamed", HALF, "origId")
log = solve("unnamed")
twice, n = repeated("unnamed", 2*HALF)
verdict("identities_lost", lost.max() < 0 and twice == 0
        and f"{len(lost)} parcels have no origId of their own" in log,
        f"{twice} of {n} parcels have the identity of others, largest before"
        f" {lost.max()}")

# Cells with other numbers
copy_case("begun", "renumbered")
extend("renumbered", 2*HALF)
write_foam("renumbered", "system/renumberMeshDict", """
numberOfPoints 1; sortCoupledFaceCells false; writeMaps false;
method random; randomCoeffs {}""")
must("renumbered", "renumberMesh", "-overwrite", "-dict",
     "system/renumberMeshDict")
must("renumbered", "rm", f"{HALF:g}/uniform/complete")
_, text = run("renumbered", "rhoCentralParcelFoam")
verdict("renumbered_refused", "are not where their positions are" in text,
        complaint(text))
