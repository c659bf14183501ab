# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Rebound, inflow, deposits, balances, restart, ranks and means."""

import filecmp
import math
import os
import re
import shutil

import numpy as np

from caseTools import (copy_case, decompose, edit, largest, must, read_field,
                       summary_of, times_of, verdict)
from dsmcTools import NITROGEN, read_molecules, read_wall, solve, write_gas
from solidTools import (NUMBER, changes, fill, read_solids, tally,
                        write_solids)

PERIODIC = dict.fromkeys(("xMin", "xMax", "yMin", "yMax", "zMin", "zMax"),
                         "cyclic")
THIN = {"density": 1e12, "weight": 1e3}     # no force worth the name
K = 1.380649e-23

# --- rebound: one law a wall, up and down in y; x tells who is who
types = dict(PERIODIC, yMin="wall", yMax="wall")
write_gas("rebound", types, (4, 4, 4), (0.01, 0.01, 0.01), **THIN,
          collisions="none",
          control={"deltaT": 1e-4, "endTime": 1e-2, "writeInterval": 1})
write_solids(
    "rebound", fill(1e-9, (0, -50, 0), simulators=40) + "walls\n{\n"
    " yMin { type hardSphereWall; restitution 0.8; friction 0.3; }\n"
    " yMax { type semiEmpiricalRebound; normal 0.7; tangential 0.9;"
    " criticalAngle 90; }\n}\n", exchange="none", walls=None)
log = solve("rebound")
names = times_of("rebound")[1:]
first, last = (read_solids("rebound", t) for t in (names[0], names[-1]))
orders = [np.argsort(s["x"][:, 0]) for s in (first, last)]
a, b = ({k: v[o] for k, v in s.items()}
        for s, o in zip((first, last), orders))
y, v = a["x"][:, 1].copy(), a["U"][:, 1].copy()
for i in range(len(y)):
    left = float(names[-1]) - float(names[0])
    while True:
        t = -y[i]/v[i] if v[i] < 0 else (0.01 - y[i])/v[i]
        if t > left:
            y[i] += v[i]*left
            break
        left -= t
        y[i], v[i] = (0., -0.8*v[i]) if v[i] < 0 else (0.01, -0.7*v[i])
worst = largest(np.abs(b["x"][:, 1] - y).max()/0.01,
                np.abs(b["U"][:, 1]/v - 1).max())
verdict("rebound_exact", len(y) == 80 and worst < 1e-6
        and np.abs(v).min() < 10,
        f"{len(y)} particles, greatest deviation {worst:.1e} of position and"
        f" velocity, speeds down to {np.abs(v).min():.3g} of 50 m/s")
verdict("rebound_sizes", np.allclose(
    b["d"], np.where(b["group"] == 0, 3e-6, 6e-6), rtol=1e-12, atol=0),
        "diameters")

# --- a steady beam onto a wall that keeps what arrives, and its means
types = dict(PERIODIC, xMin="patch", xMax="wall")
write_gas("beam", types, (8, 4, 4), (0.02, 0.01, 0.01), **THIN,
          collisions="none", wallT={"xMax": 300.},
          control={"deltaT": 1e-5, "endTime": 2e-3})
write_solids(
    "beam", "inflows { xMin { massFlow 2e-6; velocity (100 0 0);"
    " temperature 800; simulatorsPerStep (3.3 2.1); } }\n"
    "sampling { start 1e-3; fields (numberDensity concentration U T exchange"
    " surface); }\n", walls="stick", exchange="none")
copy_case("beam", "beamTwo")
log = solve("beam")
end = times_of("beam")[-1]
entered, stuck = tally(log, "entered"), tally(log, "stuck")
now = read_solids("beam", end)
verdict("beam_massEntered", abs(entered[2]/4e-9 - 1) < 2e-3,
        f"{entered[2]:.6g} kg of 4e-9 kg")
flux = read_wall("beam", end, "massFlux.solids", "xMax")
T = read_wall("beam", end, "impactT.solids", "xMax")
energy = read_wall("beam", end, "energyFlux.solids", "xMax")
verdict("beam_surface", abs(flux.mean()/2e-2 - 1) < 0.01
        and np.allclose(T, 800, rtol=1e-3)
        and np.allclose(energy/flux, 5e3, rtol=1e-3),
        f"mass flux {flux.mean():.5g} of 0.02 kg/(m2 s), temperature"
        f" {T.mean():.5g} K, energy {np.mean(energy/flux):.5g} J/kg")
rho = read_field(f"beam/{end}/concentration.solids")
U = read_field(f"beam/{end}/U.solids")
n = [read_field(f"beam/{end}/numberDensity.solids{g}") for g in (0, 1)]
verdict("beam_fields", abs(rho.mean()/2e-4 - 1) < 0.01
        and np.allclose(U, [100, 0, 0], atol=0.1)
        and abs(n[0].mean()/n[1].mean() - 8) < 0.2,
        f"concentration {rho.mean():.5g} of 2e-4 kg/m3, numbers of groups"
        f" {n[0].mean()/n[1].mean():.4g} to 1 of 8")
mass = 2700*np.pi/6*now["d"]**3*now["nParticle"]
parts, told, _ = summary_of(log)
told = told["solids"]
verdict("beam_summary", told == {
    "start": 0, "injected": entered[0], "flying": len(now["d"]),
    "escaped": 0, "stuck": stuck[0], "lost": 0}
        and abs(sum(p[0] for name, p in parts.items() if name != "in all")
                - parts["in all"][0]) < 0.006
        and {"gas, moving", "solids, moving", "writing", "rest"} <= set(parts),
        f"{told}; {parts}")
verdict("beam_massKept", abs((stuck[2] + mass.sum())/entered[2] - 1) < 1e-9
        and stuck[0] > 100, f"{stuck[0]:.0f} deposited")

copy_case("beam", "beamAgain")
edit("beamAgain", "system/controlDict", "endTime 0.002", "endTime 0.0022")
again = solve("beamAgain")
deposited = tally(again, "deposited on xMax")
verdict("beam_restartGoesOn", deposited[2] > stuck[2]
        and tally(again, "initial")[0] == 0
        and abs(read_wall("beamAgain", times_of("beamAgain")[-1],
                          "massFlux.solids", "xMax").mean()/2e-2 - 1) < 0.01,
        f"{deposited[2]:.4g} kg deposited after {stuck[2]:.4g} kg")

# Tallies go on with all their digits, whatever writePrecision is
copy_case("beamTwo", "digits")
edit("digits", "system/controlDict", "writeInterval 200", "writeInterval 100")
edit("digits", "system/controlDict", "writePrecision 16", "writePrecision 6")
solve("digits")
copy_case("digits", "digitsAgain")
shutil.rmtree(f"digitsAgain/{end}")
solve("digitsAgain")
states = []
for case in "digits", "digitsAgain":
    with open(f"{case}/{end}/uniform/solidParticlesState") as file:
        states.append(file.read())
verdict("tallies_of_a_restart_are_exact", states[0] == states[1]
        and re.search(r"mass +\d\.\d{13,}", states[0]),
        "\n".join(a for a, b in zip(*(s.split("\n") for s in states))
                  if a != b)[:300] or "the same file")

# What entered and what stays on the wall are counted by different ranks
edit("beamTwo", "system/controlDict", "writeInterval 200",
     "writeInterval 100")
decompose("beamTwo", (2, 1, 1))
two = solve("beamTwo", 2)
copy_case("beamTwo", "beamTwoAgain")
for rank in (0, 1):
    shutil.rmtree(f"beamTwoAgain/processor{rank}/{end}")
again = solve("beamTwoAgain", 2)
fates = ("initial", "entered", "stuck", "deposited on xMax")
straight, restarted = ([tally(text, fate) for fate in fates]
                       for text in (two, again))
entered, stuck = straight[1], straight[2]
verdict("beam_twoRanksTallies", abs(entered[2]/4e-9 - 1) < 2e-3
        and stuck[0] > 100 and straight[3][0] >= stuck[0],
        f"{entered[2]:.6g} kg of 4e-9 kg entered, {stuck[0]:.0f} stuck,"
        f" {straight[3][0]:.0f} deposited")
# Sums of a rank go on from those of all: they agree to round-off
verdict("beam_twoRanksTalliesRestart",
        all(x[0] == y[0] and np.allclose(x, y, rtol=1e-13, atol=0)
            for x, y in zip(straight, restarted)),
        "the numbers of the straight run, its masses to 1e-13")

# --- an inflow that goes with the gas
types = dict(PERIODIC, xMin="patch", xMax="patch")
write_gas("loaded", types, (8, 4, 4), (0.02, 0.01, 0.01), weight=1e15,
          density=1e22, T=500., U=(800, 0, 0), gas={"N2": NITROGEN},
          inflow="FreeStream", collisions="none",
          more="FreeStreamCoeffs { numberDensities { N2 1e22; }"
          " patches (xMin); }\n",
          control={"deltaT": 1e-6, "endTime": 1e-4})
write_solids("loaded", "inflows { xMin { massLoading 0.5; velocity gas;"
             " temperature gas; simulatorsPerStep 5; } }\n", walls=None)
log = solve("loaded")
exact = 0.5*1e22*NITROGEN["mass"]*800*1e-4*1e-4
entered = tally(log, "entered")
now = read_solids("loaded", times_of("loaded")[-1])
verdict("loaded_massLoading", abs(entered[2]/exact - 1) < 5e-3
        and tally(log, "left")[0] > 0,
        f"{entered[2]/exact:.5f} of half the gas's mass flow")
verdict("loaded_stateOfTheGas", abs(now["U"][:, 0].mean()/800 - 1) < 0.02
        and abs(now["T"].mean()/500 - 1) < 0.03,
        f"{now['U'][:, 0].mean():.4g} m/s, {now['T'].mean():.4g} K")
verdict("loaded_balance", changes(log).max() < 1e-12,
        f"greatest changes {changes(log)}")

# --- grains at Kn 0.02, Re 20: force of Loth's law and heat of Kavanau's,
# written down once more, not those of single molecules, ten times as large
d, u, Tg, Tp, rho = 2e-4, 100., 300., 700., 0.0178
m, gamma, Pr = NITROGEN["mass"], 1.4, 4*1.4/(9*1.4 - 5)
omega = NITROGEN["omega"]
mu = (15*np.sqrt(np.pi*m*K*273)/(2*np.pi*NITROGEN["diameter"]**2
                                 * (5 - 2*omega)*(7 - 2*omega))
      * (Tg/273)**omega)
sound = np.sqrt(gamma*K*Tg/m)
M, Re = u/sound, rho*u*d/mu
kn = np.sqrt(np.pi*gamma/2)*M/Re
s = M*np.sqrt(gamma/2)
free = ((1 + 2*s**2)*np.exp(-s**2)/(np.sqrt(np.pi)*s**3)
        + (4*s**4 + 4*s**2 - 1)*math.erf(s)/(2*s**4)
        + 2/(3*s)*np.sqrt(np.pi*Tp/Tg))
J = 2.26 - 0.1/M + 0.14/M**3
C1 = (24/Re*(1 + 0.15*Re**0.687)
      / (1 + kn*(2.514 + 0.8*np.exp(-0.55/kn))))
C2 = free/(1 + (free/J - 1)*np.sqrt(Re/45))
force = np.pi/8*d**2*rho*u**2*(C1 + M**4*C2)/(1 + M**4)
Nu0 = 2 + 0.6*np.sqrt(Re)*Pr**(1/3)
Nu = Nu0/(1 + 3.42*Nu0*M/Re/Pr)
heat = np.pi*d*Nu*(3.5*K/m*mu/Pr)*(
    Tg*(1 + np.sqrt(Pr)*0.2*M**2) - Tp)
write_gas("dense", PERIODIC, (2, 2, 2), (0.01, 0.01, 0.01), weight=rho/m*1e-11,
          density=rho/m, T=Tg, U=(u, 0, 0), gas={"N2": NITROGEN},
          collisions="LarsenBorgnakkeVariableHardSphere",
          control={"deltaT": 1e-8, "endTime": 1e-8})
write_solids("dense", fill(1e-3, T=Tp, simulators=100)
             + "knudsenCorrection { drag lothDrag; heat kavanau; }\n",
             walls=None, diameters=(d,))
log = solve("dense")
number = 1e-9/(2700*np.pi/6*d**3)
gain = np.array(re.search(rf"solids gain: \({NUMBER} {NUMBER} {NUMBER}\) N,"
                          rf" {NUMBER} W", log).groups(), float)/number
verdict("dense_followsTheLaws", abs(gain[0]/force - 1) < 0.02
        and abs(gain[3]/heat - 1) < 0.02,
        f"Kn {kn:.3f}: force {gain[0]/force:.3f}, heat {gain[3]/heat:.3f} of"
        f" the laws'")
told = re.search(rf"force over the free-molecular one: {NUMBER}\n", log)
verdict("dense_reportsItsFactor", told is not None and abs(
    float(told.group(1))/(force/(np.pi/8*d**2*rho*u**2*free)) - 1) < 0.05,
        told.group(0).strip() if told else "nothing")
verdict("dense_balance", changes(log).max() < 1e-12,
        f"greatest changes {changes(log)}")

# With six molecules to a cell their chance counts as slip: said once
FEW = "in cells of less than 20 molecules"
write_gas("sparse", PERIODIC, (2, 2, 2), (0.01, 0.01, 0.01), weight=rho/m*2e-8,
          density=rho/m, T=Tg, U=(u, 0, 0), gas={"N2": NITROGEN},
          collisions="LarsenBorgnakkeVariableHardSphere",
          control={"deltaT": 1e-8, "endTime": 2e-8})
shutil.copy("dense/constant/solidParticleProperties", "sparse/constant")
sparse = solve("sparse")
verdict("sparse_isWarnedOf", FEW not in log and sparse.count(FEW) in (1, 2)
        and "100 % of the particles whose force" in sparse,
        " ".join(re.findall(".*" + FEW, sparse)))

# --- both phases in a closed box: balance, restart to the bit, two ranks
types = dict(PERIODIC, zMin="wall", zMax="wall")
CORRECTED = "knudsenCorrection { drag singhDrag; heat kavanau; }\n"
for name, exchange, more in (("box_perCell", "perCell", ""),
                             ("box_corrected", "perCell", CORRECTED),
                             ("box_perCollision", "perCollision", "")):
    write_gas(name, types, (4, 4, 4), (0.004, 0.004, 0.004), weight=5e11,
              density=1e23, T=400., gas={"N2": NITROGEN},
              collisions="LarsenBorgnakkeVariableHardSphere",
              wall="SpecularReflection",
              control={"deltaT": 1e-6, "endTime": 4e-5, "writeInterval": 20})
    write_solids(
        name, fill(5e-3, (300, 0, -100), 2000., 1000)
        + "sampling { fields (numberDensity U T exchange surface); }\n" + more,
        exchange=exchange, diameters=(1e-6, 2e-6))
    copy_case(name, name + "_parallel")
    log = solve(name)
    worst = changes(log)
    verdict(f"{name}_balance", worst.max() < 1e-12,
            f"greatest changes {worst} in 40 steps")

    names = times_of(name)
    copy_case(name, name + "_again")
    shutil.rmtree(f"{name}_again/{names[-1]}")
    solve(name + "_again")
    straight, again = (read_solids(c, names[-1])
                       for c in (name, name + "_again"))
    gas = [read_molecules(c, names[-1]) for c in (name, name + "_again")]
    same = (all(np.array_equal(straight[k], again[k]) for k in straight)
            and np.array_equal(gas[0][0], gas[1][0])
            and np.array_equal(gas[0][2]["U"], gas[1][2]["U"])
            and np.array_equal(gas[0][2]["Ei"], gas[1][2]["Ei"]))
    fields = largest(
        np.abs(read_field(f"{name}/{names[-1]}/{f}")
               - read_field(f"{name}_again/{names[-1]}/{f}")).max()
        / np.abs(read_field(f"{name}/{names[-1]}/{f}")).max()
        for f in ("U.solids", "T.solids0", "momentumRate.gas",
                  "energyRate.solids", "numberDensity.solids1"))
    verdict(f"{name}_restart", same and fields == 0,
            f"bits {'same' if same else 'differ'}, means differ by"
            f" {fields:.1e}")

    other = name + "_parallel"
    decompose(other, (2, 1, 1))
    log2 = solve(other, 2)
    copy_case(other, other + "_again")
    for rank in (0, 1):
        shutil.rmtree(f"{other}_again/processor{rank}/{names[-1]}")
    solve(other + "_again", 2)
    differ = [f"processor{rank}/{os.path.relpath(os.path.join(d, f), here)}"
              for rank in (0, 1)
              for here in [f"{other}/processor{rank}/{names[-1]}"]
              for d, _, files in os.walk(here) for f in files
              if not filecmp.cmp(os.path.join(d, f), os.path.join(
                  d.replace(other, other + "_again", 1), f), False)]
    verdict(f"{name}_twoRanksRestart", not differ,
            "every file is the same to the last bit" if not differ
            else "differ: " + " ".join(differ[:5]))
    must(other, "reconstructPar")
    worst = changes(log2)
    two = read_solids(other, times_of(other)[-1])
    means = [np.average(s["T"], weights=s["d"]**3*s["nParticle"])
             for s in (straight, two)]
    # All spheres have the same weight
    error = 5*np.sqrt((straight["T"].var() + two["T"].var())/2000)
    verdict(f"{name}_twoRanks", worst.max() < 1e-12 and len(two["T"]) == 2000
            and 2000 - means[0] > 2*error
            and abs(means[0] - means[1]) < error,
            f"greatest changes {worst}, {len(two['T'])} particles, mean"
            f" temperatures {means[0]:.6g} and {means[1]:.6g} K")

# --- a ledger is written and read: one molecule to a cell, which can take
# nothing back; perCollision takes it to the same bits, its spheres being light
states = {}
for exchange in ("perCell", "perCollision"):
    name = f"ledger_{exchange}"
    write_gas(name, PERIODIC, (4, 4, 4), (0.004, 0.004, 0.004),
              weight=1e14, density=1e23, T=400., gas={"N2": NITROGEN},
              collisions="LarsenBorgnakkeVariableHardSphere",
              control={"deltaT": 1e-6, "endTime": 2e-5, "writeInterval": 10})
    write_solids(name, fill(5e-3, (300, 0, -100), 2000., 1000),
                 exchange=exchange, walls=None, diameters=(1e-6, 2e-6))
    log = solve(name)
    names = times_of(name)
    copy_case(name, name + "_again")
    shutil.rmtree(f"{name}_again/{names[-1]}")
    solve(name + "_again")
    straight, again = (read_solids(c, names[-1])
                       for c in (name, name + "_again"))
    owed = [read_field(f"{c}/{names[-1]}/solidLedgerEnergy")
            for c in (name, name + "_again")]
    gas = [read_molecules(c, names[-1])[2] for c in (name, name + "_again")]
    same = (all(np.array_equal(straight[k], again[k]) for k in straight)
            and np.array_equal(*owed)
            and all(np.array_equal(gas[0][k], gas[1][k]) for k in gas[0]))
    states[exchange] = straight
    verdict(f"{name}_restart", same and np.count_nonzero(owed[0]) > 5
            and changes(log).max() < 1e-12
            and ("stand for so few" in log) == (exchange == "perCollision"),
            f"bits {'same' if same else 'differ'},"
            f" {np.count_nonzero(owed[0])} cells owed, greatest changes"
            f" {changes(log)}")
copy_case("ledger_perCell", "ledgerDropped")
edit("ledgerDropped", "constant/solidParticleProperties",
     "exchange perCell", "exchange none")
edit("ledgerDropped", "system/controlDict", "endTime 2e-05", "endTime 2.1e-05")
energy = re.search(rf"The ledger of \S+ holds \({NUMBER} {NUMBER} {NUMBER}\)"
                   rf" kg m/s and {NUMBER} J that",
                   " ".join(solve("ledgerDropped").split()))
owed = read_field(f"ledger_perCell/{names[-1]}/solidLedgerEnergy").sum()
verdict("ledger_droppedWithAWarning", energy is not None
        and abs(float(energy.group(4))/owed - 1) < 1e-5,
        f"{energy and energy.group(4)} J of {owed:.6g}")
verdict("ledger_lightSpheres", all(
    np.array_equal(states["perCell"][k], states["perCollision"][k])
    for k in states["perCell"]), "exchange as with perCell")

# --- the rates that the fields hold are those of the particles
end = times_of("box_perCollision")[-1]
V = 0.004**3/64
for kind, k in (("momentumRate", 0), ("energyRate", None)):
    solids, gas = (read_field(f"box_perCollision/{end}/{kind}.{p}")
                   for p in ("solids", "gas"))
    scale = np.abs(solids).max()
    verdict(f"box_{kind}_isOpposite", np.abs(solids + gas).max() < 1e-10*scale,
            f"greatest sum {np.abs(solids + gas).max()/scale:.1e}")
s = read_solids("box_perCell", end)
m = 2700*np.pi/6*s["d"]**3*s["nParticle"]
gained = (m[:, None]*(s["U"] - [300, 0, -100])).sum(axis=0)
rate = read_field(f"box_perCell/{end}/momentumRate.solids").sum(axis=0)*V*4e-5
verdict("box_ratesOfParticles", abs(rate[0]/gained[0] - 1) < 1e-8,
        f"{rate[0]/gained[0]:.10f} of the momentum gained along x")

# --- a fill in a box, a run without the file
write_gas("part", PERIODIC, (4, 4, 4), (0.004, 0.004, 0.004), **THIN,
          collisions="none", control={"deltaT": 1e-9, "endTime": 1e-9})
write_solids("part", fill(1e-3, region="region box;"
                          " box (0 0 0) (0.002 0.004 0.004);"),
             exchange="none", walls=None)
log = solve("part")
s = read_solids("part", times_of("part")[-1])
total = (2700*np.pi/6*s["d"]**3*s["nParticle"]).sum()
verdict("part_fill", s["x"][:, 0].max() < 0.002
        and abs(total/(1e-3*0.002*0.004**2) - 1) < 1e-9
        and len(s["T"]) == 200, f"{len(s['T'])} particles, {total:.6g} kg")
os.remove("part/constant/solidParticleProperties")
shutil.rmtree(f"part/{times_of('part')[-1]}")
log = solve("part")
verdict("part_withoutSolids", "Solid particles: none" in log,
        "the log says that there are none")

# --- as many on any number of ranks, also where each has its share of a few
write_gas("few", PERIODIC, (4, 4, 4), (0.004, 0.004, 0.004), **THIN,
          collisions="none", control={"deltaT": 1e-9, "endTime": 1e-9})
one = ("{ region all; concentration 1e-3; velocity (0 0 0);"
       " temperature 300; simulators 3; }\n")
write_solids("few", f"fills {{ a {one} b {one} c {one} }}\n",
             exchange="none", walls=None)
copy_case("few", "fewTwo")
decompose("fewTwo", (2, 1, 1))
filled = [tally(solve(c, n), "initial") for c, n in (("few", 1),
                                                     ("fewTwo", 2))]
verdict("fills_onTwoRanks", filled[0][0] == 18
        and np.allclose(*filled, rtol=1e-13, atol=0)
        and abs(filled[0][2]/(3*1e-3*0.004**3) - 1) < 1e-9,
        f"{filled[0]} and {filled[1]}")

# --- a fill is put in once, also if all of it has gone
for name, wall, fate in (("gone", "patch", "left"), ("kept", "wall", "stuck")):
    write_gas(name, dict(PERIODIC, xMin="patch", xMax=wall), (2, 2, 2),
              (0.004, 0.004, 0.004), **THIN, collisions="none",
              control={"deltaT": 1e-5, "endTime": 4e-5, "writeInterval": 2})
    write_solids(name, fill(1e-6, (500, 0, 0), simulators=10),
                 walls="stick" if wall == "wall" else None, exchange="none")
    solve(name)
    shutil.rmtree(f"{name}/{times_of(name)[-1]}")
    log = solve(name)
    verdict(f"{name}_onceOnly", tally(log, fate)[0] == 20
            and tally(log, "initial")[0] == 20 and "lost: 0, now: 0" in log,
            f"{tally(log, 'initial')[0]:.0f} at the start,"
            f" {tally(log, fate)[0]:.0f} {fate}")
