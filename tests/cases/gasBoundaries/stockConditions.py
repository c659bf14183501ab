# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Stock conditions that ask for the flux, at the ends of a duct through which
a wave goes: beside the stock rhoCentralFoam, restarted, and on two ranks.
Those that make the velocity of the flux have exact solutions of their own, and
so have direction, swirl and mean over a patch."""

from caseTools import (GAMMA, R_GAS, box, copy_case, decompose, edit, largest,
                       last_fields, must, read_field, refuses, run, same_bits,
                       solve, times_of, verdict, write_block, write_case,
                       write_field,
                       write_foam)
import numpy as np

P, T, U = 1e5, 300.0, 100.0
CP = GAMMA*R_GAS/(GAMMA - 1)
T0 = T + U*U/(2*CP)
P0 = P*(T0/T)**(GAMMA/(GAMMA - 1))
RHO = P/(R_GAS*T)
N, END, BUMP = 100, 2e-3, 0.1
FLUX = RHO*U*1e-4       # through the duct's cross-section [kg/s]

SPEED = f"value uniform ({U} 0 0);"
GAS = f"psi thermo:psi; gamma {GAMMA};"
PRESSURE = f"value uniform {P};"
WARM = f"value uniform {T};"
ZERO = "type zeroGradient;"
FIXED = {"p": f"type fixedValue; {PRESSURE}", "T": f"type fixedValue; {WARM}",
         "U": f"type fixedValue; {SPEED}"}
RESERVOIR = {"p": f"type totalPressure; p0 uniform {P0!r}; {GAS} {PRESSURE}",
             "T": f"type totalTemperature; T0 uniform {T0!r}; {GAS} {WARM}"}
FREE = {
    "p": f"type freestreamPressure; freestreamValue uniform {P}; {PRESSURE}",
    "T": f"type freestream; freestreamValue uniform {T}; {WARM}",
    "U": f"type freestreamVelocity; freestreamValue uniform ({U} 0 0); {SPEED}"}
IN, OUT = "xMin", "xMax"

# Ends of the duct other than fixed T and U in, fixed p out
CONDITIONS = {
    "fixedValue": {},
    "flowRateInletVelocity": {IN: {
        "U": f"type flowRateInletVelocity; massFlowRate {FLUX!r};"
             f" rhoInlet {RHO!r}; {SPEED}"}},
    "swirlFlowRateInletVelocity": {IN: {
        "U": f"type swirlFlowRateInletVelocity; flowRate {FLUX!r}; rpm 0;"
             f" {SPEED}"}},
    "flowRateOutletVelocity": {
        IN: {**RESERVOIR,
             "U": f"type pressureInletOutletVelocity; {SPEED}"},
        OUT: {"p": ZERO, "U": "type flowRateOutletVelocity; massFlowRate"
              f" {FLUX!r}; rhoOutlet {RHO!r}; {SPEED}"}},
    "freestream": {IN: FREE, OUT: FREE},
    "inletOutlet": {OUT: {
        "U": f"type inletOutlet; inletValue uniform (0 0 0); {SPEED}",
        "T": f"type uniformInletOutlet; uniformInletValue {T}; {WARM}"}},
    "outletInlet": {OUT: {
        "p": f"type outletInlet; outletValue uniform {P}; {PRESSURE}"}},
    "fixedMean": {OUT: {
        "p": f"type fixedMean; meanValue {P}; {PRESSURE}"}},
    "waveTransmissive": {OUT: {
        "p": f"type waveTransmissive; field p; fieldInf {P}; lInf 0.5; {GAS}"
             f" {PRESSURE}"}},
    "advective": {OUT: {
        "p": f"type advective; field p; {PRESSURE}"}},
    "plenumPressure": {IN: {
        "p": f"type plenumPressure; gamma {GAMMA}; R {R_GAS!r};"
             f" supplyMassFlowRate {FLUX!r}; supplyTotalTemperature {T0!r};"
             f" plenumVolume 1e-4; plenumDensity {RHO!r};"
             f" plenumTemperature {T}; inletAreaRatio 1;"
             f" inletDischargeCoefficient 1; {PRESSURE}",
        "T": RESERVOIR["T"],
        "U": f"type pressureInletOutletVelocity; {SPEED}"}},
    "uniformTotalPressure": {IN: {
        "p": f"type uniformTotalPressure; p0 {P0!r}; {GAS} {PRESSURE}",
        "T": "type inletOutletTotalTemperature; T0 uniform"
             f" {T0!r}; inletValue uniform {T0!r}; {GAS} {WARM}",
        "U": "type fixedNormalInletOutletVelocity; fixTangentialInflow true;"
             f" normalVelocity {{ {ZERO} {SPEED} }} {SPEED}"}},
}

# Flow the other way, in through xMax and warmer there
BACK, WARMER = f"({-U} 0 0)", T + 10
FREE_BACK = {
    "p": FREE["p"],
    "T": f"type freestream; freestreamValue uniform {WARMER}; {WARM}",
    "U": f"type freestreamVelocity; freestreamValue uniform {BACK};"
         f" value uniform {BACK};"}
REVERSED = {
    "freestreamReversed": {IN: FREE_BACK, OUT: FREE_BACK},
    "inletOutletReversed": {
        IN: {"p": FIXED["p"], "T": ZERO, "U": ZERO},
        OUT: {"p": f"type outletInlet; outletValue uniform {1.1*P!r};"
                   f" {PRESSURE}",
              "T": f"type uniformInletOutlet; uniformInletValue {WARMER};"
                   f" {WARM}",
              "U": f"type inletOutlet; inletValue uniform {BACK};"
                   f" value uniform {BACK};"}},
}

# Of the wave. The schemes alone make 0.010 to 0.016, 0.020 where the outlet
# takes the flow away, 0.024 where the plenum fills.
BOUNDS = {"waveTransmissive": 0.015, "flowRateInletVelocity": 0.015,
          "swirlFlowRateInletVelocity": 0.015, "uniformTotalPressure": 0.015,
          "flowRateOutletVelocity": 0.025, "plenumPressure": 0.025}
DIRECTION = "inletDirection uniform (1 0 0);"
OF_FLUX = {
    "pressureInletVelocity": "", "pressureInletUniformVelocity": "",
    "pressureDirectedInletVelocity": DIRECTION,
    "pressureDirectedInletOutletVelocity": DIRECTION,
    "pressureNormalInletOutletVelocity": "",
    "pressureInletOutletParSlipVelocity": ""}


def prepare(case, ends, gas, bump=BUMP, u=U, cells=(N, 1, 1), across=None):
    """across: what the sides are that are not empty."""
    write_case(case, {"endTime": END, "deltaT": 1e-6, "writeInterval": END/2,
                      "writeControl": "adjustableRunTime", "maxCo": 0.1,
                      "adjustTimeStep": "yes", "writePrecision": 17},
               {}, flux="Kurganov", limiter="vanLeer")
    write_foam(case, "system/fvSchemes", """
fluxScheme Kurganov;
ddtSchemes { default Euler; }
gradSchemes { default Gauss linear; }
divSchemes { default none; div(tauMC) Gauss linear; }
laplacianSchemes { default Gauss linear corrected; }
interpolationSchemes { default linear; reconstruct(rho) vanLeer;
    reconstruct(U) vanLeerV; reconstruct(T) vanLeer; }
snGradSchemes { default corrected; }""")
    write_foam(case, "system/fvSolution", f"""
solvers
{{
    "(rho|rhoU|rhoE)" {{ solver diagonal; }}
    "(U|e)" {{ solver smoothSolver; smoother GaussSeidel; tolerance 1e-10;
        relTol 0; }}
}}
highSpeedGas {{ viscous no; {gas} }}""")
    write_foam(case, "constant/turbulenceProperties",
               "simulationType laminar;")
    thermo = "constant/thermophysicalProperties"
    edit(case, thermo, "transport sutherland", "transport const")
    edit(case, thermo, "As 1.458e-06; Ts 110.4;", "mu 0; Pr 1;")
    across = across or {}
    write_block(case, box((1, 0.01, 0.01)), cells,
                {IN: "patch", OUT: "patch", **across})
    must(case, "blockMesh")
    x = (np.arange(cells[0]) + 0.5)/cells[0]
    start = {"p": np.tile(P*(1 + bump*np.exp(-((x - 0.5)/0.08)**2)),
                          cells[1]*cells[2]), "T": T, "U": (u, 0, 0)}
    for field, values in start.items():
        upstream = ZERO if field == "p" else FIXED[field]
        downstream = FIXED["p"] if field == "p" else ZERO
        write_field(case, field, values, {
            **{s + e: "type empty;" for s in "yz" for e in ("Min", "Max")},
            **{side: f"type {kind};" for side, kind in across.items()},
            IN: ends.get(IN, {}).get(field, upstream),
            OUT: ends.get(OUT, {}).get(field, downstream)})


def difference(these, those):
    """Mean, of the wave's pressure, temperature and velocity."""
    sizes = (BUMP*P, BUMP*T*(GAMMA - 1)/GAMMA,
             BUMP*P/(RHO*np.sqrt(GAMMA*R_GAS*T)))
    return largest(np.abs(a - b).mean()/size
                   for a, b, size in zip((these[0], these[1], these[2][:, 0]),
                                         (those[0], those[1], those[2][:, 0]),
                                         sizes))


def again(case, fields):
    """Different fields after a restart, and the difference of two ranks.
    The folders beside the case were copied before it ran."""
    halves, ranks = case + "Halves", case + "Ranks"
    edit(halves, "system/controlDict", f"endTime {END}", f"endTime {END/2}")
    solve(halves)
    edit(halves, "system/controlDict", f"endTime {END/2}", f"endTime {END}")
    solve(halves)
    decompose(ranks)
    solve(ranks, 2)
    must(ranks, "reconstructPar", "-latestTime")
    return (same_bits(case, halves, f"{END:g}"),
            difference(last_fields(ranks, "p T U"), fields))


def copies(case, *names):
    for name in names:
        copy_case(case, case + name)


for name, ends in {**CONDITIONS, **REVERSED}.items():
    prepare(name, ends, "mode transient;", u=-U if name in REVERSED else U)
    copies(name, "Halves", "Ranks", "Stock")
    solve(name)
    must(name + "Stock", "rhoCentralFoam")
    ours = last_fields(name, "p T U")
    d = difference(ours, last_fields(name + "Stock", "p T U"))
    different, e = again(name, ours)
    bound = BOUNDS.get(name, 0.018)
    verdict(name, d < bound and not different and e < 1e-10,
            f"differs by {100*d:.2f} % of the wave from rhoCentralFoam, bound"
            f" {100*bound:.1f} % (the schemes differ); restarted:"
            f" {' '.join(different) or 'the same'}; two ranks {e:.1e}, bound"
            " 1e-10")

# The speed of waves alone is no total pressure
prepare("waveGamma", {OUT: {
    "p": CONDITIONS["waveTransmissive"][OUT]["p"].replace(
        f"gamma {GAMMA};", "gamma 1.3;")}}, "mode transient;")
edit("waveGamma", "system/controlDict", f"endTime {END}", "endTime 1e-6")
text = solve("waveGamma")
verdict("gamma_of_waves", "Entry gamma" not in text,
        "nothing said of the inflow" if "Entry gamma" not in text else
        "warned of another total pressure")

for name, more in OF_FLUX.items():
    # The flow to which the reservoir leads, from gas at rest
    ends = {IN: {**RESERVOIR, "U": f"type {name}; {more} value uniform"
                 " (0 0 0);"}}
    prepare(name, ends, "mode steady; residual 1e-9;", 0, 0.0)
    edit(name, "system/controlDict", f"endTime {END}", "endTime 1e-3")
    solve(name)
    p, t, u = last_fields(name, "p T U")
    far = largest(abs(p/P - 1).max(), abs(t/T - 1).max(),
                  abs(u[:, 0]/U - 1).max())

    # In time it goes the same way as with the velocity of the cells
    timed, known = name + "InTime", name + "Known"
    prepare(timed, ends, "mode transient;")
    copies(timed, "Halves", "Ranks")
    ends[IN]["U"] = "type pressureInletOutletVelocity; value uniform (0 0 0);"
    prepare(known, ends, "mode transient;")
    solve(timed)
    solve(known)
    ours = last_fields(timed, "p T U")
    d = difference(ours, last_fields(known, "p T U"))
    different, e = again(timed, ours)
    verdict(name, far < 1e-6 and d < 1e-10 and not different and e < 1e-10,
            f"steady within {far:.1e} of the reservoir's flow, bound 1e-6; in"
            f" time {d:.1e} from pressureInletOutletVelocity, bound 1e-10;"
            f" restarted: {' '.join(different) or 'the same'}; two ranks"
            f" {e:.1e}")

# A direction that is not the duct's, which goes on through its sides
for name in (n for n, more in OF_FLUX.items() if more):
    case = name + "Aslant"
    prepare(case, {IN: {
        **RESERVOIR, "U": f"type {name}; inletDirection uniform (4 3 0);"
        " value uniform (0 0 0);"}}, "mode steady; residual 1e-9;", 0, 0.0,
        (10, 2, 1), {"yMin": "cyclic", "yMax": "cyclic"})
    edit(case, "system/controlDict", f"endTime {END}", "endTime 1e-3")
    solve(case)
    p, t, u = last_fields(case, "p T U")
    far = np.max([abs(p/P - 1).max(), abs(t/T - 1).max(),
                  abs(u/U - [0.8, 0.6, 0]).max()])
    verdict(case, far < 1e-6, f"steady within {far:.1e} of the reservoir's"
            " flow in that direction, bound 1e-6")

# Swirl of what comes in: what the flow brings turns in the duct. And an outlet
# whose pressure is fixed in its mean alone, behind gas of several pressures.
# (In a time in which sound from the sides, which hold it up, gets nowhere.)
case, end, omega = "swirl", 1e-7, 300.0
across = {s + e: "symmetryPlane" for s in "yz" for e in ("Min", "Max")}
mean = f"type fixedMean; meanValue {1.02*P!r}; {PRESSURE}"
prepare(case, {IN: {
    "U": f"type swirlFlowRateInletVelocity; flowRate {FLUX!r};"
         f" rpm {omega*30/np.pi!r}; {SPEED}"}}, "mode transient;", 0, U,
        (10, 3, 3), across)
write_field(case, "p", P*(1 + 0.01*np.repeat(np.tile(range(3), 3), 10)), {
    **{side: f"type {kind};" for side, kind in across.items()},
    IN: ZERO, OUT: mean})
for old, new in ((f"endTime {END}", f"endTime {end}"),
                 ("deltaT 1e-06", f"deltaT {end}"),
                 (f"writeInterval {END/2}", f"writeInterval {end}"),
                 ("adjustTimeStep yes", "adjustTimeStep no")):
    edit(case, "system/controlDict", old, new)
solve(case)
p, u, rho = last_fields(case, "p U rho")
folder = f"{case}/{times_of(case)[-1]}/"
face = read_field(folder + "U", IN)
z, y = (c.ravel()*0.01/3 for c in np.mgrid[-1:2, -1:2])
wrong = np.abs(face - np.column_stack([
    FLUX/1e-4/read_field(folder + "rho", IN), -omega*z, omega*y])).max()
turning = (rho*(np.repeat(y, 10)*u[:, 2] - np.repeat(z, 10)*u[:, 1])).sum()
turning *= 1e-4/90/(FLUX*end*omega*(y*y + z*z).mean())
verdict(case, wrong < 1e-9*U and abs(turning - 1) < 0.01,
        f"the inlet's velocities within {wrong:.1e} m/s, bound 1e-7; in the"
        f" duct {turning:.4f} of the angular momentum that has come in,"
        " tolerance 1 %")
face, cells = read_field(folder + "p", OUT), p.reshape(9, 10)[:, -1]
wrong = np.max([abs(face.mean()/(1.02*P) - 1), np.ptp(face/cells)])
verdict("fixedMeanAcross", wrong < 1e-9 and np.ptp(cells) > 100,
        f"mean over the outlet and proportion to the cells within {wrong:.1e},"
        f" bound 1e-9, where they differ by {np.ptp(cells):.0f} Pa")

# Cells in two layers where nothing is solved
prepare("layers", {}, "mode transient;", 0)
edit("layers", "system/blockMeshDict", f"({N} 1 1)", f"({N//2} 2 1)")
must("layers", "blockMesh")
refuses("layersBetweenEmptyPatches_refused",
        run("layers", "rhoCentralParcelFoam"),
        ["several layers", "Make one layer"])
