# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Grains that fall onto a plane, or into the edge of two, bounce out and slide
along in gravity at a slope: where they get to must not depend on the time step,
which is longer than their last bounces."""

from caseTools import (box, largest, must, read_field, solve, times_of,
                       verdict, write_block, write_case, write_field,
                       write_foam)
from foamFiles import positions
from spinningCloud import write_cloud

END, START = 0.12, 0.002
PULL, DOWN, FRICTION = 5.0, 9.81, 0.2


def place(name, dt, aside=0.0):
    write_case(name, {"endTime": END, "deltaT": dt, "writeInterval": END,
                      "writeFormat": "ascii",
                      "libs": "(spinningParcel parcelInjection)"},
               {"mode": "frozen"})
    kinds = {s + e: "patch" for s in "xyz" for e in ("Min", "Max")}
    kinds["yMin"] = kinds["zMin"] = "wall"
    write_block(name, box((0.05, 0.01, 0.04)), (10, 2, 2), kinds)
    sides = dict.fromkeys(kinds, "type zeroGradient;")
    write_field(name, "p", 1e5, sides)
    write_field(name, "T", 300.0, sides)
    write_field(name, "U", (0.0, 0.0, 0.0), sides)
    write_foam(name, "constant/g",
               "dimensions [0 1 -2 0 0 0 0];"
               f" value ({PULL} {-DOWN} {-aside!r});",
               "uniformDimensionedVectorField")
    # Along the edge nothing but gravity is to act
    friction, z = (0, 1e-4) if aside else (FRICTION, 0.02)
    write_cloud(
        name, "dust", f"""
        type rakeInjection; start ({START} 1e-4 {z}); end ({START} 1e-4 {z});
        nParcels 1; diameter 2e-3; U0 (0 0 0);""", forces="gravity;",
        walls=f"""patchInteractionModel hardSphereWall; hardSphereWallCoeffs
        {{
            patches
            (
                "[yz]Min" {{ restitution 0.5; friction {friction}; }}
                "x.*|[yz]Max" {{ type escape; }}
            );
        }}""")
    write_foam(name, "constant/parcelClouds", "clouds (dust);")
    must(name, "blockMesh")
    solve(name)
    folder = f"{name}/{times_of(name)[-1]}/lagrangian/dust"
    return positions(folder)[0][0], read_field(f"{folder}/U")[0]


# Friction takes its share of all that the wall gives, in bounces and between
# them; what it takes before the first one is less than this
exact = START + 0.5*(PULL - FRICTION*DOWN)*END**2
speed = (PULL - FRICTION*DOWN)*END
for name, dt in ("slideShort", 1e-4), ("slide", 1e-3), ("slideLong", 1e-2):
    x, u = place(name, dt)
    way, velocity = (x[0] - START)/(exact - START) - 1, u[0]/speed - 1
    verdict(name, 0 < way < 0.05 and abs(x[1]) < 1e-4
            and 0 < velocity < 0.03,
            f"deltaT {dt:g}: way {100*way:.2f} % and speed {100*velocity:.2f}"
            " % more than those of a grain that slides from the start; bounds"
            " 0 to 5 and 3 %")

for name, dt in ("edge", 1e-3), ("edgeLong", 1e-2):
    x, u = place(name, dt, 7.0)
    way, speed = (x[0] - START)/(0.5*PULL*END**2) - 1, u[0]/(PULL*END) - 1
    verdict(name, abs(way) < 0.005 and abs(speed) < 1e-3
            and largest(abs(x[1:])) < 1e-4,
            f"deltaT {dt:g}: way off by {100*way:.2f} % and speed by"
            f" {100*speed:.3f} %, bounds 0.5 and 0.1 %")
