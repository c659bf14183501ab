# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""jkrImpact for the spheres of this case with another work of adhesion and
another dissipation parameter."""
import os
import subprocess
import sys

if "PARCEL_IMPACT_DIR" not in os.environ:
    sys.exit("source etc/bashrc of parcelImpact first")
for shared in ("etc/python", "applications/utilities/jkrImpact"):
    sys.path.insert(0, os.path.join(os.environ["PARCEL_IMPACT_DIR"], shared))
from jkrData import Result


def run(w, alpha, speeds, case="runs/trial"):
    """Results for the work of adhesion w [J/m2], alpha and a list of speeds
    [m/s] that ascend."""
    os.makedirs(case + "/system", exist_ok=True)
    with open(case + "/system/jkrImpactDict", "w") as file:
        file.write(
            '#include "../../../system/common"\n'
            f"contact {{ workOfAdhesion {w!r}; }}\nalpha {alpha!r};\n"
            f"speeds ({' '.join(repr(float(v)) for v in speeds)});\n")
    with open("log." + os.path.basename(case), "w") as log:
        subprocess.run(["jkrImpact", "-case", case, "-noPlot"], check=True,
                       stdout=log, stderr=log)
    return Result(case)
