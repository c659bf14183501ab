# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""A spinning cloud with error control in a frozen or steady gas."""

from caseTools import (box, must, write_block, write_case, write_field,
                       write_foam)


def write_cloud(case, name, injection, *, forces="", walls="", models="",
                coupled="no", solution="", constants="rho0 2500;",
                tolerance=1e-5):
    """Its dictionary, without spin; by default parcels escape everywhere."""
    walls = walls or ("patchInteractionModel standardWallInteraction;"
                      " standardWallInteractionCoeffs { type escape; }")
    write_foam(case, f"constant/{name}Properties", f"""
type spinningKinematicCloud;
solution
{{
    active yes; coupled {coupled}; transient yes; rotation off;
    cellValueSourceCorrection off; {solution}
    motion {{ type embeddedRK54; tolerance {tolerance!r}; }}
    interpolationSchemes {{}}
    integrationSchemes {{ U Euler; }}
}}
constantProperties {{ {constants} }}
subModels
{{
    particleForces {{ {forces} }}
    injectionModels {{ {name} {{ {injection} }} }}
    {walls}
    dispersionModel none; stochasticCollisionModel none;
    surfaceFilmModel none; {models}
}}
cloudFunctions {{}}
""")


def write_cube(case, length, n, control):
    """A cube of patches with n cells a side, in which the gas is frozen and a
    cloud, dust, flies."""
    write_case(case, control, {"mode": "frozen"})
    sides = {s + e: "type zeroGradient;" for s in "xyz"
             for e in ("Min", "Max")}
    write_block(case, box((length,)*3), (n, n, n),
                {side: "patch" for side in sides})
    write_field(case, "p", 1e5, sides)
    write_field(case, "T", 300.0, sides)
    write_field(case, "U", (0.0, 0.0, 0.0), sides)
    write_foam(case, "constant/parcelClouds", "clouds (dust);")
    must(case, "blockMesh")
