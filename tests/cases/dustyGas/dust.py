# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Cases of a gas with grains that exchange momentum and heat with it."""

import numpy as np

from caseTools import write_block, write_case, write_field, write_foam, must
from caseTools import box as corners

from caseTools import MOL_WEIGHT, R_GAS, GAMMA
CV = R_GAS/(GAMMA - 1)
RHO_P = 2500.
CP_P = 800.

CLOUD = """
type spinningKinematicCloud;
solution
{
    active yes; coupled yes; transient yes; cellValueSourceCorrection off;
    heatTransfer on;
    rotation off;
    motion { type embeddedRK54; tolerance TOLERANCE; }
    sourceTerms { schemes { U explicit 1; } }
    interpolationSchemes { U cellLinear; }
    integrationSchemes { U Euler; }
}
constantProperties { rho0 2500; T0 T_DUST; Cp0 800; MATERIAL }
subModels
{
    particleForces { DRAG }
    heatTransferModel HEAT;
    injectionModels
    {
        grains
        {
            type manualInjection; massTotal 0; parcelBasisType fixed;
            nParticle NUMBER; SOI 0; positionsFile "positions"; U0 (V_DUST);
            sizeDistribution
            {
                type fixedValue; fixedValueDistribution { value DIAMETER; }
            }
        }
    }
    patchInteractionModel standardWallInteraction;
    standardWallInteractionCoeffs { type rebound; e 1; mu 0; }
    dispersionModel none; stochasticCollisionModel none;
    surfaceFilmModel none;
}
cloudFunctions {}
"""


def sealed(case, loading, d, steps, dt, u=(300, 0, 0), v=(0, 0, 0), T=500.,
           T_dust=300., p=1e5, cells=2, per_cell=1, material="",
           drag="sphereDrag;", heat="ranzMarshall", tolerance=1e-9,
           mode=None, change=lambda cloud: cloud):
    """Gas and grains in a box without ends, all cells alike."""
    L = 1e-3
    write_case(case, {"endTime": steps*dt, "deltaT": dt,
                      "writeInterval": steps*dt, "libs": "(spinningParcel)",
                      "timePrecision": 12},
               {"mode": "transient", "viscous": "no", **(mode or {})})
    sides = ("xMin", "xMax", "yMin", "yMax")
    types = {side: "cyclic" for side in sides}
    write_block(case, corners((cells*L, cells*L, L)), (cells, cells, 1),
                types)
    must(case, "blockMesh")
    fixed = {side: "type cyclic;" for side in sides}
    fixed.update({side: "type empty;" for side in ("zMin", "zMax")})
    write_field(case, "p", p, fixed)
    write_field(case, "T", T, fixed)
    write_field(case, "U", u, fixed)
    mass = p/(R_GAS*T)*L**3
    number = loading*mass/per_cell/(RHO_P*np.pi/6*d**3)
    inner = [(np.array([i + (k + 0.5)/per_cell, j + 0.5, 0.5]))*L
             for i in range(cells) for j in range(cells)
             for k in range(per_cell)]
    write_foam(case, "constant/positions", "(\n" + "\n".join(
        "(%.17g %.17g %.17g)" % tuple(x) for x in inner) + "\n)",
        "vectorField")
    write_foam(case, "constant/parcelClouds", "clouds (sand);")
    cloud = CLOUD
    for word, value in (("TOLERANCE", repr(tolerance)),
                        ("T_DUST", repr(T_dust)), ("MATERIAL", material),
                        ("DRAG", drag), ("HEAT", heat),
                        ("NUMBER", repr(number)), ("DIAMETER", repr(d)),
                        ("V_DUST", "%r %r %r" % tuple(v))):
        cloud = cloud.replace(word, value)
    write_foam(case, "constant/sandProperties", change(cloud))
    return mass


def common(loading, u, v, T, T_dust, c=CP_P):
    """Velocity and temperature of both in the end."""
    u, v = np.asarray(u, float), np.asarray(v, float)
    w = (u + loading*v)/(1 + loading)
    energy = (CV*T + 0.5*u @ u + loading*(c*T_dust + 0.5*v @ v)
              - 0.5*(1 + loading)*w @ w)
    return w, energy/(CV + loading*c)
