# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Rate of the elastic collisions of a gas of parcels in a periodic box against
Enskog's (physics of dense gases: Carnahan & Starling in three dimensions,
Henderson in two); stands in a temporary folder."""

import math
import re

import numpy as np

from caseTools import (box, must, solve, verdict, write_block, write_case,
                       write_field, write_foam)

D = 1e-5
SPEED = 10.0
GROUPS = 16

CLOUD = """
type spinningKinematicCloud;
solution
{
    active yes; coupled no; transient yes; cellValueSourceCorrection off;
    rotation off;
    motion stock;
    collisions
    {
        type eventDriven; restitution 1; friction 0;
        overlappingInjection separate;
    }
    interpolationSchemes { rho cell; U cell; T cell; thermo:mu cell; }
    integrationSchemes { U Euler; }
}
constantProperties { rho0 2500; }
subModels
{
    particleForces {}
    rotationalTorqueModel none;
    injectionModels { INJECTORS }
    patchInteractionModel none;
    dispersionModel none; stochasticCollisionModel none;
    surfaceFilmModel none;
}
cloudFunctions {}
"""


def triple(v):
    return "(" + " ".join(repr(float(x)) for x in v) + ")"


def rate(dimension, n, fraction, per_parcel):
    """Collisions of a parcel over Enskog's number, and their number. n: along
    each axis."""
    N = n**dimension
    if dimension == 2:
        pitch = D*math.sqrt(math.pi/(4*fraction))
        contact = (1 - 7*fraction/16)/(1 - fraction)**2
    else:
        pitch = D*(math.pi/(6*fraction))**(1/3)
        contact = (1 - fraction/2)/(1 - fraction)**3
    side = n*pitch
    density = N/side**dimension

    # A lattice whose sites have one of sixteen velocities, at random, with a
    # momentum of all that is zero
    rng = np.random.default_rng(7)
    axes = np.meshgrid(*[(np.arange(n) + 0.5)*pitch]*dimension)
    sites = np.zeros((N, 3))
    sites[:, :dimension] = np.stack(axes, -1).reshape(N, dimension)
    rng.shuffle(sites)
    U = np.zeros((GROUPS, 3))
    U[:, :dimension] = rng.normal(size=(GROUPS, dimension))
    U[GROUPS//2:] = -U[:GROUPS//2]
    U *= SPEED/math.sqrt((U**2).sum(axis=1).mean()/dimension)

    # The mean relative speed in terms of the root mean square of a component
    expected = density*contact*SPEED*(
        2*D*math.sqrt(math.pi) if dimension == 2
        else 4*D**2*math.sqrt(math.pi))
    dt = 0.25/expected
    steps = 24*int(per_parcel/6)
    case = f"gas{dimension}"
    injectors = []
    for group, u in enumerate(U):
        own = sites[group*(N//GROUPS):(group + 1)*(N//GROUPS)]
        write_foam(case, f"constant/positions{group}", f"{len(own)}\n(\n"
                   + "\n".join(triple(x) for x in own) + "\n)",
                   "vectorField")
        injectors.append(
            f"g{group} {{ type manualInjection; SOI 0; massTotal 0;"
            f" parcelBasisType fixed; nParticle 1; U0 {triple(u)};"
            f' positionsFile "positions{group}"; sizeDistribution'
            f" {{ type fixedValue; fixedValueDistribution"
            f" {{ value {D!r}; }} }} }}")
    write_case(case, {"endTime": repr((steps + 0.1)*dt), "deltaT": repr(dt),
                      "writeControl": "timeStep", "writeInterval": steps//6,
                      "libs": "(spinningParcel)"}, {"mode": "frozen"})
    sides = ["xMin", "xMax", "yMin", "yMax", "zMin", "zMax"][:2*dimension]
    thickness = side if dimension == 3 else 1e-4
    cells = max(2, n//4)
    write_block(case, box((side, side, thickness)),
                (cells, cells, cells if dimension == 3 else 1),
                {name: "cyclic" for name in sides})
    must(case, "blockMesh")
    fixed = {name: "type cyclic;" for name in sides}
    if dimension == 2:
        fixed.update({name: "type empty;" for name in ("zMin", "zMax")})
    write_field(case, "p", 1e5, fixed)
    write_field(case, "T", 300, fixed)
    write_field(case, "U", (0, 0, 0), fixed)
    write_foam(case, "constant/parcelClouds", "clouds (gas);")
    write_foam(case, "constant/gasProperties",
               CLOUD.replace("INJECTORS", "\n".join(injectors)))
    log = solve(case)
    events = np.array([float(v) for v in re.findall(
        r"Pair, boundary events\s*= .*; in all ([^,]+),", log)])
    energy = np.array([float(v) for v in re.findall(
        r"Linear kinetic energy\s*= (\S+)", log)])

    # The first sixth relaxes
    assert len(events) == 6
    met = events[5] - events[0]
    return (2*met/(N*5/6*steps*dt*expected), met,
            abs(energy[-1]/energy[0] - 1))


# Longer runs agree within 0.3 %
for dimension, n in ((2, 40), (3, 12)):
    ratio, met, drift = rate(dimension, n, 0.1, 240)
    verdict(f"rate_in_{dimension}_dimensions_is_Enskogs",
            abs(ratio - 1) < 0.01 and met > 1e5 and drift < 1e-10,
            f"ratio {ratio:.4f} from {met:.0f} pairs, energy drift"
            f" {drift:.1g}")
