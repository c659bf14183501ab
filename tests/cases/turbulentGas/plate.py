# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Supersonic flow along an isothermal plate with the k-omega SST model and
wall functions; stands in a folder of its own."""

import os
import re

import numpy as np
from caseTools import (box, copy_case, decompose, edit, last_fields, must,
                       same_bits, solve, verdict, write_block, write_case,
                       write_field, write_foam)

P, T, U, WALL_T = 1e5, 300.0, 700.0, 400.0
K, OMEGA = 30.0, 3e4
END = 4e-4
NX, NY = 40, 24


def prepare(case, model):
    write_case(case, {"endTime": END, "deltaT": 1e-7, "writeInterval": END/2,
                      "writeControl": "adjustable", "adjustTimeStep": "yes",
                      "maxCo": 0.2, "maxDeltaT": 1, "writePrecision": 17,
                      "functions": ""}, {"mode": "transient",
                                         "viscous": "yes"},
               flux="Kurganov", limiter="vanLeer")
    edit(case, "system/controlDict", "functions ;", """
functions
{
    shear { type wallShearStress; libs (fieldFunctionObjects);
        patches (yMin); writeControl writeTime; }
    yPlus { type yPlus; libs (fieldFunctionObjects); writeControl writeTime; }
    heat { type wallHeatFlux; libs (fieldFunctionObjects); patches (yMin);
        writeControl writeTime; }
    eddies { type turbulenceFields; libs (fieldFunctionObjects);
        field R; writeControl writeTime; }
}""")
    write_foam(case, "system/fvSchemes", """
fluxScheme Kurganov;
ddtSchemes { default Euler; }
gradSchemes { default Gauss linear; }
divSchemes { default none; div(tauMC) Gauss linear;
    div(phi,k) Gauss upwind; div(phi,omega) Gauss upwind; }
laplacianSchemes { default Gauss linear corrected; }
interpolationSchemes { default linear; reconstruct(rho) vanLeer;
    reconstruct(U) vanLeerV; reconstruct(T) vanLeer; }
snGradSchemes { default corrected; }
wallDist { method meshWave; }""")
    write_foam(case, "system/fvSolution", """
solvers
{
    "(rho|rhoU|rhoE)" { solver diagonal; }
    "(U|e|k|omega)" { solver smoothSolver; smoother GaussSeidel;
        nSweeps 2; tolerance 1e-10; relTol 0.01; }
}
highSpeedGas { mode transient; }""")
    write_foam(case, "constant/turbulenceProperties", model)
    write_block(case, box((0.2, 0.06, 0.01)), (NX, NY, 1),
                {"xMin": "patch", "xMax": "patch", "yMin": "wall",
                 "yMax": "patch"}, "(1 12 1)")
    zero = "type zeroGradient;"
    sides = {"zMin": "type empty;", "zMax": "type empty;", "xMax": zero,
             "yMax": zero}

    def field(name, value, wall):
        text = (f"({value[0]} 0 0)" if isinstance(value, tuple)
                else repr(value))
        write_field(case, name, value, {
            **sides, "yMin": wall,
            "xMin": f"type fixedValue; value uniform {text};"})

    field("p", P, zero)
    field("T", T, f"type fixedValue; value uniform {WALL_T};")
    field("U", (U, 0, 0), "type noSlip;")
    field("k", K, f"type kqRWallFunction; value uniform {K};")
    field("omega", OMEGA,
          f"type omegaWallFunction; value uniform {OMEGA};")
    field("nut", 0.0, "type nutkWallFunction; value uniform 0;")
    field("alphat", 0.0, "type compressible::alphatWallFunction;"
          " value uniform 0;")
    must(case, "blockMesh")


def shear(case, name="wallShearStress"):
    """Wall shear over density, or heat flux, face by face."""
    with open(os.path.join(case, f"{END:g}", name), "rb") as file:
        data = file.read()
    patch = data.index(b"yMin", data.index(b"boundaryField"))
    head = re.compile(rb"List<(\w+)>\s+(\d+)\s*\(").search(data, patch)
    width = 3 if head.group(1) == b"vector" else 1
    n = int(head.group(2))
    return np.frombuffer(data, float, n*width, head.end()).reshape(n, width)


SST = "simulationType RAS;\nRAS { RASModel kOmegaSST; turbulence on;" \
      " printCoeffs off; }"
prepare("ours", SST)
for case in "restarted", "ranks":
    copy_case("ours", case)
solve("ours")
stress = -shear("ours")[:, 0]
nut, = last_fields("ours", "nut")
verdict("eddies", nut.max() > 1e-3 and stress[4:].min() > 0,
        f"nut up to {nut.max():.1e} m2/s, wanted 1e-3; stress over density"
        f" {stress[4:].min():.0f} to {stress[4:].max():.0f} m2/s2")
missing = [f for f in ("wallShearStress", "yPlus", "wallHeatFlux",
                       "turbulenceProperties:R")
           if not os.path.exists(os.path.join("ours", f"{END:g}", f))]
verdict("functionObjects", not missing,
        "missing: " + (" ".join(missing) or "none"))

prepare("laminar", "simulationType laminar;")
edit("laminar", "system/controlDict", f"endTime {END}", "endTime 2e-6")
edit("laminar", "system/controlDict", f"writeInterval {END/2}",
     "writeInterval 2e-6")
edit("laminar", "system/controlDict", "type turbulenceFields",
     "enabled no; type turbulenceFields")
solve("laminar")
verdict("functionObjectsLaminar",
        os.path.exists("laminar/2e-06/wallShearStress"),
        "wallShearStress in laminar flow")

edit("restarted", "system/controlDict", f"endTime {END}", f"endTime {END/2}")
solve("restarted")
edit("restarted", "system/controlDict", f"endTime {END/2}", f"endTime {END}")
solve("restarted")
different = same_bits("ours", "restarted", f"{END:g}", "p T U k omega nut")
verdict("restartBitwise", not different,
        "straight run = restarted run; different: "
        + (" ".join(different) or "nothing"))

decompose("ranks", (2, 1, 1))
solve("ranks", 2)
must("ranks", "reconstructPar")
d = [abs(x - y).max()/abs(x).max()
     for x, y in zip(last_fields("ours", "p T U k omega"),
                     last_fields("ranks", "p T U k omega"))]
verdict("twoRanks", max(d) < 1e-5,
        f"largest relative difference {max(d):.1e}, tolerance 1e-5 (the linear"
        " solvers of k and omega stop at a residual)")
