# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Gas at rest that is not in balance: round-off in its velocity stays so, and a
viscosity of zero is none; stands in a folder of its own."""

import numpy as np
from caseTools import (box, copy_case, decompose, edit, last_fields, must,
                       same_bits, solve, verdict, write_block, write_case,
                       write_field)

N = 12
rng = np.random.default_rng(3)
p = 1e5*4**rng.random(N*N)
noise = rng.standard_normal((N*N, 3))*(1, 1, 0)
found = []
for k, size in enumerate((0, 1e-13)):
    case = f"rest{k}"
    write_case(case, {"endTime": 3e-6, "deltaT": 1e-6, "writeInterval": 3e-6},
               {"mode": "transient"})
    write_block(case, box((0.01, 0.01, 0.001)), (N, N, 1),
                {s + e: "wall" for s in "xy" for e in ("Min", "Max")})
    for name, values, wall in (("p", p, "zeroGradient"),
                               ("T", 300.0, "zeroGradient"),
                               ("U", size*noise, "slip")):
        write_field(case, name, values, {
            "zMin": "type empty;", "zMax": "type empty;",
            **{s + e: f"type {wall};" for s in "xy" for e in ("Min", "Max")}})
    must(case, "blockMesh")
    solve(case)
    found += last_fields(case, "p")
apart = abs(found[1]/found[0] - 1).max()
verdict("gas_at_rest", apart < 1e-9 and abs(found[0]/p - 1).max() > 0.01,
        f"velocities of 1e-13 m/s change p by {apart:.1e}, tolerance 1e-9")

# Keys of schemes may be patterns
case = copy_case("rest0", "pattern")
must(case, "rm", "-r", "3e-06")
edit(case, "system/fvSchemes", "reconstruct vanAlbada", '"reconstruct.*" upwind')
said = solve(case)
verdict("patterns_are_keys", "limiter upwind" in said, "upwind by a pattern")

# The choice of the time step may change while the run goes on
case = copy_case("rest0", "changing")
must(case, "rm", "-r", "3e-06")
edit(case, "system/controlDict", "runTimeModifiable no;", """
runTimeModifiable yes;
OptimisationSwitches { fileModificationSkew 0; }
functions
{
    change
    {
        type timeActivatedFileUpdate; libs (utilityFunctionObjects);
        fileToUpdate "<case>/system/controlDict";
        timeVsFile ((-1 "<case>/system/first") (1e-6 "<case>/system/later"));
    }
}""")
for name, entry in ("first", "no"), ("later", "yes"):
    must(case, "cp", "system/controlDict", f"system/{name}")
    with open(f"{case}/system/{name}", "a") as file:
        file.write(f"adjustTimeStep {entry}; maxCo 0.01;\n")
steps = solve(case).count("\nTime = ")
verdict("time_step_by_later_choice", steps > 4, f"{steps} steps, 3 without")

# A rank without cells
case = copy_case("rest0", "idleRank")
must(case, "rm", "-r", "3e-06")
decompose(case, of_cells=2*(np.arange(N*N) % N < 5))
solve(case, 3)
must(case, "reconstructPar")
apart = abs(last_fields(case, "p")[0]/found[0] - 1).max()
verdict("rank_without_cells", apart < 1e-12,
        f"p differs by {apart:.1e} from that of one rank, tolerance 1e-12")

case = copy_case("rest0", "noViscosity")
must(case, "rm", "-r", "3e-06")
edit(case, "system/fvSolution", "viscous no;", "")
edit(case, "constant/thermophysicalProperties", "As 1.458e-06", "As 0")
inviscid = ", inviscid, " in solve(case)
different = same_bits(case, "rest0", "3e-06")
verdict("viscosity_of_zero", inviscid and not different,
        "sutherland with As 0 is " + ("" if inviscid else "not ") + "inviscid"
        + "".join(", another " + name for name in different))
