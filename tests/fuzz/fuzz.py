#!/usr/bin/env python3
# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Mistakes in dictionaries: fuzz.py [--sample N] [--tests] [--tutorials]
[--minutes N] [--jobs N] [--log FILE] [SUBJECT...]

Stands in an empty folder. Each entry is dropped, misspelt and given -1, 0,
1e300, -1e300, nan, a word and something of another type, one at a time; and
each entry that a message calls valid is added with a value that nothing can
take. No run may end in a signal or last for ever, a misspelling and an entry
that nothing reads must be refused, and a refusal names the entry. Prints the
rows of doc/stability.md, or with --tests lines PASS and FAIL; what went wrong
stands on the error stream. With --tutorials the dictionaries are those of the
tutorials (tutorials/ADHESION/..., by their names), otherwise the annotated
ones. A mistake that several tutorials have alike, in one entry of one type of
block that one program reads, is made in one of them. With --minutes N, no
mistake is begun after that time: which ones are left out is chance, the same
each time, and their number is printed. With --log, every outcome is appended
to a file, and a mistake that stands there as in order is not made again: a
run that was cut off goes on, and one with complaints is repeated after the
mending where it failed. The key of a mistake holds the text of its file.
"""

import argparse
import concurrent.futures
import hashlib
import json
import os
import random
import re
import resource
import shutil
import subprocess
import sys
import threading
import time

import tutorials
from mutations import bare, blocks, entries, misspelt, mutations
from subjects import SUBJECTS

CPU_SECONDS = 60

# Entries that the stock cloud reads and refuses before ours are looked at
STOCK = ("active", "coupled", "transient", "cellValueSourceCorrection",
         "rho0", "solution", "constantProperties", "subModels")

# Models of OpenFOAM in the tutorials' clouds, whose entries are its own
STOCK_MODELS = ("kinematicLookupTableInjection", "standardWallInteraction")

NO_NUMBER = r"(?i)(^|[,\s])-?(nan|inf)\b"

# What no reader of a number, a word, a switch, a list or a file can take
JUNK = "noneOfThese"


def run(case, command, log="log.fuzz"):
    """Exit status and what was said; limited in processor time, so that a
    busy machine makes no difference."""
    def limit():
        resource.setrlimit(resource.RLIMIT_CPU, (CPU_SECONDS, CPU_SECONDS + 5))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    with open(f"{case}/{log}", "w+", errors="replace") as log:
        try:
            status = subprocess.run(command, cwd=case, stdout=log,
                                    stderr=subprocess.STDOUT, timeout=1800,
                                    preexec_fn=limit).returncode
        except subprocess.TimeoutExpired:
            status = -24
        log.seek(0)
        return status, log.read()


def is_main(path):
    """Not a file that others include: all that is at its top is read."""
    return re.search("(Properties|Dict|parcelClouds|fvSolution)$", path)


def results_hold(case, pattern):
    """A file of results with such a word, if there is one."""
    for folder, _, files in os.walk(case):
        for name in files:
            if name.endswith(".csv"):
                with open(f"{folder}/{name}", errors="replace") as file:
                    if re.search(pattern, file.read()):
                        return os.path.join(folder, name)
    return None


def tutorial_subjects(asked):
    """The tutorials' cases, each with its dictionaries."""
    seen = set()
    for name in tutorials.names():
        if asked and name not in asked:
            continue
        cases = tutorials.capture(name, f"captured.{name.replace('/', '_')}")
        if not cases:
            yield Subject(name, None, "", [], {}, {})
        for folder in cases:
            with open(f"{folder}/command") as file:
                case, program, *options = file.read().split("\n")[:-1]
            # What dictionaries say is the same on one rank
            options = [o for o in options if o != "-parallel"]
            found = tutorials.dictionaries(f"{folder}/tree", case, program)
            files = {p: tutorials.chooser(p, program, text)
                     for p, text in found.items()
                     if (program, text) not in seen}
            seen |= {(program, text) for text in found.values()}
            if files:
                yield Subject(name, f"{folder}/tree", case.lstrip("/") or ".",
                              [program, *options], files, found)


class Subject:
    """files: which entries of a dictionary are ours, by its path below
    tree; texts: all dictionaries that the run reads; free: parents of names
    that anyone may choose; stock: parents of entries that the stock models
    read."""

    def __init__(self, name, tree, case, command, files, texts,
                 free=("grids", "cloudFunctions", "injectionModels", "fills",
                       "inflows", "moleculeProperties", "species", "groups",
                       "interfaces"),
                 stock=("interpolationSchemes", "integrationSchemes",
                        "particleForces")):
        self.name, self.tree, self.case = name, tree, case
        self.command, self.files, self.texts = command, files, texts
        self.free, self.stock = free, stock
        self.unknown = None     # a result that is no number without mistakes

    def is_macro(self, path, parts):
        """Is it there for others to refer to? What is included in a block is
        a choice among names."""
        name = re.escape(os.path.basename(path))
        return any(
            re.search(r'\{\s*#include\s+"[^"]*\b' + name + '"', text)
            or any(re.search(r"\$[{:.]*(\w+\.)*"
                             + re.escape(part.strip('"')) + r"\b", text)
                   for part in parts)
            for text in self.texts.values())

    def attempt(self, path, text, worker):
        """The outcome with another text of a dictionary."""
        trial = f"trial.{worker}"
        shutil.copytree(self.tree, trial, symlinks=True)
        with open(f"{trial}/{path}", "w") as file:
            file.write(text)
        status, said = run(f"{trial}/{self.case}", self.command)
        bad = not self.unknown and results_hold(trial, NO_NUMBER)
        shutil.rmtree(trial)
        return status, said, bad

    def is_stock(self, path, where):
        """Does a block belong to a model of OpenFOAM?"""
        text = bare(self.text(path))
        types = {e.path: text[e.valueStart:e.end - 1].strip()
                 for e in entries(text) if e.key == "type"}
        return (bool(set(where) & set(self.stock))
                or any(types.get(where[:i + 1]) in STOCK_MODELS
                       or part.replace("Coeffs", "") in STOCK_MODELS
                       for i, part in enumerate(where)))

    def together(self, path):
        """Texts of the files that one dictionary is made of, this among
        them: what stands in one of them may replace what another says."""
        found = []
        for main in self.texts:
            files = {}
            tutorials.with_included(self.tree, main, files)
            if path in files:
                found += files.values()
        return found

    def text(self, path):
        with open(f"{self.tree}/{path}") as file:
            return file.read()


def judge(subject, path, name, entry, status, text, bad):
    """What is wrong with the outcome; nothing if it is as it should be."""
    kind = name.split()[0]
    if status in (-24, 152, -9):
        return "hung"
    macro = (subject.is_macro(path, entry.path + (entry.key,))
             or not (entry.path or is_main(path)))
    if macro and status:
        # Refused is what becomes of it, and under that name; stock
        # arithmetic ends in a trap of its own
        return ("" if "FOAM FATAL" in text or "evalEntry" in text
                or "exprs::" in text else "crashed")
    at = text.find("FOAM FATAL")
    stock = (subject.is_stock(path, entry.path)
             or subject.command[0] == tutorials.STOCK_SOLVER
             and entry.key == "type")
    if status < 0 or (status and at < 0):
        return "" if stock and at >= 0 else "crashed"
    if "printStack" in text and not stock:
        return "crashed"
    if stock:
        return ""
    parent = entry.path[-1] if entry.path else ""
    if status == 0:
        if kind == "misspell" and not (parent in subject.free or macro):
            return "accepted"
        return f"not a number in {os.path.basename(bad)}" if bad else ""
    key = (misspelt(entry.key) if kind == "misspell" else entry.key).strip('"')
    if entry.key in STOCK:
        return ""
    # The line of the file names the blocks around an entry, too: of that the
    # end alone, where it is the line of an entry
    message, _, file = text[at:].split("\n    From ")[0].partition("\nfile: ")
    words = {key, entry.key.strip('"')}
    if kind == "drop":
        # What a pattern stood for, macros that nothing refers to any more,
        # the block of names that anyone may choose
        if entry.key.startswith('"'):
            words |= {word for word in re.findall(r"\w+", message)
                      if re.fullmatch(key, word)}
        words |= set(re.findall(r"\$:?(\w+)",
                                subject.text(path)[entry.start:entry.end]))
        words |= {parent}.intersection(subject.free)
    if any(re.search(rf"(?<!\w){re.escape(word)}(?!\w)", message)
           or re.search(rf"[./]{re.escape(word)} at line ", file)
           for word in words):
        return ""
    return "does not name the entry"


def alike(subject, path, name, entry, changed):
    """What two tutorials share if a mistake in them is the same: program,
    dictionary, entry, mistake, and the types of the blocks around it."""
    text = bare(subject.text(path))
    where = entry.path if entry else name
    types = {e.path: text[e.valueStart:e.end - 1].strip()
             for e in entries(text)
             if e.key in ("type", "model", "law", "law1", "law2")}
    around, last = [], ""
    for i, part in enumerate(("",) + where):
        around.append(("*" if last in subject.free else part,
                       types.get(where[:i])))
        last = part
    mistake = ("added" if entry is None else
               re.sub(re.escape("/".join(where + (entry.key,))), "", name))
    key = "" if entry is None else (
        "*" if last in subject.free and entry.isDict else entry.key)
    file = re.sub(r"^\w+(?=Properties)", "", os.path.basename(path))
    if subject.command[0] == "dsmcParcelFoam":
        file = os.path.basename(path)
    return (subject.command[0], file, tuple(around), key, mistake)


def identity(subject, path, name, entry, changed):
    """One mistake among all, the same in another run of the same text."""
    text = changed if entry else subject.text(path)
    return " ".join((subject.name, subject.case, path,
                     name if entry else "added in /" + "/".join(name),
                     hashlib.sha1(text.encode()).hexdigest()))


def logged(log):
    """(number, refused) of the mistakes in a log whose outcome is in order."""
    found = {}
    if log and os.path.isfile(log):
        with open(log) as lines:
            for line in lines:
                key, n, refused, complaints = json.loads(line)
                if not complaints:
                    found[key] = n, refused
    return found


def added(subject, path, where, end, worker):
    """What is wrong with entries that a message calls valid in a
    dictionary: (number tried, complaints)."""
    text = subject.text(path)

    def with_entry(key, value):
        return subject.attempt(
            path, f"{text[:end]}\n{key} {value};\n{text[end:]}", worker)

    status, said, _ = with_entry("qqqqqq", JUNK)
    at = said.find("FOAM FATAL")
    listed = re.search(r"Unknown entry qqqqqq.*?Valid: \(([^)]*)\)",
                       said[max(at, 0):], re.S)
    if not listed:
        return 1, ([] if status and "qqqqqq" in said[at:] else
                   ["is accepted" if status == 0 else "does not name it"])
    tried, wrong = 1, []
    present = {e.key for t in [text] + subject.together(path)
               for e in entries(bare(t)) if e.path == where}
    for key in listed.group(1).split():
        # Coefficients of models that are not chosen may stay
        if key in present or key.endswith("Coeffs"):
            continue
        tried += 1
        status, said, _ = with_entry(key, JUNK)
        if status == 0:
            wrong.append(f"{key} is read by nothing")
        elif "FOAM FATAL" not in said:
            wrong.append(f"{key} crashes")
    return tried, wrong


def annotated_subjects(asked):
    for s in SUBJECTS:
        if asked and s.name not in asked:
            continue
        case = f"good.{s.name}"
        s.build(case)
        with open(f"{case}/{s.file}") as file:
            texts = {s.file: file.read()}
        yield Subject(s.name, case, ".", s.command,
                      {s.file: tutorials.chooser(s.file, s.command[0],
                                                 texts[s.file])},
                      texts, s.free, s.stock)


def report(order, count, wrong, tests):
    """One line for each subject that was tried, in their order."""
    for name in order:
        n, refused = count[name]
        bad = sorted(wrong.get(name, []))
        if not n and not bad:
            continue
        said = f"{n} mistakes, {refused} refused, {n - refused} run"
        if tests:
            print(f"FAIL {name}: " + "; ".join(bad[:5]) if bad
                  else f"PASS {name} ({said})")
        else:
            print(f"mistakes in {name} | none crashes, hangs, is a misspelling"
                  " accepted or a refusal that does not name its entry |"
                  f" {said}" + (f"; wrong: {'; '.join(bad)}" if bad else "")
                  + f" | {'FAILED' if bad else 'ok'}")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--sample", type=int, default=0)
    parser.add_argument("--tests", action="store_true")
    parser.add_argument("--tutorials", action="store_true")
    parser.add_argument("--minutes", type=float)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--log", type=os.path.abspath)
    parser.add_argument("subjects", nargs="*")
    asked = parser.parse_args()
    in_order = logged(asked.log)
    if os.listdir("."):
        sys.exit("fuzz.py: the folder is not empty")
    known = (tutorials.names() if asked.tutorials
             else [s.name for s in SUBJECTS])
    for name in asked.subjects:
        if name not in known:
            sys.exit(f"fuzz.py: no subject {name}. There are: "
                     + " ".join(known))

    # Trials without number: with a sample, the same ones each time
    trials, count, wrong, order = [], {}, {}, []
    source = tutorial_subjects if asked.tutorials else annotated_subjects
    for subject in source(asked.subjects):
        if subject.name not in count:
            order.append(subject.name)
            count[subject.name] = [0, 0]
        problem = "its programs are not reached"
        if subject.tree:
            shutil.copytree(subject.tree, "trial.good", symlinks=True)
            status, text = run(f"trial.good/{subject.case}", subject.command)
            # So few particles leave some errors unknown
            subject.unknown = results_hold("trial.good", NO_NUMBER)
            shutil.rmtree("trial.good")
            at = max(text.find("FOAM FATAL"), 0)
            problem = ("the good case stops: "
                       + " ".join(text[at:at + 600].split())
                       if status else "")
        if problem:
            print(f"{subject.name}: {subject.case}: {problem}",
                  file=sys.stderr, flush=True)
            wrong.setdefault(subject.name, []).append(problem[:100])
            continue
        for path, chosen in subject.files.items():
            text = subject.text(path)
            for name, entry, changed in mutations(text, chosen):
                trials.append((subject, path, name, entry, changed))
            for where, end in blocks(text, chosen):
                # What a file that is included has at its top is free
                free = ((not where and (chosen is not tutorials.everything
                                        or not is_main(path)))
                        or where and where[-1] in subject.free
                        or subject.is_macro(path, where))
                if not free and not subject.is_stock(path, where):
                    trials.append((subject, path, where, None, end))

    found = len(trials)
    random.Random(1).shuffle(trials)
    if asked.tutorials:
        # Of those that are alike the first: they spread over the tutorials
        trials = list({alike(*t): t for t in reversed(trials)}.values())
        random.Random(1).shuffle(trials)
    different = len(trials)
    if asked.sample:
        trials = trials[:asked.sample]
    end = time.monotonic() + (60*asked.minutes if asked.minutes else 1e9)
    begun = []
    lock = threading.Lock()

    def attempt(trial):
        if time.monotonic() > end:
            return      # see --minutes
        begun.append(trial)
        subject, path, name, entry, changed = trial
        worker = threading.get_ident()
        key = identity(subject, path, name, entry, changed)
        said = ""
        if key in in_order:
            n, refused = in_order[key]
            complaints = []
        elif entry is None:
            n, complaints = added(subject, path, name, changed, worker)
            refused = n - len(complaints)
            complaints = [f"an entry more in /{'/'.join(name)}: {c}"
                          for c in complaints]
        else:
            status, text, bad = subject.attempt(path, changed, worker)
            problem = judge(subject, path, name, entry, status, text, bad)
            n, refused = 1, status != 0
            complaints = [f"{name}: {problem}"] if problem else []
            at = max(text.find("FOAM FATAL"), 0)
            said = " ".join(text[at:at + 250].split())
        with lock:
            if asked.log and key not in in_order:
                with open(asked.log, "a") as log:
                    log.write(json.dumps([key, n, refused, complaints]) + "\n")
            count[subject.name][0] += n
            count[subject.name][1] += refused
            for c in complaints:
                print(f"{subject.name}: {path}: {c}: {said}", file=sys.stderr,
                      flush=True)
                wrong.setdefault(subject.name, []).append(c)

    with concurrent.futures.ThreadPoolExecutor(asked.jobs) as pool:
        for done in [pool.submit(attempt, t) for t in trials]:
            done.result()
    if not begun:
        sys.exit("fuzz.py: there was nothing to try")

    # (of those that are alike, or of a sample, some have none)
    if not (asked.tutorials or asked.sample or asked.minutes):
        for name in order:
            if not count[name][0]:
                wrong.setdefault(name, []).append("nothing was tried")

    if asked.tutorials:
        said = (f"{len(begun)} of {different} different ones tried; the"
                f" tutorials have {found}")
        expected = (f"as many as {asked.minutes:g} minutes allow"
                    if asked.minutes else "all that are different")
        print(f"PASS {said}" if asked.tests else
              f"mistakes in tutorials | {expected} | {said} | ok")
    report(order, count, wrong, asked.tests)
    return bool(wrong)


if __name__ == "__main__":
    sys.exit(main())
