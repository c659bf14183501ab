# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""What the far field of a plume says of the statements of figures 8 to 10, from
the tables of freeMolecularPlume: the value of each, by its name in
paperStatements.py."""

import numpy as np
from csvTables import summary, table


def findings(folder):
    """Of a folder with grids axis (60 to 110 km) and quadrants, and stations
    at 74 and 115 km."""
    groups = table(folder + "/groups.csv")
    axis = table(folder + "/axis.csv")
    equilibrium = summary(folder)["equilibriumTemperature"]
    quadrants = table(folder + "/quadrants.csv")
    count = np.array(quadrants["testParticles"][quadrants["group"] == 1])
    if len(count) != 4:
        raise ValueError(f"{folder}/quadrants.csv: {len(count)} quadrants")
    result = {
        "plume.nearEdge": groups["nearEdge"][0]*1e-3,
        "plume.farEdge": groups["farEdge"][0]*1e-3,
        "plume.axisymmetric": np.abs(count - count.mean()).max()
        / np.sqrt(0.75*count.mean())}
    for station in (74, 115):
        r = groups[f"spreadRadius_{station}km"]
        # Sizes of which more than a thousandth have come that far
        there = groups["farEdge"] > 1e3*station
        if there.sum() < 2:
            raise ValueError(f"{there.sum()} sizes at {station} km")
        result[f"plume.spread{station}"] = np.polyfit(
            np.log(groups["diameter"][there]), np.log(r[there]), 1)[0]
    # Where a size has come
    T = [axis["temperature"][axis["group"] == k + 1]
         for k in range(len(groups["diameter"]))]
    T = [t[np.isfinite(t)] for t in T]
    shared = [min(len(a), len(b)) for a, b in zip(T, T[1:])]
    fall = [t[:4].mean() - t[-4:].mean() for t in T]
    result.update({
        "plume.largerHotter": min(
            (b[:n] - a[:n]).min() for a, b, n in zip(T, T[1:], shared)),
        "plume.smallestInEquilibrium": fall[0],
        "plume.coolsWithDistance": min(fall[1:]),
        "plume.othersNotYet": min(t[-1] - equilibrium for t in T[1:])})
    return result
