# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Sound at a waveTransmissive outlet and a totalPressure inlet beside the
stock rhoCentralFoam, and the mass flow of a subsonic nozzle; stands in a
temporary folder."""

import re

import numpy as np

from caseTools import (GAMMA, R_GAS, box, copy_case, edit, last_fields, must,
                       refuses, run, solve, verdict, write_block, write_case, write_field,
                       write_foam)

CP = GAMMA*R_GAS/(GAMMA - 1)


def stagnation(p, T, u):
    T0 = T + u**2/(2*CP)
    return p*(T0/T)**(GAMMA/(GAMMA - 1)), T0


def conditions(p, T, u):
    """Of p, T and U: total state at xMin, an open end at xMax."""
    p0, T0 = stagnation(p, T, u)
    return (
        {"xMin": f"type totalPressure; p0 uniform {p0!r}; gamma {GAMMA};"
                 f" psi thermo:psi; value uniform {p!r};",
         "xMax": f"type waveTransmissive; field p; psi thermo:psi;"
                 f" gamma {GAMMA}; fieldInf {p!r}; lInf 1;"
                 f" value uniform {p!r};"},
        {"xMin": f"type totalTemperature; T0 uniform {T0!r}; gamma {GAMMA};"
                 f" psi thermo:psi; value uniform {T!r};",
         "xMax": "type zeroGradient;"},
        {"xMin": f"type pressureInletOutletVelocity; value uniform ({u!r} 0 0);",
         "xMax": "type zeroGradient;"})


# --- a pulse of sound in a tube with the ends above

N, p, T, u = 400, 1e5, 300.0, 50.0
a = np.sqrt(GAMMA*R_GAS*T)
x = (np.arange(N) + 0.5)/N
pulse = 200*np.exp(-((x - 0.5)/0.04)**2)
for name, sign, end in (("waveTransmissive_outlet", 1, 2.1e-3),
                        ("totalPressure_inlet", -1, 2.8e-3)):
    case = name
    write_case(case, {"endTime": end, "deltaT": 1e-6, "writeInterval": end,
                      "adjustTimeStep": "yes", "maxCo": 0.1},
               {"mode": "transient"}, "Kurganov", "vanLeer")
    write_block(case, box((1, 0.01, 0.01)), (N, 1, 1),
                {"xMin": "patch", "xMax": "patch"})
    must(case, "blockMesh")
    fields = (p + pulse, T*(1 + pulse/p)**((GAMMA - 1)/GAMMA),
              np.stack([u + sign*pulse/(p/(R_GAS*T)*a), 0*x, 0*x], axis=-1))
    for field, values, ends in zip("pTU", fields, conditions(p, T, u)):
        write_field(case, field, values, dict(
            ends, **{s + e: "type empty;" for s in "yz"
                     for e in ("Min", "Max")}))
    stock = copy_case(case, case + "Stock")
    write_foam(stock, "system/fvSchemes", """
fluxScheme Kurganov;
ddtSchemes { default Euler; }
gradSchemes { default Gauss linear; }
divSchemes { default none; div(tauMC) Gauss linear; }
laplacianSchemes { default Gauss linear corrected; }
interpolationSchemes
{
    default linear;
    reconstruct(rho) vanLeer; reconstruct(U) vanLeerV; reconstruct(T) vanLeer;
}
snGradSchemes { default corrected; }""")
    write_foam(stock, "system/fvSolution", """
solvers
{
    "(rho|rhoU|rhoE)" { solver diagonal; }
    "(U|e)" { solver smoothSolver; smoother GaussSeidel; tolerance 1e-10;
        relTol 0; }
}""")
    write_foam(stock, "constant/turbulenceProperties",
               "simulationType laminar;")
    solve(case)
    must(stock, "rhoCentralFoam")
    size = [np.abs(last_fields(c, "p")[0] - p).max()/200
            for c in (case, stock)]
    # A reservoir gives back (1 - M)/(1 + M) of sound, less what the schemes
    # have damped of the pulse on its way; the open end about what it does by
    # the stock solver
    exact = (a - u)/(a + u) if sign < 0 else None
    verdict(f"reflection_of_{name}", 0.9 <= size[0]/size[1] <= 1.05
            and (exact is None or abs(size[0]/exact - 1) < 0.06),
            f"{100*size[0]:.2f} % of the pulse, rhoCentralFoam"
            f" {100*size[1]:.2f} %, wanted 0.9 to 1.05 of that"
            + (f" and {100*exact:.2f} % within 6 % of it" if exact else ""))


# --- a nozzle, one cell across: mass flow from the isentropic relations

p0, T0, pe = 1e5, 300.0, 9.2e4
inlet, throat, width = 0.1, 0.08, 0.01
case = "nozzle"
write_case(case, {"endTime": 1, "deltaT": 1, "writeInterval": 1},
           {"mode": "steady", "residual": 1e-6, "viscous": "no"})
corners = " ".join(f"({px} {sy*h/2} {z})" for z in (0, width)
                   for px, h in ((0, inlet), (0.5, throat), (1, inlet))
                   for sy in (-1, 1))
write_foam(case, "system/blockMeshDict", f"""
scale 1;
vertices ({corners});
blocks
(
    hex (0 2 3 1 6 8 9 7) (100 1 1) simpleGrading (1 1 1)
    hex (2 4 5 3 8 10 11 9) (100 1 1) simpleGrading (1 1 1)
);
edges ();
boundary
(
    xMin {{ type patch; faces ((0 1 7 6)); }}
    xMax {{ type patch; faces ((4 10 11 5)); }}
    walls {{ type wall; faces ((0 6 8 2) (2 8 10 4) (1 3 9 7) (3 5 11 9)); }}
    planes {{ type empty; faces ((0 2 3 1) (2 4 5 3) (6 7 9 8) (8 9 11 10)); }}
);""")
must(case, "blockMesh")
ends = {"walls": "type zeroGradient;", "planes": "type empty;"}
write_field(case, "p", pe, dict(
    ends, xMin=f"type totalPressure; p0 uniform {p0}; gamma {GAMMA};"
    f" psi thermo:psi; value uniform {pe};",
    xMax=f"type fixedValue; value uniform {pe};"))
write_field(case, "T", T0, dict(
    ends, xMin=f"type totalTemperature; T0 uniform {T0}; gamma {GAMMA};"
    f" psi thermo:psi; value uniform {T0};", xMax="type zeroGradient;"))
write_field(case, "U", (100.0, 0, 0), dict(
    ends, xMin="type pressureInletOutletVelocity; value uniform (100 0 0);",
    xMax="type zeroGradient;", walls="type slip;"))
other, ignored, dense, slow = [copy_case(case, name) for name in (
    "otherGamma", "gammaIgnored", "constantDensity", "slow")]
log = solve(case)
ratio = (p0/pe)**((GAMMA - 1)/GAMMA)
exact = (pe*ratio/(R_GAS*T0)*np.sqrt(2*CP*T0*(1 - 1/ratio))*inlet*width)
rho, U = last_fields(case, "rho U")
x = (np.arange(200) + 0.5)/200
height = inlet + (throat - inlet)*(1 - np.abs(2*x - 1))
flow = rho*U[:, 0]*height*width
mean = flow.mean()/exact - 1
verdict("mass_flow_of_a_nozzle", "Gas: steady" in log and abs(mean) < 2e-3,
        f"{100*mean:.3f} % from the exact {exact:.5g} kg/s, the last cell"
        f" {100*(flow[-1]/exact - 1):.3f} %")

# Conditions that are told another gas
for field in "p", "T":
    edit(other, f"0/{field}", f"gamma {GAMMA};", "gamma 1.667;")
warned = [len(re.findall(r"Entry gamma is 1\.667, that of the gas on patch xMin"
                         r" is 1\.4", text.split("warnings, each once")[0]))
          for text in (log, solve(other))]
verdict("other_gamma_is_warned_of", warned == [0, 2],
        f"{warned} warnings with the gas's gamma and another")

# A total pressure without psi: that of a gas of constant density
edit(ignored, "0/p", "psi thermo:psi;", "")
refuses("gamma_without_psi", run(ignored, "rhoCentralParcelFoam"),
        ("Entry gamma of p on patch xMin", "Add 'psi thermo:psi;'"))
for case in dense, slow:
    edit(case, "0/p", f"gamma {GAMMA}; psi thermo:psi;", "")
edit(slow, "0/p", f"value uniform {pe};", f"value uniform {p0 - 500};")
edit(slow, "0/U", "(100 0 0)", "(25 0 0)")
said = [re.findall(r"through patch xMin with a total pressure up to (\S+) %"
                   " above p0", solve(case).split("warnings, each once")[0])
        for case in (dense, slow)]
# What the boundary has with the velocity that it takes from the first cell
u = last_fields(dense, "U")[0][0, 0]
T = T0 - u**2/(2*CP)
above = 100*(stagnation(p0/(1 + u**2/(2*R_GAS*T)), T, u)[0]/p0 - 1)
verdict("total_pressure_without_psi", [len(s) for s in said] == [1, 0]
        and abs(float(said[0][0])/above - 1) < 1e-4 and above > 0.2,
        f"said {said}, {above:.4f} % exactly")
