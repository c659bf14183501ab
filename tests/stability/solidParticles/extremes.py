# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Extreme gases with solid particles. All must end with finite states, keep
momentum and energy of gas + solids + ledger to 1e-12 in every step, leave no
sphere without its heat, and say what waits in the ledger."""

import os
import re

import numpy as np

from caseTools import edit, must, read_field, run, times_of, write_foam
from dsmcTools import NITROGEN, write_gas
from solidTools import changes, fill, read_solids, write_solids

PERIODIC = dict.fromkeys(("xMin", "xMax", "yMin", "yMax", "zMin", "zMax"),
                         "cyclic")
L, CELLS = 0.004, 4
STEPS = 200


def spin(case, omega, deltaT):
    """Give the spheres of a case a spin about y after their first step."""
    control = "system/controlDict"
    whole = f"endTime {STEPS*deltaT};", f"writeInterval {STEPS};"
    first = f"endTime {deltaT};", "writeInterval 1;"
    for old, new in zip(whole, first):
        edit(case, control, old, new)
    must(case, "dsmcParcelFoam")
    for old, new in zip(first, whole):
        edit(case, control, old, new)
    time = times_of(case)[-1]
    n = len(read_solids(case, time)["d"])
    write_foam(case, f"{time}/lagrangian/solids/omega",
               f"{n}\n(\n" + f"(0 {omega} 0)\n"*n + ")", "vectorField")
    os.remove(f"{case}/{time}/uniform/complete")


def row(name, expected, Tg=400., Tp=2000., loading=1., weight=None, each=100,
        exchange="perCell", density=1e23, perCell=30, U=(300, 0, -100),
        diameters=(3e-6, 6e-6), deltaT=1e-6, holds=None, omega=None,
        collisions="LarsenBorgnakkeVariableHardSphere"):
    """One case: perCell simulated molecules to a cell, 'each' simulated
    spheres of each group; weight: real molecules over real spheres; omega:
    spin at the start [rad/s]."""
    case = re.sub(r"\W+", "_", name)
    gasWeight = density*L**3/(CELLS**3*perCell)
    concentration = loading*density*NITROGEN["mass"]
    if weight is not None:
        # As many spheres to a simulator as the ratio asks for
        sphere = 2700*np.pi/6*diameters[0]**3
        number = gasWeight/weight
        concentration = number*each*len(diameters)*sphere/L**3
    write_gas(case, PERIODIC, (CELLS,)*3, (L,)*3, weight=gasWeight,
              density=density, T=Tg, gas={"N2": NITROGEN},
              collisions=collisions,
              control={"deltaT": deltaT, "endTime": STEPS*deltaT})
    write_solids(case, fill(concentration, U, Tp, each)
                 + ("rotation yes;\n" if omega else ""),
                 exchange=exchange, walls=None, diameters=diameters)
    if omega:
        spin(case, omega, deltaT)
    status, log = run(case, "dsmcParcelFoam")
    worst = changes(log)
    end = times_of(case)[-1]
    held = [int(x) for x in
            re.findall(r"with an entry in the steps: (\d+)", log)]
    good = status == 0 and worst.max() < 1e-12
    text = f"exit status {status}, greatest changes {worst.max():.1e}"
    if status == 0:
        s = read_solids(case, end)
        speed = np.sqrt((s["U"]**2).sum(axis=1)).max()
        good = (good and np.all(np.isfinite(s["U"]))
                and s["T"].min() > 0.1*min(Tg, Tp)
                and np.isfinite(s["T"].max()))
        text += (f", spheres at {s['T'].min():.4g} to {s['T'].max():.4g} K,"
                 f" up to {speed:.4g} m/s")
        if omega:
            left = read_field(f"{case}/{end}/lagrangian/solids/omega")
            left = np.sqrt((left**2).sum(axis=1)).max()
            good = good and left < 1.1*omega
            text += f", spinning at up to {left:.4g} rad/s"
        byCell = re.search(r"(\d+) of \d+ simulated particles stand", log)
        if byCell:
            text += f", {byCell[1]} of them exchange by the cell"
        if exchange == "perCell":
            text += f", ledger used in {sum(held)} cell-steps"
            good = good and len(held) == (STEPS - 1 if omega else STEPS)
            if holds is not None:
                good = good and (sum(held) > 0) == holds
    print(f"{name} | {expected} | {text} | {'ok' if good else 'FAILED'}",
          flush=True)


KEPT = ("finite, none below a tenth of the lower temperature, kept to 1e-12 in"
        " each step")
for exchange in ("perCell", "perCollision"):
    for loading in (0.01, 1., 10.):
        row(f"mass loading {loading:g}, {exchange}", KEPT, loading=loading,
            exchange=exchange)
    for weight in (1., 1e5, 1e10):
        row(f"{weight:g} molecules to a sphere of 3 nm, {exchange}", KEPT,
            weight=weight, diameters=(3e-9,), deltaT=1e-7, exchange=exchange)
    row(f"spheres 100 times as hot as the gas, {exchange}", KEPT, Tg=100.,
        Tp=1e4, exchange=exchange)
    row(f"spheres 100 times as cold as the gas, {exchange}", KEPT, Tg=1e4,
        Tp=100., exchange=exchange, deltaT=2e-7)
    row(f"one molecule to a cell or none, {exchange}",
        KEPT + ("; the ledger is used" if exchange == "perCell" else ""),
        perCell=1, exchange=exchange, loading=5.,
        holds=True if exchange == "perCell" else None)
    row(f"a sphere heavier than all gas of its cell, {exchange}", KEPT,
        loading=100., each=10, exchange=exchange)
    # m/(dF/dv) is 1.5e-6 s; without collisions, of which there would be many
    row(f"step of 13 relaxation times (spheres of 3 nm), {exchange}", KEPT,
        diameters=(3e-9,), loading=0.01, deltaT=2e-5, collisions="none",
        exchange=exchange)
    row(f"spin of 1e9 rad/s, rims at 1500 m/s and more, {exchange}", KEPT
        + "; spins grow by a tenth at most", exchange=exchange, omega=1e9)
    row(f"the same spheres 1000 times as small, step of 13 relaxation times,"
        f" {exchange}", KEPT + "; spins grow by a tenth at most", diameters=(3e-9,),
        loading=0.01, deltaT=2e-5, collisions="none", exchange=exchange,
        omega=1e12)
