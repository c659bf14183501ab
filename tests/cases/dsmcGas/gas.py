# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""The gas against kinetic theory, restarts, ranks and the function objects of
the stock solver. Every tolerance is at least four standard deviations."""

import math
import os
import re

import numpy as np

from caseTools import (copy_case, decompose, edit, largest, must, read_field,
                       run, summary_of, times_of, verdict)
from dsmcTools import (ARGON, K, NITROGEN, collisions, energies, momenta,
                       read_molecules, read_wall, reported, solve, write_gas)

PERIODIC = dict.fromkeys(("xMin", "xMax", "yMin", "yMax", "zMin", "zMax"),
                         "cyclic")
WALLS = dict.fromkeys(PERIODIC, "wall")
OPEN = dict.fromkeys(PERIODIC, "patch")


# --- closed periodic box of argon: collision rate, conservation
write_gas("argon", PERIODIC, (16, 16, 16), weight=2.5e12, T=300.,
          control={"deltaT": 8e-6, "endTime": 8e-6*260, "writeInterval": 130},
          more="reportEvery 20;")
log = solve("argon")
n = int(re.search(r"= (\d+) now", log).group(1))
energy, momentum = energies(log), momenta(log)
mass = n*2.5e12*ARGON["mass"]
T = (energy[-1] - 0.5*np.dot(momentum[-1], momentum[-1])/mass)/(
    1.5*K*2.5e12*(n - 1))
nu = (4*ARGON["diameter"]**2*n*2.5e12/1e-3*np.sqrt(np.pi*K*273/ARGON["mass"])
      * (T/273)**(1 - ARGON["omega"]))
found = np.mean(reported(log, r"collisions per step: ([-+0-9.eE]+)")[2:])
ratio = found/(0.5*n*nu*8e-6)
verdict("argon_collisionRate", abs(ratio - 1) < 0.005,
        f"{ratio:.4f} of kinetic theory, n = {n}")
drift = np.ptp(energy)/energy[0]
verdict("argon_energy", drift < 1e-11, f"relative drift {drift:.1e}")
drift = np.ptp(momentum, axis=0).max()/np.sqrt(2*mass*energy[0])
verdict("argon_momentum", drift < 1e-11, f"relative drift {drift:.1e}")

# --- continued from half-way: the same bits; on two ranks: the same gas
half, end = times_of("argon")[1:]
copy_case("argon", "again")
os.rename(f"again/{end}", "again/straight")
solve("again")
different = [f for f in ("lagrangian/dsmc/positions", "lagrangian/dsmc/U",
                         "lagrangian/dsmc/coordinates", "dsmcSigmaTcRMax")
             if open(f"again/{end}/{f}", "rb").read()
             != open(f"again/straight/{f}", "rb").read()]
verdict("argon_restart", not different, f"differ: {different}")

copy_case("argon", "ranks")
for time in (half, end):
    os.rename(f"ranks/{time}", f"ranks/serial.{time}")
decompose("ranks")
two = solve("ranks", 2)
start, kept = energies(two), int(re.search(r"= (\d+) now", two).group(1))
verdict("argon_twoRanks", kept == n
        and np.ptp(start)/start[0] < 1e-11
        and abs(start[0]/energy[0] - 1) < 1e-12
        and abs(collisions(two)/collisions(log) - 1)
        < 6/np.sqrt(collisions(log)),
        f"{kept} of {n} molecules, collisions"
        f" {collisions(two)/collisions(log):.4f} of those on one rank")

# --- rotation against translation, periodic: molecules that do not rotate at
#     first take energy over, at a rate that Z sets, until both are alike
write_gas("nitrogen", PERIODIC, (8, 8, 8), weight=1e13, T=500.,
          gas={"N2": dict(NITROGEN, internalDegreesOfFreedom=0)},
          collisions="LarsenBorgnakkeVariableHardSphere",
          control={"deltaT": 1e-6, "endTime": 1e-4},
          more="sampling { start 2e-3; }")
edit("nitrogen", "constant/dsmcProperties", "internalDegreesOfFreedom 0",
     "internalDegreesOfFreedom 2")
log = solve("nitrogen")
Ei = read_molecules("nitrogen", times_of("nitrogen")[-1])[2]["Ei"]
# A molecule that exchanges (the second of a pair finds what the first has
# left) takes 1/(a + 1) of the energy, the relative motion having a k T of it;
# translation and rotation hold 3/2 and 1 k T
a, Z = 2.5 - NITROGEN["omega"], 5
met = 2*collisions(log)/len(Ei)
share = 1 - math.exp(-5/3*a/(a + 1)/Z*(1 - 1/(2*Z*(a + 1)))*met)
found, error = np.mean(Ei)/(300*K), np.std(Ei)/np.mean(Ei)/len(Ei)**0.5
verdict("nitrogen_relaxation", abs(found/share - 1) < 4*error < 0.1,
        f"after {met:.2f} collisions of each molecule rotation has {found:.4f}"
        f" of its energy in equilibrium, exact {share:.4f}, deviation"
        f" {100*error:.1f} %")
edit("nitrogen", "system/controlDict", "deltaT 1e-06", "deltaT 1e-05")
edit("nitrogen", "system/controlDict", "endTime 0.0001", "endTime 0.004")
edit("nitrogen", "system/controlDict", "writeInterval 100",
     "writeInterval 390")
log = solve("nitrogen")
end = times_of("nitrogen")[-1]
Tt, Ti = (np.mean(read_field(f"nitrogen/{end}/{f}"))
          for f in ("translationalT", "internalT"))
rho = read_field(f"nitrogen/{end}/rhoNMean")
# Rotation and translation of 10000 molecules fluctuate by 1 % against each
# other, less over the mean
verdict("nitrogen_equilibrium", abs(Tt/Ti - 1) < 0.03
        and abs(Tt/300 - 1) < 0.03
        and np.ptp(energies(log))/energies(log)[0] < 1e-11,
        f"T {Tt:.1f} K, rotation {Ti:.1f} K")
verdict("nitrogen_density", abs(np.mean(rho)*1e-3
        / (1e13*int(re.search(r"= (\d+) now", log).group(1))) - 1) < 1e-9,
        "mean density against the number of molecules")

# --- between diffuse walls at the temperature of the gas, half specular
write_gas("walls", WALLS, (8, 8, 8), weight=5e12, T=400.,
          gas={"N2": NITROGEN}, wall="MixedDiffuseSpecular",
          collisions="LarsenBorgnakkeVariableHardSphere",
          control={"deltaT": 2e-5, "endTime": 2e-5*800,
                   "writeInterval": 400},
          more="MixedDiffuseSpecularCoeffs { diffuseFraction 0.5; }\n"
          "wallDiffuseFractions { zMax 1; }\nsampling { start 1e-3; }")
log = solve("walls")
half, end = times_of("walls")[1:]
n = int(re.search(r"= (\d+) now", log).group(1))
pressure = n*5e12/1e-3*K*400
duration = 2e-5*750
for patch in ("xMin", "zMax"):
    p = np.mean(read_wall("walls", end, "p", patch))
    q = np.mean(read_wall("walls", end, "qMean", patch))
    hits = n*5e12/1e-3*np.sqrt(8*K*400/np.pi/NITROGEN["mass"])/4*0.01 \
        * duration/5e12
    # A hit carries energy 3 kT within sqrt(3) kT, twice, and a momentum
    # within half of its mean
    deviation = np.sqrt(6*hits)*K*400*5e12/(0.01*duration)
    verdict(f"walls_{patch}", abs(p/pressure - 1) < 4/np.sqrt(hits) + 0.01
            and abs(q) < 5*deviation,
            f"pressure {p/pressure:.4f} of n k T, heat flux {q:.1e} W/m2,"
            f" deviation {deviation:.1e} W/m2")
# Means go on where they were
copy_case("walls", "wallsAgain")
os.rename(f"wallsAgain/{end}", "wallsAgain/straight")
solve("wallsAgain")
worst = largest(
    np.max(np.abs(read_field(f"wallsAgain/{end}/{f}")
                  / read_field(f"wallsAgain/straight/{f}") - 1))
    for f in ("rhoNMean", "overallT"))
same = abs(np.mean(read_wall("wallsAgain", end, "p", "zMax"))/p - 1)
verdict("walls_restartedMeans", largest(worst, same) < 1e-10,
        f"relative difference {largest(worst, same):.1e}")

# --- heat between plates without collisions: exact
plates = dict(PERIODIC, yMin="wall", yMax="wall")
for case, fraction in ("plates", 1), ("halfDiffuse", 0.5):
    write_gas(case, plates, (4, 10, 4), weight=2.5e13, T=400.,
              wallT={"yMin": 300., "yMax": 600.}, gas={"N2": NITROGEN},
              collisions="none",
              wall="MaxwellianThermal" if fraction == 1
              else "MixedDiffuseSpecular",
              more="MixedDiffuseSpecularCoeffs { diffuseFraction"
              f" {fraction}; }}\nsampling {{ start 2e-3; }}",
              control={"deltaT": 2e-5, "endTime": 2e-5*1100})
    log = solve(case)
    end = times_of(case)[-1]
    n = int(re.search(r"= (\d+) now", log).group(1))*2.5e13/1e-3
    # Half the molecules come from either plate, with n sqrt(T) the same for
    # both; each carries (2 + 1) k T of its plate. Of a plate that reflects
    # the others 1/(2 - f) of them come from it, the rest from the other plate:
    # the same numbers and pressure, f/(2 - f) of the heat
    root = np.sqrt([300., 600.])
    flux = 2*n*root[1]/root.sum()*np.sqrt(K*300/(2*np.pi*NITROGEN["mass"]))
    hits = flux*0.01*2e-2/2.5e13
    exact = 3*K*300*flux*fraction/(2 - fraction)
    force = n*K*np.sqrt(300.*600.)
    # Energies of 3 k T scatter by sqrt(3) k T, at 300 and at 600 K, in hits
    # that are not mirrored. Slow molecules forget the start late: 1 % of the
    # pressure at 2 ms
    error = np.sqrt(3*(300**2 + 600**2)*fraction/hits)/(
        900*fraction/(2 - fraction))
    for patch, sign in (("yMin", 1), ("yMax", -1)):
        q = sign*np.mean(read_wall(case, end, "qMean", patch))
        p = np.mean(read_wall(case, end, "p", patch))
        verdict(f"{case}_{patch}", abs(q/exact - 1) < 4.5*error
                and abs(p/force - 1) < 4/np.sqrt(hits) + 0.01
                and error < 0.02,
                f"heat flux {q/exact:.4f} (error {error:.4f}), pressure"
                f" {p/force:.4f} of the exact ones")

# --- a stream into an empty box and out of it
write_gas("stream", OPEN, (8, 8, 8), weight=4e12, T=300., U=(500, 200, 0),
          collisions="none", inflow="FreeStream",
          more="FreeStreamCoeffs { numberDensities { Ar 1e20; } }\n"
          "sampling { start 2e-3; }", initialise=False,
          control={"deltaT": 1e-5, "endTime": 1e-5*1200})
log = solve("stream")
end = times_of("stream")[-1]
rho, T = (read_field(f"stream/{end}/{f}") for f in ("rhoNMean", "overallT"))
U = np.mean(read_field(f"stream/{end}/UMean"), axis=0)
# 25000 molecules, renewed every 1e-4 s
verdict("stream_state", abs(np.mean(rho)/1e20 - 1) < 0.005
        and abs(np.mean(T)/300 - 1) < 0.01
        and np.all(np.abs(U - [500, 200, 0]) < 3),
        f"density {np.mean(rho)/1e20:.4f}, temperature {np.mean(T)/300:.4f},"
        f" velocity {np.round(U, 1)}")
ends = rho.reshape(8, 8, 8)[:, :, (0, -1)].mean(axis=(0, 1))/1e20
verdict("stream_uniform", np.all(np.abs(ends - 1) < 0.01),
        f"density next to the entrance and the exit {np.round(ends, 4)}")

# --- gases of their own behind two patches, until the first molecules have
#     crossed half the box: what has come in against the half-range Maxwellians
GASES = {"Ar": ARGON, "N2": NITROGEN}


def crossing(kind, n, T, inward, along):
    """Fluxes of number, mass, inward and tangential momentum, and energy."""
    m, zeta = kind["mass"], kind["internalDegreesOfFreedom"]
    c = np.sqrt(2*K*T/m)
    s = inward/c
    gauss, both = np.exp(-s*s), np.sqrt(np.pi)*(1 + math.erf(s))
    flux = n*c/(2*np.sqrt(np.pi))*(gauss + s*both)
    S2 = (inward**2 + along**2)/c**2
    energy = (n*K*T*c/(2*np.sqrt(np.pi))
              * ((S2 + 2)*gauss + s*(S2 + 2.5)*both) + flux*zeta/2*K*T)
    through = n*m*c*c/(2*np.sqrt(np.pi))*(s*gauss + (s*s + 0.5)*both)
    return np.array([flux, m*flux, through, m*along*flux, energy])


jets = dict(PERIODIC, xMin="patch", xMax="patch")
JET = ("xMin { numberDensities { Ar 1e20; N2 3e20; } temperature 200;"
       " velocity (600 150 0); } ")
other = crossing(ARGON, 5e19, 700., -200., 100.)*[1, 1, -1, 1, 1]
jet = (crossing(ARGON, 1e20, 200., 600., 150.)
       + crossing(NITROGEN, 3e20, 200., 600., 150.))
for name, more, exact in (
        ("jets", "inflows { " + JET + "\"x.*x\" { numberDensities"
         " { Ar 5e19; } } }", jet + other),
        ("jetAndStream", "numberDensities { Ar 5e19; } inflows { " + JET + "}",
         jet + other),
        ("jet", "inflows { " + JET + "}", jet)):
    write_gas(name, jets, (6, 4, 4), weight=2e11, T=700., U=(200, 100, 0),
              gas=GASES, collisions="none", inflow="FreeStream",
              more="FreeStreamCoeffs { " + more + " }", initialise=False,
              control={"deltaT": 1e-6, "endTime": 2.5e-5})
    log = solve(name)
    n = int(re.search(r"= (\d+) now", log).group(1))
    found = np.array([n*2e11, reported(log, r"mass: (\S+) kg")[-1],
                      *momenta(log)[-1][:2], energies(log)[-1]])
    ratio = found/(exact*0.01*2.5e-5)
    # 3e5 molecules; the energy of one scatters by as much as its mean
    verdict(f"{name}_fluxes", n > 2e5 and np.all(np.abs(ratio - 1)
            < 5/np.sqrt(n)*np.array([1, 1, 1, 3, 1.5])),
            "number, mass, momentum, energy: " + " ".join(
                f"{r:.4f}" for r in ratio)
            + f" of the exact ones, {n} molecules")

# --- plate in a free-molecular stream (Schaaf and Chambre), whatever it sends
#     back leaving through the open sides
wind = np.array([400., 0., -800.])
write_gas("plate", dict(OPEN, zMin="wall"), (6, 6, 6), weight=8e12, T=300.,
          U=tuple(wind), wallT={"zMin": 500.}, collisions="none",
          inflow="FreeStream",
          more="FreeStreamCoeffs { numberDensities { Ar 1e20; } }\n"
          "sampling { start 0; }",
          control={"deltaT": 1e-5, "endTime": 1e-5*600})
log = solve("plate")
end = times_of("plate")[-1]
m = ARGON["mass"]
c = np.sqrt(2*K*300/m)
s = 800/c
S2 = np.dot(wind, wind)/c**2
gauss, both = np.exp(-s*s), 1 + math.erf(s)
flux = 1e20*c/(2*np.sqrt(np.pi))*(gauss + np.sqrt(np.pi)*s*both)
exact = {
    "pressure": 1e20*K*300*(2*s*gauss/np.sqrt(np.pi) + (1 + 2*s*s)*both)/2
    + flux*np.sqrt(np.pi*m*K*500/2),
    "shear": flux*m*400,
    "heat": 1e20*K*300*np.sqrt(K*300/(2*np.pi*m))
    * ((S2 + 2)*gauss + np.sqrt(np.pi)*s*(S2 + 2.5)*both) - flux*2*K*500}
force = np.mean(read_wall("plate", end, "fDMean", "zMin"), axis=0)
found = {"pressure": -force[2], "shear": force[0],
         "heat": np.mean(read_wall("plate", end, "qMean", "zMin"))}
error = 1/np.sqrt(flux*0.01*6e-3/8e12)
ratios = {name: found[name]/exact[name] for name in exact}
verdict("plate_fluxes", error < 0.005 and all(
        abs(r - 1) < 4.5*error for r in ratios.values()),
        ", ".join(f"{name} {r:.4f}" for name, r in ratios.items())
        + f" of the exact ones, error {error:.4f}")

# --- effusion through an open side: exponential decay of a mixed gas
side = dict(WALLS, xMax="patch")
write_gas("effusion", side, (1, 1, 1), (0.4, 0.1, 0.1), weight=1e12,
          density=2.5e19, T=300., collisions="none",
          control={"deltaT": 4e-6, "endTime": 4e-6*4})
log = solve("effusion")
n0, n = (int(re.search(p, log).group(1))
         for p in (r"Molecules: (\d+)", r"= (\d+) now"))
told = summary_of(log)[1]["molecules"]
verdict("effusion_summary", told == {
    "start": n0, "injected": 0, "flying": n, "escaped": n0 - n, "stuck": 0,
    "lost": 0}, f"{told}")
# Before a depletion wave can matter: flux n c/4 from a gas at rest
rate = np.sqrt(8*K*300/np.pi/ARGON["mass"])/4*0.01/4e-3*1.6e-5
verdict("effusion_flux", abs((n0 - n)/(n0*rate) - 1)
        < 4.5/np.sqrt(n0*rate),
        f"{(n0 - n)/(n0*rate):.3f} of n c/4, {n0 - n} left")

# --- function objects of the stock tutorials; another name for every field
write_gas("functions", PERIODIC, (4, 4, 4), weight=4e13,
          control={"deltaT": 1e-5, "endTime": 2e-4})
names = "rhoN rhoM dsmcRhoN momentum linearKE internalE iDof q fD".split()
with open("functions/system/controlDict", "a") as file:
    file.write("functions\n{\n average { type fieldAverage;"
               " libs (fieldFunctionObjects); writeControl writeTime;"
               " fields (\n" + "\n".join(
                   f"{x} {{ mean on; prime2Mean off; base time; }}"
                   for x in names)
               + "); }\n gas { type dsmcFields; writeControl writeTime;"
               " libs (lagrangianFunctionObjects); }\n}\n")
log = solve("functions")
end = times_of("functions")[-1]
T = read_field(f"functions/{end}/overallT")
n = int(re.search(r"= (\d+) now", log).group(1))
expected = (energies(log)[0] - 0.5*np.dot(momenta(log)[0], momenta(log)[0])
            / (n*4e13*ARGON["mass"]))/(1.5*K*4e13*n)
# Cells of 40 molecules move by themselves, which dsmcFields takes off
verdict("functions_fields", abs(np.mean(T)/expected - 1) < 0.05
        and os.path.exists(f"functions/{end}/rhoNMean"),
        f"mean of overallT {np.mean(T):.1f} K, gas {expected:.1f} K")

# --- and the stock solver goes on from what was written
edit("functions", "system/controlDict", "endTime 0.0002;", "endTime 0.00022;")
stock = must("functions", "dsmcFoam")
counts = reported(stock, r"Number of dsmc particles\s+= (\d+)")
kinetic = reported(stock, r"Average linear kinetic energy\s+= (\S+)")
verdict("functions_stockContinues", len(counts) == 2 and np.all(counts == n)
        # (six digits of the stock solver's log)
        and np.allclose(kinetic*n*4e13, energies(log)[-1], rtol=5e-6, atol=0),
        f"{counts} of {n} molecules, energy"
        f" {kinetic*n*4e13/energies(log)[-1]} of ours")

# --- what conditions of walls say goes before their entries 'value', names
# before patterns; the stock fields beside means of our own
LID = dict(PERIODIC, yMin="wall", yMax="wall")


def lid(case, condition, fractions):
    write_gas(case, LID, (4, 4, 4), weight=4e13,
              control={"deltaT": 1e-5, "endTime": 2e-4},
              more=f"wallDiffuseFractions {{ {fractions} }}\n"
              "sampling { start 1e-4; }")
    edit(case, "0/boundaryU", "yMax { type fixedValue; value uniform (0 0 0);",
         "yMax { " + condition)
    with open(f"{case}/system/controlDict", "a") as file:
        file.write("functions { gas { type dsmcFields; writeControl writeTime;"
                   " libs (lagrangianFunctionObjects); } }\n")
    solve(case)
    end = times_of(case)[-1]
    return (open(f"{case}/{end}/lagrangian/dsmc/U", "rb").read(),
            np.mean(read_wall(case, end, "fDMean", "yMax"), axis=0)[0])


FIXED = "type fixedValue; value uniform (200 0 0);"
plain, drag = lid("lid", FIXED, "yMax 1; yMin 0.5;")
ignored = lid("lid_ignored", FIXED, "yMax 1;")[0] == plain
verdict("lid_fraction", not ignored, "half of the molecules reflected by one"
        f" wall move {'as if none were' if ignored else 'another way'}")
for name, condition, fractions in (
        ("value", "type uniformFixedValue; uniformValue (200 0 0);"
         " value uniform (0 0 0);", "yMax 1; yMin 0.5;"),
        ("names", FIXED, 'yMax 1; "y.*" 1; "yM.x" 0; yMin 0.5;')):
    other = lid(f"lid_{name}", condition, fractions)[0]
    verdict(f"lid_{name}", other == plain and abs(drag) > 1e-3,
            f"{'the' if other == plain else 'not the'} velocities of a wall"
            f" with fixedValue, on which the gas pulls by {drag:.3f} Pa")

edit("lid", "system/controlDict", "functions {",
     "functions { mean { type fieldAverage; libs (fieldFunctionObjects);"
     " fields (boundaryT { mean on; prime2Mean off; base time; }); }")
allowed, _ = run("lid", "dsmcParcelFoam")
edit("lid", "system/controlDict", "(boundaryT {", "(rhoN {")
status, text = run("lid", "dsmcParcelFoam")
verdict("lid_fieldAverage", allowed == 0 and status != 0
        and "Field rhoNMean" in text and "valid is one of them" in text,
        f"beside sampling means of boundaryT end with {allowed}, those of rhoN"
        f" with {status}")
