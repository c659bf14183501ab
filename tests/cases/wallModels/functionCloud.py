# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Clouds of function objects move when their solver has written the directory
of the step: parcels in it and what injection models have counted must be of
the same instant, with wall models of the stock too."""

import os
import shutil

from caseTools import complaint, copy_case, edit, run, verdict, write_foam
from plate import CLOUD, injector, mesh, parcels, write_plate

SOLVER = "pimpleFoam"
STEP, WRITE, END = 2e-4, 5, 10
PLATE = 'patches ( ".*" { type rebound; } );'

case = "unbroken"
write_plate(case, "localInteraction", PLATE,
            [injector((0.3, y, 0.1), (0.7, y, 0.1), 10, (0, -1, 0), 1e-5)
             + f" startTime {(step - 0.5)*STEP!r};"
             for y, step in ((0.05, 2), (0.06, WRITE - 1), (0.07, WRITE))],
            end=END*STEP, step=STEP, write=WRITE)
with open(f"{case}/system/controlDict", "a", encoding="utf-8") as file:
    file.write("functions { sand { type icoUncoupledKinematicCloud; libs"
               " (lagrangianFunctionObjects parcelInjection"
               " parcelWallInteraction); } }\n")
edit(case, "system/fvSchemes", "divSchemes { default none; }",
     "divSchemes { default Gauss linear; }")
edit(case, "system/fvSchemes", "laplacianSchemes { default none; }",
     "laplacianSchemes { default Gauss linear orthogonal; }")
with open(f"{case}/system/fvSolution", "a", encoding="utf-8") as file:
    file.write('solvers { "(p|U).*" { solver PBiCGStab; preconditioner DILU;'
               " tolerance 1e-9; } } PIMPLE { nCorrectors 1; }\n")
with open(f"{case}/constant/transportProperties", "a",
          encoding="utf-8") as file:
    file.write("rho 1.2;\n")
write_foam(case, "0/p", """dimensions [0 2 -2 0 0 0 0];
internalField uniform 0;
boundaryField
{
    xMax { type fixedValue; value uniform 0; }
    ".*" { type zeroGradient; }
}""", "volScalarField")
mesh(case)
status, text = run(case, SOLVER)
end, middle = f"{END*STEP:g}", f"{WRITE*STEP:g}"
again = copy_case(case, "goesOn")
shutil.rmtree(f"{again}/{end}")
second, more = run(again, SOLVER)
if status or second:
    verdict("functionCloud_runs", False, complaint(text if status else more))
else:
    whole, parts = ([x.tolist() for x in parcels(
        c, end, "origProcId", "U", "age")] for c in (case, again))
    there = len(parcels(case, middle)[0])
    verdict("functionCloud_goesOn", whole == parts and len(whole[0]) == 30
            and there == 20,
            f"{there} parcels at the restart, {len(parts[0])} of"
            f" {len(whole[0])} at the end, "
            + ("the same to the bit" if whole == parts else "others"))

# All leave in the step of the write: nothing of them may stay in the directory
case = copy_case("unbroken", "empties")
for name in end, middle:
    shutil.rmtree(f"{case}/{name}")
text = PLATE.replace("type rebound", "type escape")
write_plate("emptied", "localInteraction", text,
            [injector((0.3, (WRITE - 0.5)*STEP, 0.1),
                      (0.7, (WRITE - 0.5)*STEP, 0.1), 10, (0, -1, 0), 1e-5)],
            end=END*STEP, step=STEP, write=WRITE)
shutil.copy(f"emptied/constant/{CLOUD}Properties",
            f"{case}/constant/{CLOUD}Properties")
status, text = run(case, SOLVER)
left = os.path.exists(f"{case}/{middle}/lagrangian/{CLOUD}/U")
verdict("functionCloud_empties", status == 0 and not left,
        complaint(text) if status else "parcels that have left are "
        + ("still there" if left else "gone"))
