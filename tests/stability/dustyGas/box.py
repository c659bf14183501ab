# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""A gas of 300 m/s and 500 K and grains at rest and 300 K in a box without
ends: box.py LOADING DIAMETER[um] STEPS STEP[s]. Stands in a temporary folder."""

import os
import sys

import numpy as np

from caseTools import (largest, last_fields, read_field, solve, times_of,
                       verdict)
from dust import CP, CP_P, dust_energy, read_dust, relaxation, sealed

loading, d, steps, dt = (float(word) for word in sys.argv[1:])
d *= 1e-6
sealed("box", loading, d, int(steps), dt)
solve("box")
first, last = times_of("box")[0], times_of("box")[-1]
rho, u, p, T = last_fields("box", "rho U p T")
# (a field that is the same everywhere is one number)
volume = 4e-9
R = np.mean(p/(rho*T))
_, v, Tp = read_dust("box", last)
folder = os.path.join("box", last, "lagrangian", "sand")
number, density = (read_field(os.path.join(folder, name))
                   for name in ("nParticle", "rho"))
mass = np.sum(number*density)*np.pi/6*d**3
gas = volume*np.mean(rho)
u = np.reshape(u, (-1, 3))
momentum = (volume*np.mean(rho*u[:, 0]) + mass*np.mean(v))/(gas*300) - 1
before = gas*((CP - R)*500 + 0.5*300**2) + mass*CP_P*300
after = volume*np.mean(rho*((CP - R)*T + 0.5*np.sum(u**2, axis=1))) \
    + dust_energy("box")
k, heat, _ = relaxation(d, 0, np.mean(rho), 500, R, 300)
longest = int(steps)*dt*min(k, heat)*(1 + loading)
apart = abs(np.mean(u[:, 0]) - np.mean(v))/300, abs(np.mean(T) - np.mean(Tp))/200
hottest = 500 + 0.5*300**2/(CP - R)
fine = -1e-9 < v.min() and v.max() < 300 + 1e-9 and u[:, 0].min() > -1e-9 \
    and 300 - 1e-9 < min(T.min(), Tp.min()) and max(T.max(), Tp.max()) < hottest
verdict("box", fine and abs(momentum) < 1e-12 and abs(after/before - 1) < 1e-12
        and (longest < 100 or largest(apart) < 1e-6),
        "steps of %.2g relaxation times, in all %.2g; velocities differ by"
        " %.1e of 300 m/s, temperatures by %.1e of 200 K; momentum off by %.1e,"
        " energy by %.1e" % (dt*k, longest, *apart, momentum,
                             after/before - 1))
