# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Reading of the results of jkrImpact."""
import csv

import numpy as np


def table(name):
    """Columns of a file as arrays; empty fields are nan."""
    with open(name) as f:
        rows = list(csv.DictReader(f))
    return {k: np.array([float(r[k]) if r[k] else np.nan for r in rows])
            for k in rows[0]}


class Result:
    """The files of one case."""

    def __init__(self, case):
        self.folder = case + '/postProcessing/jkrImpact/'
        with open(self.folder + 'summary.csv') as f:
            self.summary = {r['quantity']: float(r['value'])
                            for r in csv.DictReader(f)}

    def __getitem__(self, name):
        return self.summary[name]

    def table(self, name):
        return table(self.folder + name + '.csv')

    def trajectory(self, i):
        return self.table(f'trajectory_{i}')
