# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Each program writes until a file may grow no further, which is what a full
disk or a quota does to it: it must end non-zero, name the file and the reason,
and leave whole what was there before. Stands in an empty folder."""

import hashlib
import os
import re
import shutil
import subprocess

from caseTools import (complaint, decompose, must, verdict, write_foam)
from subjects import SUBJECTS, cloud_text, gas_case, rarefied

NOBODY = 65534


def attempt(case, command, ranks=1, most=None, other=False):
    """Exit status and text of a run whose files may have so many bytes."""
    if most is not None:
        # Not of mpirun itself, which keeps files of its own; nor of what its
        # ranks share, in files as well
        command = ["bash", "-c", f"trap '' XFSZ; exec prlimit --fsize={most}"
                   ' "$@"', "limited", *command]
    if ranks > 1:
        command = ["mpirun", "--oversubscribe", "--mca", "btl", "self,tcp",
                   "-x", "PMIX_MCA_gds=hash", "-np", str(ranks), *command,
                   "-parallel"]

    def limit():
        if other and os.getuid() == 0:
            os.setgid(NOBODY)
            os.setuid(NOBODY)
    # (Through a pipe: a log would be cut as well)
    done = subprocess.run(command, cwd=case, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True,
                          errors="replace", preexec_fn=limit)
    return done.returncode, done.stdout


def files_of(case):
    """Size and checksum of every file, by its path."""
    found = {}
    for folder, _, names in os.walk(case):
        for name in names:
            path = os.path.join(folder, name)
            with open(path, "rb") as file:
                data = file.read()
            found[os.path.relpath(path, case)] = (
                len(data), hashlib.sha1(data).hexdigest())
    return found


def results(files, start=()):
    return {p: f for p, f in files.items() if p not in start
            and not p.startswith("log.") and "/log." not in p}


def marks(case):
    """Times that a restart would take as complete."""
    return {os.path.dirname(os.path.dirname(p)) for p in files_of(case)
            if p.endswith("uniform/complete")}


def same_but_clock(one, other):
    """Names of the files that differ, beside those that hold the time that
    a run took."""
    skip = re.compile(r"uniform/(time|complete|functionObjects)|"
                      r"profiling|summary\.csv|convergence\.csv")
    return sorted(p for p in set(one) | set(other)
                  if not skip.search(p) and one.get(p) != other.get(p))


def limits(files, n):
    """Sizes at which one file after the other is cut, evenly chosen."""
    sizes = sorted({size - 1 for path, (size, _) in files.items()
                    if size > 300 and not path.endswith("complete")})
    return sizes if len(sizes) <= n else [
        sizes[k*(len(sizes) - 1)//(n - 1)] for k in range(n)]


def said(text):
    """The file and the reason that the last message names."""
    at = text.rfind("FOAM FATAL ERROR")
    found = re.search(r"Cannot write (\S+): ([^,\n]+)|does not allow write"
                      r" (permission).* directories in\s+(\S+)",
                      text[max(at, 0):], re.S)
    # A folder is refused by OpenFOAM
    return at >= 0 and found and (found.groups()[:2] if found.group(1)
                                  else found.groups()[:1:-1])


def complete(case, command, ranks):
    status, text = attempt(case, command, ranks)
    if status:
        raise SystemExit(f"FAIL {case}: {complaint(text)}")


def solver(name, build, command, ranks, early=False):
    """A first part that is written whole, and a second one that is cut; early:
    in its first write."""
    case = f"good_{name}"
    build(case)
    if ranks > 1:
        decompose(case)
    first = case + ".first"
    shutil.copytree(case, first)
    control = f"{first}/system/controlDict"
    with open(control) as file:
        text = file.read()
    end = float(re.search(r"endTime\s+([^;]+)", text).group(1))
    with open(control, "w") as file:
        file.write(re.sub(r"endTime\s+[^;]+", f"endTime {end/3!r}", text))
    complete(first, command, ranks)
    shutil.copy(f"{case}/system/controlDict", control)
    shutil.copytree(first, f"{case}.straight")
    complete(f"{case}.straight", command, ranks)
    whole = files_of(f"{case}.straight")
    before = files_of(first)
    kept = marks(first)

    new = results(whole, before)
    if early:
        first_time = sorted(t for t in (p.split("/")[1] for p in new) if
                            re.match(r"[0-9]", t))[0]
        new = {p: f for p, f in new.items() if f"/{first_time}/" in p}
    bad, n = [], 0
    for most in limits(new, 3 if ranks == 1 else 2):
        trial = "trial"
        shutil.copytree(first, trial)
        status, text = attempt(trial, command, ranks, most)
        n += 1
        what = f"{most} bytes"
        about = said(text)
        if not status:
            bad.append(f"{what}: ends with 0")
        elif not about:
            bad.append(f"{what}: {complaint(text)}")
        elif "large" not in about[1] and "full" not in about[1]:
            bad.append(f"{what}: the reason is '{about[1]}'")
        left = files_of(trial)
        if any(same_but_clock({p: f for p, f in left.items()
                               if p.startswith(m + "/")},
                              {p: f for p, f in whole.items()
                               if p.startswith(m + "/")})
               for m in marks(trial) - kept):
            bad.append(f"{what}: a time that was cut is marked complete")
        lost = [p for p, f in before.items() if re.match(
            r"(processor\d/)?[0-9]", p) and left.get(p) != f]
        if lost:
            bad.append(f"{what}: changed {lost[:3]}")
        status, text = attempt(trial, command, ranks)
        after = files_of(trial)
        differ = [p for p in same_but_clock(whole, after)
                  if ".unfinished" not in p and not p.startswith("log.")]
        if status or differ:
            bad.append(f"{what}, run again: {differ[:3] or complaint(text)}")
        shutil.rmtree(trial)
    verdict(f"fullDisk_{name}", not bad and n > 1, "; ".join(bad[:4]) or
            f"{n} runs cut, refused, and gone on with to the same end")

    shutil.copytree(first, "trial")
    open_to_all("trial", write=False)
    status, text = attempt("trial", command, ranks, other=True)
    about = said(text)
    open_to_all("trial", write=True)
    good = (status and about and "ermission" in about[1]
            and marks("trial") == kept
            and not set(same_but_clock(before, files_of("trial"))))
    verdict(f"noPermission_{name}", good,
            f"{about}" if good else complaint(text))
    shutil.rmtree("trial")


def open_to_all(case, write):
    """For a user who may read, and write or not."""
    os.chmod(".", 0o755)
    for folder, _, names in os.walk(case):
        os.chmod(folder, 0o777 if write else 0o555)
        for name in names:
            os.chmod(os.path.join(folder, name), 0o666 if write else 0o444)


def utility(subject):
    """A program that writes once; the results of an earlier run stay."""
    case = f"good_{subject.name}"
    subject.build(case)
    start = files_of(case)
    must(case, *subject.command)
    # What is new, and what it has replaced
    end = files_of(case)
    whole = results(end, {p for p, f in end.items() if start.get(p) == f})
    bad, n = [], 0
    for most in limits(whole, 6):
        shutil.copytree(case, "trial")
        status, text = attempt("trial", subject.command, most=most)
        n += 1
        about = said(text)
        if not status:
            bad.append(f"{most} bytes: ends with 0")
        elif not about or not ("large" in about[1] or "full" in about[1]):
            bad.append(f"{most} bytes: {complaint(text)}")
        differ = [p for p in same_but_clock(
            whole, {p: f for p, f in results(files_of("trial")).items()
                    if p in whole or p not in start}) if
            ".unfinished" not in p]
        if differ:
            bad.append(f"{most} bytes: other files {differ[:3]}")
        shutil.rmtree("trial")
    verdict(f"fullDisk_{subject.name}", not bad and n > 1,
            "; ".join(bad[:4]) or f"{n} runs cut and refused, the results of"
            " the run before are whole")
    shutil.copytree(case, "trial")
    open_to_all("trial", write=False)
    status, text = attempt("trial", subject.command, other=True)
    open_to_all("trial", write=True)
    about = said(text)
    good = status and about and "ermission" in about[1]
    verdict(f"noPermission_{subject.name}", good,
            f"{about}" if good else f"status {status}: {complaint(text)}")
    shutil.rmtree("trial")


def dust(form):
    def build(case):
        gas_case(case, {"mode": "frozen"}, 6)
        path = f"{case}/system/controlDict"
        with open(path) as file:
            text = file.read()
        with open(path, "w") as file:
            file.write(re.sub(r"writeInterval [^;]+", "writeInterval 1e-06",
                              text).replace("binary", form))
        write_foam(case, "constant/parcelClouds", "clouds (dust);")
        write_foam(case, "constant/dustProperties",
                   cloud_text("hardSphereWall", "surfaceImpact",
                              "dispersedPhase", "rakeInjection"))
    return build


def molecules(case):
    rarefied("solidParticleProperties").build(case)
    path = f"{case}/system/controlDict"
    with open(path) as file:
        text = file.read()
    with open(path, "w") as file:
        file.write(re.sub(r"writeInterval [^;]+", "writeInterval 1",
                          re.sub(r"endTime [^;]+", "endTime 6e-06", text)))


solver("dust", dust("binary"), ["rhoCentralParcelFoam"], 1)
solver("dustAscii", dust("ascii"), ["rhoCentralParcelFoam"], 1)
solver("dustTwoRanks", dust("binary"), ["rhoCentralParcelFoam"], 2)
solver("molecules", molecules, ["dsmcParcelFoam"], 1)
# (A restart of molecules on two ranks keeps the bits of its start alone: sums
# over those that have changed ranks come in another order)
solver("moleculesTwoRanks", molecules, ["dsmcParcelFoam"], 2, early=True)
for each in SUBJECTS[:3] + [s for s in SUBJECTS if
                           s.name == "alignMeshToShock"]:
    utility(each)
