# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""What stock solvers offer to our models and these do not take: cyclic patches
and symmetry planes as walls, two laws of drag, an inlet that moves. Stands in
an empty folder."""

import re

from caseTools import complaint, refuses, run, verdict, write_foam
from plate import SOLVER, injector, mesh, write_plate

FALLS = injector((0.4, 0.005, 0.09), (0.4, 0.005, 0.11), 2, (100, -100, 0),
                 50e-6)
WALL = "{ restitution 0.9; friction 0.1; }"
LID = '"[xy]Max" { type escape; } xMin { type escape; }'
CYCLIC = {"xMin": "patch", "xMax": "patch", "yMin": "wall", "yMax": "patch",
          "zMin": "cyclic", "zMax": "cyclic"}
MOVING = "icoUncoupledKinematicParcelDyMFoam"


def case(name, *, walls=f"yMin {WALL}", lid=LID, falls=FALLS, **options):
    write_plate(name, "hardSphereWall", f"patches ( {walls} {lid} );",
                [falls], **options)
    mesh(name)
    return name


def main():
    # A pattern that means walls, and takes in the cyclic patches beside them
    for name, walls, lid, warnings in (
            ("byPattern", f'"[yz]M.*n" {WALL}', LID, ["1(zMin)"]),
            ("byName", f"yMin {WALL}", LID, []),
            ("all", f'".*" {WALL}', "", [])):
        status, text = run(case("cyclic_" + name, sides=CYCLIC, walls=walls,
                                lid=lid), SOLVER)
        said = re.findall(r"stay what they are, among them (\S+)\.", text)
        verdict(f"warnsOfCyclicWalls_{name}",
                status == 0 and said == warnings,
                f"warned of {said}" if status == 0 else complaint(text))
    refuses("refuses_cyclicWall",
            run(case("cyclicNamed", sides=CYCLIC,
                     walls=f"yMin {WALL} zMin {WALL}"), SOLVER),
            ["zMin", "type cyclic", "multiInteraction"])
    refuses("refuses_secondDrag",
            run(case("twoDrags", extra="particleForces { sphereDrag;"
                     " lothDrag {} }", libs="parcelForces parcelInjection"
                     " parcelWallInteraction"), SOLVER),
            ["sphereDrag and lothDrag", "forces add up"])

    stream = ("type crossSectionInjection; patches (yMax); U0 (0 -10 0);"
              " volumeFraction 1e-6; diameter 1e-5; nParticle 1e6;")
    for moves in (False, True):
        name = case("inletMoves" if moves else "inletRests", falls=stream,
                    lid='"([xy]Max|xMin|z.*)" { type escape; }')
        write_foam(name, "constant/dynamicMeshDict", """
dynamicFvMesh dynamicMotionSolverFvMesh; motionSolverLibs (fvMotionSolvers);
motionSolver solidBody; solver solidBody; cellSet none;
solidBodyMotionFunction linearMotion; linearMotionCoeffs { velocity (1 0 0); }
""" if moves else "dynamicFvMesh staticFvMesh;")
        status, text = run(name, MOVING)
        if moves:
            refuses("refuses_movingInlet", (status, text),
                    ["mesh moves", "rakeInjection"], start=None)
        else:
            verdict("takesInletAtRest", status == 0,
                    complaint(text) if status else "runs")


main()
