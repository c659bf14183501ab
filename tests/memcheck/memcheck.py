# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Rows of memcheck: stands in an empty folder."""

import os
import re
import subprocess
import sys

from dust import sealed
from subjects import SUBJECTS

HERE = os.path.dirname(os.path.abspath(__file__))
MEMCHECK = ["valgrind", "-q", "--leak-check=full", "--num-callers=25",
            "--show-leak-kinds=definite", "--errors-for-leak-kinds=definite",
            "--error-exitcode=99", f"--suppressions={HERE}/stock.supp",
            "--log-file=log.memcheck"]

# Valgrind reports what a trap of floating-point errors would end
ENVIRONMENT = {**os.environ, "FOAM_SIGFPE": "false"}


class Dust:
    """Grains that act on a gas that changes, with heat and collisions: the
    cases of the fuzz have a frozen gas."""

    name = "dustyGas"
    command = ["rhoCentralParcelFoam"]

    @staticmethod
    def build(case):
        sealed(case, 1, 3e-5, 3, 1e-5, per_cell=4, scatter=20.,
               number=1e-3/3e-5, change=lambda cloud: cloud.replace(
                   "rotation off;",
                   "rotation on; collisions { type eventDriven; }"))


failed = False
subjects = {subject.name: subject for subject in [*SUBJECTS, Dust]}
for name in sys.argv[1:]:
    if name not in subjects:
        sys.exit(f"memcheck.py: no subject {name}. There are: "
                 + " ".join(subjects))
for name in sys.argv[1:] or subjects:
    subject = subjects[name]
    subject.build(subject.name)
    status = subprocess.run(MEMCHECK + subject.command, cwd=subject.name,
                            stdout=subprocess.DEVNULL, env=ENVIRONMENT,
                            stderr=subprocess.STDOUT).returncode
    with open(f"{subject.name}/log.memcheck") as file:
        text = file.read()
    found = re.findall(r"==\d+== (\S.*)\n==\d+==    at ", text)
    print(text, file=sys.stderr, end="")
    failed = failed or status != 0
    print(f"{subject.command[0]}, {subject.name} | no error and no block lost,"
          f" but for those of the stock | exit status {status},"
          f" {len(found)} reports | {'FAILED' if status else 'ok'}", flush=True)
sys.exit(failed)
