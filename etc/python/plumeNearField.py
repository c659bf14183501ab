# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Near field of a two-phase plume in vacuum in seconds: a continuum gas that is
marched along the axis, and spheres that exchange momentum and heat with it.

Gas: steady Euler equations of an ideal gas, axisymmetric, supersonic along the
axis, so that they can be marched (MUSCL, minmod; HLL with the slopes of the
Mach lines; two stages), on a mesh that spreads with the plume up to 45 degrees
from the lip. Spheres: groups of one size in rings of equal mass flow, whose
edges are followed; between them everything is linear. What they take is taken
from the gas of the cells that a ring crosses: momentum and energy are kept.

Exchange: exact free-molecular force and heat of a mixture (Schaaf and Chambre;
part `accommodation` of the molecules is reflected diffusely), or these times
the ratios of singhDrag and kavanau to free-molecular flow, as the entry
knudsenCorrection of dsmcParcelFoam has it.

    motor = readMotor(path)     of etc/caseDicts/solidMotor
    pure, two = march(motor, False), march(motor)
    findings(motor, two, pure)

No molecules: the gas does not leave equilibrium, which it does where it is
thin. The DSMC solver is for that.
"""

import math
import os
import re

import numpy as np

K, NA = 1.380649e-23, 6.02214076e23
SPECIES = ("N2", "CO", "H2", "H2O", "CO2", "HCl")
MASS = np.array([46.5e-27, 46.5e-27, 3.34e-27, 29.9e-27, 73.1e-27, 61.4e-27])
DIAMETER = 1e-10*np.array([4.17, 4.19, 2.92, 4.5, 5.62, 5.76])
OMEGA = np.array([0.74, 0.73, 0.67, 1, 0.93, 1])
ROTATION = np.array([2, 2, 2, 3, 2, 2])

CONE = math.tan(math.radians(45))
CELLS, RINGS = 100, 12
WIDTH = 1.2             # of the mesh at the exit, in exit radii
OUTER = 3.5             # Mach number where the fan of the lip is cut off
RECORD = 0.1            # distance of recorded stations, in exit radii


# -------------------------------------------------- force and heat on a sphere

# Of a stream of speed ratio s: s Cd of what arrives; mean speed and mean cube
# of the speed, in the most probable speed
_S = np.concatenate([[1e-3], np.linspace(0.02, 12, 600)])
_ERF = np.array([math.erf(s) for s in _S])
_E = np.exp(-_S**2)/math.sqrt(math.pi)
_DRAG = np.where(_S < 0.05, 16/(3*math.sqrt(math.pi))*(1 + _S**2/5),
                 (2*_S**2 + 1)/_S**2*_E
                 + (4*_S**4 + 4*_S**2 - 1)/(2*_S**3)*_ERF)
_SPEED = _E + (_S + 0.5/_S)*_ERF
_CUBE = (_S**2 + 2.5)*_E + (_S**3 + 3*_S + 0.75/_S)*_ERF


def readMotor(path):
    """The numbers of a dictionary of entries `name value;`, evaluated, with
    what it includes."""
    motor = {"pi": math.pi}

    def read(path):
        with open(path, encoding="utf-8") as file:
            text = re.sub(r"//.*", "", file.read())
        for line in re.findall(r'#include\s+"[^"]+"|[^;]+;', text):
            include = re.search(r'#include\s+"([^"]+)"', line)
            if include:
                read(os.path.join(os.path.dirname(path),
                                  os.path.expandvars(include.group(1))))
                line = line[include.end():]
            found = re.search(
                r"(\w+)\s+(?:#eval\{)?(.*?)\}?\s*;", line, re.S)
            if found:
                motor[found.group(1)] = eval(
                    found.group(2).replace("$", ""),
                    {"sqrt": math.sqrt, **motor})

    read(path)
    return motor


def lognormal(radius, deviation, classes=5):
    """Diameters of classes of equal mass of a law of mass, as sizeGroups."""
    s = math.log(deviation)

    def below(a):
        return 0.5*(1 + math.erf(a/math.sqrt(2)))

    def quantile(p):
        low, high = -9., 9.
        for _ in range(60):
            middle = 0.5*(low + high)
            low, high = ((middle, high) if below(middle) < p
                         else (low, middle))
        return low

    edges = [quantile(i/classes) for i in range(classes + 1)]
    median = math.log(radius) - 3*s*s
    return np.array([
        2*math.exp(median + 1.5*s*s
                   - math.log(classes*(below(b + 3*s) - below(a + 3*s)))/3)
        for a, b in zip(edges, edges[1:])])


def diameters(motor):
    return lognormal(motor["exitSolidRadius"], motor["exitSolidDeviation"])


class Gas:
    """The mixture: ideal, its rotation excited, its vibration not."""

    def __init__(self, motor):
        self.x = np.array([motor["exit" + s] for s in SPECIES])
        self.x = self.x/self.x.sum()
        self.m = self.x @ MASS
        rotation = self.x @ ROTATION
        self.gamma = (5 + rotation)/(3 + rotation)
        self.R = K/self.m
        self.cp = self.gamma/(self.gamma - 1)*self.R
        self.temperatures = np.geomspace(20, 6000, 200)
        self.viscosities = self._viscosity(self.temperatures)

    def _viscosity(self, T):
        """Variable hard spheres, mixed by Wilke's rule."""
        mu = (15*np.sqrt(math.pi*MASS*K*273)
              / (2*math.pi*DIAMETER**2*(5 - 2*OMEGA)*(7 - 2*OMEGA))
              * (T[:, None]/273)**OMEGA)
        ratio = MASS[:, None]/MASS
        root = 1 + np.sqrt(mu[:, :, None]/mu[:, None, :]/np.sqrt(ratio))
        around = (root**2/np.sqrt(8*(1 + ratio))) @ self.x
        return (self.x*mu/around).sum(axis=1)

    def viscosity(self, T):
        return np.interp(T, self.temperatures, self.viscosities)


def freeMolecular(gas, w, T, rho, Tp, accommodation):
    """Force over velocity and area, heat brought and heat shed over area."""
    n = rho/gas.m
    force = brought = shed = 0.
    for share, m, z in zip(gas.x, MASS, ROTATION):
        c = np.sqrt(2*K*T/m)
        s = w/c
        arriving = np.interp(s, _S, _DRAG)
        v1 = c*np.interp(s, _S, _SPEED)
        v3 = c**3*np.interp(s, _S, _CUBE)
        diffuse = accommodation*2/3*np.sqrt(math.pi*Tp/T)
        force = force + 0.5*n*share*m*c*(arriving + diffuse)
        brought = brought + n*share*(0.5*m*v3 + 0.5*z*K*T*v1)
        shed = shed + n*share*(2 + 0.5*z)*K*Tp*v1
    return force, accommodation*brought, accommodation*shed


def singhCd(gamma, Re, Kn, tau, omega=0.74, hoc=0.9071):
    """Cd Re of Singh et al. (2022), as singhDrag; Kn stands for M/Re."""
    g1 = gamma - 1
    M = Kn*Re
    A0, a0 = 24/9.4**2, 0.3555
    fast = M > 1
    Ms = np.where(fast, M, 1.)
    behind, ahead = 2 + g1*Ms**2, 2*gamma*Ms**2 - g1
    U = behind/((gamma + 1)*Ms**2)
    Ts = U*ahead/(gamma + 1)
    a = 1/(1 + a0*(Ms - 1))
    C = 0.9 - A0*(1 + 0.25*g1**2/gamma)**(gamma/g1)
    pressure = np.where(
        fast, C*(1 - a*U)/(1 - g1/((gamma + 1)*a0*Ms)), 0)
    ratio = np.where(fast, (a*a*Ts)**-omega, 1)
    hot = np.where(fast, (1 + tau/Ts)**omega, 1)
    theta = (1 + 0.5*g1*np.where(fast, behind/ahead, M**2))**(gamma/g1)
    root = np.sqrt(ratio*theta**(0.5*(gamma + 1)/gamma - g1*omega/gamma))
    continuum = pressure*Re + A0*theta*(np.sqrt(Re) + 9.4/root)**2
    power = M**(2*omega - 1)
    BoverK = (power + 1)*hot
    B = Kn*BoverK
    knudsen = math.sqrt(0.5*math.pi*gamma)*Kn
    slip = 1 + knudsen*(2.514 + 0.8*np.exp(-0.55/knudsen))
    f = 1/(slip*(1 + hoc*Kn*power*hot))
    root = math.sqrt(0.5*gamma)
    free = (np.interp(root*M, _S, _DRAG)
            + 2/3*np.sqrt(math.pi*tau))/root
    return (continuum*f + free*BoverK*B**0.8)/(1 + B**1.8), free/Kn


def corrections(gas, d, w, T, rho, Tp):
    """Factors of force, of heat brought and of heat shed."""
    g = gas.gamma
    sound = np.sqrt(g*gas.R*T)
    Kn = gas.viscosity(T)/(rho*d*sound)
    M = w/sound
    Re = M/Kn
    wanted, free = singhCd(g, Re, Kn, np.minimum(Tp/T, 1e3))
    Pr = 4*g/(9*g - 5)
    Nu = 1/(1/(2 + 0.6*Pr**(1/3)*np.sqrt(Re)) + 3.42/Pr*Kn)
    taw = 1 + 0.5*(g - 1)*math.sqrt(Pr)*M**2
    s = math.sqrt(0.5*g)*M
    v1, v3 = np.interp(s, _S, _SPEED), np.interp(s, _S, _CUBE)
    freeNu = Pr*(g + 1)/(8*g)/math.sqrt(0.5*g)*v1/Kn
    half = 0.5*(5 - 3*g)/(g - 1)
    freeTaw = (v3/v1 + half)/(2 + half)
    return wanted/free, Nu*taw/(freeNu*freeTaw), Nu/freeNu


# ------------------------------------------------------------------- the gas

def primitives(G, g):
    """Of the axial fluxes of mass, momenta and energy, supersonic."""
    m, P, N, E = G
    v, b = N/m, P/m
    h = E/m - 0.5*v*v
    c = g/(g - 1)
    u = (c*b + np.sqrt(np.maximum(c*c*b*b - 4*(c - 0.5)*h, 0)))/(2*c - 1)
    return m/u, u, v, np.maximum(P - m*u, 1e-12*P)


def fluxes(rho, u, v, p, g):
    """Axial and radial."""
    H = g/(g - 1)*p/rho + 0.5*(u*u + v*v)
    m, n = rho*u, rho*v
    return (np.array([m, m*u + p, m*v, m*H]),
            np.array([n, n*u, n*v + p, n*H]))


def slopes(rho, u, v, p, g):
    c2 = g*p/rho
    root = np.sqrt(c2*np.maximum(u*u + v*v - c2, 0))
    under = np.maximum(u*u - c2, 1e-3*u*u)
    return (u*v - root)/under, (u*v + root)/under


def changes(G, r, spread, g):
    """Of the axial fluxes in rings, over x. r: faces; spread: their slopes."""
    W = np.array(primitives(G, g))
    # Linear in the cells, minmod; mirrored at the axis
    d = np.diff(W, axis=1, prepend=W[:, :1], append=W[:, -1:])
    slope = np.where(d[:, 1:]*d[:, :-1] > 0, np.sign(d[:, 1:])*np.minimum(
        np.abs(d[:, 1:]), np.abs(d[:, :-1])), 0)
    left, right = W + 0.5*slope, W - 0.5*slope
    left = left[:, :-1]
    right = right[:, 1:]
    GL, FL = fluxes(*left, g)
    GR, FR = fluxes(*right, g)
    lowL, highL = slopes(*left, g)
    lowR, highR = slopes(*right, g)
    s = spread[1:-1]
    low = np.minimum(np.minimum(lowL, lowR) - s, 0)
    high = np.maximum(np.maximum(highL, highR) - s, 0)
    F = (high*(FL - s*GL) - low*(FR - s*GR) + low*high*(GR - GL))/(high - low)
    # Outermost: all leaves
    GE, FE = fluxes(*W[:, -1], g)
    out = FE - spread[-1]*GE
    total = np.zeros((4, len(r)))
    total[:, 1:-1] = F*r[1:-1]
    total[:, -1] = out*r[-1]
    rate = -np.diff(total, axis=1)
    rate[2] += W[3]*np.diff(r)
    least = np.maximum(np.abs(low), np.abs(high))
    return rate, least.max()


# ------------------------------------------------------------------ the march

def exitGas(motor):
    """Of the mixture: gas, velocity, density."""
    gas = Gas(motor)
    T = motor["exitTemperature"]
    return (gas, motor["exitMach"]*math.sqrt(gas.gamma*gas.R*T),
            motor["exitPressure"]/(gas.R*T))


def turned(M, U, rho, T, gas):
    """Gas that has turned about the lip to the Mach number OUTER."""
    g = gas.gamma

    def angle(M):
        root = math.sqrt((g + 1)/(g - 1))
        beta = math.sqrt(M*M - 1)
        return root*math.atan(beta/root) - math.atan(beta)

    ratio = (1 + 0.5*(g - 1)*M*M)/(1 + 0.5*(g - 1)*OUTER**2)
    theta = angle(OUTER) - angle(M)
    speed = OUTER/M*U*math.sqrt(ratio)
    dense = rho*ratio**(1/(g - 1))
    return (dense, speed*math.cos(theta), speed*math.sin(theta),
            dense*gas.R*T*ratio)


class Spheres:
    """Edges of the rings of each group, and what they take."""

    def __init__(self, motor, gas, u, rho, Te):
        d = diameters(motor)
        shape = len(d), RINGS + 1
        self.gas, self.d = gas, d[:, None]
        self.mass = motor["exitSolidDensity"]*math.pi/6*self.d**3
        self.cp = motor["exitSolidHeat"]
        self.R = motor["exitRadius"]
        self.accommodation = motor.get("accommodation", 1.)
        self.corrected = motor.get("corrected", True)
        self.r = np.broadcast_to(
            np.sqrt(np.arange(RINGS + 1)/RINGS), shape).copy()
        self.vx = np.full(shape, u*motor["exitSolidVelocity"])
        self.vr = np.zeros(shape)
        self.T = np.full(shape, Te*motor["exitSolidTemperature"])
        # Mass flow of a ring over pi R^2
        share = motor["exitSolidShare"]
        self.flow = np.full(
            (len(d), 1), share/(1 - share)*rho*u/RINGS/len(d))

    def advance(self, r, centres, W, dx):
        """Move to x + dx; returns what the gas of each cell gains, over 2 pi
        R^2, momentum along and outwards and energy."""
        rho, u, v, p = (np.interp(self.r, centres, w) for w in W)
        v = v*np.minimum(self.r/centres[0], 1)
        T = p/(rho*self.gas.R)
        wx, wr = u - self.vx, v - self.vr
        w = np.hypot(wx, wr) + 1e-3
        force, brought, shed = freeMolecular(
            self.gas, w, T, rho, self.T, self.accommodation)
        if self.corrected:
            f, heating, cooling = corrections(
                self.gas, self.d, w, T, rho, self.T)
            force, brought, shed = force*f, brought*heating, shed*cooling
        area = math.pi/4*self.d**2
        dt = dx*self.R/self.vx
        # Towards the gas without passing it
        k = force*area/self.mass
        pull = -np.expm1(-k*dt)
        dvx, dvr = wx*pull, wr*pull
        cooling = shed*area/(self.mass*self.cp*self.T)
        heating = brought*area/(self.mass*self.cp)
        dT = (heating/cooling - self.T)*-np.expm1(-cooling*dt) \
            if self.accommodation else np.zeros_like(self.T)
        energy = dvx*(self.vx + 0.5*dvx) + dvr*(self.vr + 0.5*dvr) \
            + self.cp*dT
        self.r = np.maximum(
            self.r + dx*(self.vr + 0.5*dvr)/(self.vx + 0.5*dvx), 0)
        self.vx = self.vx + dvx
        self.vr = self.vr + dvr
        self.T = self.T + dT
        gains = np.zeros((3, len(centres)))
        for k in range(len(self.d)):
            for j, take in enumerate((dvx[k], dvr[k], energy[k])):
                mean = 0.5*(take[1:] + take[:-1])*self.flow[k]
                sums = np.concatenate([[0], np.cumsum(mean)])
                gains[j] -= 0.5*np.diff(np.interp(r*r, self.r[k]**2, sums))
        return gains

    def density(self, r):
        """Mass per volume of each group in cells, and its temperature."""
        out = []
        for k in range(len(self.d)):
            at = self.r[k]**2
            c = 0.5*(r[1:]**2 + r[:-1]**2)
            flow = np.diff(np.interp(
                r*r, at, np.arange(RINGS + 1)*self.flow[k, 0]))
            out.append((flow/(np.diff(r*r)*np.interp(c, at, self.vx[k])),
                        np.interp(c, at, self.T[k]),
                        np.interp(c, at, self.vx[k])))
        return np.array(out)


def march(motor, particles=True, end=10.):
    """Stations from the exit on: list of dictionaries."""
    gas, U, rho = exitGas(motor)
    g, Te = gas.gamma, motor["exitTemperature"]
    eta = np.linspace(0, 1, CELLS + 1)
    spread = eta*CONE
    r = eta*WIDTH
    start = np.empty((4, CELLS))
    inside = 0.5*(r[1:] + r[:-1]) < 1
    start[:, inside] = np.array([[rho, U, 0, rho*gas.R*Te]]).T
    start[:, ~inside] = np.array([turned(motor["exitMach"], U, rho, Te, gas)]).T
    G = fluxes(*start, g)[0]
    area = 0.5*np.diff(r*r)
    spheres = Spheres(motor, gas, U, rho, Te) if particles else None
    x, dx, stations = 0., 1e-4, []
    while True:
        W = np.array(primitives(G, g))
        if not stations or x >= len(stations)*RECORD:
            station = {"x": x, "r": r, "gas": W, "T": W[3]/(W[0]*gas.R)}
            if particles:
                station["solids"] = spheres.density(r)
                station["edges"] = (spheres.r, spheres.vx, spheres.vr,
                                    spheres.T)
            stations.append(station)
        if x >= end:
            return stations
        rate, steepest = changes(G, r, spread, g)
        dx = min(0.45*(r[1] - r[0])/steepest, 1.5*dx, end - x)
        # Two stages, Heun
        content = G*area
        r1 = r + dx*spread
        area1 = 0.5*np.diff(r1*r1)
        first = (content + dx*rate)/area1
        second, _ = changes(first, r1, spread, g)
        content = content + 0.5*dx*(rate + second)
        if particles:
            gains = spheres.advance(r, 0.5*(r[1:] + r[:-1]), W, dx)
            content[1:] += gains
        G = content/area1
        r, area = r1, area1
        x += dx


# --------------------------------------------------------------- the findings

def onAxis(stations, x, row):
    """Of the gas at a distance, mean of the two cells at the axis by area;
    row: density, velocities along and outwards, pressure, temperature."""
    values = [np.dot(s["T"][:2] if row == 4 else s["gas"][row][:2], (1, 3))/4
              for s in stations]
    return np.interp(x, [s["x"] for s in stations], values)


def findings(motor, two, pure, burn=70.):
    """What the paper gives numbers for: differences of the gas on the axis at
    x = 6, largest difference in the mean temperature of the particles behind
    x = 1, far edge of the smallest after the burn, exponent of the spread in
    the diameter."""
    d = diameters(motor)
    low, high = np.inf, -np.inf
    most = 0
    for s in two:
        if s["x"] > 1:
            mass, T, _ = np.moveaxis(s["solids"], 1, 0)
            number = (mass/d[:, None]**3).sum(axis=0)
            most = max(most, number.max())
            filled = number > 1e-3*most
            mean = ((mass*T).sum(axis=0)[filled]/mass.sum(axis=0)[filled])
            low, high = min(low, mean.min()), max(high, mean.max())
    _, vx, vr, _ = two[-1]["edges"]
    rings = 0.5*(vx[0, 1:] + vx[0, :-1])
    place = np.linspace(0, burn*vx[0].max(), 4001)
    share = np.mean([np.clip(place/(burn*v), 0, 1) for v in rings], axis=0)
    spread = [np.interp(0.99, np.arange(RINGS + 1)/RINGS, (vr/vx)[k])
              for k in range(len(d))]
    return {"slower": onAxis(pure, 6, 1) - onAxis(two, 6, 1),
            "hotter": onAxis(two, 6, 4) - onAxis(pure, 6, 4),
            "span": high - low,
            "farEdge": np.interp(0.999, share, place)/1e3,
            "exponent": np.polyfit(np.log(d), np.log(spread), 1)[0]}


PAPER = {"slower": 160., "hotter": 40., "span": 300., "farEdge": 115.,
         "exponent": -1.}


def worst(found, names=tuple(PAPER)):
    """Largest relative deviation from the paper, and of what."""
    return max((abs(found[n]/PAPER[n] - 1), n) for n in names)
