# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Particles that leave for a far field: as many as enter, all on the surface;
continued from half-way and on two ranks the same; read by the utility. And the
refusal of bad entries."""

import os
import re

import numpy as np

from caseTools import (copy_case, decompose, edit, largest, must, times_of,
                       verdict, write_foam)
from csvTables import table
from dsmcTools import refuses, solve, write_gas

OPEN = dict.fromkeys(("xMin", "xMax", "yMin", "yMax", "zMin", "zMax"), "patch")
SOLIDS = "constant/solidParticleProperties"
STEP, STEPS = 1e-6, 600


def records(case):
    """The last file of a case, by diameter."""
    folder = f"{case}/postProcessing/particleInterface"
    time = max(os.listdir(folder), key=float)
    return table(f"{folder}/{time}/interface.csv")


write_gas("near", OPEN, (5, 2, 2), weight=1e12, density=1e18,
          inflow="FreeStream", initialise=False,
          more="FreeStreamCoeffs { inflows { xMin { numberDensities"
          " { Ar 1e18; } temperature 300; velocity (1500 0 0); } } }",
          control={"deltaT": STEP, "endTime": STEPS*STEP,
                   "writeInterval": 300})
write_foam(
    "near", SOLIDS,
    "material { density 2000; specificHeat 900; }\n"
    "groups { type list; diameters (1e-5 2e-5); massFractions (1 3); }\n"
    "accommodation 1;\nexchange none;\n"
    "inflows { xMin { massFlow 1e-6; velocity (1000 0 0); temperature 500;"
    " simulatorsPerStep (2 1); } }\n"
    "interface { patches (xMax \"[yz].*\"); start 2e-4; sectors 8;"
    " origin (-0.5 0 0); }\n")
log = solve("near")
found = records("near")
for d, part in ((1e-5, 0.25), (2e-5, 0.75)):
    own = np.abs(found["diameter"]/d - 1) < 1e-9
    rate = 8*1e-6*part/(2000*np.pi/6*d**3)
    ratio = found["weight"][own].sum()/rate
    # 1 or 2 enter in each step, at any instant of it, for 400 steps
    verdict(f"interface_rate{d*1e6:.0f}um", abs(ratio - 1) < 0.015,
            f"{ratio:.4f} of what enters, {own.sum()} records")
verdict("interface_place", np.all(np.abs(found["x"] - 0.6) < 1e-12)
        and np.all(np.abs(found["ux"]/1000 - 1) < 0.01)
        and np.all(np.abs(found["T"]/500 - 1) < 0.1)
        and np.all((found["y"] > 0) & (found["y"] < 0.1)),
        f"x from {found['x'].min():.6g} to {found['x'].max():.6g} m,"
        f" ux {found['ux'].min():.1f} to {found['ux'].max():.1f} m/s")

copy_case("near", "nearAgain")
last = times_of("nearAgain")[-1]
must("nearAgain", "rm", "-r", last, f"postProcessing/particleInterface/{last}")
solve("nearAgain")
again = records("nearAgain")
same = len(again["x"]) == len(found["x"]) and largest(
    np.max(np.abs(again[name]/found[name] - 1)) for name in found
    if name not in ("uy", "uz"))
verdict("interface_restart", same is not False and same < 1e-9,
        f"{len(again['x'])} records, greatest difference {same:.1e}")

copy_case("near", "nearRanks")
must("nearRanks", "rm", "-r", *times_of("nearRanks")[1:], "postProcessing")
decompose("nearRanks")
solve("nearRanks", 2)
two = records("nearRanks")
ratio = two["weight"].sum()/found["weight"].sum()
verdict("interface_twoRanks", abs(ratio - 1) < 0.02,
        f"{ratio:.4f} of the particles per second of one rank")

write_foam(
    "near", "system/freeMolecularPlumeDict",
    "source { type file; file \""
    f"postProcessing/particleInterface/{last}/interface.csv\"; }}\n"
    "burn { start 0; end 1; } times (1);\n"
    "material { density 2000; heatCapacity 900; absorptivity 0.5;"
    " emissivity 0.5; }\n"
    "grids { all { type sphere; from 0; to 1e4; n 5; } }\n"
    "nParticles 10000;")
must("near", "freeMolecularPlume", "-noPlot")
with open("near/postProcessing/freeMolecularPlume/1/summary.csv") as file:
    real = float(re.search(r"realParticles,([^,\s]+)", file.read()).group(1))
verdict("interface_isRead", abs(real/found["weight"].sum() - 1) < 1e-6,
        f"{real:.6g} particles in a second of burning")

for name, old, new, texts in (
        ("Patch", "(xMax", "(frontier", ["frontier", "xMin xMax"]),
        ("Sectors", "sectors 8", "sectors 0", ["sectors 0", "valid range"]),
        ("Entry", "start 2e-4", "begin 2e-4", ["Unknown entry begin"])):
    case = copy_case("near", "badInterface" + name)
    edit(case, SOLIDS, old, new)
    must(case, "rm", "-r", *times_of(case)[1:])
    refuses(f"refuses_interface{name}", case, texts)
