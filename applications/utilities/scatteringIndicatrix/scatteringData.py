# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Reading of the results of scatteringIndicatrix."""
import csv

import numpy as np


class Result:
    """The files of one result folder: alpha [deg], F and its standard error
    [1/rad], and summary, a dictionary of numbers."""

    def __init__(self, folder):
        self.alpha, self.F, self.error = np.loadtxt(
            folder + '/F.csv', delimiter=',', skiprows=1).T
        with open(folder + '/summary.csv') as f:
            self.summary = {r['quantity']: float(r['value'])
                            for r in csv.DictReader(f)}

    def __getitem__(self, name):
        return self.summary[name]

    @property
    def width(self):
        """Bin width [rad]."""
        return np.radians(180/len(self.alpha))


def variation(p, q):
    """Total-variation distance of the distributions of alpha2 of two results
    with the same bins; what leaves into the wall counts as one more bin."""
    into = abs((1 - p.F.sum()*p.width) - (1 - q.F.sum()*q.width))
    return 0.5*(np.abs(p.F - q.F).sum()*p.width + into)
