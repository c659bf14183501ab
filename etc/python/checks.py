# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""The checks of the tutorials, with one word for the verdict, and the records
of what they found of the papers' statements.

A script of a tutorial:

    sys.path.insert(0, os.environ["PARCEL_IMPACT_DIR"] + "/etc/python")
    from checks import Checks

    check = Checks("adhesion/silicaLayer")
    check.near(value, truth, tolerance, "what it is [unit]")
    check.statement("adhesion.chainCapture", value)
    check.finish()

Each check prints a line that begins with PASS or FAIL. A value that is not a
number fails. finish() writes statements.csv, fails for each statement of
paperStatements.py that names this tutorial and was not made, and ends the
program with 1 if something failed.
"""

import csv
import math
import sys

from paperStatements import BY_NAME, STATEMENTS


def largest(*values):
    """As max(), but nan where one of them is, which max() may pass over."""
    found = [float(v) for v in (values if len(values) > 1 else values[0])]
    return math.nan if any(map(math.isnan, found)) else max(found)


class Checks:
    def __init__(self, tutorial=None):
        self.tutorial = tutorial
        self.failed = 0
        self.made = {}

    def that(self, ok, what):
        """A property that holds or does not; print its numbers in what."""
        print(("PASS " if ok else "FAIL ") + what, flush=True)
        self.failed += not ok
        return bool(ok)

    def near(self, value, truth, tolerance, what):
        """Is the value within a tolerance of the truth?"""
        return self.that(
            abs(value - truth) <= tolerance,
            f"{what}: {value:.6g} ({truth:.6g} +- {tolerance:.2g})")

    def between(self, value, low, high, what):
        """Is the value within two bounds?"""
        if not (math.isfinite(low) and math.isfinite(high) and low < high):
            raise ValueError(f"{what}: bounds {low} and {high} are not two"
                             " finite numbers that ascend")
        return self.that(low <= value <= high,
                         f"{what}: {value:.4g} ({low:.4g} to {high:.4g})")

    def statement(self, name, value, error=0.0):
        """A statement of a paper, by its name in paperStatements.py. The
        standard error, if there is one, is printed and recorded."""
        about = BY_NAME[name]
        if about.tutorial != self.tutorial or name in self.made:
            raise ValueError(f"{name} belongs to {about.tutorial}, once; here"
                             f" is {self.tutorial}")
        value = float(value)
        self.made[name] = value, float(error)
        text = (f"{name}: {about.quantity}: {value:.4g}"
                + (f" +- {error:.1g}" if error else "")
                + (" " + about.unit if about.unit else ""))
        met = about.low <= value <= about.high
        paper = f"{about.low:g} to {about.high:g}"
        if about.ours is None:
            return self.that(met, f"{text} (paper: {paper})")
        low, high = about.ours
        if met:
            return self.that(False, f"{text} (paper: {paper}: reproduced,"
                             " though it stands in the list as differing)")
        return self.that(low <= value <= high,
                         f"{text} (differs from the paper's {paper};"
                         f" ours: {low:g} to {high:g})")

    def finish(self):
        for about in STATEMENTS:
            if about.tutorial == self.tutorial and about.name not in self.made:
                self.that(False, f"{about.name}: not made")
        if self.made:
            with open("statements.csv", "w", newline="",
                      encoding="utf-8") as file:
                rows = csv.writer(file)
                rows.writerow(("name", "value", "standardError"))
                for name, (value, error) in self.made.items():
                    rows.writerow((name, f"{value:.6g}", f"{error:.2g}"))
        sys.exit(1 if self.failed else 0)
