# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""A cylinder in argon at Mach number 10, half a mean free path across, beside
SPARTA: drag and heat, by angle."""

import math

import numpy as np

from caseTools import must, read_field, times_of, verdict, write_foam
from dsmcTools import read_wall, solve, write_gas

# Radius [m], stream [1/m^3, K, m/s], wall [K]
R, OUTER, DENSITY, T, U, WALL = 0.1524, 1., 8.494e18, 200., 2624.1, 500.
MASS, OMEGA = 6.63e-26, 0.734
ARGON = {"mass": MASS, "omega": OMEGA, "internalDegreesOfFreedom": 0,
         "diameter": 3.595e-10*(1000/273)**(0.5*OMEGA - 0.25)}

# SPARTA of 24 September 2025 (github.com/sparta/sparta, 09391fe8): collide vss
# with alpha 1 and nearcp, surf_collide diffuse 500 1.0, square cells of 20 mm,
# of 5 mm around the cylinder, 3e5 molecules, means of 4000 steps of 2e-6 s
# after as many. Coefficients over the diameter; by angles of 15 degrees from
# the stagnation line
DRAG, HEAT = 1.8527, 0.6642
BY_ANGLE = 0.6669, 0.6052, 0.4980, 0.3651, 0.2275, 0.1130

RADIAL, AROUND = 60, 60
case = "cylinder"
types = {"xMin": "wall", "xMax": "patch", "yMin": "symmetryPlane",
         "yMax": "symmetryPlane"}
weight = DENSITY*0.5*math.pi*(OUTER**2 - R**2)/(15*RADIAL*AROUND)
write_gas(case, types, weight=weight, density=DENSITY, T=T, U=(U, 0, 0),
          gas={"Ar": ARGON}, wallT={"xMin": WALL}, inflow="FreeStream",
          more="FreeStreamCoeffs { numberDensities { Ar %r; } }\n"
          "sampling { start 5e-3; every 1; }\nreportEvery 500;" % DENSITY,
          control={"deltaT": 3e-6, "endTime": 0.012}, initialise=False)
# Two blocks, about 0 to 90 and 90 to 180 degrees from behind
corners = [(x*r, y*r, z) for z in (0, 1) for x, y in ((1, 0), (0, 1), (-1, 0))
           for r in (R, OUTER)]
H = math.sqrt(0.5)
write_foam(case, "system/blockMeshDict", f"""
vertices ({" ".join("(%r %r %r)" % c for c in corners)});
blocks
(
    hex (0 1 3 2 6 7 9 8) ({RADIAL} {AROUND//2} 1) simpleGrading (12 1 1)
    hex (2 3 5 4 8 9 11 10) ({RADIAL} {AROUND//2} 1) simpleGrading (12 1 1)
);
edges ({" ".join(
    f"arc {a + 6*z} {a + 2 + 6*z} ({x*r*H!r} {r*H!r} {z})"
    for z in (0, 1) for a, x, r in ((0, 1, R), (1, 1, OUTER), (2, -1, R),
                                    (3, -1, OUTER)))});
boundary
(
    xMin {{ type wall; faces ((0 2 8 6) (2 4 10 8)); }}
    xMax {{ type patch; faces ((1 3 9 7) (3 5 11 9)); }}
    yMin {{ type symmetryPlane; faces ((0 1 7 6)); }}
    yMax {{ type symmetryPlane; faces ((4 5 11 10)); }}
    zMin {{ type empty; faces ((0 1 3 2) (2 3 5 4)); }}
    zMax {{ type empty; faces ((6 7 9 8) (8 9 11 10)); }}
);""")
must(case, "blockMesh")
must(case, "dsmcInitialise")
must(case, "postProcess", "-func", "writeCellCentres", "-time", "0")
solve(case)

time = times_of(case)[-1]
force = read_wall(case, time, "fDMean", "xMin")[:, 0]
heat = read_wall(case, time, "qMean", "xMin")
centre = read_field(f"{case}/0/C", "xMin")
angle = np.degrees(np.arctan2(centre[:, 1], -centre[:, 0]))
push = 0.5*MASS*DENSITY*U**2
drag = math.pi*force.mean()/push
verdict("cylinder_drag", abs(drag/DRAG - 1) < 0.01,
        f"coefficient {drag:.4f}, SPARTA {DRAG}")
taken = math.pi*heat.mean()/(push*U)
verdict("cylinder_heat", abs(taken/HEAT - 1) < 0.015,
        f"coefficient {taken:.4f}, SPARTA {HEAT}")
found = np.array([heat[(angle > 15*i) & (angle < 15*(i + 1))].mean()
                  for i in range(6)])/(push*U)
off = np.abs(found - BY_ANGLE)/HEAT
verdict("cylinder_heat_by_angle", off.max() < 0.02,
        "coefficients " + " ".join(f"{f:.4f}" for f in found) + ", SPARTA "
        + " ".join(f"{s:.4f}" for s in BY_ANGLE))
