# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Profiles of gas and grains, of this run and published ones, and what both
have in their plateaus."""

import os
import re

import numpy as np
from foamFiles import positions, read

LENGTH, DIAPHRAGM = 0.2578, 0.129
FRACTION, RHO_P = 5.172e-4, 2500.
ATM, RHO0, R, CV = 101298., 1.30633, 287.2, 718.
SOUND = np.sqrt(1.4*R*270)


def parcel_mass(case):
    """[kg]"""
    with open(f"{case}/constant/sandProperties") as file:
        text = file.read()
    number, d = (float(re.search(rf"{word}\s+(\S+);", text).group(1))
                 for word in ("nParticle", "diameter"))
    return number*RHO_P*np.pi/6*d**3


class Profile:
    """Gas and grains at a time."""

    def __init__(self, case, time):
        folder = f"{case}/{time}"
        self.p, self.rho, self.T = (read(f"{folder}/{name}")
                                    for name in ("p", "rho", "T"))
        self.u = read(f"{folder}/U")[:, 0]
        n = len(self.p)
        self.x = (np.arange(n) + 0.5)*LENGTH/n
        cloud = f"{folder}/lagrangian/sand"
        xs = positions(cloud)[0][:, 0]
        order = np.argsort(xs)
        self.xs = xs[order]
        self.us = read(f"{cloud}/U")[order, 0]
        self.Ts = read(f"{cloud}/T")[order]
        # Over 5 cells each
        number, edges = np.histogram(self.xs, n//5, (0, LENGTH))
        self.xd = 0.5*(edges[1:] + edges[:-1])
        self.mass = parcel_mass(case)
        self.dust = number*self.mass/(1e-6*(edges[1] - edges[0]))

    def head(self):
        """Of the expansion, at 9.7 of the 10 atmospheres."""
        return self.x[np.nonzero(self.p > 9.7*ATM)[0][-1]]


def times(case="."):
    """Those that have been written."""
    return sorted((d for d in os.listdir(case)
                   if re.fullmatch(r"0\.\d+|[1-9]\S*e-\d+", d)), key=float)


class Published:
    """Digitised profiles, read by the ends of the tube, where nothing has
    changed: ten and one of both pressure and density. Those of the dust, by
    what the shock has met of it: no dust comes or goes."""

    def __init__(self, folder="published"):
        def table(name):
            return np.loadtxt(f"{folder}/{name}.csv", delimiter=",").T

        def scale(x, q):
            ten, one = q[x < 0.055].mean(), q[x > 0.235].mean()
            return lambda value: 1 + 9*(value - one)/(ten - one)
        self.xp, p = table("pressure")
        self.xr, rho = table("gasDensity")
        self.xd, dust = table("dustDensity")
        self.axes = [q[x < 0.055].mean() for x, q in ((self.xp, p),
                                                      (self.xr, rho))] \
            + [q[x > 0.235].mean() for x, q in ((self.xp, p), (self.xr, rho))]
        density = scale(self.xr, rho)
        self.p = scale(self.xp, p)(p)
        self.rho, self.dust = density(rho), density(dust)
        self.front = front(self.xp, self.p)
        order = np.argsort(self.xd)
        held = np.trapz(np.append(self.dust[order], self.dust[order][-1]),
                        np.append(self.xd[order], self.front))
        self.held = held/(FRACTION*RHO_P/RHO0*(self.front - DIAPHRAGM))
        self.dust /= self.held
        # The digitised head lies within the first points of the expansion
        self.head = np.interp(-9.7, -self.p[3:12], self.xp[3:12])


def front(x, q, level=1.5):
    """Last place at which q passes the level."""
    i = np.nonzero(q > level)[0][-1]
    return x[i] + (q[i] - level)/(q[i] - q[i + 1])*(x[i + 1] - x[i])


def with_head(case, head):
    """The time whose expansion has its head there, and its profile."""
    at = min(times(case), key=lambda t: abs(Profile(case, t).head() - head))
    return at, Profile(case, at)


def levels(profile, published):
    """Mean levels over the published ones: between expansion and dust, and in
    the dust."""
    ratios = {}
    for name, low, high, x, q, ours, values in (
            ("middle pressure", 0.125, 0.155, published.xp, published.p,
             profile.x, profile.p/ATM),
            ("dusty pressure", 0.17, 0.205, published.xp, published.p,
             profile.x, profile.p/ATM),
            ("middle density", 0.13, 0.15, published.xr, published.rho,
             profile.x, profile.rho/RHO0),
            ("dusty density", 0.185, 0.205, published.xr, published.rho,
             profile.x, profile.rho/RHO0),
            ("dust", 0.18, 0.21, published.xd, published.dust, profile.xd,
             profile.dust/RHO0)):
        seen = (x > low) & (x < high)
        ratios[name] = np.mean(np.interp(x[seen], ours, values)/q[seen])
    return ratios
