# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""What each rank has had to do, the warning where one has most of it, and the
weights with which decomposePar spreads it."""

import re

import numpy as np

import dsmcTools
from caseTools import (box, copy_case, decompose, edit, must, read_field,
                       solve, times_of, verdict, write_block, write_case,
                       write_field, write_foam)

# A warning needs a fifth of the time that gas, cloud and writing take
N, STEPS = 30000, 400
CLOUD = """
type spinningKinematicCloud;
solution
{
    active yes; coupled no; transient yes; cellValueSourceCorrection off;
    rotation off; motion embeddedRK54;
    interpolationSchemes { U cellLinear; } integrationSchemes { U Euler; }
}
constantProperties { rho0 2500; }
subModels
{
    particleForces { sphereDrag; }
    injectionModels
    {
        grains
        {
            type manualInjection; massTotal 0; parcelBasisType fixed;
            nParticle 1; SOI 0; positionsFile "positions"; U0 (0 0 0);
            sizeDistribution
            {
                type fixedValue; fixedValueDistribution { value 1e-5; }
            }
        }
    }
    patchInteractionModel rebound; reboundCoeffs { UFactor 1; }
    dispersionModel none; stochasticCollisionModel none;
    surfaceFilmModel none;
}
cloudFunctions {}
"""


def by_rank(log):
    """Titles of the table of ranks, its lines, and most over mean."""
    text = log[log.rindex("    rank "):].split("\n\n")[0]
    title, *lines, most = text.splitlines()
    return (re.split(r"  +", title.strip())[1:],
            np.array([[float(x) for x in line.split()[1:]] for line in lines]),
            [float(x) for x in most.split()[3:]])


# Grains in the first quarter of a box, in gas at rest
write_case("quarter", {"endTime": STEPS*1e-6, "deltaT": 1e-6,
                       "writeInterval": STEPS*1e-6, "timePrecision": 12,
                       "libs": "(spinningParcel)"}, {"mode": "frozen"})
sides = [axis + end for axis in "xyz" for end in ("Min", "Max")]
write_block("quarter", box((0.4, 0.1, 0.1)), (40, 5, 5),
            {side: "wall" for side in sides})
must("quarter", "blockMesh")
zero = {side: "type zeroGradient;" for side in sides}
for name, value in (("p", 1e5), ("T", 300.), ("U", (0, 0, 0))):
    write_field("quarter", name, value, zero)
x = np.random.default_rng(1).random((N, 3))*[0.1, 0.1, 0.1]
write_foam("quarter", "constant/positions", "(\n" + "\n".join(
    "(%.12g %.12g %.12g)" % tuple(p) for p in x) + "\n)", "vectorField")
write_foam("quarter", "constant/parcelClouds",
           "clouds (sand); decompositionWeights yes;")
write_foam("quarter", "constant/sandProperties", CLOUD)

ranks = copy_case("quarter", "quarterRanks")
decompose(ranks)
log = solve(ranks, 2)
titles, lines, most = by_rank(log)
steps = lines[:, titles.index("sand")]
verdict("each_rank_has_a_line",
        titles == ["CPU s", "peak MB", "sand"] and len(lines) == 2
        and steps[0] == N*STEPS and steps[1] == 0 and most[-1] == 2
        and lines[:, 1].min() > 10,
        f"{titles}, {lines.tolist()}, most over mean {most}")
verdict("warns_of_a_rank_with_twice_the_mean",
        "Rank 0 has done 2 times the mean number of particle steps (sand)"
        in " ".join(log.split()) and "decompositionWeights yes" in log,
        "named with the remedy")

# On one rank there is no such table
one = copy_case("quarter", "quarterOne")
log = solve(one)
weights = read_field(f"{one}/{times_of(one)[-1]}/decompositionWeights")
verdict("one_rank_has_no_table", "most over mean" not in log
        and "waited for it" not in log, "neither table nor warning")
# (All parcels are in a quarter of the cells, and the gas costs little)
inside = weights.reshape(25, 40)[:, :10].mean()
outside = weights.reshape(25, 40)[:, 10:]
verdict("weights_follow_the_parcels",
        abs(weights.mean() - 1) < 1e-4 and 3 < inside < 4
        and np.ptp(outside) == 0 and outside.min() > 0,
        f"mean {weights.mean():.5f}; {inside:.2f} in the quarter,"
        f" {outside.mean():.2g} elsewhere")

# The case goes on, decomposed by them: put together it is from two ranks
must(ranks, "reconstructPar", "-latestTime")
decompose(ranks)
with open(f"{ranks}/system/decomposeParDict", "a") as file:
    file.write("\nweightField decompositionWeights;\n")
must(ranks, "decomposePar", "-force", "-latestTime")
edit(ranks, "system/controlDict", f"endTime {STEPS*1e-6}",
     f"endTime {2*STEPS*1e-6}")
log = solve(ranks, 2)
titles, lines, most = by_rank(log)
time = lines[:, titles.index("sand")]
verdict("weights_spread_the_parcels", 1 <= most[-1] < 1.3 and time.min() > 0
        and "waited for it" not in log,
        f"most over mean {most[-1]} (2 before)")

# Molecules
dsmcTools.write_gas(
    "gas", {side: "cyclic" for side in sides}, cells=(4, 4, 4),
    weight=2e12, control={"endTime": 2e-6, "deltaT": 1e-6},
    more="decompositionWeights yes;")
pair = copy_case("gas", "gasRanks")
dsmcTools.solve("gas")
end = times_of("gas")[-1]
_, cell, _ = dsmcTools.read_molecules("gas", end)
n = np.bincount(cell, minlength=64)
weights = read_field(f"gas/{end}/decompositionWeights")
expected = (n/n.mean() + 0.01)/1.01
verdict("weights_of_molecules", np.ptp(n) > 0
        and np.abs(weights - expected).max() < 1e-12,
        f"numbers from {n.min()} to {n.max()} in a cell")
decompose(pair)
titles, lines, _ = by_rank(dsmcTools.solve(pair, 2))
verdict("molecules_of_each_rank", lines[:, titles.index("molecules")].sum()
        == 2*n.sum(), f"{lines[:, -1].tolist()} molecule steps")
