# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Gas and molten alumina in the diverging part of a nozzle, a steady gas and
particles in turn, against the quasi-one-dimensional equations of two phases;
account of the energy, restart, ranks, bad input. Stands in a temporary
folder.

    nozzle.py M loading diameter[um] [cells [all]]

With "all" restart, ranks and refusals are tried too.
"""

import os
import re
import sys

import numpy as np

import dust
from caseTools import (GAMMA, R_GAS, complaint, copy_case, decompose, edit,
                       largest, last_fields, must, run, same_bits, solve,
                       times_of, verdict, write_block, write_case,
                       write_field, write_foam)
from dust import CLOUD, CP, read_dust, relaxation

# Molten alumina
dust.RHO_P, dust.CP_P = 3000., 1888.
LENGTH, HEIGHT, RATIO = 0.2, 1e-3, 2.5
T0, P0 = 2200., 1e6


class Nozzle:
    """Gas and particles as functions of x, on a table."""

    def __init__(self, M, loading, d):
        self.loading, self.d = loading, d
        # (which a written field keeps to the bit)
        self.u0 = round(float(M*np.sqrt(GAMMA*R_GAS*T0)), 3)
        self.G = P0/(R_GAS*T0)*self.u0*HEIGHT      # per depth
        self.Gp = loading*self.G
        self.energy = self.G*(CP*T0 + self.u0**2/2) \
            + self.Gp*(dust.CP_P*T0 + self.u0**2/2)
        self.integrate()

    @staticmethod
    def area(x):
        return HEIGHT*(1 + (RATIO - 1)*x/LENGTH)

    def gas(self, x, y):
        """u, T, p of supersonic gas whose p A + G u is y[0]."""
        thrust, v, Tp = y
        A = GAMMA/(GAMMA - 1)*thrust
        B = self.energy - self.Gp*(dust.CP_P*Tp + v*v/2)
        C = (GAMMA + 1)/(GAMMA - 1)*self.G
        u = (A + np.sqrt(A*A - 2*C*B))/C
        p = (thrust - self.G*u)/self.area(x)
        return u, p*self.area(x)*u/(self.G*R_GAS), p

    def slope(self, x, y):
        thrust, v, Tp = y
        u, T, p = self.gas(x, y)
        k, heat, more = relaxation(self.d, abs(u - v), p/(R_GAS*T), T, R_GAS,
                                   Tp)
        dv = k*(u - v)/v
        return np.array([p*HEIGHT*(RATIO - 1)/LENGTH - self.Gp*dv, dv,
                         heat*(T + more - Tp)/v])

    def integrate(self):
        n = 4000
        h = LENGTH/n
        y = np.array([P0*HEIGHT + self.G*self.u0, self.u0, T0])
        table = [y]
        for i in range(n):
            x = i*h
            k1 = self.slope(x, y)
            k2 = self.slope(x + h/2, y + h/2*k1)
            k3 = self.slope(x + h/2, y + h/2*k2)
            k4 = self.slope(x + h, y + h*k3)
            y = y + h/6*(k1 + 2*k2 + 2*k3 + k4)
            table.append(y)
        self.x = np.linspace(0, LENGTH, n + 1)
        self.table = np.array(table)
        self.gases = np.array([self.gas(x, y)
                               for x, y in zip(self.x, self.table)])

    def at(self, x):
        """u, T, p, v, Tp at x."""
        return [np.interp(x, self.x, q)
                for q in (*self.gases.T, *self.table.T[1:])]

    def given(self):
        """Force and power of the particles on the gas, per depth."""
        _, v, Tp = self.table[-1]
        return -self.Gp*(v - self.u0), -self.Gp*(
            dust.CP_P*(Tp - T0) + 0.5*(v*v - self.u0**2))


def feedback(passage):
    """The annotated block with the times of this case."""
    path = os.path.join(os.environ["PARCEL_IMPACT_DIR"],
                        "etc/caseDicts/annotated/steadyFeedback")
    with open(path) as file:
        text = file.read()
    text = re.sub(r"//.*", "", text[text.rindex("feedback\n") + 8:])
    return re.sub(r"2e-4", repr(float(passage)), " ".join(text.split()))


def write(name, nozzle, d, cells, passages):
    depth = HEIGHT
    # A binary fraction: times are added up and written without rounding
    passage = np.ceil(LENGTH/nozzle.u0*2**16)/2**16
    dt = passage/64
    corners = [(x, s*nozzle.area(x)/2, z) for z in (0, depth)
               for x, s in ((0, -1), (LENGTH, -1), (LENGTH, 1), (0, 1))]
    write_case(name, {"endTime": passages*passage, "deltaT": dt,
                      "writeInterval": passages*passage, "timePrecision": 16,
                      "libs": "(spinningParcel parcelInjection)",
                      "writeFormat": "binary"},
               {"mode": "steady", "viscous": "no", "residual": 1e-8,
                "feedback": feedback(passage)})
    write_block(name, corners, (cells, 1, 1),
                {"xMin": "patch", "xMax": "patch", "yMin": "wall",
                 "yMax": "wall"})
    must(name, "blockMesh")
    for field, value in (("p", P0), ("T", T0), ("U", (nozzle.u0, 0, 0))):
        inlet = "(%r 0 0)" % float(nozzle.u0) if field == "U" else repr(value)
        wall = "slip" if field == "U" else "zeroGradient"
        write_field(name, field, value, {
            "xMin": f"type fixedValue; value uniform {inlet};",
            "xMax": "type zeroGradient;", "yMin": f"type {wall};",
            "yMax": f"type {wall};", "zMin": "type empty;",
            "zMax": "type empty;"})

    rho = P0/(R_GAS*T0)
    number = nozzle.loading*rho/(dust.RHO_P*np.pi/6*d**3)*LENGTH/1000 \
        *HEIGHT*depth
    a = CLOUD.index("        grains")
    b = CLOUD.index("    patchInteractionModel")
    cloud = (CLOUD[:a] + "drops\n{ type crossSectionInjection; arrival quiet;"
             f" volumeFraction {nozzle.loading*rho/dust.RHO_P!r};"
             f" diameter {d!r}; nParticle {number!r};"
             f" U0 ({nozzle.u0!r} 0 0); patches (xMin); }}\n    }}\n"
             + CLOUD[b:])
    for old, new in (("TOLERANCE", "1e-5"), ("T_DUST", repr(T0)),
                     ("MATERIAL", ""), ("DRAG", "sphereDrag;"),
                     ("HEAT", "ranzMarshall"), ("rho0 2500", "rho0 3000"),
                     ("Cp0 800", "Cp0 1888"),
                     ("standardWallInteraction;", "localInteraction;"),
                     ("standardWallInteractionCoeffs { type rebound; e 1;"
                      " mu 0; }",
                      "localInteractionCoeffs { patches ( \"x.*\" { type"
                      " escape; } \"y.*\" { type rebound; e 1; mu 0; } ); }")):
        cloud = cloud.replace(old, new)
    write_foam(name, "constant/parcelClouds", "clouds (sand);")
    write_foam(name, "constant/sandProperties", cloud)
    return passage


def main():
    M, loading, d = float(sys.argv[1]), float(sys.argv[2]), \
        1e-6*float(sys.argv[3])
    cells = int(sys.argv[4]) if len(sys.argv) > 4 else 200
    nozzle = Nozzle(M, loading, d)
    name = f"nozzle_{sys.argv[1]}_{sys.argv[2]}_{sys.argv[3]}"
    passage = write(name, nozzle, d, cells, 30)
    log = solve(name)
    x = (np.arange(cells) + 0.5)*LENGTH/cells
    rho, U, T = last_fields(name, "rho U T")
    ue, Te, _, _, _ = nozzle.at(x)
    xp, vp, Tp = read_dust(name, times_of(name)[-1])
    _, _, _, ve, Tpe = nozzle.at(xp)
    alone = Nozzle(M, 1e-9, d).at(x)
    errors = [100*np.mean(np.abs(a - b))/np.mean(b) for a, b in (
        (U[:, 0], ue), (T, Te), (vp, ve), (Tp, Tpe))]
    verdict(name, largest(errors) < 0.1,
            "L1 of gas and particles: velocities %.3f, %.3f %%, temperatures"
            " %.3f, %.3f %%; without particles the gas would be off by %.1f"
            " and %.1f %%" % (errors[0], errors[2], errors[1], errors[3],
                              100*np.mean(np.abs(alone[0] - ue)/ue),
                              100*np.mean(np.abs(alone[1] - Te)/Te)))
    rests = re.findall(r"in round (\d+).*rest", log)
    force, power = (np.sum(last_fields(name, n)[0], axis=0)/HEIGHT
                    for n in ("particleForce", "particlePower"))
    exact = nozzle.given()
    balance = float(re.findall(r"of total enthalpy (\S+)", log)[-1])
    verdict(name + "_account", "not steady" not in log
            and bool(rests) and abs(force[0]/exact[0] - 1) < 0.01
            and abs(power/exact[1] - 1) < 0.01 and abs(balance) < 1e-8,
            "rests in round %s; force %.5g N/m, by the equations %.5g; power"
            " %.5g W/m, by the equations %.5g; of the total enthalpy out of"
            " balance %.1e" % ((rests or ["none"])[-1], force[0], exact[0], power,
                               exact[1], balance))

    if len(sys.argv) <= 5:
        return

    # Stopped in an open window
    end = 3.75*passage
    straight, half, ranks = (copy_case(name, name + n)
                             for n in ("Straight", "Half", "Ranks"))
    for case in (straight, half, ranks):
        for time in times_of(case)[1:]:
            must(case, "rm", "-rf", time)
        edit(case, "system/controlDict", f"endTime {30*passage}",
             f"endTime {end}")
        edit(case, "system/controlDict", f"writeInterval {30*passage}",
             f"writeInterval {end}")
    log = solve(straight)
    verdict("unfinished_is_said", "The run has ended in round 2" in log,
            "warning of a run that ends before gas and particles rest")
    edit(half, "system/controlDict", f"endTime {end}",
         f"endTime {1.5*passage}")
    edit(half, "system/controlDict", f"writeInterval {end}",
         f"writeInterval {1.5*passage}")
    solve(half)
    edit(half, "system/controlDict", f"endTime {1.5*passage}",
         f"endTime {end}")
    edit(half, "system/controlDict", f"writeInterval {1.5*passage}",
         f"writeInterval {2.25*passage}")
    solve(half)
    names = "p T U rho particleForce particlePower particleForceSum" \
        " particlePowerSum"
    time = times_of(straight)[-1]
    other = same_bits(straight, half, time, names)
    other += same_bits(straight, half, f"{time}/lagrangian/sand", "U T")
    verdict("restart_in_a_window_is_bitwise", not other,
            f"different: {other}")
    decompose(ranks)
    solve(ranks, 2)
    must(ranks, "reconstructPar", "-latestTime")
    apart = largest(np.abs(a - b).max()/np.abs(a).max() for a, b in zip(
        last_fields(straight, "p T U particlePower"),
        last_fields(ranks, "p T U particlePower")))
    # To what is left of the imbalance, 1e-8 of a cell
    verdict("two_ranks", apart < 1e-6, "differ by %.1e" % apart)

    block = f"feedback {feedback(passage)};"
    path = os.path.join(straight, "system/fvSolution")
    with open(path) as file:
        text = file.read()
    for label, old, new, said in (
            ("no_block", block, "", "Add to the block highSpeedGas"),
            ("transient", "mode steady", "mode transient",
             "Valid: no block feedback"),
            ("frozen", "mode steady", "mode frozen", "Block feedback is for"),
            ("window", f"window {float(passage)!r}", "window 0", "valid range (0,"),
            ("no_window", f"window {float(passage)!r};", "", "window"),
            ("word", "tolerance", "tolerence", "Did you mean tolerance")):
        with open(path, "w") as file:
            file.write(text.replace(old, new))
        status, out = run(straight, "rhoCentralParcelFoam")
        verdict("refused_" + label, status != 0 and said in out
                and "fvSolution" in out, complaint(out))


if __name__ == "__main__":
    main()
