# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Table of bad edits; stands in a folder with the prepared case 'good'."""

import math
import os
import re
import shutil

from caseTools import (complaint, copy_case, edit, must, refuses, run,
                       verdict, write_block, write_field, write_foam)

SOLUTION, SCHEMES = "system/fvSolution", "system/fvSchemes"
THERMO = "constant/thermophysicalProperties"
FLUXES = ["Kurganov", "SLAU2", "AUSMPlusUp", "HLLC"]
MODES = ["transient", "steady", "frozen"]


def gas(**settings):
    """A new highSpeedGas block."""
    def change(case):
        body = " ".join(f"{k} {v};" for k, v in settings.items())
        write_foam(case, SOLUTION, f"highSpeedGas {{ {body} }}")
    return change


def replace(path, old, new):
    return lambda case: edit(case, path, old, new)


def remove(path):
    return lambda case: os.remove(os.path.join(case, path))


def frozen_without(field):
    def change(case):
        gas(mode="frozen")(case)
        os.remove(os.path.join(case, "0", field))
    return change


def without_patch(case):
    with open(os.path.join(case, "0/p")) as file:
        text = file.read()
    with open(os.path.join(case, "0/p"), "w") as file:
        file.write(re.sub(r"\n\s*outlet\s*\{[^}]*\}", "", text))


def liquid(case):
    write_foam(case, THERMO, """
thermoType
{
    type heRhoThermo; mixture pureMixture; properties liquid;
    energy sensibleInternalEnergy;
}
mixture { H2O; }
""")


def several_gases(case):
    write_foam(case, THERMO, """
thermoType
{
    type hePsiThermo; mixture reactingMixture; transport const;
    thermo hConst; energy sensibleEnthalpy; equationOfState perfectGas;
    specie specie;
}
inertSpecie N2;
chemistryReader foamChemistryReader;
foamChemistryFile "$FOAM_CASE/constant/reactions";
foamChemistryThermoFile "$FOAM_CASE/constant/gases";
""")
    write_foam(case, "constant/reactions",
               "species (N2 O2);\nreactions {}")
    write_foam(case, "constant/gases", "".join(f"""
{name}
{{
    specie {{ molWeight {weight}; }}
    thermodynamics {{ Cp 1000; Hf 0; }}
    transport {{ mu 1.8e-5; Pr 0.7; }}
}}""" for name, weight in (("N2", 28), ("O2", 32))))
    write_foam(case, "0/Ydefault", """
dimensions [0 0 0 0 0 0 0];
internalField uniform 0.5;
boundaryField
{
    symmetry { type symmetryPlane; }
    frontAndBack { type empty; }
    ".*" { type zeroGradient; }
}""", "volScalarField")


def dense(state):
    """A liquid's equation of state."""
    def change(case):
        body = {
            "rhoConst": ("hConst", "const", "Cp 4180; Hf 0;",
                         "mu 1e-3; Pr 7;", "equationOfState { rho 1000; }"),
            "icoPolynomial": (
                "hPolynomial", "polynomial",
                "Hf 0; Sf 0; CpCoeffs<8> (4180 0 0 0 0 0 0 0);",
                "muCoeffs<8> (1e-3 0 0 0 0 0 0 0);"
                " kappaCoeffs<8> (0.6 0 0 0 0 0 0 0);",
                "equationOfState { rhoCoeffs<8> (1000 0 0 0 0 0 0 0); }")}
        thermo, transport, heat, coeffs, extra = body[state]
        write_foam(case, THERMO, f"""
thermoType
{{
    type heRhoThermo; mixture pureMixture; transport {transport};
    thermo {thermo}; equationOfState {state}; specie specie;
    energy sensibleEnthalpy;
}}
mixture
{{
    specie {{ molWeight 18; }}
    thermodynamics {{ {heat} }}
    transport {{ {coeffs} }}
    {extra}
}}""")
    return change


def coupled(case, sources=""):
    edit(case, "constant/sandCloud", "coupled         no;",
         "coupled yes;" + sources)


def source(entry):
    return lambda case: coupled(case, " sourceTerms { schemes { " + entry
                                + " } }")


def stock(case):
    """The stock cloud in the place of ours, without what only ours knows."""
    edit(case, "constant/sandCloud", "spinningKinematicCloud",
         "basicKinematicCloud")
    edit(case, "constant/sandCloud", "magnus;", "")
    edit(case, "constant/sandCloud", "rotation        off;", "")
    edit(case, "constant/sandCloud", """    motion
    {
        type            embeddedRK54;
        tolerance       1e-5;
    }
""", "")
    edit(case, "system/controlDict", "(spinningParcel)",
         "(parcelForces parcelInjection parcelWallInteraction)")


def stock_with(*edits):
    def change(case):
        stock(case)
        for old, new in edits:
            edit(case, "constant/sandCloud", old, new)
    return change


def stock_coupled(case):
    coupled(case)
    stock(case)


def with_file(path, body):
    return lambda case: write_foam(case, path, body)


def in_time(**schemes):
    """Marched in time with other schemes."""
    def change(case):
        gas(mode="transient")(case)
        for old, new in schemes.values():
            edit(case, SCHEMES, old, new)
    return change


def turbulent(body, ddt="Euler", **settings):
    def change(case):
        gas(**settings)(case)
        edit(case, SCHEMES, "default Euler", "default " + ddt)
        write_foam(case, "constant/turbulenceProperties", body)
        edit(case, SCHEMES, "ddtSchemes",
             "wallDist { method meshWave; } ddtSchemes")
        sides = {"symmetry": "type symmetryPlane;",
                 "frontAndBack": "type empty;", '".*"': "type zeroGradient;"}
        for field in "k", "omega", "nut", "alphat":
            write_field(case, field, 1, sides)
    return change


def elliptic(case):
    """A turbulence model whose phit has another scheme than k and epsilon."""
    turbulent("simulationType RAS; RAS { RASModel kEpsilonPhitF; turbulence"
              " on; }", mode="steady")(case)
    edit(case, SCHEMES, "default Euler", "default Euler; ddt(rho,k)"
         " steadyState; ddt(rho,epsilon) steadyState")
    with open(os.path.join(case, SOLUTION), "a") as file:
        file.write('relaxationFactors { equations { ".*" 0.5; } }')
    for field in "epsilon", "phit", "f":
        write_field(case, field, 1, {
            "symmetry": "type symmetryPlane;", "frontAndBack": "type empty;",
            '".*"': "type zeroGradient;"})


def without_header(path):
    def change(case):
        with open(os.path.join(case, path), "w") as file:
            file.write("simulationType RAS; RAS { RASModel kOmegaSST; }\n")
    return change


def quarter_ring(case):
    """A mesh whose sides are joined by a rotation."""
    def point(quarter, radius, z):
        angle = quarter*math.pi/2
        return radius*math.cos(angle), -radius*math.sin(angle), z
    corners = [point(*c, z) for z in (0, 0.1)
               for c in ((0, 1), (1, 1), (1, 2), (0, 2))]
    write_block(case, corners, (4, 4, 1),
                {"xMin": "cyclic", "xMax": "cyclic", "yMin": "patch",
                 "yMax": "patch"})
    must(case, "blockMesh")
    sides = {"xMin": "type cyclic;", "xMax": "type cyclic;",
             "yMin": "type zeroGradient;", "yMax": "type zeroGradient;",
             "zMin": "type empty;", "zMax": "type empty;"}
    for field, value in ("p", 1e5), ("T", 300), ("U", (0, 0, 0)):
        write_field(case, field, value, sides)


def wedge(layers, shift=0.0):
    """A wedge of layers around an axis beside the origin."""
    def change(case):
        def corner(x, r, side):
            angle = math.radians(side)
            return x, shift + r*math.cos(angle), r*math.sin(angle)
        write_block(case, [corner(x, r, side) for side in (-2, 2)
                           for x, r in ((0, 1), (1, 1), (1, 2), (0, 2))],
                    (4, 4, layers), {
                        "xMin": "patch", "xMax": "patch", "yMin": "patch",
                        "yMax": "patch", "zMin": "wedge", "zMax": "wedge"})
        must(case, "blockMesh")
        sides = {"zMin": "type wedge;", "zMax": "type wedge;",
                 '".*"': "type zeroGradient;"}
        for field, value in ("p", 1e5), ("T", 300), ("U", (0, 0, 0)):
            write_field(case, field, value, sides)
    return change


def changed(*edits):
    """Several edits of the cloud of the sand."""
    def change(case):
        for old, new in edits:
            edit(case, "constant/sandCloud", old, new)
    return change


def without_library(case):
    """The stock cloud without the library of its drag."""
    stock(case)
    edit(case, "system/controlDict", "(parcelForces ", "(")


RAS = "simulationType RAS; RAS { RASModel kOmegaSST; turbulence on; }"
RAKE = "constant/rake50Properties"
SAND = "constant/sand50Properties"
STREAM = "constant/sandStream"

def sizes(classes):
    """A stream of several sizes."""
    return replace(STREAM, "diameter        $:diameter",
                   f"sizes ({classes})")


# Name, change, texts that the message must hold
TABLE = [
    ("fluxScheme", replace(SCHEMES, "HLLC", "Roe"),
     ["fluxScheme", "Roe", *FLUXES, "fvSchemes"]),
    ("limiter", replace(SCHEMES, "vanAlbada", "vanAlbeda"),
     ["reconstruct", "vanAlbeda", "vanAlbada", "vanLeer", "Minmod"]),
    ("fluxSchemeKey", replace(SCHEMES, "fluxScheme ", "fluxscheme "),
     ["Unknown entry fluxscheme", "Did you mean fluxScheme?"]),
    ("gasOfParcels", replace("constant/sandCloud", "rho             cellLinear",
                             "Uu cellPoint; rho cellLinear"),
     ["field Uu", "interpolationSchemes", "thermo:mu", "curlUcDt"]),
    ("longestStep", replace("constant/sandCloud", "interpolationSchemes",
                            "deltaTMax 1e-9; interpolationSchemes"),
     ["deltaTMax", "1e-09", "none with motion embeddedRK54"]),
    ("temperatureAlone", replace("constant/sandCloud", "constantProperties\n{",
                                 "constantProperties\n{ T0 300;"),
     ["Entry T0", "heatTransfer on;", "solution"]),
    ("magnusCoefficient", replace("constant/sandCloud", "magnus;",
                                  "magnus { coefficient 3; }"),
     ["entry coefficient", "Valid: no entry", "magnus"]),
    ("virtualMassEntry", replace("constant/sandCloud", "magnus;",
                                 "magnus; virtualMass { Cvn 0.5; }"),
     ["entry Cvn", "Cvm"]),
    ("virtualMassRange", replace("constant/sandCloud", "magnus;",
                                 "magnus; virtualMass { Cvm -3; }"),
     ["Cvm -3", "[0, 1e3]"]),
    ("frameEntry", replace("constant/sandCloud", "magnus;",
                           "magnus; nonInertialFrame { omega w; }"),
     ["entry omega", "angularVelocity"]),
    ("frameFile", replace("constant/sandCloud", "magnus;",
                          "magnus; nonInertialFrame { angularVelocity w; }"),
     ["angularVelocity w", "file in constant"]),
    ("reconstructKey", replace(SCHEMES, "interpolationSchemes\n{",
                               "interpolationSchemes\n{ reconstruct(u) none;"),
     ["Unknown entry reconstruct(u)", "Did you mean reconstruct(U)?"]),
    ("dimensionsOfP", replace("0/p", "[1 -1 -2 0 0 0 0]", "[0 2 -2 0 0 0 0]"),
     ["dimensions of p", "[1 -1 -2 0 0 0 0]", "0/p"]),
    ("dimensionsOfU", replace("0/U", "[0 1 -1 0 0 0 0]", "[0 0 0 0 0 0 0]"),
     ["dimensions of U", "[0 1 -1 0 0 0 0]", "0/U"]),
    ("mode", gas(mode="stationary"), ["mode", "stationary", *MODES]),
    ("scheme", gas(mode="steady", scheme="RK4"),
     ["scheme", "RK4", "RK3", "implicit"]),
    ("implicitInTime", gas(mode="transient", scheme="implicit"),
     ["scheme", "implicit", "Euler RK2 RK3"]),
    ("implicitByDefault", gas(scheme="implicit"),
     ["scheme implicit", "(Euler RK2 RK3) with mode transient, the default"]),
    ("feedbackOfAWord", gas(mode="frozen", feedback="late"),
     ["Entry feedback is no block"]),
    ("surroundings", changed(
        ("active          yes;", "active yes; heatTransfer on;"),
        ("rho0            2500;", "rho0 2500; T0 300; Cp0 800;"
         " TSurroundings -3;")), ["TSurroundings -3", "[0, 1e8) K"]),
    ("emptyWall", changed(("type    escape;", "")),
     ["Entry type is missing", "the law, 'type escape;'"]),
    ("adhesionOfNothing", changed(
        ("patchInteractionModel hardSphereWall;",
         "patchInteractionModel jkrAdhesion;"),
        ("hardSphereWallCoeffs", "jkrAdhesionCoeffs"),
        ("""restitutionModel    McNamaraFalcon;
                restitution         0.7;
                restitutionSpeed    0.3;
""", "alpha 1;")), ["Entry contact is missing", "particle and wall"]),
    ("otherLibrary", without_library,
     ["add libs (parcelForces)", "type spinningKinematicCloud"]),
    ("misspelt", gas(mode="steady", maxCourant=0.5),
     ["maxCourant", "maxCo", "residual"]),
    ("maxCo_zero", gas(scheme="RK3", maxCo=0), ["maxCo 0:", "(0, 1]"]),
    ("maxCo_negative", gas(scheme="RK3", maxCo=-1),
     ["maxCo -1:", "(0, 1]"]),
    ("maxCo_two", gas(scheme="RK3", maxCo=2), ["maxCo 2:", "(0, 1]"]),
    ("maxCo_implicit", gas(mode="steady", maxCo=0), ["maxCo 0:", "1e9]"]),
    ("maxCo_word", gas(maxCo="large"), ["maxCo", "large", "fvSolution"]),
    ("residual_zero", gas(mode="steady", residual=0),
     ["residual 0:", "(0, 1)"]),
    ("residual_two", gas(mode="steady", residual=2),
     ["residual 2:", "(0, 1)"]),
    ("maxIterations", gas(mode="steady", maxIterations=0),
     ["maxIterations 0:", "[1, "]),
    ("reportEvery", gas(mode="steady", reportEvery=0),
     ["reportEvery 0:", "[1, "]),
    ("rhoConst", dense("rhoConst"),
     ["equationOfState", "rhoConst", "perfectGas", "thermophysical"]),
    ("icoPolynomial", dense("icoPolynomial"),
     ["equationOfState", "icoPolynomial", "perfectGas"]),
    ("liquid", liquid, ["properties liquid", "perfectGas", "thermophysical"]),
    ("reactingMixture", several_gases,
     ["mixture reactingMixture", "pureMixture"]),
    ("noSpecificHeat", replace(THERMO, "Cp          1004.675", "Cp 200"),
     ["Cp", "> 0", "thermophysicalProperties"]),
    ("negativeT", replace("0/T", "uniform 223.25", "uniform -223.25"),
     ["-223.25", "emperature"]),
    ("zeroP", replace("0/p", "uniform 26500", "uniform 0"),
     ["p = 0", "positive"]),
    ("negativeBoundaryT", replace("0/T", "value $internalField",
                                  "value uniform -10"),
     ["T", "-10", "freestream"]),
    ("missingP", remove("0/p"), ["/0/p"]),
    ("patchWithoutField", without_patch, ["outlet", "0/p"]),
    ("frozenWithoutU", frozen_without("U"), ["/0/U"]),
    ("frozenWithoutT", frozen_without("T"), ["/0/T"]),
    ("cloudTwice", replace("constant/parcelClouds", "(rake50)",
                           "(rake50 rake50)"),
     ["clouds", "rake50", "parcelClouds"]),
    ("cloudOfAField", replace("constant/parcelClouds", "(rake50)", "(p)"),
     ["clouds p", "a name that no field has", "volScalarField"]),
    ("sourceSmoothing", replace("constant/parcelClouds", "(rake50);",
                                "(rake50);\nsourceSmoothing 0;"),
     ["sourceSmoothing 0", "(0, 1e3] m", "parcelClouds"]),
    ("cloudWithoutProperties", replace("constant/parcelClouds", "(rake50)",
                                       "(dust)"), ["constant/dustProperties"]),
    ("cloudType", replace("constant/sandCloud", "spinningKinematicCloud",
                          "rollingKinematicCloud"),
     ["rollingKinematicCloud", "basicKinematicCloud",
      "spinningKinematicCloud"]),
    ("stockCoupled", stock_coupled, ["coupled yes", "no for a cloud"]),
    ("stockSolution", stock_with(("active ", "rotation off; active ")),
     ["Unknown entry rotation", "cellValueSourceCorrection", "solution"]),
    ("stockProperties", stock_with(("rho0 ", "rho1 2500; rho0 ")),
     ["Unknown entry rho1", "Did you mean rho0?", "constantProperties"]),
    ("stockModels", stock_with(("dispersionModel none",
                                "injectionModel none; dispersionModel none")),
     ["Unknown entry injectionModel", "Did you mean injectionModels?",
      "subModels"]),
    ("coupledSteadyGas", coupled, ["steady", "feedback {", "highSpeedGas"]),
    ("sourceFactor", source("U explicit 0.5;"),
     ["U explicit 0.5", "explicit 1", "what the parcels lose"]),
    ("sourceScheme", source("U implicit 1;"),
     ["Unknown U implicit", "explicit semiImplicit"]),
    ("sourceField", source("u explicit 1;"),
     ["Unknown entry u", "Did you mean U?"]),
    ("gravityWithoutFile", replace("constant/sandCloud", "        magnus;",
                                   "        magnus; gravity;"),
     ["gravity", "constant/g", "value (0 0 -9.81)"]),
    ("wordForBlock", replace("constant/sandCloud", "    particleForces",
                             "particleForces none; other"),
     ["particleForces", "not a sub-dictionary", "subModels"]),
    ("secondBlock", replace(SOLUTION, "highSpeedGas",
                            "highSpedGas { mode frozen; } highSpeedGas"),
     ["Unknown entry highSpedGas", "Did you mean highSpeedGas?"]),
    ("motion", replace("constant/sandCloud", "embeddedRK54", "leapfrog"),
     ["motion", "leapfrog", "stock", "embeddedRK54"]),
    ("tolerance", replace("constant/sandCloud", "1e-5", "-1"),
     ["tolerance -1", "[1e-14, 0.1]"]),
    ("restitution", replace("constant/sandCloud", "restitution         0.7",
                            "restitution 1.7"),
     ["restitution", "1.7", "[0, 1]"]),
    ("friction", replace("constant/sandCloud", "friction            0.2",
                         "friction -0.2"), ["friction", "-0.2", "[0, "]),
    ("includedUnknown", replace("constant/sandCloud", "dispersionModel none;",
                                "dispersionModel none; weather fine;"),
     ["Unknown entry weather", "dispersionModel", "subModels"]),
    ("particleForce", replace("constant/sandCloud", "hendersonDrag;",
                              "hendersenDrag;"),
     ["hendersenDrag", "hendersonDrag", "sphereDrag"]),
    ("TwOverT", replace("constant/sandCloud", "hendersonDrag;",
                        "hendersonDrag { TwOverT -1; }"),
     ["TwOverT -1", "(0, 1000]"]),
    ("volumeFraction", replace(STREAM, "1e-5", "0.2"),
     ["volumeFraction 0.2:", "(0, "]),
    ("diameter_stream", replace(SAND, "50e-6", "0"),
     ["diameter 0:", "[1e-10, 100]"]),
    ("diameter_rake", replace(RAKE, "50e-6", "0"),
     ["diameter 0:", "[1e-10, 100]"]),
    ("micrometres_stream", replace(SAND, "50e-6", "50"),
     ["diameter 50:", "corner of the mesh", "in metres"]),
    ("micrometres_rake", replace(RAKE, "50e-6", "50"),
     ["diameter 50:", "corner of the mesh", "in metres"]),
    ("secondDrag", replace("constant/sandCloud", "hendersonDrag;",
                           "hendersonDrag; sphereDrag;"),
     ["hendersonDrag and sphereDrag", "forces add up"]),
    ("volumeFraction_limit", replace(STREAM, "1e-5", "0.1"),
     ["volumeFraction 0.1:", "(0, 0.1)"]),
    ("volumeFraction_zero", replace(STREAM, "1e-5", "0"),
     ["volumeFraction 0:", "(0, 0.1)"]),
    ("neitherSizes", replace(STREAM, "diameter        $:diameter;", ""),
     ["sizes is missing, as is diameter"]),
    ("noSizes", sizes(""), ["sizes ()", "at least one"]),
    ("sizesDiameter", sizes("(5e-6 0.5) (-1e-5 0.5)"),
     ["sizes -1e-05:", "[1e-10, 100]"]),
    ("sizesShare", sizes("(5e-6 1.5) (1e-5 -0.5)"),
     ["sizes 1.5:", "(0, 1]"]),
    ("sizesSum", sizes("(5e-6 0.5) (1e-5 0.4)"),
     ["sum of the fractions of sizes 0.9:", "[0.999999, 1.000001]"]),
    ("stream_speed", replace(STREAM, "1797.172554", "0"),
     ["U0 (0 0 0)"]),
    ("density", replace("constant/sandCloud", "2500", "-2500"),
     ["rho0 -2500:", "(0, 1e6)"]),
    ("restitution_negative",
     replace("constant/sandCloud", "restitution         0.7",
             "restitution -0.1"), ["restitution", "-0.1", "[0, 1]"]),
    ("injectionPatch", replace(STREAM, "(freestream)", "(nowhere)"),
     ["patches", "nowhere", "freestream", "cylinder"]),
    ("timeStep", replace("system/controlDict", "deltaT ", "deltaT 0; //"),
     ["deltaT 0", "(0, 1e12] s", "controlDict"]),
    ("movingMesh", with_file("constant/dynamicMeshDict",
                             "dynamicFvMesh dynamicMotionSolverFvMesh;"),
     ["dynamicFvMesh", "dynamicMotionSolverFvMesh", "staticFvMesh"]),
    ("localEuler", in_time(ddt=("default Euler", "default localEuler")),
     ["localEuler", "mode steady", "Euler"]),
    ("steadyState", in_time(ddt=("default Euler", "default steadyState")),
     ["steadyState", "mode steady", "Euler"]),
    ("boundedSteadyState", in_time(
        ddt=("default Euler", "default bounded steadyState")),
     ["steadyState", "mode steady", "Euler"]),
    ("steadySchemesOfParcels", replace(
        SCHEMES, "default Euler", "default steadyState"),
     ["default steadyState", "transient yes", "default Euler"]),
    ("inletOfChance", replace(
        "0/T", "outlet      { type zeroGradient; }",
        "outlet { type turbulentInlet; referenceField uniform 223.25;"
        " fluctuationScale 0.01; value uniform 223.25; }"),
     ["Field T", "turbulentInlet", "outlet", "mode transient"]),
    ("wedgeOfLayers", wedge(3), ["wedge", "one layer"]),
    ("wedgeBesideOrigin", wedge(1, 0.5),
     ["origin", "transformPoints -translate"]),
    ("fvOptions", with_file("system/fvOptions", "heater"
                            " { type scalarSemiImplicitSource; active yes; }"),
     ["heater", "fvOptions", "active no"]),
    ("fvOptionsOfConstant", with_file(
        "constant/fvOptions", "heater { type fixedTemperatureConstraint; }"),
     ["heater", "fvOptions", "active no"]),
    ("MRF", with_file("constant/MRFProperties",
                      "rotor { cellZone rotor; omega 10; }"),
     ["rotor", "MRFProperties", "active no"]),
    ("porosity", with_file("constant/porosityProperties",
                           "grid { type DarcyForchheimer; active yes; }"),
     ["grid", "porosityProperties", "active no"]),
    ("radiation", with_file("constant/radiationProperties",
                            "radiation on; radiationModel P1;"),
     ["radiationModel", "P1", "none"]),
    ("turbulentWithoutFriction", turbulent(RAS, mode="transient",
                                           viscous="no"),
     ["simulationType", "RAS", "viscous yes", "laminar"]),
    ("turbulentSteadyInTime", turbulent(RAS, mode="steady"),
     ["ddt(rho,k)", "Euler", "steadyState"]),
    ("turbulentSteadyUnrelaxed", turbulent(
        RAS, ddt="steadyState", mode="steady"),
     ["equation of k", "equations { k 0.7; }"]),
    ("turbulentSteadyPhit", elliptic,
     ["ddt(rho,phit)", "Euler", "steadyState"]),
    ("turbulentSteadyLES", turbulent(
        "simulationType LES; LES { LESModel kEqn; turbulence on;"
        " delta cubeRootVol; cubeRootVolCoeffs { deltaCoeff 1; } }",
        mode="steady"),
     ["simulationType", "LES", "mode transient", "laminar"]),
    ("laminarModel", turbulent(
        "simulationType laminar; laminar { model Maxwell;"
        " MaxwellCoeffs { nuM 1; lambda 1; } }", mode="transient"),
     ["Maxwell", "Stokes"]),
    ("turbulenceWithoutHeader", without_header(
        "constant/turbulenceProperties"),
     ["turbulenceProperties", "FoamFile"]),
    ("rotationalCyclic", quarter_ring,
     ["xMin", "rotation", "translations"]),
    ("patchInteractionModel", replace("constant/sandCloud",
                                      "patchInteractionModel hardSphereWall",
                                      "patchInteractionModel hardSpereWall"),
     ["hardSpereWall", "Did you mean hardSphereWall", "rebound"]),
    ("integrationScheme", replace("constant/sandCloud", "Euler;", "Eular;"),
     ["Eular", "Did you mean Euler", "analytical"]),
    ("trackingCo", replace("constant/sandCloud", "transient       yes;",
                           "transient yes; maxCo 0;"),
     ["maxCo 0:", "[1e-6, 1e6]"]),
    ("impactPatch", replace(RAKE, "patches     (cylinder)",
                            "patches (nowhere)"),
     ["patches", "nowhere", "freestream", "cylinder"]),
]


OF_THE_STREAM = ("volumeFraction", "volumeFraction_limit",
                 "volumeFraction_zero", "diameter_stream",
                 "micrometres_stream", "neitherSizes", "noSizes",
                 "sizesDiameter", "sizesShare", "sizesSum", "stream_speed",
                 "density", "injectionPatch")


def trial(name, change):
    # A folder whose name is no word of the table: messages hold the path
    case = copy_case("good", "trial")
    clouds = "sand50" if change and name in OF_THE_STREAM else "rake50"
    write_foam(case, "constant/parcelClouds", f"clouds ({clouds});")
    edit(case, "system/controlDict", "endTime         6.4e-4",
         "endTime 1e-6")
    if change:
        change(case)
    status, text = run(case, "rhoCentralParcelFoam")
    shutil.rmtree(case)
    return status, text


# The case itself must be good, with a short march
for name in "good_rake50", "volumeFraction":
    status, text = trial(name, None if name == "good_rake50"
                         else replace(SOLUTION, "residual        1e-6",
                                      "maxIterations 1"))
    verdict("good_" + name.replace("good_", ""),
            status == 0 and "\nEnd" in text, complaint(text)
            if status else "the unspoilt case runs")

for name, change, words in TABLE:
    refuses(name, trial(name, change), words)
