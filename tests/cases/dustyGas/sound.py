# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Speed of sound of a gas whose grains follow it at once: a standing wave.
Stands in a temporary folder."""

import numpy as np

from caseTools import GAMMA, R_GAS, last_fields, solve, times_of, verdict
from dust import CP, CP_P, sealed

CELLS, LOADING, T0, P0 = 64, 1., 300., 1e5
L = 1e-3*CELLS

c = LOADING*CP_P
gamma = (CP + c)/(CP/GAMMA + c)
exact = np.sqrt(gamma*R_GAS/(1 + LOADING)*T0)
period = L/exact
n = 256

x = (np.arange(CELLS) + 0.5)/CELLS
wave = np.cos(2*np.pi*x)
p = P0*(1 + 1e-3*wave)
T = T0*(1 + 1e-3*(gamma - 1)/gamma*wave)
sealed("sound", LOADING, 1e-7, n, period/n, u=(0, 0, 0), T=T, T_dust=T0, p=p,
       cells=(CELLS, 1), tolerance=1e-6, writes=n//4)
solve("sound")


def amplitude(time):
    return 2*np.mean(last_fields("sound", "p", time)[0]*wave)/(1e-3*P0)


times = [t for t in times_of("sound") if float(t) > 0]
a = np.array([amplitude(t) for t in times])
t = np.array([float(t) for t in times])
# Half a period between two times at which nothing is left
zeros = [t[i] + (t[i + 1] - t[i])*a[i]/(a[i] - a[i + 1])
         for i in range(len(a) - 1) if a[i]*a[i + 1] < 0]
found = L/(2*(zeros[1] - zeros[0]))
verdict("sound", len(zeros) == 2 and abs(found/exact - 1) < 0.005,
        "speed %.2f m/s, of the mixture %.2f m/s, of the gas alone %.2f m/s;"
        " amplitude after a period %.3f" % (
            found, exact, np.sqrt(GAMMA*R_GAS*T0), a[-1]))
