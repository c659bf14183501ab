# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""A box of homogeneous turbulence at rest, and parcels in it."""

import os

import numpy as np

from caseTools import (R_GAS, box, edit, must, read_field, times_of,
                       write_block, write_case, write_field, write_foam)
from foamFiles import positions

K, OMEGA, P, T = 24., 1e4, 1e5, 300.
EPSILON = 0.09*K*OMEGA
LIFE = 0.3*K/EPSILON
SIZE = 0.09**0.75*K**1.5/EPSILON
RHO = P/R_GAS/T
MU = 1.458e-6*T**1.5/(T + 110.4)
N, SIDE, CELLS = 4000, 0.1, 10
END = 30*LIFE

CLOUD = """
type spinningKinematicCloud;
solution
{
    active yes; coupled no; transient yes; cellValueSourceCorrection off;
    rotation off; motion { type embeddedRK54; tolerance 1e-4; }
    interpolationSchemes { U cellLinear; }
    integrationSchemes { U Euler; }
}
constantProperties { rho0 DENSITY; }
subModels
{
    particleForces { sphereDrag; }
    injectionModels
    {
        point
        {
            type manualInjection; massTotal 0; parcelBasisType fixed;
            nParticle 1; SOI 0; positionsFile "positions"; U0 (0 0 0);
            sizeDistribution
            {
                type fixedValue; fixedValueDistribution { value DIAMETER; }
            }
        }
    }
    patchInteractionModel standardWallInteraction;
    standardWallInteractionCoeffs { type escape; }
    dispersionModel stochasticDispersionRAS;
    stochasticDispersionRASCoeffs { seed 3; }
    stochasticCollisionModel none; surfaceFilmModel none;
}
cloudFunctions {}
"""
SST = ("simulationType RAS;\n"
       "RAS { RASModel kOmegaSST; turbulence on; printCoeffs off; }")


def prepare(case, d, density, dt, k=K, omega=OMEGA, end=END, n=N):
    write_case(case, {"endTime": end, "deltaT": dt, "writeInterval": end/2,
                      "writeControl": "adjustable", "timePrecision": 12,
                      "libs": "(spinningParcel)"},
               {"mode": "frozen", "viscous": "yes"})
    edit(case, "system/fvSchemes", "laplacianSchemes",
         "wallDist { method meshWave; }\nlaplacianSchemes")
    write_foam(case, "constant/turbulenceProperties", SST)
    sides = [axis + end for axis in "xyz" for end in ("Min", "Max")]
    write_block(case, box((SIDE,)*3, (-SIDE/2,)*3), (CELLS,)*3,
                {side: "patch" for side in sides})
    must(case, "blockMesh")
    fixed = {side: "type zeroGradient;" for side in sides}
    for name, value in (("p", P), ("T", T), ("U", (0, 0, 0)), ("k", k),
                        ("omega", omega), ("nut", k/omega), ("alphat", 0.)):
        write_field(case, name, value, fixed)
    write_foam(case, "constant/positions", "(\n" + "(1e-5 2e-5 3e-5)\n"*n
               + ")", "vectorField")
    write_foam(case, "constant/parcelClouds", "clouds (dust);")
    cloud = CLOUD.replace("DENSITY", repr(density))
    write_foam(case, "constant/dustProperties",
               cloud.replace("DIAMETER", repr(d)))
    return case


def parcels(case, time=None):
    """Places and velocities in the order of identities."""
    folder = os.path.join(case, time or times_of(case)[-1], "lagrangian",
                          "dust")
    order = np.argsort(read_field(folder + "/origId"))
    return (positions(folder)[0][order] - [1e-5, 2e-5, 3e-5],
            read_field(folder + "/U")[order])


def age(case):
    """Stock injectors let parcels fly once more in the step of injection."""
    return read_field(f"{case}/{times_of(case)[-1]}/lagrangian/dust/age")[0]
