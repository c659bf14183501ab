# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Collisions of grains that stick to a wall and come off it again: what a layer
releases where another grain has just struck it is no injection upon others, and
no mass goes; stands in a temporary folder."""

import re

from caseTools import (box, must, solve, verdict, write_block, write_case,
                       write_field, write_foam)
from spinningCloud import write_cloud

END = 6e-2
SLOW = ("type crossSectionInjection; patches (yMax); U0 (0.02 -1 0.03);"
        " volumeFraction 1e-4; sizes ((1e-5 0.3) (2e-5 0.7)); nParticle 1;")
FAST = ("type crossSectionInjection; patches (yMax); U0 (3 -20 1); seed 4;"
        " volumeFraction 1.5e-5; diameter 3e-5; nParticle 1; startTime 0.01;")
WALLS = """
patchInteractionModel jkrAdhesion;
jkrAdhesionCoeffs
{
    patches
    (
        "yMin"
        {
            contact { modulus 50e9; workOfAdhesion 0.3; }
            alpha 0.9; friction 0.3; LAYER
        }
        "yMax" { type escape; }
    );
    sizeClasses (1.5e-5);
}
"""
LAYER = "layer { modulus 36.5e9; workOfAdhesion 0.06; }"


def counts(case, layer, overlapping):
    """Of the log at the end: masses, and injections upon others."""
    write_case(case, {"endTime": END, "deltaT": 1e-5, "writeInterval": END,
                      "libs": "(spinningParcel parcelInjection"
                              " parcelWallInteraction)"},
               {"mode": "frozen"})
    kinds = {"xMin": "cyclic", "xMax": "cyclic", "yMin": "wall",
             "yMax": "patch", "zMin": "cyclic", "zMax": "cyclic"}
    write_block(case, box((5e-4, 5e-4, 5e-4)), (8, 8, 8), kinds)
    must(case, "blockMesh")
    sides = {side: "type cyclic;" if kind == "cyclic" else
             "type zeroGradient;" for side, kind in kinds.items()}
    write_field(case, "p", 1e5, sides)
    write_field(case, "T", 300.0, sides)
    write_field(case, "U", (0, 0, 0), sides)
    write_cloud(case, "slow", SLOW + " } fast { " + FAST,
                walls=WALLS.replace("LAYER", layer and LAYER),
                solution="collisions { type eventDriven; restitution 0.7;"
                f" friction 0.2; overlappingInjection {overlapping}; }}")
    write_foam(case, "constant/parcelClouds", "clouds (slow);")
    log = solve(case)
    last = log[log.rindex("Cloud: slow"):]

    def number(pattern):
        return [float(x) for x in re.findall(pattern, last)]

    injected = sum(number(r"mass introduced\s+= (\S+)"))
    kept = sum(sum(number(pattern)) for pattern in (
        r"Current mass in system\s+= (\S+)",
        r"escaped \(number, mass\)\s+= \S+ (\S+)",
        r"adhered \(number, mass\)\s+= \S+ (\S+)"))
    released = number(r"detached particles\s+= (\S+)")
    upon = number(r"Injections upon others\s+= \d+; in all (\d+)")
    return injected/kept - 1, sum(released), sum(upon)


bare = counts("layerBare", "", "refuse")
refused = counts("layerRefuse", LAYER, "refuse")
apart = counts("layerSeparate", LAYER, "separate")
more = refused[2] - bare[2]
verdict("layer_releasesStay",
        refused[1] > 30 and abs(more) < 0.1*refused[1],
        f"{refused[1]:.0f} grains came off the layer; {refused[2]:.0f}"
        f" injections upon others were refused, {bare[2]:.0f} without a layer"
        " (other ways), tolerance a tenth of those that came off")
verdict("layer_mass", apart[1] > 30 and abs(apart[0]) < 1e-5,
        f"{apart[1]:.0f} grains came off the layer; mass injected over that in"
        f" flight, escaped and adhered: 1 + {apart[0]:.1e}, tolerance 1e-5")
