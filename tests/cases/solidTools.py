# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Cases of dsmcParcelFoam with solid particles, and what it writes of them."""

import os
import re

import numpy as np

from caseTools import read_field, write_foam
from foamFiles import positions

PROPERTIES = "constant/solidParticleProperties"
NUMBER = r"([-+0-9.eE]+)"


def write_solids(case, more="", diameters=(3e-6, 6e-6), fractions=None,
                 density=2700., heat=900., accommodation=1.,
                 exchange="perCell", walls="specular", report=1):
    """solidParticleProperties; 'more' has fills, inflows and the rest."""
    def numbers(values):
        return "(" + " ".join(repr(float(v)) for v in values) + ")"

    write_foam(
        case, PROPERTIES,
        f"material {{ density {density!r}; specificHeat {heat!r}; }}\n"
        f"groups {{ type list; diameters {numbers(diameters)};"
        f" massFractions {numbers(fractions or [1.]*len(diameters))}; }}\n"
        f"accommodation {accommodation!r};\nexchange {exchange};\n"
        + (f'walls {{ ".*" {{ type {walls}; }} }}\n' if walls else "")
        + f"reportEvery {report};\n" + more)


def fill(concentration, U=(0, 0, 0), T=300., simulators=100,
         region="region all;"):
    return (f"fills {{ one {{ {region} concentration {concentration!r};"
            f" velocity ({U[0]} {U[1]} {U[2]}); temperature {T!r};"
            f" simulators {simulators}; }} }}\n")


def read_solids(case, time):
    """Positions and fields of the particles, from binary files."""
    folder = os.path.join(case, time, "lagrangian/solids")

    fields = dict(zip(("x", "cell"), positions(folder)))
    for name in ("U", "T", "nParticle", "d", "group", "origProcId"):
        fields[name] = read_field(os.path.join(folder, name))
    return fields


def changes(log):
    """Greatest changes of momentum and energy of all in a step reported."""
    found = np.array(re.findall(
        rf"change in this step by: {NUMBER} of momentum, {NUMBER} of energy",
        log), float)
    return found.max(axis=0) if len(found) else np.array([np.nan, np.nan])


def tally(log, fate):
    """Simulated and real particles and mass of a line of the last report."""
    found = re.findall(rf"    {fate}: (\d+)  {NUMBER}  {NUMBER}\n", log)
    return np.array(found[-1], float) if found else np.zeros(3)
