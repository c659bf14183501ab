# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Cases of a gas with grains that exchange momentum and heat with it."""

import os

import numpy as np

from caseTools import (GAMMA, R_GAS, last_fields, must, read_field,
                       times_of, write_block, write_case,
                       write_field, write_foam)
from caseTools import box as corners
from foamFiles import positions

CP = GAMMA*R_GAS/(GAMMA - 1)
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
            nParticle NUMBER; minParticlesPerParcel 0; SOI 0;
            positionsFile "positions"; U0 (V_DUST);
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
           mode=None, writes=1, scatter=0., number=None,
           change=lambda cloud: cloud):
    """Gas and grains in a box without ends. cells: along each side, or along x
    and y, or along all three; T and p may have a value for each. scatter: half of the grains, in a
    group of their own, are that much faster [m/s]."""
    L = 1e-3
    along = (cells, cells) if np.ndim(cells) == 0 else tuple(cells)
    nx, ny, nz = (*along, 1)[:3]
    write_case(case, {"endTime": steps*dt, "deltaT": dt,
                      "writeInterval": steps*dt/writes, "libs": "(spinningParcel)",
                      "timePrecision": 12},
               {"mode": "transient", "viscous": "no", **(mode or {})})
    sides = [axis + end for axis in ("xyz" if nz > 1 else "xy")
             for end in ("Min", "Max")]
    types = {side: "cyclic" for side in sides}
    write_block(case, corners((nx*L, ny*L, nz*L)), (nx, ny, nz), types)
    must(case, "blockMesh")
    fixed = {side: "type empty;" for side in ("zMin", "zMax")}
    fixed.update({side: "type cyclic;" for side in sides})
    write_field(case, "p", p, fixed)
    write_field(case, "T", T, fixed)
    write_field(case, "U", u, fixed)
    mass = np.mean(p)/(R_GAS*np.mean(T))*L**3
    number = number or loading*mass/per_cell/(RHO_P*np.pi/6*d**3)
    inner = [np.array([i + (k + 0.5)/per_cell, j + 0.5, m + 0.5])*L
             for i in range(nx) for j in range(ny) for m in range(nz)
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
    if scatter:
        a, b = cloud.index("        grains"), cloud.index("    patchInter")
        group = cloud[a:b].rstrip().rstrip("}").rstrip()
        faster = group.replace("grains", "faster").replace(
            "U0 (%r" % v[0], "U0 (%r" % (v[0] + scatter)).replace(
                '"positions"', '"positionsFaster"')
        cloud = cloud[:a] + group + "\n" + faster + "\n    }\n" + cloud[b:]
        write_foam(case, "constant/positionsFaster", "(\n" + "\n".join(
            "(%.17g %.17g %.17g)" % tuple(x + np.array([0.4*L/per_cell, 0, 0]))
            for x in inner) + "\n)", "vectorField")
    write_foam(case, "constant/sandProperties", change(cloud))
    return mass


def state(case, time=None):
    """Density, pressure, temperature and velocity of the gas of a box in which
    all cells are alike."""
    means = []
    for name, q in zip(("rho", "p", "T", "U"),
                       last_fields(case, "rho p T U", time)):
        rows = np.asarray(q).reshape(-1, 3 if name == "U" else 1)
        if np.ptp(rows, axis=0).max() > 1e-9*np.abs(rows).max():
            raise RuntimeError(f"{case}: {name} is not uniform")
        means.append(np.squeeze(rows.mean(axis=0)))
    return means


def read_dust(case, time):
    """x, velocity along x and temperature of the grains."""
    folder = os.path.join(case, time, "lagrangian", "sand")
    return (positions(folder)[0][:, 0],
            read_field(os.path.join(folder, "U"))[:, 0],
            read_field(os.path.join(folder, "T")))


def dust_energy(case, time=None, parts=False, enthalpy=lambda T: CP_P*T):
    """Of the grains' motion, spin and heat [J], all ranks together."""
    time = time or times_of(case)[-1]
    folder = os.path.join(case, time, "lagrangian", "sand")

    def read(name):
        return read_field(os.path.join(folder, name))
    d = read("d")
    mass = read("nParticle")*read("rho")*np.pi/6*d**3
    each = (0.5*np.sum(mass[:, None]*read("U")**2),
            0.05*np.sum((mass*d**2)[:, None]*read("omega")**2),
            np.sum(mass*enthalpy(read("T"))))
    return each if parts else sum(each)


def viscosity(T):
    """Of the gas of write_case [Pa s]."""
    return 1.458e-6*np.sqrt(T)/(1 + 110.4/T)


def prandtl(R):
    """Of Sutherland's viscosity with Eucken's conductivity, as OpenFOAM has
    it."""
    Cv = CP - R
    return CP/Cv/(1.32 + 1.77*R/Cv)


def sphere_drag(Re, M, tau, gamma):
    """Cd Re of the stock sphereDrag."""
    return 24*(1 + Re**(2/3)/6) if Re < 1000 else 0.424*Re


def henderson_drag(Re, M, tau, gamma):
    """Cd Re of hendersonDrag up to the speed of sound."""
    if M > 1:
        raise ValueError(f"Mach number {M}: subsonic only")
    if M < 1e-9:
        return 24.
    S = M*np.sqrt(gamma/2)
    x = 0.03*Re + 0.48*np.sqrt(Re)
    Cd = (24/(Re + S*(4.33 + (3.65 - 1.53*tau)/(1 + 0.353*tau)
                      * np.exp(-0.247*Re/S)))
          + np.exp(-0.5*M/np.sqrt(Re))*((4.5 + 0.38*x)/(1 + x) + 0.1*M**2
                                        + 0.2*M**8)
          + 0.6*S*(1 - np.exp(-M/Re)))
    return Cd*Re


def relaxation(d, speed, rho, T, R, T_dust, drag=sphere_drag):
    """Rates of velocity and temperature [1/s] by a drag law and ranzMarshall,
    and what the temperature of a grain without heat has more than T [K]."""
    mu = viscosity(T)
    Pr = prandtl(R)
    Re = rho*speed*d/mu
    gamma = CP/(CP - R)
    CdRe = drag(Re, speed/np.sqrt(gamma*R*T), T_dust/T, gamma)
    Nu = 2 + 0.6*np.sqrt(Re)*Pr**(1/3)
    return (0.75*mu*CdRe/(RHO_P*d**2), 6*Nu*CP*mu/Pr/(RHO_P*d**2*CP_P),
            np.sqrt(Pr)*speed**2/(2*CP))


def exchange(loading, d, end, u, v, T, T_dust, R, rho, emissivity=0.,
             T_around=0., drag=sphere_drag):
    """u and T of gas, v and T of grains in a box after a time, by their
    differential equations."""
    cv = CP - R
    u, v = np.array(u, float), np.array(v, float)
    y = np.concatenate([v, [T_dust]])
    P = u + loading*v
    radiated = 0.
    E = cv*T + 0.5*u @ u + loading*(CP_P*T_dust + 0.5*v @ v)

    def gas(y, radiated):
        w = P - loading*y[:3]
        return w, (E - radiated - 0.5*w @ w - loading*(
            CP_P*y[3] + 0.5*y[:3] @ y[:3]))/cv

    def rates(z):
        y, lost = z[:4], z[4]
        w, Tg = gas(y, lost)
        k, heat, more = relaxation(d, np.linalg.norm(w - y[:3]), rho, Tg, R,
                                   y[3], drag)
        light = 6*emissivity*5.670374419e-8/(RHO_P*d)*(
            y[3]**4 - T_around**4)
        return np.concatenate([k*(w - y[:3]),
                               [heat*(Tg + more - y[3]) - light/CP_P,
                                loading*light]])
    z = np.concatenate([y, [radiated]])
    n = 4000
    h = end/n
    for _ in range(n):
        k1 = rates(z)
        k2 = rates(z + h/2*k1)
        k3 = rates(z + h/2*k2)
        k4 = rates(z + h*k3)
        z = z + h/6*(k1 + 2*k2 + 2*k3 + k4)
    return (*gas(z[:4], z[4]), z[:3], z[3])
