# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Reading of the files of OpenFOAM, ASCII and binary alike, as arrays."""

import glob
import os
import re

import numpy as np

WIDTHS = {"symmtensor": 6, "tensor": 9, "vector": 3, "scalar": 1, "label": 1}


def times(case="."):
    """Names of the times that a case has written, in their order."""
    return sorted((d for d in os.listdir(case)
                   if re.fullmatch(r"[0-9][0-9.e+-]*", d)), key=float)


def _open(path):
    """Kind of a file's data, how many numbers an entry has, whether they are
    binary, and what follows the header."""
    with open(path, "rb") as file:
        data = file.read()
    end = data.index(b"}") + 1
    kind = re.search(rb"class\s+([\w:<>]+)", data[:end])[1].decode().lower()
    width = next((n for name, n in WIDTHS.items() if name in kind), 1)
    binary = re.search(rb"format\s+binary", data[:end]) is not None
    return kind, width, binary, re.sub(rb"//[^\n]*\n", b"", data[end:], 1)


def _plain(text, most=-1):
    return text.replace(b"(", b" ").replace(b")", b" ").split(None, most)


def _list(data, at, width, binary, number):
    """The list that begins at a place: (...), or {of one value}."""
    head = re.compile(rb"\s*(\d+)\s*([({])").match(data, at)
    if not head:        # an empty list may be a bare 0
        return np.empty((0, width))
    n = int(head[1])
    if head[2] == b"{":
        one = _plain(data[head.end():data.index(b"}", head.end())])
        return np.tile(np.array(one, number), (n, 1))
    if binary:
        return np.frombuffer(data, number, n*width,
                             head.end()).reshape(n, width)
    text = _plain(data[head.end():], n*width)
    return np.array(text[:n*width], number).reshape(n, width)


def read(path, patch=None):
    """The numbers of a field: of its cells, or of one of its patches, or of
    the parcels of a cloud; one row per entry if it has several numbers. A
    uniform field of cells or faces gives a single value."""
    kind, width, binary, data = _open(path)
    number = "<i4" if "label" in kind else "<f8"
    if not re.match("vol|surface|point", kind):
        rows = _list(data, 0, width, binary, number)
        return rows[:, 0] if width == 1 else rows
    at = 0
    if patch:
        at = data.index(b"boundaryField")
        at = re.compile(rb"\n\s*" + patch.encode() + rb"\s*\{").search(
            data, at).end()
    found = re.compile(
        rb"\b" + (b"value" if patch else b"(?:internalField|value)")
        + rb"\s+(?:uniform\s+([^;]+);|nonuniform\s+List<\w+>)").search(data, at)
    if found[1]:
        return np.array(_plain(found[1]), number).squeeze()
    rows = _list(data, found.end(), width, binary, number)
    return rows[:, 0] if width == 1 else rows


def positions(folder):
    """Places and cells of the parcels of a cloud, from its folder."""
    _, _, binary, data = _open(os.path.join(folder, "positions"))
    head = re.match(rb"\s*(\d+)\s*\(", data)
    n = int(head[1]) if head else 0
    if binary:
        # Each entry stands in brackets, on a line of its own
        rows = np.frombuffer(data, np.dtype([
            ("open", "S1"), ("x", "<f8", 3), ("cell", "<i4"),
            ("close", "S2")]), n, head.end() + 1 if head else 0)
        return rows["x"].copy(), rows["cell"].copy()
    rows = _list(data, 0, 4, False, "<f8")
    return rows[:, :3], rows[:, 3].astype(int)


def parcels(case, time, cloud, *names):
    """Fields of the parcels of all ranks, in the order of their identities,
    which come first."""
    rows = []
    for part in sorted(glob.glob(f"{case}/processor*")) or [case]:
        folder = f"{part}/{time}/lagrangian/{cloud}"
        if os.path.exists(folder + "/origId"):
            rows.append([read(f"{folder}/{name}")
                         for name in ("origId", *names)])
    columns = [np.concatenate(c) for c in zip(*rows)]
    order = np.argsort(columns[0], kind="stable")
    return [c[order] for c in columns]
