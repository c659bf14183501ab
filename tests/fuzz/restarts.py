#!/usr/bin/env python3
# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Damage to the files that a run starts from: restarts.py [--tests]

Stands in an empty folder. Each file of the start directory is removed, cut to
nothing, cut to a half and given another bit, on one rank and on two: the run
must be refused with the name of the file. A mark without a list, as earlier
versions wrote it, is taken as it is. Prints rows of doc/stability.md or, with
--tests, lines PASS and FAIL.
"""

import os
import re
import shutil
import sys

from caseTools import (complaint, decompose, edit, must, run, times_of,
                       write_foam)
from fuzz import run as run_quietly
from subjects import cloud_text, gas_case, rarefied

TESTS = "--tests" in sys.argv
failed = False


def verdict(name, expected, observed, bad):
    global failed
    failed = failed or bool(bad)
    if TESTS:
        print(f"FAIL {name}: " + "; ".join(bad[:5]) if bad
              else f"PASS {name} ({observed})", flush=True)
    else:
        print(f"{name} | {expected} | {observed}"
              + ("; wrong: " + "; ".join(bad) if bad else "")
              + f" | {'FAILED' if bad else 'ok'}", flush=True)


def remove(path):
    os.remove(path)


def empty(path):
    open(path, "w").close()


def halve(path):
    os.truncate(path, os.path.getsize(path)//2)


def flip(path):
    with open(path, "r+b") as file:
        file.seek(os.path.getsize(path)//2)
        byte = file.read(1)[0]
        file.seek(-1, 1)
        file.write(bytes([byte ^ 4]))


def listed(mark):
    with open(mark) as file:
        lines = file.read().split("\n")
    return [line.split(" ", 2)[2] for line in lines[1:] if line]


def molecules(case):
    """Molecules and solid particles, with their means."""
    rarefied("solidParticleProperties").build(case)
    control = f"{case}/system/controlDict"
    with open(control) as file:
        text = file.read()
    with open(control, "w") as file:
        file.write(re.sub(r"writeInterval [^;]+", "writeInterval 1",
                          re.sub(r"endTime [^;]+", "endTime 4e-06", text)))
    return "dsmcParcelFoam"


def dust(case):
    """Grains in flight, others in a layer on the wall, averages of impacts."""
    gas_case(case, {"mode": "frozen"}, 3)
    edit(case, "system/controlDict", "endTime 3e-06", "endTime 6e-06")
    write_foam(case, "constant/parcelClouds", "clouds (dust);")
    text = cloud_text("jkrAdhesion", "surfaceImpact", "rakeInjection")
    for old, new in (("(0.03 0.02 0)", "(0.03 1e-6 0)"),
                     ("(0.03 0.04 0)", "(0.07 1e-6 0)"),
                     ("(1797 0 0)", "(0 -1 0)")):
        text = text.replace(old, new)
    text += """
subModels { injectionModels { flying { type rakeInjection; nParcels 3;
    start (0.03 0.05 0); end (0.07 0.05 0); diameter 5e-6; U0 (1 0 0); } } }
"""
    write_foam(case, "constant/dustProperties", text)
    return "rhoCentralParcelFoam"


def prepare(case, build, ranks):
    command = [build(case)]
    if ranks > 1:
        decompose(case)
        command = ["mpirun", "--oversubscribe", "-np", str(ranks), *command,
                   "-parallel"]
    must(case, *command)
    where = f"{case}/processor{ranks - 1}" if ranks > 1 else case
    times = times_of(where)
    for folder in ([case] if ranks == 1 else
                   [f"{case}/processor{i}" for i in range(ranks)]):
        for time in times[2:]:
            shutil.rmtree(f"{folder}/{time}")
    return command, where[len(case):] + "/" + times[1]


for build, ranks in ((dust, 1), (dust, 2), (molecules, 1), (molecules, 2)):
    case = f"good{build.__name__}{ranks}"
    of = f"{build.__name__}, {ranks} ranks"
    command, start = prepare(case, build, ranks)
    mark = f"{case}{start}/uniform/complete"
    files = listed(mark)
    if TESTS and build is molecules:
        files = files[::3]      # of species much alike
    n, bad = 0, []
    cloud = "dust" if build is dust else "dsmc"
    for name in f"lagrangian/{cloud}/positions", f"lagrangian/{cloud}/U":
        if name not in listed(mark):
            bad.append(f"the mark lists {len(files)} files, no {name}")
    for k, name in enumerate(files):
        # A test takes one damage of each file, in turn
        every = (remove, empty, halve, flip)
        for damage in ([every[k % 4]] if TESTS else every):
            shutil.copytree(case, "trial")
            damage(f"trial{start}/{name}")
            status, text = run_quietly("trial", command)
            shutil.rmtree("trial")
            n += 1
            if (not status or f'/{name}"' not in text
                    or "FOAM FATAL" not in text
                    or "\nTime = " in text):
                bad.append(f"{damage.__name__} {name}: {complaint(text)}")
    verdict(f"damaged files of a restart, {of}",
            "refused with the name of the file",
            f"{n} damages to {len(files)} files refused", bad)

    bad = []
    for name in ("nothing", "an earlier version's mark"):
        shutil.copytree(case, "trial")
        if name != "nothing":
            with open(f"trial{start}/uniform/complete", "w") as file:
                file.write("being written\n")
        status, text = run("trial", *command)
        shutil.rmtree("trial")
        if status:
            bad.append(f"{name}: {complaint(text)}")
    verdict(f"restart as it was left, and with an earlier version's mark,"
            f" {of}", "runs", "both run", bad)

sys.exit(failed)
