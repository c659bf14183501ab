# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Restarts in a stock solver. A time directory that was not written to its end
must not begin with fewer parcels, an empty layer or new averages in silence;
nor may a model or averages with other settings than before."""

import csv
import os
import re
import shutil

from caseTools import complaint, copy_case, edit, run, times_of, verdict
from plate import CLOUD, SOLVER, injector, mesh, solve, write_plate

COEFFS = """
patches
(
    yMin { contact { modulus 7e10; workOfAdhesion 0.2; } alpha 0.5;
           outside hold; friction 0.3; }
    "(x|z)M.*|yMax" { type escape; }
);"""
FUNCTIONS = """
hits { type surfaceImpact; patches (yMin); threshold 0; }"""

case = "whole"
write_plate(case, "jkrAdhesion", COEFFS, [
    injector((0.4, 1e-6, 0.1), (0.6, 1e-6, 0.1), 5, (0, -0.01, 0), 1e-6),
    injector((0.4, 0.05, 0.1), (0.6, 0.05, 0.1), 5, (0, -1, 0), 1e-5)],
    end=1e-3, step=2e-4, write=2, functions=FUNCTIONS)
mesh(case)
solve(case)
times = times_of(case)
for time in times[2:]:
    shutil.rmtree(f"{case}/{time}")
start = f"{case}/{times[1]}"

status, text = run(copy_case(case, "again"), SOLVER)
verdict("halfWritten_whole", status == 0, complaint(text)
        if status else "the directory as it was left runs")

for name, words in (("lagrangian/" + CLOUD, ["0 parcels of 5"]),
                    (f"uniform/lagrangian/{CLOUD}/{CLOUD}:hits",
                     [f"{CLOUD}:hits is missing"]),
                    (f"{CLOUD}:layer0Number", ["layer0Number is missing"]),
                    (f"{CLOUD}:layer0Mass", ["layer0Mass is missing"])):
    bad = copy_case(case, "damaged")
    path = f"{bad}/{times[1]}/{name}"
    if not os.path.exists(path):
        verdict("halfWritten_" + os.path.basename(name), False,
                f"there is no {name} in " + " ".join(os.listdir(start)))
        continue
    if os.path.isdir(path):
        shutil.rmtree(path)
    else:
        os.remove(path)
    status, text = run(bad, SOLVER)
    words = ["not written to its end", *words]
    missing = [w for w in words if w not in text]
    verdict("halfWritten_" + os.path.basename(name),
            status != 0 and not missing,
            f"refused with {words[1]!r}" if status and not missing
            else f"lacks {missing}: {complaint(text)}" if status
            else "accepted")
    shutil.rmtree(bad)


# Settings that have changed. All impacts are in the part before
SAID = "settings of the wall model are not those of the run before"
LEFT = "averages of an earlier part of the run are left behind"
THRESHOLD = "threshold 0;", "threshold 1;"
HARD = ("patchInteractionModel jkrAdhesion;", "patchInteractionModel"
        " hardSphereWall; hardSphereWallCoeffs { patches"
        " ( \".*\" { restitution 0.5; friction 0.1; } ); }")
for name, changes, impacts, words in (
        ("nothing", [], 5, []),
        ("patch", [("friction 0.3", "friction 0.4")], 5,
         [SAID, "(jkrAdhesion then)", "restart anew;"]),
        ("model", [HARD], 5, [SAID, "(jkrAdhesion then)", "restart anew;"]),
        ("anew", [("threshold 0;", "threshold 0; restart anew;")], 0, [LEFT]),
        ("patchAnew", [("friction 0.3", "friction 0.4"),
                       ("threshold 0;", "threshold 0; restart anew;")], 0,
         [SAID, LEFT]),
        ("averages", [THRESHOLD], None,
         ["made with other settings", "threshold", "restart anew;"]),
        ("averagesAnew", [THRESHOLD, ("threshold 1;",
                                      "threshold 1; restart anew;")], 0,
         [LEFT])):
    changed = copy_case(case, "changed")
    shutil.rmtree(f"{changed}/postProcessing")
    for old, new in changes:
        edit(changed, f"constant/{CLOUD}Properties", old, new)
    status, text = run(changed, SOLVER)
    wrong = [f"lacks {w!r}" for w in words if w not in text]
    wrong += [f"says {w!r}" for w in (SAID, LEFT)
              if w in text and w not in words]
    found = None
    if not status:
        folder = f"{changed}/postProcessing/hits/{CLOUD}"
        last = max(os.listdir(folder), key=float)
        with open(f"{folder}/{last}/byPatch.csv") as file:
            rows = [r for r in csv.reader(file) if r and r[0][0] != "#"]
        found = int(rows[1][rows[0].index("nImpacts")])
    if found != impacts or (impacts is None and "Time = " in text):
        wrong.append(f"{found} impacts, expected {impacts}")
    verdict(f"changed_{name}", not wrong, "; ".join(wrong) + ": "
            + complaint(text) if wrong else f"{found} impacts")
    shutil.rmtree(changed)


# Counters go on with all their digits, whatever writePrecision is; earlier
# versions wrote them as plain numbers
LOST = re.compile(r"wallCounters_yMin\s+\d*\s*\(([^)]*)\)")


def counts(case, time):
    path = f"{case}/{time}/uniform/lagrangian/{CLOUD}/{CLOUD}OutputProperties"
    with open(path) as file:
        return LOST.search(file.read()).group(1).split()


case = "digits"
write_plate(case, "hardSphereWall", 'patches ( yMin { restitution 0.7;'
            ' friction 0.1; } "(x|z)M.*|yMax" { type escape; } );',
            [injector((0.4, y, 0.1), (0.6, y, 0.1), 7, (0, -u, 0), 1e-6)
             for y, u in ((1e-6, 0.013), (5e-4, 1.07))],
            end=8e-4, step=2e-4, write=2)
mesh(case)
edit(case, "system/controlDict", "writePrecision 17", "writePrecision 6")
solve(case)
first, last = times_of(case)[1:3]
again = copy_case(case, "digitsAgain")
shutil.rmtree(f"{again}/{last}")
old = copy_case(again, "digitsOld")
solve(again)
verdict("counters_of_a_restart_are_exact",
        counts(again, last) == counts(case, last)
        and counts(case, last)[0] == '"14"'
        and max(map(len, counts(case, first))) > 12,
        f"{counts(again, last)[:8]}, straight {counts(case, last)[:8]}")
path = f"{old}/{first}/uniform/lagrangian/{CLOUD}/{CLOUD}OutputProperties"
with open(path) as file:
    text = file.read()
with open(path, "w") as file:
    file.write(text.replace(LOST.search(text).group(0), LOST.search(
        text).group(0).replace('"', "")))
solve(old)
verdict("counters_of_earlier_versions_go_on", counts(old, last)[0] == '"14"',
        f"{counts(old, last)[:2]}")
