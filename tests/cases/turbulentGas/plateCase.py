# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Supersonic flow along an isothermal plate with the k-omega SST model and
wall functions: the case that the tests of the turbulent gas share."""

import os

from caseTools import (box, edit, must, read_field, write_block, write_case,
                       write_field, write_foam)

P, T, U, WALL_T = 1e5, 300.0, 700.0, 400.0
K, OMEGA = 30.0, 3e4
END = 4e-4
NX, NY = 40, 24
SST = ("simulationType RAS;\n"
       "RAS { RASModel kOmegaSST; turbulence on; printCoeffs off; }")


def prepare(case, model, n=(NX, NY), grading="(1 12 1)", k=K, omega=OMEGA):
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
    write_block(case, box((0.2, 0.06, 0.01)), (*n, 1),
                {"xMin": "patch", "xMax": "patch", "yMin": "wall",
                 "yMax": "patch"}, grading)
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
    field("k", k, f"type kqRWallFunction; value uniform {k};")
    field("omega", omega,
          f"type omegaWallFunction; value uniform {omega};")
    field("nut", 0.0, "type nutkWallFunction; value uniform 0;")
    field("alphat", 0.0, "type compressible::alphatWallFunction;"
          " value uniform 0;")
    must(case, "blockMesh")


def prepare_steady(case, residual, **given):
    fields = "k omega"
    prepare(case, SST, **given)
    edit(case, "system/fvSchemes", "ddtSchemes { default Euler; }",
         "ddtSchemes { default Euler; "
         + " ".join(f"ddt(rho,{f}) steadyState;" for f in fields.split())
         + " }")
    edit(case, "system/fvSolution", "highSpeedGas { mode transient; }",
         "highSpeedGas { mode steady; residual %g;"
         " maxIterations 500; }\n"
         "relaxationFactors { equations { \"(%s)\" 0.7; } }"
         % (residual, fields.replace(" ", "|")))


def wall(case, time, name="wallShearStress"):
    """Wall shear over density, or heat flux, face by face."""
    faces = read_field(os.path.join(case, time, name), "yMin")
    return faces.reshape(len(faces), -1)
