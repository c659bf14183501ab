# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Grains too heavy for the gas strike a sphere in a wedge: over the angle from
the stagnation point the flux of a stream on a sphere, n U cos(angle), from the
first bin on if parcels are spread evenly over the radius. Stands in a temporary
folder."""

import glob

import numpy as np

from bluntBody import RADIUS, SOUND, prepare
from caseTools import edit, solve, verdict, write_foam
from csvTables import table
from spinningCloud import write_cloud

M, OUTER, SHARE, DIAMETER, N = 6, 2.5, 1e-6, 1e-3, 30000
DENSITY = SHARE/(np.pi*DIAMETER**3/6)
SPEED = float(M*SOUND)
END = 40*RADIUS/SPEED

case = "sphereFlux"
prepare(case, "sphere", (20, 30), OUTER, M, {"mode": "frozen"})
edit(case, "system/controlDict", "endTime 1;",
     f"endTime {END!r}; libs (spinningParcel);")
edit(case, "system/controlDict", "deltaT 1;", f"deltaT {END/400!r};")
edit(case, "system/controlDict", "writeInterval 1;", f"writeInterval {END!r};")
area = 0.5*np.sin(np.radians(5))*(OUTER*RADIUS)**2
write_cloud(case, "dust", f"""
    type crossSectionInjection; volumeFraction {SHARE!r};
    diameter {DIAMETER!r}; U0 ({SPEED!r} 0 0); patches (inlet); arrival quiet;
    weighting radial; nParticle {float(DENSITY*area*SPEED*END/N)!r};""")
edit(case, "constant/dustProperties", "cloudFunctions {}", f"""
cloudFunctions
{{
    impacts
    {{
        type surfaceImpact; patches (body); window {{ start {END/8!r}; }}
        axis {{ direction (0 0 1); from (-1 0 0); binWidth 5; }}
    }}
}}""")
write_foam(case, "constant/parcelClouds", "clouds (dust);")
solve(case)
found = glob.glob(f"{case}/postProcessing/impacts/dust/*/byAngle.csv")
rows = table(found[0])
middle = np.radians(rows["phi_deg"])
low, high = middle - np.radians(2.5), middle + np.radians(2.5)
exact = DENSITY*SPEED*0.5*(np.sin(high)**2 - np.sin(low)**2) \
    / (np.cos(low) - np.cos(high))
off = rows["intensity"]/exact - 1
# (the last bins see few parcels, and facets instead of a sphere)
verdict("flux_on_a_sphere",
        len(off) == 18 and np.abs(off[:12]).max() < 0.01
        and np.abs(off[:4]).max() < 0.006 and rows["nImpacts"][0] > 800,
        f"within {100*np.abs(off[:4]).max():.2f} % to 20 degrees,"
        f" {100*np.abs(off[:12]).max():.2f} % to 60;"
        f" {rows['nImpacts'][0]:.0f} impacts in the first bin")
