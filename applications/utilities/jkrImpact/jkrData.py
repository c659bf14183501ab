# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Reading of the results of jkrImpact, and checks on them."""
import csv
import sys

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


class Checks:
    """Prints PASS and FAIL lines; finish() ends the program."""

    def __init__(self):
        self.failed = 0

    def that(self, ok, what):
        print(('PASS ' if ok else 'FAIL ') + what)
        self.failed += not ok

    def near(self, got, expected, tolerance, what):
        self.that(abs(got - expected) <= tolerance,
                  f'{what}: {got:.6g} ({expected:.6g} +- {tolerance:.2g})')

    def finish(self):
        sys.exit(1 if self.failed else 0)
