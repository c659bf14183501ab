# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""A stock solver's time directory that was not written to its end: a restart
must not begin with fewer parcels, an empty layer or new averages in silence."""

import os
import shutil

from caseTools import complaint, copy_case, run, times_of, verdict
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
    bad = copy_case(case, "bad")
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
