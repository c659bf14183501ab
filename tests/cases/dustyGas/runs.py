# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Grains that exchange momentum and heat with a gas in a box without ends:
the common state, order in time, account of energies, radiation, melting,
collisions, restart, ranks, bad input. Stands in a temporary folder."""

import csv
import filecmp
import os
import re

import numpy as np

from caseTools import (GAMMA, copy_case, decompose, edit, largest,
                       last_fields, must, read_field, refuses, run, solve,
                       times_of, verdict, write_block, write_field, write_foam)
from caseTools import box as corners
from dust import (CP, CP_P, dust_energy, exchange, prandtl, read_dust, sealed,
                  state)

U0, T0, TD = (300., 20., 0.), 500., 300.
VOLUME = 4e-9


def gas_energy(case, time=None):
    rho, u, p, T = last_fields(case, "rho U p T", time)
    return VOLUME/len(rho)*np.sum(rho*(CP - p/(rho*T))*T
                                  + 0.5*rho*np.sum(u**2, axis=1))


def common(case, loading, v=(0, 0, 0), enthalpy=None):
    """Velocity and temperature of both in the end, with the solver's own
    gas constant; enthalpy of the grains as a function of T."""
    rho, p, T, _ = state(case)
    R = p/(rho*T)
    cv = CP - R
    start = 1e5/(R*T0)
    loading = loading*DENSITY/start
    enthalpy = enthalpy or (lambda T: CP_P*T)
    u, v = np.asarray(U0), np.asarray(v, float)
    w = (u + loading*v)/(1 + loading)
    have = (cv*T0 + 0.5*u @ u + loading*(enthalpy(TD) + 0.5*v @ v)
            - 0.5*(1 + loading)*w @ w)
    low, high = 1., 1e4
    for _ in range(200):
        mid = 0.5*(low + high)
        more = cv*mid + loading*enthalpy(mid) > have
        low, high = (low, mid) if more else (mid, high)
    return w, low


DENSITY = 1e5/(287.05*T0)

# The common state, whatever the loading, the grains and the step
for name, loading, d, steps, dt in (
        ("stiff", 10, 1e-7, 8, 1e-5), ("equal", 1, 1e-6, 40, 1e-5),
        ("slow", 0.3, 1e-5, 40, 1e-3), ("little", 0.01, 3e-7, 20, 2e-5),
        ("much", 100, 1e-7, 12, 1e-5)):
    sealed(name, loading, d, steps, dt, u=U0, T=T0, T_dust=TD)
    solve(name)
    w, T = common(name, loading)
    _, _, found, u = state(name)
    off = np.abs(u - w).max()/np.linalg.norm(w), abs(found/T - 1)
    verdict("sealed_" + name, largest(off) < 1e-10,
            "loading %g, %g um, %g s: velocity off by %.1e, temperature by "
            "%.1e" % (loading, 1e6*d, dt, *off))

# One step of a stiff exchange is the end of it
sealed("one", 10, 1e-7, 1, 1e-5, u=U0, T=T0, T_dust=TD)
solve("one")
w, T = common("one", 10)
_, _, found, u = state("one")
off = np.abs(u - w).max()/np.linalg.norm(w), abs(found/T - 1)
verdict("one_step", off[0] < 1e-10 and off[1] < 1e-3,
        "130 relaxation times in a step: velocity off by %.1e, temperature "
        "by %.1e" % off)

# Order in time against the differential equations
for name, loading, d, end in (("order", 1, 1e-5, 4e-4),
                              ("orderHeavy", 5, 3e-6, 6e-5)):
    errors = []
    for n in (2, 4, 8, 16):
        case = f"{name}{n}"
        sealed(case, loading, d, n, end/n, u=U0, T=T0, T_dust=TD)
        solve(case)
        rho, p, T, u = state(case)
        exact = exchange(loading*DENSITY/rho, d, end, U0, (0, 0, 0), T0, TD,
                         p/(rho*T), rho)
        errors.append((np.abs(u - exact[0]).max()/300,
                       abs(T - exact[1])/200))
        must(".", "rm", "-rf", case)
    orders = np.log2(np.array(errors[:-1])/np.array(errors[1:]))
    verdict(name + "_in_time",
            np.all(orders[1:] > 0.8) and largest(errors[-1]) < 5e-3,
            "errors of u and T with 2 to 16 steps: " + ", ".join(
                "%.1e %.1e" % e for e in errors)
            + "; orders " + ", ".join("%.2f %.2f" % tuple(o) for o in orders))

# Grains that the gas does not feel, in a gas that does not change: exact for
# any step. A stock injection moves what it injects, and the cloud moves it once
# more: one step too many, in stock clouds as well
def rake(cloud):
    first = cloud.index("            type manualInjection")
    last = cloud.index("        }\n    }\n    patchInteraction")
    return cloud[:first] + (
        "type rakeInjection; start (2e-4 1.05e-3 5e-4); end (1.8e-3 1.1e-3 5e-4);"
        " nParcels 20; nParticle 1; diameter 1e-5; U0 (0 0 0);\n"
    ) + cloud[last:]


errors = {}
for name, change in (("rake", rake), ("stockInjection", lambda c: c)):
    for n in (2, 16):
        case = f"{name}{n}"
        sealed(case, 1, 1e-5, n, 4e-4/n, u=U0, T=T0, T_dust=TD,
               mode={"mode": "frozen"}, change=lambda c: change(c).replace(
                   "coupled yes", "coupled no"))
        edit(case, "system/controlDict", "libs (spinningParcel)",
             "libs (spinningParcel parcelInjection)")
        solve(case)
        rho, p, T, _ = state(case)
        _, _, v, hot = exchange(1e-15, 1e-5, 4e-4, U0, (0, 0, 0), T0, TD,
                                p/(rho*T), rho)
        time = times_of(case)[-1]
        _, found, heat = read_dust(case, time)
        age = read_field(f"{case}/{time}/lagrangian/sand/age")
        errors[name, n] = (largest(np.abs(found - v[0]).max()/300,
                                   np.abs(heat - hot).max()/200),
                           np.abs(age*n/4e-4 - n).max())
        must(".", "rm", "-rf", case)
verdict("one_way", all(errors["rake", n][0] < 1e-8
                       and errors["rake", n][1] < 1e-9 for n in (2, 16)),
        "off by %.1e with 2 steps, %.1e with 16" % tuple(
            errors["rake", n][0] for n in (2, 16)))
verdict("one_way_stock_injection", all(
    abs(errors["stockInjection", n][1] - 1) < 1e-9 for n in (2, 16)),
        "one step older than the time, off by %.1e with 2 steps, %.1e with 16"
        % tuple(errors["stockInjection", n][0] for n in (2, 16)))

# Radiation leaves the box, and no more than the log says
material = "epsilon0 0.7; TSurroundings 400;"
sealed("radiating", 1, 1e-5, 200, 2.5e-4, u=U0, T=T0, T_dust=2500.,
       material=material)
edit("radiating", "system/controlDict", "writeInterval 0.05",
     "writeInterval 0.0025")
log = solve("radiating")
times = times_of("radiating")
lost = [float(w) for w in re.findall(r"gas, radiated += \S+, (\S+)", log)]
first, last = (gas_energy("radiating", t) + dust_energy("radiating", t)
               for t in (times[1], times[-1]))
gone = lost[-1] - lost[0]
verdict("radiation_is_accounted",
        # (1e-14 for the root of 1e5 steps of the gas)
        abs(first - last - gone) < 4e-12*first and gone > 0.05*first,
        "energy %.9g to %.9g J, radiated %.9g J, off by %.1e" % (
            first, last, gone, first - last - gone))
rho, p, T, u = state("radiating")
exact = exchange(DENSITY/rho, 1e-5, 0.05, U0, (0, 0, 0), T0, 2500.,
                 p/(rho*T), rho, 0.7, 400.)
verdict("radiation_temperature", abs(T/exact[1] - 1) < 1e-3,
        "%.3f K, by the differential equations %.3f K" % (T, exact[1]))

# Grains that melt: a common state within the range of melting and above it
for name, TG, latent in (("melts", 1500., 5e5), ("melted", 1500., 5e4)):
    T0 = TG
    DENSITY = 1e5/(287.05*T0)
    sealed(name, 1, 1e-6, 60, 1e-4, u=U0, T=T0, T_dust=TD,
           change=lambda c: c.replace(
               "Cp0 800;", "Cp0 (700 0.3); melting { solidus 600; liquidus"
               f" 610; latentHeat {latent}; }}"))
    solve(name)

    def enthalpy(T):
        return 700*T + 0.15*T*T + latent*min(max((T - 600)/10, 0), 1)
    w, T = common(name, 1, enthalpy=enthalpy)
    _, _, found, u = state(name)
    off = np.abs(u - w).max()/np.linalg.norm(w), abs(found/T - 1)
    verdict(name, largest(off) < 1e-9 and (600 < T < 610) == (name == "melts"),
            "common temperature %.3f K; off by %.1e, %.1e" % (T, *off))
T0 = 500.
DENSITY = 1e5/(287.05*T0)

# Two kinds of grains, each relaxed in a gas that the other has not changed
# yet, would take from it more than there is
sealed("two", 3, 1e-7, 60, 1e-5, u=U0, T=T0, T_dust=TD)
write_foam("two", "constant/parcelClouds", "clouds (sand ash);")
with open("two/constant/sandProperties") as file:
    text = file.read()
with open("two/constant/ashProperties", "w") as file:
    file.write(text.replace("sandProperties", "ashProperties"))
solve("two")
w, T = common("two", 6)
_, _, found, u = state("two")
off = np.abs(u - w).max()/np.linalg.norm(w), abs(found/T - 1)
verdict("two_clouds", largest(off) < 1e-10, "off by %.1e, %.1e" % off)


# Forces by the acceleration of the gas act on it, too: light grains in waves
x = (np.arange(20) + 0.5)/20
sealed("waves", 100, 2e-5, 60, 1e-7, u=U0, T=T0, T_dust=TD, cells=(20, 1),
       p=1e5*(1 + 0.5*np.sin(2*np.pi*x)), writes=2,
       drag="sphereDrag; pressureGradient { U U; }"
       " virtualMass { U U; Cvm 0.5; } SaffmanMeiLiftForce { U U; }",
       change=lambda cloud: cloud.replace("rho0 2500", "rho0 5"))
solve("waves")


def momentum(case, time):
    rho, u = last_fields(case, "rho U", time)
    folder = os.path.join(case, time, "lagrangian", "sand")
    d, n, rho_p, v = (read_field(os.path.join(folder, name))
                      for name in ("d", "nParticle", "rho", "U"))
    mass = n*rho_p*np.pi/6*d**3
    return (1e-9*np.sum(rho[:, None]*u, axis=0),
            np.sum(mass[:, None]*v, axis=0))


(gas0, dust0), (gas1, dust1) = (momentum("waves", t)
                                for t in times_of("waves")[1:])
moved = np.linalg.norm(dust1 - dust0)
off = np.linalg.norm(gas1 - gas0 + dust1 - dust0)/moved
verdict("gas_feels_its_acceleration", off < 1e-9 and moved > 1e-2*abs(gas0[0]),
        "of the momentum that grains in waves received the gas lost all but"
        " %.1e; it was %.2g of the gas' own" % (off, moved/abs(gas0[0])))
half = copy_case("waves", "wavesHalf")
for time in times_of(half)[2:]:
    must(".", "rm", "-rf", os.path.join(half, time))
solve(half)
verdict("acceleration_restarts", np.array_equal(
    *(read_dust(case, times_of(case)[-1])[1] for case in ("waves", half))),
        "to the bit")

# Parcels of a stock cloud have neither spin nor a number of impacts
begun = times_of(half)[1]
for name, lost in (("fromStock", ("omega", "nImpacts")),
                   ("incomplete", ("nImpacts",))):
    copy_case(half, name)
    must(".", "rm", "-rf", os.path.join(name, times_of(name)[-1]))
    os.remove(os.path.join(name, begun, "uniform", "complete"))
    for file in lost:
        os.remove(os.path.join(name, begun, "lagrangian", "sand", file))
solve("fromStock")
verdict("goes_on_from_a_stock_cloud", np.array_equal(
    *(read_dust(case, times_of(case)[-1])[1] for case in (half, "fromStock"))),
        "to the bit")
refuses("lost_number_of_impacts_is_refused",
        run("incomplete", "rhoCentralParcelFoam"), ["nImpacts"])

# In the first step, too: grains at rest in a gas that was, and nothing else
sealed("firstStep", 1, 2e-5, 1, 1e-7, u=(0, 0, 0), T=T0, T_dust=T0,
       cells=(20, 1), p=1e5*(1 + 0.5*np.sin(2*np.pi*x)),
       drag="pressureGradient { U U; }",
       change=lambda cloud: cloud.replace("rho0 2500", "rho0 5"))
solve("firstStep")
rho, u = last_fields("firstStep", "rho U")
wanted = rho*u[:, 0]/5
_, v, _ = read_dust("firstStep", times_of("firstStep")[-1])
off = np.abs(v - wanted).max()/wanted.max()
verdict("acceleration_of_the_first_step", off < 1e-2,
        "velocities off by %.1e of the largest" % off)

# Sources spread over a length: the kernel of one implicit step on a periodic
# line, the totals, ranks. So short a step that the gas does not carry it on
def spread_out(case, length, steps=1, dt=1e-12, number=None, cells=(40, 1),
               place="0.0105 0.0005 0.0005"):
    sealed(case, 1, 1e-7, steps, dt, u=U0, T=T0, T_dust=TD,
           cells=cells, number=number, writes=min(steps, 2))
    write_foam(case, "constant/positions", f"(({place}))", "vectorField")
    if length:
        write_foam(case, "constant/parcelClouds",
                   f"clouds (sand); sourceSmoothing {length!r};")


GRAINS = 100*1e-9*DENSITY/(2500*np.pi/6*1e-21)
for name, length in (("pointed", 0), ("spread", 0.003), ("bare", 0)):
    spread_out(name, length, number=GRAINS if name != "bare" else 1e-12*GRAINS)
    solve(name)


def received(case):
    """Momentum along x and y [kg m/s] and energy [J] of each cell."""
    fields = [np.reshape(q, (-1, w)) for w, q in zip(
        (1, 1, 1, 3), last_fields(case, "rho p T U"))]
    n = max(map(len, fields))
    rho, p, T, u = (np.full((n, q.shape[1]), q) for q in fields)
    rho, p, T = rho[:, 0], p[:, 0], T[:, 0]
    e = (CP - p/(rho*T))*T + 0.5*np.sum(u**2, axis=1)
    return 1e-9*np.column_stack((rho*u[:, 0], rho*u[:, 1], rho*e))


bare = received("bare")
pointed, wide = (received(case) - bare for case in ("pointed", "spread"))
line = np.eye(40)
laplace = np.roll(line, 1, 0) + np.roll(line, -1, 0) - 2*line
kernel = np.linalg.solve(line - 0.5*(0.003/0.001)**2*laplace, line[10])
off = np.abs(wide/pointed[10] - kernel[:, None]).max()
total = np.abs(wide.sum(axis=0) - pointed.sum(axis=0))/bare.sum(axis=0)
x = np.arange(40) - 10.
width = np.sqrt(np.sum(kernel[:21]*x[:21]**2)/np.sum(kernel[:21]))
verdict("smoothing", off < 1e-5*kernel.max() and total.max() < 1e-14,
        "off the exact spread (%.2g of the source in the cell of the grain,"
        " deviation %.2f cells of 3) by %.1e; totals of momentum and energy"
        " by %.1e of the gas'" % (kernel[10], width, off, total.max()))

# The same in space, where the kernel is known by its transform
N = 12
for name, length in (("pointedBox", 0), ("spreadBox", 0.002), ("bareBox", 0)):
    spread_out(name, length, number=GRAINS if name != "bareBox"
               else 1e-12*GRAINS, cells=(N, N, N), place="0.0055 0.0035 0.0075")
    solve(name)
bare = received("bareBox")
pointed, wide = (received(case) - bare for case in ("pointedBox", "spreadBox"))
here = 5 + N*(3 + N*7)
wave = 4*np.sin(np.pi*np.arange(N)/N)**2
damping = 1 + 0.5*2**2*(wave[:, None, None] + wave[None, :, None] + wave)
source = np.zeros(N**3)
source[here] = 1
kernel = np.fft.ifftn(np.fft.fftn(source.reshape(N, N, N))/damping).real.ravel()
off = np.abs(wide/pointed[here] - kernel[:, None]).max()
total = np.abs(wide.sum(axis=0) - pointed.sum(axis=0))/bare.sum(axis=0)
verdict("smoothing_in_space",
        off < 1e-5*kernel.max() and total.max() < 1e-14,
        "off the exact spread (%.2g of the source in the cell of the grain) by"
        " %.1e; totals of momentum and energy by %.1e of the gas'" % (
            kernel.max(), off, total.max()))

spread_out("spreadSerial", 0.003, 10, 1e-7, 1e-2*GRAINS)
ranks = copy_case("spreadSerial", "spreadRanks")
half = copy_case("spreadSerial", "spreadHalf")
solve("spreadSerial")
decompose(ranks)
solve(ranks, 2)
must(ranks, "reconstructPar", "-latestTime")
apart = largest(np.abs(a - b).max()/np.abs(b).max() for a, b in zip(
    last_fields("spreadSerial", "T p U"), last_fields(ranks, "T p U")))
must(".", "rm", "-rf", ranks)
verdict("smoothing_on_ranks", apart < 1e-12,
        "two ranks differ from one by %.1e" % apart)
edit(half, "system/controlDict", "endTime 1e-06", "endTime 5e-07")
solve(half)
edit(half, "system/controlDict", "endTime 5e-07", "endTime 1e-06")
solve(half)
verdict("smoothing_restarts", all(
    np.array_equal(a, b) for a, b in zip(
        last_fields("spreadSerial", "T p U"), last_fields(half, "T p U"))),
        "to the bit")

# Stiff grains, everywhere and in one cell of ten times the mass of its gas:
# nothing leaves the range of what was there (but for waves of sound), and the
# energy is that without smoothing
energies = []
for name, length in (("heavy", 0), ("heavySpread", 0.003)):
    sealed(name, 10, 1e-7, 40, 5e-7, u=U0, T=np.repeat([500., 700.], 20),
           T_dust=TD, cells=(40, 1))
    if length:
        write_foam(name, "constant/parcelClouds",
                   f"clouds (sand); sourceSmoothing {length!r};")
    solve(name)
    energies.append(received(name)[:, 2].sum() + dust_energy(name))
spread_out("heavyCell", 0.003, 200, 5e-7, 0.1*GRAINS)
solve("heavyCell")
for name, hottest in (("heavySpread", 700), ("heavyCell", 1.05*T0)):
    u, T = last_fields(name, "U T")
    verdict("smoothing_" + name, u[:, 0].min() > 0 and u[:, 0].max() < 300
            and TD < T.min() and T.max() < hottest,
            "velocities %.4g to %.4g m/s, temperatures %.4g to %.4g K" % (
                u[:, 0].min(), u[:, 0].max(), T.min(), T.max()))
off = energies[1]/energies[0] - 1
verdict("smoothing_keeps_energy", abs(off) < 1e-12, "off by %.1e" % off)


# What collisions and walls of the box lose heats the grains
def colliding(cloud):
    return cloud.replace(
        "rotation off;", "rotation on; collisions { type eventDriven;"
        " restitution 0.6; friction 0.3; }")


sealed("colliding", 1, 3e-5, 40, 1e-5, u=U0, T=T0, T_dust=TD, per_cell=8,
       scatter=20., number=1e-3/3e-5, change=colliding)
edit("colliding", "system/controlDict", "writeInterval 0.0004",
     "writeInterval 2e-05")
log = solve("colliding")
times = [t for t in times_of("colliding") if float(t) > 0]
energies = np.array([(gas_energy("colliding", t), *dust_energy(
    "colliding", t, parts=True)) for t in times])
totals = energies.sum(axis=1)
pairs = re.findall(r"Pair, boundary events\s*= [^\n]*in all (\d+)", log)
verdict("collisions_close_the_account",
        np.ptp(totals) < 1e-12*totals[0] and pairs and int(pairs[-1]) > 10,
        "total %.12g J, range %.1e; pair collisions %s" % (
            totals[0], np.ptp(totals), pairs[-1:]))

# Restart to the bit, two ranks
case = copy_case("colliding", "half")
for t in times:
    must(case, "rm", "-rf", t)
end = times[-1]
edit(case, "system/controlDict", "endTime 0.0004", "endTime 0.0002")
solve(case)
edit(case, "system/controlDict", "endTime 0.0002", "endTime 0.0004")
solve(case)
folder = os.path.join(end, "lagrangian", "sand")
other = [n for n in sorted(os.listdir(os.path.join("colliding", folder)))
         if not filecmp.cmp(os.path.join("colliding", folder, n),
                            os.path.join(case, folder, n), False)]
verdict("restart_is_bitwise",
        not other and "T" in os.listdir(os.path.join(case, folder)),
        f"different: {other}")

# Each rank keeps the account of its own
ranks = copy_case("colliding", "collidingRanks")
for t in times:
    must(ranks, "rm", "-rf", t)
edit(ranks, "system/controlDict", "writeInterval 2e-05",
     "writeInterval 0.0004")
decompose(ranks)
log = solve(ranks, 2)
must(ranks, "reconstructPar", "-latestTime")
total = gas_energy(ranks, end) + dust_energy(ranks, end)
shared = re.findall(r"hand-overs between ranks = [^\n]*in all (\d+), (\d+)",
                    log)
off = abs(total/totals[-1] - 1), abs(
    dust_energy(ranks, end)/energies[-1, 1:].sum() - 1)
verdict("collisions_of_two_ranks_close_it",
        largest(off) < 1e-10 and shared and int(shared[-1][0]) > 0,
        "total differs by %.1e from that of one rank, grains by %.1e; pairs"
        " between ranks, hand-overs %s" % (*off, shared[-1:]))

sealed("straight", 3, 1e-6, 10, 1e-5, u=U0, T=T0, T_dust=TD, per_cell=5)
ranks = copy_case("straight", "ranks")
solve("straight")
decompose(ranks)
solve(ranks, 2)
must(ranks, "reconstructPar", "-latestTime")
apart = largest(np.abs(a/b - 1).max() for a, b in zip(
    last_fields("straight", "T p"), last_fields(ranks, "T p")))
grains = abs(dust_energy("straight")/dust_energy(ranks) - 1)
verdict("two_ranks", apart < 1e-12 and grains < 1e-12,
        "gas differs by %.1e, grains by %.1e" % (apart, grains))

# A run without temperatures goes on with them, from T0
cold = "cold"
sealed(cold, 3, 1e-6, 4, 1e-5, u=U0, T=T0, T_dust=TD,
       change=lambda c: c.replace("heatTransfer on", "heatTransfer off"))
solve(cold)
without = not os.path.exists(f"{cold}/{times_of(cold)[-1]}/lagrangian/sand/T")
edit(cold, "constant/sandProperties", "heatTransfer off", "heatTransfer on")
edit(cold, "system/controlDict", "endTime 4e-05", "endTime 8e-05")
log = solve(cold)
verdict("begins_at_T0", without and "begin at T0 300 K: 4" in log,
        "no file T without heat transfer, then T0")

# Stock parcels with a temperature, which keep no account of energy
def stock(cloud):
    for old, new in (
            ("spinningKinematicCloud", "basicThermoCloud"),
            ("coupled yes", "coupled no"), ("heatTransfer on;", ""),
            ("rotation off;", "maxCo 0.3;"),
            ("motion { type embeddedRK54; tolerance 1e-09; }", ""),
            ("{ U cellLinear; }", "{ rho cell; U cell; thermo:mu cell; T cell;"
             " Cp cell; kappa cell; p cell; }"),
            ("{ U Euler; }", "{ U Euler; T analytical; }"),
            ("sourceTerms { schemes { U explicit 1; } }", ""),
            ("Cp0 800;", "Cp0 800; epsilon0 1; f0 0.5;"),
            ("heatTransferModel ranzMarshall;", "radiation off;"
             " heatTransferModel RanzMarshall;"
             " RanzMarshallCoeffs { BirdCorrection off; }")):
        if old not in cloud:
            raise RuntimeError(old)
        cloud = cloud.replace(old, new)
    return cloud


sealed("stock", 0.1, 2e-5, 30, 1e-5, u=(0, 0, 0), T=500., T_dust=490.,
       mode={"mode": "frozen"}, change=stock)
solve("stock")
time = times_of("stock")[-1]
found = read_field(f"stock/{time}/lagrangian/sand/T")
kappa = 1.458e-6*np.sqrt(500)/(1 + 110.4/500)*CP/prandtl(CP - CP/GAMMA)
left = 10*np.exp(-6*2*kappa/(2500*(2e-5)**2*CP_P)*3e-4)
verdict("stock_thermo_cloud", 1 < left < 9 and np.all(
    np.abs((500 - found)/left - 1) < 0.02),
        "temperature of the gas less that of the grains %.4f K, by the"
        " relaxation %.4f" % (500 - found.mean(), left))
for name, old, new, words in (
        ("coupledStock", "coupled no", "coupled yes",
         ["coupled yes", "no account of the energy"]),
        ("radiatingStock", "radiation off", "radiation on",
         ["radiation on", "off"]),
        ("misspeltStock", "f0 0.5", "f00 0.5", ["Unknown entry f00", "f0"])):
    case = copy_case("stock", "bad")
    edit(case, "constant/sandProperties", old, new)
    refuses("refuses_" + name, run(case, "rhoCentralParcelFoam"), words)
    must(".", "rm", "-rf", case)

# What grains bring to a wall, beside what the gas brings
sealed("load", 1e-3, 1e-5, 20, 1e-6, u=(0, 0, 0), v=(0, -300, 0), T=500.,
       T_dust=900., per_cell=4, number=1.,
       mode={"mode": "frozen", "viscous": "yes"},
       change=lambda c: c.replace("coupled yes", "coupled no").replace(
           "standardWall", "hardSphereWall").replace(
           "WallInteraction;", "Wall;").replace(
           "WallInteractionCoeffs { type rebound; e 1; mu 0; }",
           "WallCoeffs { patches (\"y.*\" { type rebound; restitution 0.5;"
           " friction 0.1; }); }").replace(
           "cloudFunctions {}", "cloudFunctions { hits { type surfaceImpact;"
           " patches (yMin); log yes; heat { wallTemperature 400; } } }"))
L = 2e-3
write_block("load", corners((L, L, L/2)), (2, 2, 1),
            {"xMin": "cyclic", "xMax": "cyclic", "yMin": "wall",
             "yMax": "wall"})
must("load", "blockMesh")
sides = {"xMin": "type cyclic;", "xMax": "type cyclic;",
         "zMin": "type empty;", "zMax": "type empty;"}
for field, value, wall in (("p", 1e5, "zeroGradient"),
                           ("T", 500, "fixedValue; value uniform 400"),
                           ("U", (0, 0, 0), "noSlip")):
    write_field("load", field, value, {
        **sides, "yMin": f"type {wall};", "yMax": f"type {wall};"})
with open("load/system/controlDict", "a") as file:
    file.write("functions { heat { type wallHeatFlux; libs"
               " (fieldFunctionObjects); writeControl writeTime; } }\n")
edit("load", "system/controlDict", "libs (spinningParcel)",
     "libs (spinningParcel parcelWallInteraction)")
refuses("refuses_wallHeatFlux_without_model",
        run("load", "rhoCentralParcelFoam"),
        ("heat of type wallHeatFlux", "simulationType laminar"))
write_foam("load", "constant/turbulenceProperties", "simulationType laminar;")
log = solve("load")
time = times_of("load")[-1]


def on_wall(name):
    """The value on yMin, where it is the same everywhere."""
    return np.mean(read_field(f"load/{time}/{name}", "yMin"))


heat, power, incident, load, gas = (
    on_wall(n) for n in ("sand:hits:heatFlux", "sand:hits:specificPower",
                         "sand:hits:specificHeatIncident",
                         "sand:hits:heatLoad", "wallHeatFlux"))
mass = float(re.findall(r"impacts of particles, their mass = \S+, (\S+)",
                        log)[-1])
expected = mass*CP_P*500/(L*L/2*2e-5)
with open("load/postProcessing/hits/sand/0/impacts.csv") as file:
    logged = np.mean([float(r["T"]) - 400 for r in csv.DictReader(file)])
# With the viscosity of the gas, which is less at the wall
conduction = 1.458e-6*np.sqrt(500)/(1 + 110.4/500)*CP/0.69*100/(L/4)
verdict("heat_load", mass > 0 and abs(heat/power - 1) < 1e-12
        and 0.95 < incident/expected < 1
        and abs(incident/expected/(logged/500) - 1) < 1e-5
        and abs(load - (heat - gas)) < 1e-9*load
        and 0.8 < -gas/conduction < 1,
        "grains lose %.4g W/m2 and bring %.4g (%.4g if they did not cool on"
        " their way), the gas gives %.4g: load %.6g" % (
            heat, incident, expected, -gas, load))

# Bad input: words that the message must have
for name, old, new, words in (
        ("switch", "heatTransfer on", "heatTransfer maybe", ["maybe"]),
        ("motion", "motion { type embeddedRK54; tolerance 1e-09; }",
         "motion stock;", ["heatTransfer on", "embeddedRK54"]),
        ("model", "heatTransferModel ranzMarshall",
         "heatTransferModel ranzMarschall",
         ["Unknown heatTransferModel ranzMarschall", "Did you mean",
          "kavanau"]),
        ("entry", "heatTransferModel ranzMarshall;",
         "heatTransferModel { type fox; form original; }", ["form", "fox"]),
        ("recovery", "heatTransferModel ranzMarshall;",
         "heatTransferModel { type fox; recoveryFactor 3; }",
         ["recoveryFactor 3", "[0, 2]"]),
        ("noT0", "T0 300.0; ", "", ["T0"]),
        ("T0", "T0 300.0", "T0 -3", ["T0 -3", "(0, 1e8)"]),
        ("noCp", "Cp0 800; ", "", ["Cp0"]),
        ("Cp", "Cp0 800", "Cp0 (800 -1)", ["Cp0", "1 to 5000 K"]),
        ("Cp0", "Cp0 800", "Cp0 0", ["Cp0 0", "[0.001, 1e9]"]),
        ("emissivity", "Cp0 800;", "Cp0 800; epsilon0 2;",
         ["epsilon0 2", "[0, 1]"]),
        ("surroundings", "Cp0 800;", "Cp0 800; epsilon0 0.5;",
         ["TSurroundings"]),
        ("melting", "Cp0 800;", "Cp0 800; melting { solidus 900; liquidus"
         " 900; latentHeat 1e5; }", ["liquidus 900", "solidus"]),
        ("misspelt", "Cp0 800;", "Cp0 800; epsilon 0.5;",
         ["epsilon", "epsilon0"]),
        ("TwOverT", "sphereDrag;", "hendersonDrag { TwOverT 0.5; }",
         ["TwOverT", "temperatures of their own"])):
    case = copy_case("one", "bad")
    for t in times_of(case)[1:]:
        must(case, "rm", "-rf", t)
    edit(case, "constant/sandProperties", old, new)
    refuses("refuses_" + name, run(case, "rhoCentralParcelFoam"), words)
    must(".", "rm", "-rf", case)
