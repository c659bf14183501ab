# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Reading of the tables of comma-separated values that the programs write."""

import csv

import numpy as np


def _number(text):
    return float(text or "nan")


def table(path):
    """Columns of a table by name, none if it has no rows; empty entries are
    nan. A column with words is one of texts; lines that begin with # are
    comments."""
    with open(path, newline="", encoding="utf-8") as file:
        names, *rows = csv.reader(l for l in file if not l.startswith("#"))
    columns = dict(zip(names, zip(*rows)))
    for name, column in columns.items():
        try:
            columns[name] = np.array([_number(x) for x in column])
        except ValueError:
            columns[name] = np.array(column)
    return columns


def summary(folder):
    """Quantities of summary.csv by name."""
    t = table(f"{folder}/summary.csv")
    return dict(zip(t["quantity"], t["value"]))
