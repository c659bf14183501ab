# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Tables of laws whose coefficients depend on the speed: rebounds drawn from
them between their speeds against relief struck anew, ranks, restart, and what is
refused; stands in an empty folder."""

import math
import os
import shutil

import numpy as np

from caseTools import largest, must, times_of, verdict, write_foam
from indicatrices import (BOX, LAW, LID, ROUGH, beam, by_degree, excess, new,
                          patches)
from plate import counters, mesh, parcels, solve, write_plate
from walls import check_ranks, check_refusals

# Restitution between 0.95 and 0.5, and along the wall between 0.1 and 0.5
OF_SPEED = """law
{
    type restitution;
    normal { type table; angles (0 40 90); speeds (5 60 200);
             values ((0.95 0.85 0.7) (0.9 0.75 0.6) (0.85 0.65 0.5)); }
    tangential { type polynomial; speedRange (5 200);
                 coefficients ((0.1 2e-3) (-0.1 1e-3)); }
}"""
SPEEDS = (25, 200)


def write_table(name, entries, law=OF_SPEED, incidences="15 18 21",
                speeds=SPEEDS):
    case = new(name)
    write_foam(case, "system/scatteringIndicatrixDict", f"""
{BOX} {ROUGH} {law} incidence ({incidences}); speed 50; nParticles 1; seed 7;
{f'tableSpeedRange ({speeds[0]} {speeds[1]});' if speeds else ''} {entries}""")
    must(case, "scatteringIndicatrix", "-noPlot", "-table")
    file = os.path.abspath(name + ".csv")
    shutil.copy(f"{case}/postProcessing/scatteringIndicatrix/"
                "responseTable.csv", file)
    return file


def tabulated(file, law=OF_SPEED, more="speedRange (25 200);",
              incidences="15 21"):
    return (f'{BOX} {ROUGH} {law} method tabulated; table "{file}";'
            f" incidenceRange ({incidences}); {more}")


def fly(settings, speed, n):
    """Velocities after one impact on the plate, and the counters."""
    case = new("beam")
    step = 0.04/speed
    write_plate(case, "nonSphericalRebound",
                patches(f"yMin {{ {settings} }}", LID),
                [beam(17, n, speed=speed)], end=2*step, step=step)
    mesh(case)
    log = solve(case)
    return parcels(case, times_of(case)[-1], "U")[1], counters(log)


def differences(a, b, table_rows):
    """Chi squared of the angles, and differences of the means of speed and of
    its square, all in standard deviations; b is of a table, itself a sample."""
    n = len(a)
    weight = 1/(1/len(b) + 1/table_rows)
    out = [excess(by_degree(a), n, by_degree(b)*weight/len(b), weight)]
    for power in (1, 2):
        x, y = (np.linalg.norm(u, axis=1)**power for u in (a, b))
        out.append(abs(x.mean() - y.mean())/math.sqrt(
            x.var()/n + y.var()/weight))
    return out


def check_between_speeds():
    n, rows = 40000, 40000
    file = write_table("fine", f"tableSpeeds 9; tableSamples {rows};")
    with open(file) as text:
        head = [line for line in text if line.startswith("#")]
    verdict("speedTable_head", "# scatteringResponse version 3\n" in head
            and "# nSpeeds 9\n" in head, f"{len(head)} lines")
    speeds = np.unique(np.loadtxt(file, delimiter=",", usecols=0,
                                  skiprows=len(head) + 1))
    verdict("speedTable_equalRatios",
            np.allclose(speeds, np.geomspace(25, 200, 9), rtol=1e-8),
            " ".join(f"{v:.6g}" for v in speeds))

    # Between its 1st and 2nd, 4th and 5th, 7th and 8th
    direct = {}
    for speed in (28, 80, 150):
        direct[speed], _ = fly(f"{BOX} {ROUGH} {OF_SPEED}", speed, n)
        drawn, c = fly(tabulated(file), speed, n)
        x = differences(direct[speed], drawn, rows)
        # Those that strike again are slower
        again = c["hits"][0] - n
        verdict(f"speedTable_{speed}", largest(x) < 5 and len(drawn) == n
                and c["speed held"][0] <= again < n/100,
                "angle, speed, its square: " + " ".join(
                    f"{v:.1f}" for v in x) + " deviations")
    slow = 28
    for fast in (80, 150):
        scaled = direct[slow]*fast/slow
        x = differences(direct[fast], scaled, rows)
        verdict(f"speedTable_hasPower_{fast}", x[0] > 10 and x[1] > 10,
                f"rebounds at {slow} m/s, scaled: {x[0]:.0f} {x[1]:.0f}"
                " deviations")

    # Faster than the table: its last speed, and told
    drawn, c = fly(tabulated(file), 250, 2000)
    at_last, _ = fly(tabulated(file), 200, 2000)
    same = np.allclose(drawn/250, at_last/200, atol=1e-9)
    verdict("speedTable_outside", c["speed held"] == c["hits"] and same,
            f"{c['speed held']} of {c['hits']}, as at 200 m/s: {same}")


def check_box():
    """Parcels that lose speed at each impact leave the range of the table."""
    file = write_table("coarse", "tableSpeeds 4; tableSamples 4000;",
                       incidences="2 10 20 40 60 90", speeds=(80, 200))
    c = check_ranks(
        ("speedTable", "nonSphericalRebound",
         tabulated(file, more="speedRange (80 200);", incidences="2 90")))
    verdict("speedTable_leavesItsRange",
            0 < c["speed held"][0] < c["hits"][0],
            f"{c['speed held'][0]:.0f} of {c['hits'][0]:.0f} impacts")
    return file


def check_bad_input(file):
    constant = write_table("constant", "tableSamples 10;", LAW, speeds=None)
    rows = [
        ("speedRangeMissing", tabulated(file, more=""), ["speedRange"]),
        ("speedRangeOrder", tabulated(file, more="speedRange (80 30);"),
         ["speedRange (80 30)", "lowest <= highest"]),
        ("speedRangeZero", tabulated(file, more="speedRange (0 30);"),
         ["speedRange 0", "less than light"]),
        ("speedRangeTooLow", tabulated(file, more="speedRange (20 200);"),
         ["holds the speeds 80 to 200", "needs 20 to 200"]),
        ("speedRangeTooHigh", tabulated(file, more="speedRange (90 201);"),
         ["holds the speeds 80 to 200", "needs 90 to 201"]),
        ("speedRangeOfConstantLaw", tabulated(constant, LAW),
         ["speedRange", "does not depend on the speed"]),
        ("tableOfConstantLaw", tabulated(constant),
         ["law restitution 0.8 0", "law restitution table"]),
        ("tableOfAnotherSpeed", tabulated(
            file, OF_SPEED.replace("60 200", "70 200")),
         ["law restitution table"]),
    ]
    check_refusals([(name, "nonSphericalRebound", patches(
        f"yMin {{ {text} }}", LID), words) for name, text, words in rows])


check_between_speeds()
check_bad_input(check_box())
