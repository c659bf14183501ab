# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Parcels in turbulence at its edge: rows for doc/stability.md."""

import os
import re
import shutil

import numpy as np

from caseTools import complaint, run, times_of
from turbulence import age, parcels, prepare

N = 1000


def row(name, expected, right, steps, dt, d, density, k, omega):
    """One case. right(x, U, spread): in the end; spread is the variance that
    what follows the gas has by then."""
    shutil.rmtree("case", ignore_errors=True)
    os.mkdir("case")
    prepare("case", d, density, dt, k, omega, steps*dt, N)
    status, log = run("case", "timeout", "100", "rhoCentralParcelFoam")
    good, seen = False, f"exit status {status}: {complaint(log)[:100]}"
    if status == 0:
        x, U = parcels("case", times_of("case")[-1])
        spread = 2*0.1*k/(0.09*omega)*age("case")
        good = (len(x) == N and bool(np.all(np.isfinite(U)))
                and right(np.mean(x**2), np.mean(U**2), spread))
        met, together = re.findall(r"Eddies met.*= (\S+), (\S+) %", log)[-1]
        most = re.findall(r"Most forces between two faces\s*= (\S+)", log)[-1]
        cpu = re.search(r"parcel-steps in (\S+) CPU s", log)[1]
        seen = (f"variance {np.mean(x**2):.3g} m2, of velocity"
                f" {np.mean(U**2):.3g} m2/s2; {met} eddies, {together} % of"
                f" them several, most forces between two faces {most},"
                f" {float(cpu):.1f} CPU s")
    print(f"{name} | {expected} | {seen} | {'ok' if good else 'FAILED'}",
          flush=True)


# A variance of 3000 numbers has 2.6 %
row("eddies of 3 ns, steps of 1 ms, grain of 10 nm",
    "taken together, follows the gas: 2 D t within 10 %",
    lambda x, U, spread: abs(x/spread - 1) < 0.1,
    20, 1e-3, 1e-8, 1000., 24., 1e9)
row("eddies of 3 ns, grains of 0.1 mm",
    "nothing that is felt: slower than 1e-3 of u'",
    lambda x, U, spread: U < 1e-6*24,
    20, 1e-5, 1e-4, 2500., 24., 1e9)
row("fluctuations of 8 km/s, grain of 0.1 um",
    "has the velocity of its eddy: 2k/3 within 10 %",
    lambda x, U, spread: abs(U/(2e8/3) - 1) < 0.1,
    20, 1e-8, 1e-7, 1000., 1e8, 1e6)
row("no energy (the model keeps 1e-15 m2/s2)", "that of the model, 2k/3",
    lambda x, U, spread: abs(U/(2e-15/3) - 1) < 0.1,
    20, 1e-5, 1e-7, 1000., 0., 1e4)
row("eddies that live for hours", "has the velocity of the first: 2k/3",
    lambda x, U, spread: abs(U/16 - 1) < 0.1,
    20, 1e-6, 1e-7, 1000., 24., 1e-4)
row("one step of 300 eddies", "as many short steps: 2 D t within 10 %",
    lambda x, U, spread: abs(x/spread - 1) < 0.1,
    1, 0.01, 1e-7, 1000., 0.24, 1e5)
