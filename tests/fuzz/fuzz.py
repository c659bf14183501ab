#!/usr/bin/env python3
"""Mistakes in dictionaries: fuzz.py [--sample N] [--tests] [SUBJECT...]

Stands in an empty folder. Each entry is dropped, misspelt and given -1, 0,
1e300, nan and a word, one at a time. No run may end in a signal or last for
ever, a misspelling must be refused, and a refusal names the entry. Prints the
rows of doc/stability.md, or with --tests lines PASS and FAIL; what went wrong
stands on the error stream.
"""

import argparse
import os
import random
import re
import resource
import shutil
import subprocess
import sys

from mutations import misspelt, mutations
from subjects import SUBJECTS

CPU_SECONDS = 60

# Entries that the stock cloud reads and refuses before ours are looked at
STOCK = ("active", "coupled", "transient", "cellValueSourceCorrection",
         "rho0", "solution", "constantProperties", "subModels")


def run(case, command):
    """Exit status and what was said; limited in processor time, so that a
    busy machine makes no difference."""
    def limit():
        resource.setrlimit(resource.RLIMIT_CPU, (CPU_SECONDS, CPU_SECONDS + 5))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    with open(f"{case}/log.fuzz", "w+", errors="replace") as log:
        try:
            status = subprocess.run(command, cwd=case, stdout=log,
                                    stderr=subprocess.STDOUT, timeout=1800,
                                    preexec_fn=limit).returncode
        except subprocess.TimeoutExpired:
            status = -24
        log.seek(0)
        return status, log.read()


def results_hold(case, pattern):
    """A file of results with such a word, if there is one."""
    for folder, _, files in os.walk(case):
        for name in files:
            if name.endswith(".csv"):
                with open(f"{folder}/{name}", errors="replace") as file:
                    if re.search(pattern, file.read()):
                        return os.path.join(folder, name)
    return None


def judge(subject, case, name, entry, status, text):
    """What is wrong with the outcome; nothing if it is as it should be."""
    kind = name.split()[0]
    if status in (-24, 152, -9):
        return "hung"
    at = text.find("FOAM FATAL")
    stock = bool(set(entry.path) & set(subject.stock))
    # Some stock selectors end with abort() and a stack, after they have said
    # which name they do not know
    unknown = (status in (-6, 134) and at >= 0
               and misspelt(entry.key).strip('"') in text[at:])
    if not unknown and (status < 0 or (status and at < 0)
                        or ("printStack" in text and not stock)):
        return "crashed"
    if stock:
        return ""
    if status == 0:
        parent = entry.path[-1] if entry.path else ""
        if kind == "misspell" and parent not in subject.free:
            return "accepted"
        bad = results_hold(case, r"(?i)(^|[,\s])-?(nan|inf)\b")
        return f"not a number in {os.path.basename(bad)}" if bad else ""
    key = (misspelt(entry.key) if kind == "misspell" else entry.key).strip('"')
    message = text[at:].split("From function")[0]
    words = {key, entry.key.strip('"')}
    if kind == "drop":
        # Something else may be missing without it, there or in its place
        words |= set(entry.path[-1:])
    if entry.key in STOCK:
        return ""
    if not any(w in message for w in words):
        return "does not name the entry"
    return ""


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--sample", type=int, default=0)
    parser.add_argument("--tests", action="store_true")
    parser.add_argument("subjects", nargs="*")
    asked = parser.parse_args()
    if shutil.rmtree.avoids_symlink_attacks and os.listdir("."):
        sys.exit("fuzz.py: the folder is not empty")

    trials, good = [], {}
    for subject in SUBJECTS:
        if asked.subjects and subject.name not in asked.subjects:
            continue
        case = f"good.{subject.name}"
        subject.build(case)
        shutil.copytree(case, "trial")
        status, text = run("trial", subject.command)
        shutil.rmtree("trial")
        if status:
            at = max(text.find("FOAM FATAL"), 0)
            print(f"{subject.name}: the good case stops: "
                  + " ".join(text[at:at + 600].split()), file=sys.stderr)
            print(f"FAIL {subject.name}_good: it stops" if asked.tests else
                  f"{subject.name} | runs | stops FAILED")
            return 1
        with open(f"{case}/{subject.file}") as file:
            trials += [(subject, case, *m) for m in mutations(file.read())]
        good[subject.name] = [0, 0]

    if asked.sample:
        random.Random(1).shuffle(trials)
        trials = trials[:asked.sample]
    worst = {}
    for subject, case, name, entry, text in trials:
        shutil.copytree(case, "trial")
        with open(f"trial/{subject.file}", "w") as file:
            file.write(text)
        status, said = run("trial", subject.command)
        wrong = judge(subject, "trial", name, entry, status, said)
        good[subject.name][0] += 1
        good[subject.name][1] += status != 0
        if wrong:
            at = max(said.find("FOAM FATAL"), 0)
            print(f"{subject.name}: {name}: {wrong}: "
                  + " ".join(said[at:at + 250].split()), file=sys.stderr,
                  flush=True)
            worst.setdefault(subject.name, []).append(f"{name}: {wrong}")
        shutil.rmtree("trial")

    for name, (n, refused) in good.items():
        bad = worst.get(name, [])
        said = f"{n} mistakes, {refused} refused, {n - refused} run"
        if asked.tests:
            print(f"FAIL {name}: " + "; ".join(bad[:5]) if bad
                  else f"PASS {name} ({said})")
        else:
            print(f"mistakes in {name} | none crashes, hangs, is a misspelling"
                  " accepted or a refusal that does not name its entry |"
                  f" {said}" + (f"; wrong: {'; '.join(bad)}" if bad else "")
                  + f" | {'FAILED' if bad else 'ok'}")
    return bool(worst)


if __name__ == "__main__":
    sys.exit(main())
