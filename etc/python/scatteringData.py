# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Reading of the results of scatteringIndicatrix."""
import functools
import re

import numpy as np
from csvTables import summary


class Result:
    """The files of one result folder: alpha [deg], F and its standard error
    [1/rad], and summary, a dictionary of numbers."""

    def __init__(self, folder):
        self.folder = folder
        self.alpha, self.F, self.error = np.loadtxt(
            folder + '/F.csv', delimiter=',', skiprows=1).T
        self.summary = summary(folder)

    def __getitem__(self, name):
        return self.summary[name]

    @property
    def width(self):
        """Bin width [rad]."""
        return np.radians(180/len(self.alpha))

    @functools.cached_property
    def I(self):
        """Spatial indicatrix [1/rad^2], by alpha2 and beta2."""
        bins = len(self.alpha)
        return np.loadtxt(self.folder + '/I.csv', delimiter=',', skiprows=1,
                          usecols=2).reshape(bins, bins)


def variation(p, q):
    """Total-variation distance of the distributions of alpha2 of two results
    with the same bins; what leaves into the wall counts as one more bin."""
    into = abs((1 - p.F.sum()*p.width) - (1 - q.F.sum()*q.width))
    return 0.5*(np.abs(p.F - q.F).sum()*p.width + into)


def mostProbable(result):
    """The most probable alpha2 [deg]: the top of the parabola through F where
    it is above nine tenths of its maximum. The highest bin of a flat maximum
    scatters over all of that. Without a top there, the highest mean of five
    bins."""
    mean = np.convolve(result.F, np.ones(5)/5, 'same')[2:-2]
    alpha = result.alpha[2:-2]
    high = np.flatnonzero(mean > 0.9*mean.max())
    i = slice(high[0], high[-1] + 1)
    if high.size > 2:
        bend, slope, _ = np.polyfit(alpha[i], result.F[2:-2][i], 2)
        if bend < 0 and alpha[i][0] <= -slope/bend/2 <= alpha[i][-1]:
            return -slope/bend/2
    return alpha[mean.argmax()]


def asymmetry(result):
    """How far I is from symmetry in beta2, in standard deviations: chi squared
    of the numbers in mirrored cells. Of n particles in a cell and its image,
    each in either with probability 1/2, d more in one: d^2/n has the mean 1
    and the variance 2 - 2/n."""
    counts = np.rint(result.I*result['nParticles']*result.width**2)
    half = counts.shape[1]//2
    one, other = counts[:, :half], counts[:, ::-1][:, :half]
    n = one + other
    d, n = (one - other)[n > 0], n[n > 0]
    return (d*d/n - 1).sum()/np.sqrt((2 - 2/n).sum())


def entry(text, name):
    """The number of an entry in the text of a dictionary."""
    return float(re.search(rf'\b{name}\s+([-+.\deE]+);', text)[1])


SHAPES = {'sphere': 'sphere', 'prolate': 'prolate ellipsoid',
          'oblate': 'oblate ellipsoid', 'elongatedPrism': 'elongated prism',
          'flattenedPrism': 'flattened prism',
          'truncatedPrism': 'truncated prism'}


def titles(text):
    """For each body of SHAPES in the text of a dictionary what to call it in
    a picture, with its sides over the first."""
    names = dict(SHAPES)
    for name, size in re.findall(r'(?m)^(\w+)\s.*size \(([^)]*)\)', text):
        a, b, c = map(float, size.split())
        names[name] += f', b/a = {b/a:g}' + (f', c/a = {c/a:g}' if b != c
                                             else '')
    return names
