# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Reading of the results of freeMolecularPlume."""
import csv

import numpy as np


def table(path):
    """Columns of a table by name; empty fields are nan."""
    with open(path) as file:
        rows = list(csv.DictReader(file))
    return {name: np.array([float(r[name] or 'nan') for r in rows])
            for name in rows[0]} if rows else {}


def summary(folder):
    """Quantities of summary.csv by name."""
    with open(folder + '/summary.csv') as file:
        return {r['quantity']: float(r['value'])
                for r in csv.DictReader(file)}


def stations(groups):
    """Names of the stations [km] in groups.csv."""
    head = 'spreadRadius_'
    return [name[len(head):-2] for name in groups if name.startswith(head)]
