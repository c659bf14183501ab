# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Cases of surfaceImpact; stands in a folder with the case 'stock'."""

import csv
import filecmp
import math
import os
import re
import shutil

import numpy as np

from caseTools import (complaint, copy_case, decompose, edit, hard_sphere,
                       largest, must, read_field, refuses, run, times_of,
                       verdict, write_foam)
import csvTables

SOLVER = "uncoupledKinematicParcelFoam"
CLOUD = "kinematicCloud"
R, V, CV, D, RHO, DZ = 0.03, 500.0, 1e-5, 5e-6, 2500.0, 1e-3
N = 6*CV/(math.pi*D**3)         # number density of the beam
MASS = RHO*math.pi/6*D**3

AXIS = "axis { direction (0 0 1); from (-1 0 0); }"


def mesh_cylinder(case):
    """The upstream half of an annulus; faces of 3 degrees on the cylinder."""
    def ring(r):
        c = r*math.sqrt(0.5)
        return [(0, -r), (-r, 0), (0, r)], [(-c, -c), (-c, c)]

    (inner, inner_arc), (outer, outer_arc) = ring(R), ring(2*R)
    points = [(x, y, z) for z in (0, DZ) for x, y in inner + outer]
    arcs = "".join(
        f"arc {a + k + 6*top} {a + k + 1 + 6*top}"
        f" ({x!r} {y!r} {top*DZ!r})\n"
        for a, line in ((0, inner_arc), (3, outer_arc))
        for k, (x, y) in enumerate(line) for top in (0, 1))
    hexes = "".join(
        f"hex ({k + 1} {k + 4} {k + 3} {k} {k + 7} {k + 10} {k + 9} {k + 6})"
        " (20 30 1) simpleGrading (1 1 1)\n" for k in (0, 1))
    write_foam(case, "system/blockMeshDict", f"""
vertices ({" ".join("(%r %r %r)" % p for p in points)});
blocks ({hexes});
edges ({arcs});
boundary
(
    inlet {{ type patch; faces ((3 4 10 9) (4 5 11 10)); }}
    plate {{ type wall; faces ((0 1 7 6) (1 2 8 7)); }}
    sides {{ type patch; faces ((0 3 9 6) (2 5 11 8)); }}
    planes {{ type empty; faces ((0 1 4 3) (1 2 5 4) (6 7 10 9) (7 8 11 10)); }}
);""")


def prepare(name, functions, cylinder=True, wall="escape", control="",
            u0=(V, 0, 0), start=0.0, cloud=CLOUD):
    """A meshed case with a uniform beam that no gas disturbs."""
    case = copy_case("stock", name)
    shutil.copytree(os.path.join(case, "0.orig"), os.path.join(case, "0"))
    if cylinder:
        mesh_cylinder(case)
    must(case, "blockMesh")
    settings = f"""
application {SOLVER};
startFrom latestTime; startTime 0; stopAt endTime; endTime 4e-4;
deltaT 1e-6; writeControl timeStep; writeInterval 200;
writeFormat binary; writePrecision 17; timePrecision 12;
runTimeModifiable no; libs (parcelInjection parcelWallInteraction);
{control}"""
    write_foam(case, "system/controlDict", settings)
    rebound = ("patchInteractionModel rebound; reboundCoeffs { UFactor 1; }"
               if wall == "rebound" else
               "patchInteractionModel standardWallInteraction;"
               f"standardWallInteractionCoeffs {{ type {wall}; }}")
    write_foam(case, f"constant/{cloud}Properties", f"""
solution
{{
    active yes; coupled no; transient yes; cellValueSourceCorrection off;
    maxCo 0.5;
    interpolationSchemes {{ rho cell; U cell; thermo:mu cell; }}
    integrationSchemes {{ U Euler; }}
}}
constantProperties {{ rho0 {RHO}; }}
subModels
{{
    particleForces {{}}
    injectionModels
    {{
        beam
        {{
            type crossSectionInjection; volumeFraction {CV}; diameter {D};
            U0 ({u0[0]} {u0[1]} {u0[2]}); patches (inlet); startTime {start};
        }}
    }}
    dispersionModel none; stochasticCollisionModel none;
    surfaceFilmModel none;
    {rebound}
}}
cloudFunctions
{{
{functions}
}}""")
    return case


def surface(body, name="surfaceImpact"):
    return f"{name} {{ type surfaceImpact; patches (plate); {body} }}\n"


def table(case, name="byAngle", time=None, function="surfaceImpact"):
    """Columns of the last table; nan where a value is left empty."""
    folder = os.path.join(case, "postProcessing", function, CLOUD)
    times = sorted((t for t in os.listdir(folder) if os.path.exists(
        os.path.join(folder, t, name + ".csv"))), key=float)
    columns = csvTables.table(
        os.path.join(folder, time or times[-1], name + ".csv"))
    if "patch" in columns:
        columns["patch"] = list(columns["patch"])
    return columns


def solve(case, ranks=1, solver=SOLVER):
    command = [solver]
    if ranks > 1:
        command = ["mpirun", "--oversubscribe", "-np", str(ranks), *command,
                   "-parallel"]
    return must(case, *command, log=solver)


def same_table(a, b):
    """Largest relative difference of two tables."""
    worst = 0.0
    for key in a:
        if key == "patch":
            if a[key] != b[key]:
                return math.inf
            continue
        if not np.array_equal(np.isnan(a[key]), np.isnan(b[key])):
            return math.inf
        x, y = np.nan_to_num(a[key]), np.nan_to_num(b[key])
        # Errors are differences of sums: compare with what they belong to
        scale = np.maximum(np.abs(x), np.abs(y))
        base = key.replace("Error", "")
        scale = np.maximum(scale, np.abs(np.nan_to_num(a[base])))
        with np.errstate(invalid="ignore"):
            worst = max(worst, np.max(np.nan_to_num(np.abs(x - y)/scale)))
    return worst


def files(case, time):
    """Time directory: the files that a restart must repeat."""
    found = []
    for root, _, names in os.walk(os.path.join(case, time)):
        found += [os.path.relpath(os.path.join(root, n), case) for n in names
                  if n not in ("time", "complete")
                  and not n.endswith("OutputProperties")]
    return sorted(found)


def boundary(case, time, name, patch="plate"):
    """Values of an ascii field on a patch."""
    with open(os.path.join(case, time, name)) as file:
        text = file.read()
    text = text[text.index("boundaryField"):]
    text = text[text.index(patch):]
    text = text[:text.index("}")]
    value = text.split("value")[1]
    if "nonuniform" not in value:
        return np.array([float(value.split("uniform")[1].split(";")[0])])
    return np.array(value[value.index("(") + 1:value.index(")")].split(),
                    float)


# ------------------------------------------- a beam on a cylinder, stock wall

ascii_format = "writeFormat ascii;"
case = prepare("cylinder",
               surface(f"window {{ start 1.5e-4; end 3.9e-4; }} {AXIS}"
                       " threshold 0; log yes;"
                       " erosion { model Finnie; p 1e9; }")
               + surface("threshold 0; erosion { model Finnie; p 1e9; }",
                         "faces")
               + surface("window { start 1.5e-4; end 3.9e-4; } threshold 0;"
                         f" normalThreshold {0.5*V!r}; {AXIS}", "steep")
               + "stockErosion { type particleErosion; patches (plate);"
                 " p 1e9; psi 2; K 2; }\n"
               + "dispersedPhase { type dispersedPhase;"
                 " window { start 1.5e-4; } }",
               control=ascii_format)
log = solve(case)
t = table(case)
phi = np.radians(t["phi_deg"])
half = np.radians(0.5)
exact = N*V*(np.sin(phi + half) - np.sin(phi - half))/(2*half)
z = (t["intensity"] - exact)/t["intensityError"]
verdict("cylinder_bins", len(phi) == 90
        and np.allclose(np.degrees(phi), np.arange(90) + 0.5),
        f"{len(phi)} bins")
verdict("cylinder_area", abs(t["area"].sum()/(math.pi*R*DZ) - 1) < 2e-4
        and np.ptp(t["area"])/t["area"].mean() < 2e-3,
        f"{t['area'].sum():.6g} of {math.pi*R*DZ:.6g} m2")
# Half of the parcels that enter strike: their number is binomial
bar = 4*math.sqrt(0.5/t["nImpacts"].sum())
verdict("cylinder_intensity_total",
        abs((t["intensity"]*t["area"]).sum()/(N*V*2*R*DZ) - 1) < bar,
        f"{(t['intensity']*t['area']).sum():.6g} of {N*V*2*R*DZ:.6g} 1/s")
# With ten blocks z follows Student's law of about 10 degrees of freedom or
# more: |z| > 6 once in 1e4, mean square 1.25 at most
verdict("cylinder_intensity", np.max(np.abs(z)) < 6
        and 0.7 < np.mean(z**2) < 1.8,
        f"deviation/error: rms {np.sqrt(np.mean(z**2)):.2f},"
        f" largest {np.max(np.abs(z)):.2f}")
verdict("cylinder_first", np.array_equal(t["intensity"], t["firstIntensity"])
        and abs(t["nImpacts"].sum()*DZ/D/2.4e-4
                / (t["intensity"]*t["area"]).sum() - 1) < 1e-9,
        f"{t['nImpacts'].sum():.0f} impacts of parcels that escape")
verdict("cylinder_normal_speed",
        np.max(np.abs(t["meanNormalSpeed"] - V*np.cos(phi))) < V*half,
        "within the width of a bin")
verdict("cylinder_angle",
        np.max(np.abs(t["impactAngle"] - (90 - np.degrees(phi)))) < 0.51,
        "within the width of a bin")
verdict("cylinder_mass_flux",
        np.allclose(t["massFlux"], t["intensity"]*MASS, rtol=1e-9)
        and np.allclose(t["specificPowerIncident"],
                        t["massFlux"]*V**2/2, rtol=1e-9), "rho V n")
verdict("stock_rebound_is_unknown", np.all(t["reboundKnown"] == 0)
        and all(np.all(np.isnan(t[k])) for k in (
            "specificPower", "specificPowerTranslational", "capturedMassFlux",
            "specificPowerError")) and "rebound unknown" in log
        and not os.path.exists(os.path.join(
            case, "0.0004", CLOUD + ":surfaceImpact:specificPower")),
        "columns are empty, fields left out")

# The log holds the impacts that count
with open(os.path.join(case, "postProcessing/surfaceImpact", CLOUD,
                       "0/impacts.csv")) as file:
    hits = list(csv.DictReader(file))
verdict("log_holds_what_counts", len(hits) == t["nImpacts"].sum()
        and all(1.5e-4 <= float(h["time"]) <= 3.9e-4 and h["UxOut"] == ""
                and h["reboundKnown"] == "0" for h in hits),
        f"{len(hits)} lines")
angles = np.array([abs(math.degrees(math.atan2(-float(h["y"]),
                                               -float(h["x"]))))
                   for h in hits])
count = np.bincount(np.minimum(angles.astype(int), 89), minlength=90)
verdict("bins_hold_their_hits", np.abs(count - t["nImpacts"]).sum() <= 2,
        f"{np.abs(count - t['nImpacts']).sum():.0f} apart")

steep = table(case, function="steep")["nImpacts"].sum()
verdict("normal_threshold", abs(steep - (angles < 60).sum()) <= 2
        and 100 < steep < len(hits),
        f"{steep:.0f} of {len(hits)} hits are as fast towards the wall as at 60"
        f" degrees, {(angles < 60).sum()} within them")

# Fields: what ParaView shows sums up to the table of the patch
p = table(case, "byPatch")
area = 2*R*math.sin(math.radians(1.5))*DZ
face = boundary(case, "0.0004", CLOUD + ":surfaceImpact:intensity")
verdict("field_is_the_table", len(face) == 60 and p["patch"] == ["plate"]
        and abs((face*area).sum()/(p["intensity"][0]*p["area"][0]) - 1) < 1e-9,
        f"{(face*area).sum():.6g} 1/s")
face_error = boundary(case, "0.0004", CLOUD + ":surfaceImpact:intensityError")
must(case, "postProcess", "-func", "writeCellCentres", "-time", "0.0004")
middle = np.arctan2(boundary(case, "0.0004", "Cy"),
                    -boundary(case, "0.0004", "Cx"))
beam = N*V*2*R*np.sin(np.radians(1.5))*np.cos(middle)*DZ/area
z = (face - beam)/face_error
verdict("field_error", np.max(np.abs(z)) < 6 and 0.6 < np.mean(z**2) < 2,
        f"rms of deviation/error {np.sqrt(np.mean(z**2)):.2f}")

# Stock erosion sums all impacts since the start
stock = boundary(case, "0.0004", CLOUD + "Q") if os.path.exists(
    os.path.join(case, "0.0004", CLOUD + "Q")) else None
ours = boundary(case, "0.0004", CLOUD + ":faces:erosionRate")*area*4e-4
verdict("finnie_is_stock_erosion", stock is not None and stock.sum() > 0
        and np.max(np.abs(ours - stock)) < 1e-9*stock.max(),
        f"{ours.sum():.6g} of {stock.sum() if stock is not None else 0:.6g}"
        " m3")

# ------------------------------------------------------------ dispersed phase

density = read_field(os.path.join(case, "0.0004",
                                  CLOUD + ":dispersedPhase:numberDensity"))
velocity = read_field(os.path.join(case, "0.0004",
                                   CLOUD + ":dispersedPhase:U"))
share = read_field(os.path.join(case, "0.0004",
                                CLOUD + ":dispersedPhase:concentration"))
rms = read_field(os.path.join(case, "0.0004",
                              CLOUD + ":dispersedPhase:URms"))
# Cells next to the entry lack the parcels of a step; those by the outlet are
# left out, too
inner = np.arange(1200).reshape(2, 30, 20)[:, 3:27, 2:18].ravel()
velocity = np.broadcast_to(velocity, (1200, 3))
verdict("dispersed_density", abs(density[inner].mean()/N - 1) < 0.03
        and abs(share[inner].mean()/CV - 1) < 0.03,
        f"{density[inner].mean():.4g} of {N:.4g} 1/m3")
verdict("dispersed_velocity", np.allclose(velocity[inner], (V, 0, 0),
                                          rtol=1e-12, atol=1e-9)
        and np.max(rms) < 1e-9*V, f"rms at most {np.max(rms):.2g} m/s")

# ------------------------------------ wear by a known stream at known angles

# Half of the stream strikes the plate, at atan(600/120) to it; the other half
# the upper side on its way, at atan(120/600)
STREAM = (600.0, 120.0, 0.0)
case = prepare("wear", surface("patches (plate sides); window { start 2e-4; }"
                               " erosion { model Oka; hardness 1.8; }").replace(
                                   "patches (plate);", ""),
               cylinder=False, u0=STREAM, control=ascii_format)
log = solve(case)
p = table(case, "byPatch")
row = {key: column[p["patch"].index("plate")] for key, column in p.items()}


def oka(angle):
    """mm3/kg by the formula as printed, in GPa, m/s and um"""
    hv, s = 1.8, math.sin(angle)
    return (65*hv**-0.12*(math.hypot(*STREAM)/104)**(2.3*hv**0.038)
            * (D*1e6/326)**0.19
            * s**(0.71*hv**0.14)*(1 + hv*(1 - s))**(2.4*hv**-0.94))


steep, flat = math.atan2(STREAM[0], STREAM[1]), math.atan2(*STREAM[1::-1])
known = [oka(steep if name == "plate" else flat) for name in p["patch"]]
verdict("specific_erosion", sorted(p["patch"]) == ["plate", "sides"]
        and np.allclose(p["specificErosion_mm3_per_kg"], known, rtol=1e-9)
        and np.all(p["specificErosionError_mm3_per_kg"]
                   < 1e-9*np.array(known)),
        f"{p['specificErosion_mm3_per_kg']} of {known} mm3/kg")
flux = RHO*CV*STREAM[0]*(0.02/0.04)
year = 365.25*24*3600           # s
exact = flux*oka(steep)*1e-9*1e3*year
bar = 4*math.sqrt(0.5/row["nImpacts"])
verdict("wear_rate", abs(row["wearRate_mm_per_year"]/exact - 1) < bar < 0.1
        and abs(row["wearRate_mm_per_year"]
                / (row["erosionRate"]*1e3*year) - 1) < 1e-9
        and abs(row["wearRateError_mm_per_year"]/row["wearRate_mm_per_year"]
                / (row["massFluxError"]/row["massFlux"]) - 1) < 1e-6,
        f"{row['wearRate_mm_per_year']:.4g} of {exact:.4g} mm/year,"
        f" allowed {100*bar:.1f} %")
depth = boundary(case, "0.0004", CLOUD + ":surfaceImpact:wearRate")
ratio = boundary(case, "0.0004", CLOUD + ":surfaceImpact:specificErosion")
metres = boundary(case, "0.0004", CLOUD + ":surfaceImpact:erosionRate")
verdict("wear_of_faces", np.allclose(depth, metres*1e3*year, rtol=1e-5)
        and abs(depth.mean()/row["wearRate_mm_per_year"] - 1) < 1e-5
        and np.allclose(ratio, np.where(depth > 0, oka(steep), 0), rtol=1e-5)
        and 5 < np.count_nonzero(ratio) < len(ratio) == 20,
        f"{np.count_nonzero(ratio)} of {len(ratio)} faces are struck, all at"
        f" {ratio.max():.6g} mm3/kg")


def unit_of(result):
    with open(os.path.join(case, "0.0004",
                           CLOUD + ":surfaceImpact:" + result)) as file:
        return re.findall(r'note +"([^"]*)";', file.read())


told = re.search(r"wear of plate: (\S+) \+- (\S+) mm/year,"
                 r" (\S+) \+- \S+ mm3/kg\n +\((\S+) mm3 by (\S+) kg\)",
                 log[log.rindex("surfaceImpact of"):])
told = list(map(float, told.groups())) if told else [math.nan]*5
verdict("wear_in_words", np.allclose(told, [
    row["wearRate_mm_per_year"], row["wearRateError_mm_per_year"],
    oka(steep), told[4]*oka(steep), row["massFlux"]*row["area"]*2e-4],
                                     rtol=1e-4, atol=0)
        and unit_of("wearRate") == unit_of("wearRateError") == ["mm/year"]
        and unit_of("specificErosion") == ["mm3/kg"]
        and unit_of("erosionRate") == [],
        f"the log says {told}")

# -------------------------------------- rebounding parcels, ranks and restart

def channel(name, control="", write=200):
    """Parcels that cross a channel and come back from the plate."""
    case = prepare(name, surface(
        "patches (plate sides); axis { origin (0.05 0.02 0);"
        " direction (0 0 1); from (-1 0 0); binWidth 5; }"
        " window { start 1.1e-4; } log yes;"
        " erosion { model Oka; hardness 1.8; }").replace(
            "patches (plate);", "")
        + "dispersedPhase { type dispersedPhase; window { start 5e-5; } }",
        cylinder=False, wall="rebound", u0=(600, 500, 0),
        control=f"writeInterval {write}; {control}")
    return case


straight = channel("straight")
log = solve(straight)
t = table(straight, "byPatch")
i, f = t["intensity"], t["firstIntensity"]
verdict("rebound_strikes_again", np.all(f < i) and np.all(i > 0)
        and f.sum() > 0, f"first/all {f/i}")
with open(os.path.join(straight, "postProcessing/surfaceImpact", CLOUD,
                       "0/impacts.csv")) as file:
    hits = list(csv.DictReader(file))
firsts = [h["origId"] for h in hits if h["firstImpact"] == "1"]
verdict("first_impact_once", len(firsts) == len(set(firsts)) > 100
        and len(hits) > 1.3*len(firsts),
        f"{len(firsts)} first of {len(hits)} impacts")
total = sum(float(h["nParticle"]) for h in hits if h["firstImpact"] == "1")
verdict("first_intensity_is_the_log",
        abs((f*t["area"]).sum()*2.9e-4/total - 1) < 1e-9,
        f"{total:.6g} particles")

restarted = channel("restarted", control="endTime 2e-4;")
solve(restarted)
write_foam(restarted, "system/controlDict", f"""
#include "{os.path.abspath(straight)}/system/controlDict"
""")
solve(restarted)
a, b = files(straight, "0.0004"), files(restarted, "0.0004")
differ = [n for n in a if n not in b or not filecmp.cmp(
    os.path.join(straight, n), os.path.join(restarted, n), False)]
verdict("restart_is_bitwise", a == b and not differ
        and any("uniform" in n and "surfaceImpact" in n for n in a)
        and any("specificPowerIncidentError" in n for n in a)
        and any("wearRateError" in n for n in a)
        and any("specificErosion" in n for n in a)
        and any("dispersedPhase:URms" in n for n in a), str(differ[:5]))
verdict("restart_has_the_same_table", all(
    filecmp.cmp(os.path.join(straight, "postProcessing/surfaceImpact", CLOUD,
                             "0.0004", n),
                os.path.join(restarted, "postProcessing/surfaceImpact", CLOUD,
                             "0.0004", n), False)
    for n in ("byAngle.csv", "byPatch.csv")), "to the last digit")

ranks = channel("ranks")
decompose(ranks)
solve(ranks, 2)
worst = largest(same_table(table(straight, n), table(ranks, n))
                for n in ("byAngle", "byPatch"))
verdict("ranks_have_the_same_table", worst < 1e-10, f"apart by {worst:.2g}")
must(ranks, "reconstructPar", "-latestTime")
worst = 0.0
for name in ("numberDensity", "concentration", "U", "URms"):
    field = f"{CLOUD}:dispersedPhase:{name}"
    x = read_field(os.path.join(straight, "0.0004", field))
    y = read_field(os.path.join(ranks, "0.0004", field))
    scale = 1e3 if name == "URms" else np.abs(x).max()
    worst = largest(worst, np.abs(x - y).max()/scale)
verdict("ranks_have_the_same_dispersed_phase", worst < 1e-10,
        f"apart by {worst:.2g}")

# Two ranks, then one: averages do not depend on the decomposition
shared = channel("shared", control="endTime 2e-4;")
decompose(shared)
solve(shared, 2)
must(shared, "reconstructPar", "-latestTime")
write_foam(shared, "system/controlDict", f"""
#include "{os.path.abspath(straight)}/system/controlDict"
""")
solve(shared)
worst = largest(same_table(table(straight, n), table(shared, n))
                for n in ("byAngle", "byPatch"))
verdict("two_ranks_then_one", worst < 1e-10, f"apart by {worst:.2g}")

# One rank, then two
shared = channel("shared2", control="endTime 2e-4;")
solve(shared)
decompose(shared)
write_foam(shared, "system/controlDict", f"""
#include "{os.path.abspath(straight)}/system/controlDict"
""")
solve(shared, 2)
worst = largest(same_table(table(straight, n), table(shared, n))
                for n in ("byAngle", "byPatch"))
verdict("one_rank_then_two", worst < 1e-10, f"apart by {worst:.2g}")

# Averages that were made otherwise are not gone on with
write_foam(restarted, "system/controlDict", f"""
#include "{os.path.abspath(straight)}/system/controlDict"
endTime 6e-4;
""")
properties = os.path.join(restarted, f"constant/{CLOUD}Properties")
with open(properties) as file:
    text = file.read()
with open(properties, "w") as file:
    file.write(text.replace("binWidth 5", "binWidth 3"))
status, text = run(restarted, SOLVER)
verdict("other_settings_are_refused", status != 0 and "other settings" in text
        and "\nTime = " not in text, complaint(text))

# ------------------------------------------------- a cloud of spinning spheres

OURS = "rhoCentralParcelFoam"
SPIN, RESTITUTION, FRICTION = (2e7, -3e7, 5e7), 0.8, 0.1


def spinning(name, control=""):
    """The channel with spheres that enter spinning, over a frozen gas that
    does not touch them."""
    case = channel(name, control)
    path = os.path.join(case, f"constant/{CLOUD}Properties")
    with open(path) as file:
        text = file.read()
    for old, new in (
            ("solution\n{", "type spinningKinematicCloud;\nsolution\n{"),
            ("U cell;", "U cell; T cell;"),
            ("particleForces {}",
             "particleForces {} rotationalTorqueModel none;"),
            (f"rho0 {RHO};", f"rho0 {RHO}; omega0 (%r %r %r);" % SPIN),
            ("patchInteractionModel rebound; reboundCoeffs { UFactor 1; }",
             "patchInteractionModel hardSphereWall; hardSphereWallCoeffs {"
             " patches ( \"(plate|sides)\" { restitution "
             f"{RESTITUTION}; friction {FRICTION}; }} inlet {{ type escape; }}"
             " ); }")):
        if text.count(old) != 1:
            raise SystemExit(f"{path}: '{old}' is not there once")
        text = text.replace(old, new)
    with open(path, "w") as file:
        file.write(text)
    write_foam(case, "constant/parcelClouds", f"clouds ({CLOUD});")
    write_foam(case, "system/fvSolution", "highSpeedGas { mode frozen; }")
    shutil.copy(os.path.join(os.environ["tutorial"], "system/fvSchemes"),
                os.path.join(case, "system/fvSchemes"))
    must(case, "foamDictionary", "-entry", "libs", "-set",
         "(parcelInjection parcelWallInteraction spinningParcel)",
         "system/controlDict")
    return case


straight = spinning("spinStraight")
solve(straight, solver=OURS)
t = table(straight, "byPatch")
with open(os.path.join(straight, "postProcessing/surfaceImpact", CLOUD,
                       "0/impacts.csv")) as file:
    hits = list(csv.DictReader(file))


def vector_of(hit, name):
    return np.array([float(hit[name.replace("#", x)]) for x in ("x y z" if
                     name[0] == "U" else "X Y Z").split()])


worst, chained, broken, last = 0.0, 0, 0, {}
power = {name: [0.0, 0.0] for name in t["patch"]}
for hit in sorted(hits, key=lambda h: float(h["time"])):
    U, Uout = vector_of(hit, "U#"), vector_of(hit, "U#Out")
    w, wout = vector_of(hit, "omega#"), vector_of(hit, "omega#Out")
    n = ((-1, 0, 0) if hit["patch"] == "plate"
         else (0, 1 if float(hit["y"]) < 0.02 else -1, 0))
    U1, omega = hard_sphere(U, w, n, D/2, RESTITUTION, FRICTION)
    U1[2] = 0       # not solved for
    worst = largest(worst, np.abs(Uout - U1).max()/V,
                    D/2*np.abs(wout - omega).max()/V)
    key = hit["origProc"], hit["origId"]
    before = SPIN if hit["firstImpact"] == "1" else last.get(key)
    if before is not None:
        chained += 1
        broken += not np.allclose(w, before, rtol=1e-12, atol=0)
    last[key] = wout
    real = float(hit["nParticle"])
    power[hit["patch"]][0] += real*MASS*(U @ U - Uout @ Uout)/2
    power[hit["patch"]][1] += real*0.1*MASS*D**2*(w @ w - wout @ wout)/2
verdict("spin_rebounds", worst < 1e-11 and len(hits) > 300,
        f"{len(hits)} impacts apart from the law by {worst:.1e} at most")
verdict("spin_arrives", broken == 0 and chained > 0.9*len(hits),
        f"{chained} impacts with the spin of the injection or of the impact"
        f" before, {broken} otherwise")
window = t["area"]*2.9e-4
told = t["specificPower"]*window
moved = t["specificPowerTranslational"]*window
summed = np.array([power[name] for name in t["patch"]])
verdict("spin_power",
        np.allclose(moved, summed[:, 0], rtol=1e-9, atol=0)
        and np.allclose(told, summed.sum(axis=1), rtol=1e-9, atol=0)
        and np.all(np.abs(told/moved - 1) > 0.01),
        f"in space {moved} J, with spin {told} J")
firsts = [h["origId"] for h in hits if h["firstImpact"] == "1"]
total = sum(float(h["nParticle"]) for h in hits if h["firstImpact"] == "1")
verdict("spin_first_impacts", len(firsts) == len(set(firsts)) > 100
        and len(hits) > 1.2*len(firsts)
        and abs((t["firstIntensity"]*window).sum()/total - 1) < 1e-9,
        f"{len(firsts)} first of {len(hits)} impacts")

restarted = spinning("spinRestarted", control="endTime 2e-4;")
solve(restarted, solver=OURS)
must(restarted, "foamDictionary", "-entry", "endTime", "-set", "4e-4",
     "system/controlDict")
solve(restarted, solver=OURS)
a, b = files(straight, "0.0004"), files(restarted, "0.0004")
differ = [n for n in a if n not in b or not filecmp.cmp(
    os.path.join(straight, n), os.path.join(restarted, n), False)]
verdict("spin_restart_is_bitwise", a == b and not differ
        and any("specificPowerError" in n for n in a)
        and any("uniform" in n and "surfaceImpact" in n for n in a),
        str(differ[:5]))

ranks = spinning("spinRanks")
decompose(ranks)
solve(ranks, 2, OURS)
worst = largest(same_table(table(straight, n), table(ranks, n))
                for n in ("byAngle", "byPatch"))
verdict("spin_ranks_have_the_same_table", worst < 1e-10,
        f"apart by {worst:.2g}")

# ------------------------------------------------------------- stop at error

case = prepare("stop", surface(
    f"{AXIS} window {{ start 1.5e-4; }}"
    " stopAtError { bins (0 60); target 0.15;"
    " quantities (intensity massFlux); }"), control="endTime 1;")
status, text = run(case, SOLVER)
last = times_of(case)[-1]
t = table(case)
low = t["phi_deg"] <= 60
worst = np.max((t["intensityError"]/t["intensity"])[low])
# Not at the target itself: the error of ten blocks and more has one of its own,
# for which it is taken 1.29 to 1.47 times
verdict("stops_at_the_error", status == 0 and "the target is met" in text
        and 1.6e-4 < float(last) < 1e-2 and 0.07 < worst < 0.15/1.29
        and os.path.exists(os.path.join(
            case, last, CLOUD + ":surfaceImpact:intensity")),
        f"at {last} s with {worst:.3f}")

# The same on two ranks, and in our own solver, over a frozen gas
for time in times_of(case)[1:]:
    shutil.rmtree(os.path.join(case, time))
shutil.rmtree(os.path.join(case, "postProcessing"))
decompose(case, (1, 2, 1))
text = solve(case, 2)
ours = times_of(os.path.join(case, "processor0"))[-1]
verdict("two_ranks_stop_at_the_error", ours == last
        and "the target is met" in text, f"at {ours} s")
write_foam(case, "constant/parcelClouds", f"clouds ({CLOUD});")
write_foam(case, "system/fvSolution", "highSpeedGas { mode frozen; }")
shutil.copy(os.path.join(os.environ["tutorial"], "system/fvSchemes"),
            os.path.join(case, "system/fvSchemes"))
status, text = run(case, "rhoCentralParcelFoam")
ours = times_of(case)[-1]
verdict("stops_rhoCentralParcelFoam", status == 0 and ours == last
        and "the target is met" in text
        and os.path.exists(os.path.join(case, ours, "uniform/complete")),
        f"at {ours} s: {complaint(text) if status else 'End'}")
shutil.rmtree(case)

# ------------------------------------------------------------------ bad input

CASE = prepare("bad", surface(""))


def refused(name, functions, *words, control=""):
    properties = os.path.join(CASE, f"constant/{CLOUD}Properties")
    with open(properties) as file:
        text = file.read()
    at = text.index("cloudFunctions")
    with open(properties, "w") as file:
        file.write(text[:at] + "cloudFunctions {\n" + functions + "}\n")
    refuses("refuses_" + name, run(CASE, SOLVER),
            (CLOUD + "Properties", *words))


refused("zero_axis", surface("axis { direction (0 0 0); from (-1 0 0); }"),
        "direction", "(0 0 0)", "any vector but zero")
refused("direction_along_axis",
        surface("axis { direction (0 0 1); from (0 0 2); }"), "from",
        "(0 0 2)", "across")
refused("bin_width", surface(AXIS.replace("}", "binWidth 7; }")), "7",
        "whole part of 180")
refused("unknown_patch", surface("").replace("(plate)", "(wall)"), "patches",
        "wall", "plate")
refused("empty_patch", surface("").replace("(plate)", "(planes)"), "patches",
        "planes", "plate")
refused("no_patches", surface("").replace("(plate)", "()"), "patches", "()")
refused("threshold", surface("threshold -1;"), "threshold", "-1",
        "[0, 3e8)")
refused("empty_window", surface("window { start 2e-4; end 2e-4; }"), "end",
        "0.0002", "greater than start")
refused("past_window", surface("window { start -2; end -1; }"), "end", "-1",
        "greater than the time")
refused("blocks", surface("blocks 5;"), "blocks", "5", "[10, 1000]")
refused("stop_target", surface(
    AXIS + "stopAtError { bins (0 60); target 0; }"), "target", "(0, 1e6]")
refused("stop_bins", surface(
    AXIS + "stopAtError { bins (100 120); target 0.1; }"), "bins",
        "(100 120)", "area")
refused("stop_bins_without_axis", surface(
    "stopAtError { bins (0 60); target 0.1; }"), "bins", "axis")
refused("stop_quantity", surface(
    "stopAtError { target 0.1; quantities (speed); }"), "quantities", "speed",
        "meanNormalSpeed")
refused("stop_without_erosion", surface(
    "stopAtError { target 0.1; quantities (wearRate); }"), "stopAtError",
        "quantities", "wearRate", "needs the entry erosion")
refused("erosion_model", surface("erosion { model Bitter; }"), "Bitter",
        "Finnie", "Oka")
refused("flow_stress", surface("erosion { model Finnie; p 0; }"), "p",
        "[1e-3, 1e14]")
refused("hardness", surface("erosion { model Oka; hardness -1; }"),
        "hardness", "-1", "[1e-6, 150]")
refused("interval", "d { type dispersedPhase; interval 0; }", "interval", "0",
        "[1, ")
refused("dispersed_window", "d { type dispersedPhase;"
        " window { start 1; end 0.5; } }", "end", "0.5", "greater than start")

# A wall without faces, as meshers leave them, has no wear and no error
case = prepare("bare", surface(
    "erosion { model Finnie; p 1e9; } stopAtError { target 0.9;"
    " quantities (wearRate); }").replace("(plate)", "(plate bare)"))
edit(case, "system/blockMeshDict", "boundary\n(",
     "boundary\n(\n    bare { type wall; faces (); }")
must(case, "blockMesh")
for name in "pTU":
    edit(case, "0/" + name, "|sides)", "|sides|bare)")
status, text = run(case, SOLVER)
verdict("patch_without_faces", status == 0 and "wear of bare: 0" in text
        and "the target is met" in text,
        complaint(text) if status else re.findall("wear of bare.*", text)[-1])
