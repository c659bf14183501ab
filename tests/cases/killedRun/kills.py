# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""A shock tube that writes every step, killed again and again."""

import os
import re
import shutil
import signal
import subprocess
import time

import numpy as np
from caseTools import (R_GAS, box, complaint, copy_case, decompose, largest,
                       last_fields, must, run, same_bits, solve, times_of,
                       verdict, write_block, write_case, write_field)

N, STEPS, DT = 4000, 60, 1e-7


def tube(case):
    write_case(case, {"endTime": STEPS*DT, "deltaT": DT, "writeInterval": DT},
               {"mode": "transient"})
    write_block(case, box((1, 0.01, 0.01)), (N, 1, 1),
                {"xMin": "patch", "xMax": "patch"})
    zero = {s + e: "type empty;" for s in "yz" for e in ("Min", "Max")}
    zero.update(xMin="type zeroGradient;", xMax="type zeroGradient;")
    x = (np.arange(N) + 0.5)/N
    p, rho = np.where(x < 0.5, 1e5, 1e4), np.where(x < 0.5, 1, 0.125)
    write_field(case, "p", p, zero)
    write_field(case, "T", p/(rho*R_GAS), zero)
    write_field(case, "U", (0, 0, 0), zero)
    must(case, "blockMesh")
    return case


def marked(case, name, mark):
    return os.path.exists(os.path.join(case, name, "uniform", mark))


def parts(case, ranks):
    return ([case] if ranks == 1
            else [f"{case}/processor{rank}" for rank in range(ranks)])


def written(case, ranks=1):
    """Times that any rank has begun to write."""
    return sorted({t for part in parts(case, ranks) for t in times_of(part)},
                  key=float)


def unfinished(case, ranks=1):
    """What the solver has begun to write and not marked complete on all ranks:
    a kill may come between making a directory and its first mark."""
    return [t for t in written(case, ranks)[1:]
            if not all(marked(part, t, "complete")
                       for part in parts(case, ranks))]


def first_time(text):
    found = re.search(r"^Time = (\S+)", text, re.M)
    return found and found.group(1)


def skips(text):
    """The latest directory a run has set aside and the one it started from."""
    found = re.findall(r"Time directory (\S+) was not written to its end:"
                       r" set aside as \1.unfinished", text)
    start = re.search(r"Create mesh for time = (\S+)", text)
    return ((max(found, key=float), start.group(1)) if found and start
            else None)


def agrees(case, name):
    """The end of a run against that of the straight run."""
    end = times_of("straight")[-1]
    if times_of(case)[-1] != end:
        return verdict(name, False, f"ended at {times_of(case)[-1]}")
    d = largest(abs(a/b - 1).max() for a, b in
                zip(last_fields(case, "p T rho"), last_fields("straight",
                                                              "p T rho")))
    bad = same_bits("straight", case, end)
    return verdict(name, not bad, f"largest difference from the straight run"
                   f" {d:.1e}; not the same to the last bit: "
                   + (", ".join(bad) or "nothing"))


tube("straight")
solve("straight")
all_times = times_of("straight")
verdict("marks", all(marked("straight", t, "complete")
                     and not marked("straight", t, "incomplete")
                     for t in all_times[1:]),
        "every directory of a finished run is marked complete")

def process_of_rank(launcher, rank):
    """A rank's process below mpirun."""
    for entry in filter(str.isdigit, os.listdir("/proc")):
        try:
            with open(f"/proc/{entry}/stat") as file:
                parent = file.read().rsplit(")", 1)[1].split()[1]
            with open(f"/proc/{entry}/environ", "rb") as file:
                mine = (b"OMPI_COMM_WORLD_RANK=%d\0" % rank) in file.read()
        except OSError:
            continue
        if int(parent) == launcher and mine:
            return int(entry)
    return None


def killed_again_and_again(case, kills, ranks=1):
    """Killed as soon as a chosen directory is marked, plus nothing, 1, 2 .. 5
    ms: inside a write or between two. What a kill before the mark leaves is
    made by hand below. On ranks, one of them is killed, each in its turn."""
    suffix = "" if ranks == 1 else f"_{ranks}ranks"
    command = ["rhoCentralParcelFoam"]
    if ranks > 1:
        command = ["mpirun", "--oversubscribe", "-np", str(ranks), *command,
                   "-parallel"]
    hits = 0
    for kill in range(kills):
        rank = kill % ranks
        before = written(case, ranks)
        latest = before[-1]
        wanted = all_times[min(all_times.index(latest) + 5,
                               len(all_times) - 1)]
        stopped = unfinished(case, ranks)
        log = open(f"{case}/log.{kill}", "w")
        process = subprocess.Popen(command, cwd=case, stdout=log,
                                   stderr=subprocess.STDOUT)
        until = time.time() + 60
        while (process.poll() is None and time.time() < until
               and not any(marked(parts(case, ranks)[rank], wanted, mark)
                           for mark in ("incomplete", "complete"))):
            pass
        time.sleep(1e-3*kill)
        victim = (process.pid if ranks == 1
                  else process_of_rank(process.pid, rank))
        if victim:
            os.kill(victim, signal.SIGKILL)
        process.wait()
        with open(log.name) as file:
            text = file.read()
        killed = process.returncode == (-9 if ranks == 1 else 137)
        complete = [t for t in before if t not in stopped]
        expected = (latest, complete[-1]) if latest in stopped else None
        hits += latest in stopped
        good = (killed and skips(text) == expected and "FOAM FATAL" not in text
                and first_time(text)
                == all_times[all_times.index(complete[-1]) + 1])
        verdict(f"kill_{kill}{suffix}", good,
                f"started from {complete[-1]}, skipped"
                f" {expected[0] if expected else 'nothing'}" if good else
                f"ended with {process.returncode}; skipped {skips(text)},"
                f" expected {expected}; first time {first_time(text)};"
                f" {complaint(text)}")
    latest = written(case, ranks)[-1]
    hits += latest in unfinished(case, ranks)
    status, text = run(case, *command)
    left = unfinished(case, ranks)
    verdict("afterKills" + suffix, status == 0 and not left,
            (complaint(text) if status else
             f"{hits} of {kills} kills have hit a write; still marked"
             f" unfinished: " + (", ".join(left) or "nothing")))
    verdict("sameTimes" + suffix, written(case, ranks) == all_times,
            "directories in only one of killed and straight run: "
            + (", ".join(sorted(set(written(case, ranks)) ^ set(all_times)))
               or "none"))


tube("killed")
killed_again_and_again("killed", 6)
agrees("killed", "killedRunSame")

# The same on two ranks, of which one is killed
tube("straight2")
decompose("straight2")
copy_case("straight2", "killed2")
solve("straight2", 2)
killed_again_and_again("killed2", 4, 2)
bad = [f"{part}: {name}"
       for rank in (0, 1) for part in [f"processor{rank}"]
       for name in same_bits(f"straight2/{part}", f"killed2/{part}",
                             all_times[-1])]
verdict("killedRunSame_2ranks", not bad, "not the same to the last bit as the"
        " straight run: " + (", ".join(bad) or "nothing"))


# ------------------------------------------- directories made up by this test

def cut(case, until):
    """The straight run as if it had ended at a step."""
    copy_case("straight", case)
    for t in all_times[until + 1:]:
        shutil.rmtree(os.path.join(case, t))
    return case


def unfinish(folder, *truncated):
    os.rename(f"{folder}/uniform/complete", f"{folder}/uniform/incomplete")
    for name in truncated:
        size = os.path.getsize(f"{folder}/{name}")
        os.truncate(f"{folder}/{name}", size//2)


def restarts(name, case, refused, start, ranks=1):
    command = ["rhoCentralParcelFoam"]
    if ranks > 1:
        command = ["mpirun", "--oversubscribe", "-np", str(ranks), *command,
                   "-parallel"]
    status, text = run(case, *command)
    expected = (all_times[refused], all_times[start]) if refused else None
    good = (status == 0 and skips(text) == expected
            and first_time(text) == all_times[start + 1])
    return verdict(name, good, "skipped " + (expected or ["nothing"])[0]
                   if good else f"skipped {skips(text)}, expected {expected};"
                   f" {complaint(text)}")


cut("half", 50)
unfinish(f"half/{all_times[50]}", "p")
if restarts("truncatedPressure", "half", 50, 49):
    left = unfinished("half")
    verdict("skippedIsWrittenAgain", not left,
            "still marked unfinished at the end: "
            + (", ".join(left) or "nothing"))
    agrees("half", "truncatedPressureSame")

cut("two", 50)
unfinish(f"two/{all_times[50]}", "p", "U")
unfinish(f"two/{all_times[49]}", "T")
restarts("twoUnfinished", "two", 50, 48)

cut("clock", 50)
unfinish(f"clock/{all_times[50]}", "uniform/time")
restarts("truncatedClock", "clock", 50, 49)

cut("state", 50)
unfinish(f"state/{all_times[50]}")
for name in "p", "T", "U", "rho", "Ma", "uniform/time":
    os.remove(f"state/{all_times[50]}/{name}")
restarts("onlyTheMark", "state", 50, 49)

# Killed between making the directory and marking it
cut("empty", 50)
shutil.rmtree(f"empty/{all_times[50]}")
os.makedirs(f"empty/{all_times[50]}/uniform")
restarts("emptyDirectory", "empty", 50, 49)

# Prepared by hand: fields and no marks
cut("hand", 50)
shutil.rmtree(f"hand/{all_times[50]}/uniform")
restarts("noMarks", "hand", None, 50)

cut("none", 0)
os.makedirs("none/0/uniform")
open("none/0/uniform/incomplete", "w").close()
status, text = run("none", "rhoCentralParcelFoam")
verdict("nothingComplete", status != 0 and "FOAM FATAL" in text
        and "no complete one" in text and "Time = " not in text,
        complaint(text))

# Unfinished on one of two ranks only
tube("ranks")
decompose("ranks")
solve("ranks", 2)
for t in all_times[51:]:
    for rank in 0, 1:
        shutil.rmtree(f"ranks/processor{rank}/{t}")
unfinish(f"ranks/processor1/{all_times[50]}", "p")
if restarts("oneRankUnfinished", "ranks", 50, 49, 2):
    must("ranks", "reconstructPar", "-latestTime")
    d = largest(abs(a/b - 1).max() for a, b in
                zip(last_fields("ranks", "p T rho"),
                    last_fields("straight", "p T rho")))
    verdict("oneRankUnfinishedSame", d < 1e-11,
            f"differs from one rank by {d:.1e}, tolerance 1e-11")

# Files of all ranks together
status, text = run("straight2", "mpirun", "--oversubscribe", "-np", "2",
                   "rhoCentralParcelFoam", "-parallel", "-fileHandler",
                   "collated")
verdict("collated_is_refused", status != 0
        and "with -fileHandler uncollated" in text, complaint(text))
