# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Free flight of the spin-carrying cloud through a wedge, past and through its
axis; stands in a temporary folder."""

import re

import numpy as np

from caseTools import (R_GAS, complaint, copy_case, edit, must, read_field, run,
                       solve, times_of, verdict, write_case, write_field,
                       write_foam)
from foamFiles import positions
from spinningCloud import write_cloud

CLOUD = """
type spinningKinematicCloud;
solution
{
    active yes; coupled no; transient yes; cellValueSourceCorrection off;
    maxCo 0.3;
    MOTION
    interpolationSchemes
    { rho SCHEME; U SCHEME; T SCHEME; thermo:mu SCHEME; }
    integrationSchemes { U Euler; }
}
constantProperties { rho0 2500; omega0 (3e4 -4e4 5e4); }
subModels
{
    particleForces {}
    rotationalTorqueModel none;
    injectionModels
    {
        rake
        {
            type rakeInjection; start START; end END; nParcels 40;
            diameter 1e-5; U0 VELOCITY;
        }
    }
    patchInteractionModel standardWallInteraction;
    standardWallInteractionCoeffs { type escape; }
    dispersionModel none; stochasticCollisionModel none;
    surfaceFilmModel none;
}
cloudFunctions {}
"""
N = 40
END = 8e-5
START, LAST = np.array([0.01, 0.004, 0]), np.array([0.03, 0.03, 0])
EMBEDDED = "motion { type embeddedRK54; tolerance 1e-6; }"
CLOUDS = {"linear": (EMBEDDED, "cellLinear", (300, -600, 100)),
          "point": (EMBEDDED, "cellPoint", (300, -600, 100)),
          "linearThrough": (EMBEDDED, "cellLinear", (300, -600, 0)),
          "pointThrough": (EMBEDDED, "cellPoint", (300, -600, 0))}


def vector(x):
    return "(" + " ".join(repr(float(v)) for v in x) + ")"


case = "wedge"
write_case(case, {"endTime": END, "deltaT": END/8, "writeInterval": END,
                  "writeFormat": "ascii", "writePrecision": 16,
                  "libs": "(spinningParcel parcelInjection)"},
           {"mode": "frozen"})
c, s = 0.1*np.cos(np.radians(2.3)), 0.1*np.sin(np.radians(2.3))
sides = {"xMin": "(0 3 5 0)", "xMax": "(1 2 4 1)", "yMax": "(3 5 4 2)",
         "zMin": "(0 1 2 3)", "zMax": "(0 1 4 5)"}
kinds = {side: "wedge" if side[0] == "z" else "patch" for side in sides}
write_foam(
    case, "system/blockMeshDict",
    f"vertices ((0 0 0) (0.1 0 0) (0.1 {c!r} {-s!r}) (0 {c!r} {-s!r})"
    f" (0.1 {c!r} {s!r}) (0 {c!r} {s!r}));\n"
    "blocks (hex (0 1 2 3 0 1 4 5) (20 20 1) simpleGrading (1 1 1));\n"
    "edges ();\nboundary (\n" + "\n".join(
        f"{side} {{ type {kinds[side]}; faces ({face}); }}"
        for side, face in sides.items()) + "\n);")
must(case, "blockMesh")
fields = {side: "type wedge;" if side[0] == "z" else "type zeroGradient;"
          for side in sides}
write_field(case, "p", 3e4, fields)
write_field(case, "T", 250.0, fields)
write_field(case, "U", (0.0, 0.0, 0.0), fields)
for name, (motion, scheme, velocity) in CLOUDS.items():
    text = CLOUD
    for key, value in (("MOTION", motion), ("SCHEME", scheme),
                       ("START", vector(START)), ("END", vector(LAST)),
                       ("VELOCITY", vector(velocity))):
        text = text.replace(key, value)
    write_foam(case, f"constant/{name}Properties", text)
write_foam(case, "constant/parcelClouds", f"clouds ({' '.join(CLOUDS)});")
stock = copy_case(case, "wedgeStock")
log = solve(case)
rested = sum(int(n) for n in re.findall(
    r"uncontrolled, at rest *= *\d+, (\d+)", log))


def of_axis(x, u, spin):
    return np.column_stack([
        x[:, 0]/0.1, np.hypot(x[:, 1], x[:, 2])/0.1, u[:, 0]/600,
        (x[:, 1]*u[:, 1] + x[:, 2]*u[:, 2])/60,
        (x[:, 1]*u[:, 2] - x[:, 2]*u[:, 1])/60,
        spin[:, 0]/3e4, np.linalg.norm(spin, axis=1)/3e4])


identities = np.arange(40)
for name, (_, _, velocity) in CLOUDS.items():
    folder = f"{case}/{times_of(case)[-1]}/lagrangian/{name}"
    order = np.argsort(read_field(f"{folder}/origId"))
    n = len(order)
    if n != 40:
        verdict(f"wedge_{name}", False, f"{n} parcels of 40")
        continue
    x = positions(folder)[0][order]
    u = read_field(f"{folder}/U")[order]
    spin = read_field(f"{folder}/omega")[order]
    u0 = np.tile(np.array(velocity, float), (40, 1))
    there = (START + (LAST - START)*identities[:, None]/39 + END*u0)
    exact = of_axis(there, u0, np.tile([3e4, -4e4, 5e4], (40, 1)))
    error = np.abs(of_axis(x, u, spin) - exact).max()
    past = np.count_nonzero(there[:, 1] < 0)
    verdict(f"wedge_{name}", error < 1e-9 and past > 10,
            f"largest error {error:.1e}, {past} parcels went past the axis,"
            f" {rested} rests")

write_foam(stock, "constant/parcelClouds", "clouds (linearThrough);")
edit(copy_case(stock, "wedgeRough"), "constant/linearThroughProperties",
     EMBEDDED, "")
for old, new in (
        ("type spinningKinematicCloud", "type basicKinematicCloud"),
        (" omega0 (3e4 -4e4 5e4);", ""), ("rotationalTorqueModel none;", ""),
        ("standardWallInteraction;", "nonSphericalRebound;"),
        ("standardWallInteractionCoeffs { type escape; }",
         'nonSphericalReboundCoeffs { patches (".*"'
         " { shape { type ellipsoid; size (2 1 1); } wall { type smooth; }"
         " law { type restitution; } }); }")):
    edit("wedgeRough", "constant/linearThroughProperties", old, new)
edit("wedgeRough", "system/controlDict", "(spinningParcel parcelInjection)",
     "(parcelInjection parcelWallInteraction)")
status, text = run("wedgeRough", "rhoCentralParcelFoam")
said = complaint(text)
verdict("wedge_refuses_azimuthal_rebounds",
        status != 0 and "axis of a wedge" in said, f"exit {status}: {said}")

edit(stock, "constant/linearThroughProperties", EMBEDDED, "motion stock;")
status, text = run(stock, "rhoCentralParcelFoam")
said = complaint(text)
verdict("wedge_refuses_stock_motion",
        status != 0 and "wedge" in said and "embeddedRK54" in said,
        f"exit status {status}: {said}")

# Gas that turns about the axis with 20 m/s everywhere, and grains that begin
# with it: against the equations in r and the two velocities
swirl = copy_case(stock, "wedgeSwirl")
write_field(swirl, "U", (0.0, 0.0, 20.0), fields)
for scheme in "cellLinear", "cellPoint":
    write_cloud(swirl, scheme, "type rakeInjection; start (0.01 0.012 0);"
                " end (0.09 0.06 0); nParcels 9; diameter 2e-5; U0 (0 0 20);",
                forces="sphereDrag;", tolerance=1e-8)
    edit(swirl, f"constant/{scheme}Properties", "interpolationSchemes {}",
         "interpolationSchemes { rho %s; U %s; T %s; thermo:mu %s; }".replace(
             "%s", scheme))
write_foam(swirl, "constant/parcelClouds", "clouds (cellLinear cellPoint);")
DURATION = 1e-3
edit(swirl, "system/controlDict", repr(END), repr(DURATION))
solve(swirl)

mu = 1.458e-6*np.sqrt(250.0)/(1 + 110.4/250.0)
rho = 3e4/(R_GAS*250.0)


def runge_kutta(slope, y, n):
    """State after the duration, by n classical steps of fourth order."""
    h = DURATION/n
    for _ in range(n):
        k1 = slope(y)
        k2 = slope(y + 0.5*h*k1)
        k3 = slope(y + 0.5*h*k2)
        k4 = slope(y + h*k3)
        y = y + h*(k1 + 2*k2 + 2*k3 + k4)/6
    return y


def slope(y):
    r, radial, around = y
    rel = np.array([-radial, 20 - around])
    Re = rho*np.hypot(*rel)*2e-5/mu
    k = 18*mu/(2500*2e-5**2)*(1 + Re**(2/3)/6)
    return np.array([radial, k*rel[0] + around**2/r,
                     k*rel[1] - radial*around/r])


y = np.array([np.linspace(0.012, 0.06, 9), np.zeros(9), np.full(9, 20.0)])
y = runge_kutta(slope, y, 4000)
for scheme in "cellLinear", "cellPoint":
    folder = f"{swirl}/{times_of(swirl)[-1]}/lagrangian/{scheme}"
    order = np.argsort(read_field(f"{folder}/origId"))
    x, u = positions(folder)[0][order], read_field(f"{folder}/U")[order]
    r = np.hypot(x[:, 1], x[:, 2])
    found = np.array([r, (x[:, 1]*u[:, 1] + x[:, 2]*u[:, 2])/r,
                      (x[:, 1]*u[:, 2] - x[:, 2]*u[:, 1])/r])
    error = np.abs((found - y)/np.array([[0.012], [20], [20]])).max()
    verdict(f"wedge_swirl_{scheme}", len(order) == 9 and error < 1e-3,
            f"r from {y[0, 0]*1e3:.3f} to {y[0, -1]*1e3:.3f} mm and velocities"
            f" within {error:.1e} of 12 mm and 20 m/s, tolerance 1e-3; least"
            f" velocity about the axis {found[2].min():.2f} m/s")

# On the axis a parcel of the stock is put elsewhere
on_axis = copy_case(stock, "wedgeOnAxis")
write_cloud(on_axis, "line", "type rakeInjection; start (0.011 0 0);"
            " end (0.089 0 0); nParcels 50; diameter 2e-5; U0 (0 0 0);")
write_foam(on_axis, "constant/parcelClouds", "clouds (line);")
solve(on_axis)
folder = f"{on_axis}/{times_of(on_axis)[-1]}/lagrangian/line"
x = positions(folder)[0]
x = x[np.argsort(x[:, 0])]
away = (np.abs(x[:, 0] - np.linspace(0.011, 0.089, 50)).max()
        + np.hypot(x[:, 1], x[:, 2]).max() if len(x) == 50 else np.inf)
verdict("wedge_onAxis", away < 1e-10, f"{len(x)} parcels of 50, {away:.1e} m"
        " away from where they were put, tolerance 1e-10 m")

# Gas that flows to the axis and turns about it, both in proportion to the
# distance: grains that go there with it, others that shoot past, from as near
# as a trace, against the equations in the plane across the axis. The axis
# holds nobody up
INWARD, TURN = 1e4, 2e3
sink = copy_case(stock, "wedgeSink")
must(sink, "postProcess", "-func", "writeCellCentres", "-time", "0")
centre = read_field(f"{sink}/0/C")
write_field(sink, "U", np.column_stack(
    [0*centre[:, 1], -INWARD*centre[:, 1], TURN*centre[:, 1]]), fields)
SINKS = {"fine": 1e-6, "coarse": 5e-6}
for name, diameter in SINKS.items():
    write_cloud(sink, name, "type rakeInjection; start (0.01 1e-9 0);"
                " end (0.09 0.0046 0); nParcels 9;"
                f" diameter {diameter}; U0 (0 0 0);",
                forces="sphereDrag;", tolerance=1e-8)
write_foam(sink, "constant/parcelClouds", f"clouds ({' '.join(SINKS)});")
edit(sink, "system/controlDict", repr(END), repr(DURATION))
log = solve(sink)
for name, diameter in SINKS.items():
    def motion(y):
        place, u = y
        rel = -INWARD*place + TURN*1j*place - u
        Re = rho*np.abs(rel)*diameter/mu
        return np.array([u, 18*mu/(2500*diameter**2)*(1 + Re**(2/3)/6)*rel])

    y = np.array([np.linspace(1e-9, 0.0046, 9), np.zeros(9)], complex)
    y = runge_kutta(motion, y, 20000)
    folder = f"{sink}/{times_of(sink)[-1]}/lagrangian/{name}"
    order = np.argsort(read_field(f"{folder}/origId"))
    x, u = positions(folder)[0][order], read_field(f"{folder}/U")[order]
    found = np.array([np.hypot(x[:, 1], x[:, 2]),
                      np.hypot(u[:, 1], u[:, 2])/INWARD])
    error = np.abs(found - np.abs(y)/[[1], [INWARD]]).max()/0.0046
    verdict(f"wedge_sink_{name}", len(order) == 9 and error < 1e-7,
            f"distances and speeds within {error:.1e} of the first ones,"
            f" of which {np.abs(y[0]).max()/0.0046:.1e} is left; tolerance"
            " 1e-7")
steps = [float(n) for n in re.findall(r"Sub-steps, .*= *([\d.e+]+),", log)]
verdict("wedge_sink_sub_steps", len(steps) >= 2 and max(steps) < 9*2000,
        f"{steps[-2:]} sub-steps of 9 grains, at most 18000")
