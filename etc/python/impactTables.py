# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Reading of what surfaceImpact writes by angle: rates over a part of the
surface, each with its standard error."""

import glob

import numpy as np


def by_angle(case, cloud):
    """The latest table of what the impacts of a cloud do, by angle; what no
    impact has told is not a number. None if there is no table."""
    tables = glob.glob(
        f"{case}/postProcessing/surfaceImpact/{cloud}/*/byAngle.csv")
    if not tables:
        return None
    latest = max(tables, key=lambda t: float(t.split("/")[-2]))
    return np.genfromtxt(latest, delimiter=",", names=True)


def scaled(table, factor):
    """The impacts of a stream without collisions at another volume fraction:
    in proportion."""
    if table is None:
        return None
    table = table.copy()
    for name in table.dtype.names:
        if any(name.startswith(start) for start in
               ("intensity", "firstIntensity", "specificPower", "massFlux")):
            table[name] *= factor
    return table


def total(table, name, upto=180):
    """Sum over the surface up to an angle, and its standard error."""
    inside = table["phi_deg"] < upto
    area = table["area"][inside]
    return (np.nansum(table[name][inside]*area),
            np.sqrt(np.nansum((table[name + "Error"][inside]*area)**2)))


def normal_speed(table, upto=180):
    """Mean normal speed of the impacts, and its standard error."""
    inside = (table["phi_deg"] < upto) & (table["nImpacts"] > 0)
    n = table["nImpacts"][inside]
    return (np.sum(n*table["meanNormalSpeed"][inside])/n.sum(),
            np.sqrt(np.nansum(
                (n*table["meanNormalSpeedError"][inside])**2))/n.sum())


def ratio(x, y):
    """Ratio of two values with standard errors."""
    value = x[0]/y[0]
    return value, value*np.hypot(x[1]/x[0], y[1]/y[0])
