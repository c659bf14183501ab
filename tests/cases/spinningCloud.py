# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""A spinning cloud with error control in a frozen or steady gas."""

from caseTools import write_foam


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
