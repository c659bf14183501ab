# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""A shock tube into which something impossible is brought: in the fields it
starts from, or by a boundary condition halfway."""

import os

import numpy as np
from caseTools import (R_GAS, box, complaint, decompose, last_fields, must,
                       read_field, read_points, refuses, run, times_of,
                       verdict, write_block, write_case, write_field,
                       write_points)

N, DT, END = 100, 1e-6, 2e-5
AT = 1e-5           # time at which the boundary condition goes wrong


def tube(case, inlet=None):
    """A tube of N cells. inlet: field -> boundary condition at xMin."""
    write_case(case, {"endTime": END, "deltaT": DT, "writeInterval": END/4,
                      "writeFormat": "ascii"}, {"mode": "transient"})
    write_block(case, box((1, 0.01, 0.01)), (N, 1, 1),
                {"xMin": "patch", "xMax": "patch"})
    boundary = {s + e: "type empty;" for s in "yz" for e in ("Min", "Max")}
    boundary.update(xMax="type zeroGradient;")
    left = np.arange(N) < N//2
    p, rho = np.where(left, 1e5, 1e4), np.where(left, 1, 0.125)
    fields = {"p": p, "T": p/(rho*R_GAS), "U": np.zeros((N, 3))}
    for name, field in fields.items():
        write_field(case, name, field, dict(
            boundary, xMin=(inlet or {}).get(name, "type zeroGradient;")))
    must(case, "blockMesh")
    return case


def poison(case, name, value, patch=False):
    """Write a field in binary, the only form that can hold a NaN, with a
    value put into cell 42, or at the inlet."""
    path = os.path.join(case, "0", name)
    values = read_field(path)
    if not patch:
        values[42] = value
    vector = values.ndim == 2
    kind = "vector" if vector else "scalar"

    def entry(key, numbers):
        return (f"{key} nonuniform List<{kind}> {len(numbers)}(".encode()
                + np.asarray(numbers, float).tobytes() + b");")

    with open(path, "rb") as file:
        text = file.read().replace(b"format ascii", b"format binary")
    start = text.index(b"internalField")
    end = text.index(b"boundaryField")
    text = (text[:start] + entry("internalField", values) + b"\n"
            + text[end:])
    if patch:
        text = text.replace(b"xMin { type zeroGradient; }",
                            b"xMin { type fixedValue; "
                            + entry("value", [value]) + b" }")
    with open(path, "wb") as file:
        file.write(text)


def table(before, after):
    return (f"type uniformFixedValue; uniformValue table ((0 {before})"
            f" ({AT} {before}) ({AT + 1e-9} {after}) (1 {after}));")


def refused(name, case, *words):
    """Stops before the first step, and says why."""
    refuses(name, run(case, "rhoCentralParcelFoam"), words)


def stops(name, case, *words, ranks=1, near=AT):
    """Stops when the gas breaks down, names cell, place and time, and leaves
    finite fields of just before, marked as no place to restart from."""
    command = ["rhoCentralParcelFoam"]
    if ranks > 1:
        command = ["mpirun", "--oversubscribe", "-np", str(ranks), *command,
                   "-parallel"]
    status, text = run(case, *command)
    reason = complaint(text)
    good = (status != 0 and "The gas solution broke down at time" in text
            and "sigFpe" not in text)
    for word in ("Gas: cell ", " at (", " at time ", " has no possible gas.",
                 *words):
        if word not in text:
            good, reason = False, reason + f"; does not say {word!r}"
    if good:
        roots = ([case] if ranks == 1 else
                 [f"{case}/processor{r}" for r in range(ranks)])
        for root in roots:
            last = times_of(root)[-1]
            good &= os.path.exists(f"{root}/{last}/uniform/incomplete")
            good &= abs(float(last) - near) < 2.5*DT
            p, t, U, rho = last_fields(root)
            for field in p, t, rho:
                good &= bool(np.isfinite(field).all() and (field > 0).all())
            good &= bool(np.isfinite(U).all()) and len(p) == N//ranks
        reason = f"stopped at {last} s; all that it has written is finite"
    verdict(name, good, reason)


for name, value in ("p", "nan"), ("T", "nan"), ("T", "inf"), ("p", "-1"):
    case = tube(f"start_{name}_{value}")
    poison(case, name, float(value))
    refused(case, case, f" of {name} ", value, "index 42")

poison(tube("start_U_nan"), "U", (float("nan"), 0, 0))
refused("start_U_nan", "start_U_nan", "cell 42", "U = (nan 0 0)")

poison(tube("inlet_T_nan"), "T", float("nan"), patch=True)
refused("inlet_T_nan", "inlet_T_nan", "Entry value of T", "xMin", "nan")

for name, condition in ("T", "totalTemperature; gamma 1.4; T0"), (
        "p", "totalPressure; p0"):
    case = tube("inlet_total_" + name, inlet={
        name: f"type {condition} uniform -1; value uniform 1;"})
    refused(case, case, f"0 of {name}", "xMin", "-1", "must be positive")

# One row of points beyond the next one
points = read_points(tube("inside_out"))
points[np.abs(points[:, 0] - 43/N) < 0.1/N, 0] += 1.5/N
write_points("inside_out", points)
refused("inside_out", "inside_out", "Cell 43", "inside out, the worst of 1",
        "checkMesh")

# The velocity of a boundary is looked at when the first step is
poison(tube("inlet_U_nan"), "U", (float("nan"), 0, 0), patch=True)
stops("inlet_U_nan", "inlet_U_nan", "patch xMin", "U = (nan 0 0)", near=DT)

tube("negative", inlet={"T": table(348, -348)})
stops("inletTurnsNegative", "negative", "patch xMin", "face 0")

tube("overflow", inlet={"U": table("(0 0 0)", "(1e200 0 0)")})
stops("inletOverflows", "overflow", "patch xMin", "face 0")

tube("infinite", inlet={"p": table(1e5, 1e150)})
stops("inletBecomesInfinite", "infinite", "patch xMin", "face 0")

# Both ranks must stop, though one alone has the inlet
tube("ranks", inlet={"T": table(348, -348)})
decompose("ranks")
stops("ranksStopTogether", "ranks", "patch xMin", ranks=2)
