# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""The gas, the measured points, and the states that are computed."""

import csv
import math

R, T, P = 8314.46261815324/28.96523277, 300.0, 1e5
CP = 1004.675
GAMMA = CP/(CP - R)
RHO = P/(R*T)
MU = 1.458e-6*T**1.5/(T + 110.4)
SOUND = math.sqrt(GAMMA*R*T)
DELTA_T = 1e-9
# Where the sources have incompressible flow
SLOW = 1e-3
# Beyond, the boundary layer becomes turbulent: no law here knows of it
RE_MAX = 2e5
# Below, points of the digitised curve lie under Stokes' law (half of it at
# Re 0.1), which nothing can
RE_MIN = 1


def rows(name):
    """Numbers of a table, without its head."""
    with open("measured/" + name) as file:
        for row in csv.reader(line for line in file if line[0] != "#"):
            try:
                yield [float(x) for x in row if x.strip()]
            except ValueError:
                pass


def measured():
    """By source: points (Re, M, Cd)."""
    return {
        "Roos & Willmarth": [(re, SLOW, cd) for re, cd in
                             rows("roos_willmarth1971.csv") if re <= RE_MAX],
        "Miller & Bailey": [(re, max(m, SLOW), cd) for m, re, cd in
                            rows("miller_bailey1979.csv")
                            if RE_MIN <= re <= RE_MAX],
        "Bailey & Hiatt": [(re, m, cd) for m, re, cd in
                           rows("bailey_hiatt.csv")],
    }


def curves():
    """By name: states (Re, M) of a curve."""
    result = {"Re 1e4": [(1e4, 0.05*1.065**i) for i in range(80)],
              "figures": [(1.0, 1.0), (10.0, 3.0), (100.0, 2.0),
                          (1000.0, 6.0)]}
    for m in (SLOW, 1.0, 3.0):
        result["M %g" % m] = [(0.01*10**(i/10), m) for i in range(71)]
    return result


def states():
    """All of them, in the order of the clouds."""
    result = []
    for points in measured().values():
        result += [p[:2] for p in points]
    for points in curves().values():
        result += points
    return result


def diameter(re, mach):
    return re*MU/(RHO*mach*SOUND)
