# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""A stream of Mach 3 without friction along a wall that turns away from it by
15 degrees at a sharp corner, against Prandtl and Meyer's expansion (Anderson,
Modern Compressible Flow, 4.14). A difference scheme leaves an error in the
cells next to the wall, which flows along it; none may take entropy from the
gas, and steady gas that is given much is warned of."""

import re

import numpy as np
from caseTools import (GAMMA, R_GAS, last_fields, must, solve, verdict,
                       write_case, write_field, write_foam)

P, T, MACH = 26500.0, 223.25, 3.0
TURN = np.radians(15)
SOUND = np.sqrt(GAMMA*R_GAS*T)
BEFORE, BEHIND, NY = 10, 50, 40


def expanded():
    """Pressure and temperature behind the corner, in those before it."""
    k = np.sqrt((GAMMA + 1)/(GAMMA - 1))

    def angle(M):
        beta = np.sqrt(M*M - 1)
        return k*np.arctan(beta/k) - np.arctan(beta)

    low, M = MACH, 50.0
    for _ in range(100):
        middle = 0.5*(low + M)
        low, M = ((middle, M) if angle(middle) < angle(MACH) + TURN
                  else (low, middle))
    ratio = ((1 + 0.5*(GAMMA - 1)*MACH**2)/(1 + 0.5*(GAMMA - 1)*M*M))
    return ratio**(GAMMA/(GAMMA - 1)), ratio


def case(name, mode, flux, turn=TURN, mach=MACH):
    speed = mach*SOUND
    end = 5/speed if mode == "transient" else 1
    write_case(name, {"endTime": end, "deltaT": 1e-3*end, "writeInterval": end,
                      "adjustTimeStep": "yes", "maxCo": 0.4, "maxDeltaT": 1,
                      "writeControl": "adjustableRunTime"}
               if mode == "transient" else
               {"endTime": 1, "deltaT": 1, "writeInterval": 1},
               {"mode": mode}, flux,
               "vanLeer" if mode == "transient" else "vanAlbada")
    below = -np.tan(turn)
    plane = [(-0.2, 0), (0, 0), (1, below), (-0.2, 1), (0, 1), (1, 1)]
    write_foam(name, "system/blockMeshDict", f"""
scale 1;
vertices ({' '.join(f'({x!r} {y!r} {z})' for z in (0, 0.1)
                    for x, y in plane)});
blocks
(
    hex (0 1 4 3 6 7 10 9) ({BEFORE} {NY} 1) simpleGrading (1 1 1)
    hex (1 2 5 4 7 8 11 10) ({BEHIND} {NY} 1) simpleGrading (1 1 1)
);
edges ();
boundary
(
    inlet {{ type patch; faces ((0 3 9 6)); }}
    outlet {{ type patch; faces ((2 5 11 8) (3 4 10 9) (4 5 11 10)); }}
    wall {{ type wall; faces ((0 1 7 6) (1 2 8 7)); }}
    sides {{ type empty; faces ((0 1 4 3) (1 2 5 4) (6 7 10 9) (7 8 11 10)); }}
);""")
    for field, value in ("p", P), ("T", T), ("U", (speed, 0, 0)):
        uniform = (f"({speed!r} 0 0)" if field == "U" else repr(value))
        write_field(name, field, value, {
            "inlet": f"type fixedValue; value uniform {uniform};",
            "outlet": "type zeroGradient;",
            "wall": "type slip;" if field == "U" else "type zeroGradient;",
            "sides": "type empty;"})
    must(name, "blockMesh")
    return name


def at_wall(name):
    p, t = (f[BEFORE*NY:].reshape(NY, BEHIND)[0]
            for f in last_fields(name, "p T"))
    return p/P, t/T


exact_p, exact_T = expanded()
for mode, flux, hot in (("transient", "HLLC", 0.05),
                        ("transient", "Kurganov", 0.05),
                        ("steady", "HLLC", 0.15)):
    name = f"{mode}_{flux}"
    solve(case(name, mode, flux))
    p, t = at_wall(name)
    entropy = (t/p**((GAMMA - 1)/GAMMA)).min()
    least, last = p.min()/exact_p, p[-1]/exact_p
    verdict(f"sharpCorner_{name}",
            0.6 < least < 1.02 and abs(last - 1) < 0.01
            and abs(t[-1]/exact_T - 1) < hot and entropy > 0.97,
            f"at the wall, in parts of Prandtl and Meyer's: least p"
            f" {least:.3f} (0.6 to 1.02), at the outlet p {last:.4f}"
            f" (1 %), T {t[-1]/exact_T:.3f} ({100*hot:g} %); least entropy in"
            f" the stream's {entropy:.3f} (0.97)")

# What is said of steady gas that gains entropy while it expands, in the cells
# at the wall by more than a tenth, against the largest that they have
log = solve(case("steady_weak", "steady", "HLLC", np.radians(8)))
verdict("weakExpansion_is_not_warned_of", "has expanded" not in log,
        "corner of 8 degrees")
p, t = at_wall("steady_HLLC")
largest = (t/p**((GAMMA - 1)/GAMMA)).max() - 1
with open("steady_HLLC/log.rhoCentralParcelFoam", encoding="utf-8") as file:
    said = re.search(r"In (\d+) cells gas that has expanded is hotter .* by up"
                     r" to (\S+) %", file.read())
told = float(said[2])/100 if said else np.nan
verdict("expansion_is_warned_of", 0.5*largest < told < 1.1*largest,
        f"{told:.3f} of the temperature; largest entropy at the wall"
        f" {largest:.3f} above the stream's")

# In time: of gas that has lost entropy, by how much
log = solve(case("transient_fast", "transient", "HLLC", mach=8))
p, t = (f/at for f, at in zip(last_fields("transient_fast", "p T"), (P, T)))
least = (t/p**((GAMMA - 1)/GAMMA)).min()
said = re.search(r"less entropy than .* up to (\S+) % too cold", log)
told = float(said[1])/100 if said else np.nan
with open("transient_HLLC/log.rhoCentralParcelFoam", encoding="utf-8") as file:
    silent = "less entropy" not in file.read()
verdict("loss_of_entropy_is_warned_of",
        silent and abs(told - (1 - least)) < 1e-3 and least < 0.8,
        f"Mach 8: {told:.4f}, by the fields {1 - least:.4f}; Mach 3: silence")
