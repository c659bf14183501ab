# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""The motion of an adhesive contact and its scales, written down once more."""

import math

RHO = 2500.0
MODULUS, WORK, ALPHA = 50e9, 0.1528, 1.1891


def mass(d):
    return RHO*math.pi/6*d**3


def separation_speed(d):
    """v_st of physics' static curve: W = 7.0926 (w^5 R^4/E^2)^(1/3)."""
    a0 = (9*math.pi*WORK*(d/2)**2/(2*MODULUS))**(1/3)
    length = a0**2/(2*6**(1/3)*(d/2))
    work = 0.935502783*1.5*math.pi*WORK*(d/2)*length
    return math.sqrt(2*work/mass(d))


def restitution(alpha, q):
    """Motion in u = sqrt(a/a0) and s, dt = D'(u) ds, by RK4."""
    kappa = math.sqrt(2/6**(1/3))
    u0, u1 = (2/3)**(1/3), (1/6)**(1/3)

    def slope(u):
        return 6**(1/3)*(8*u**3 - 4/3)

    def rate(u, p):
        return p, -slope(u)*(4*(u**6 - u**3) + alpha*kappa*u*p)

    V = q*math.sqrt(2*0.935502783)
    u, p, turned = u0, V, False
    while True:
        h = 5e-4*u/max(abs(p), u**5, 0.02)
        k1 = rate(u, p)
        k2 = rate(u + h/2*k1[0], p + h/2*k1[1])
        k3 = rate(u + h/2*k2[0], p + h/2*k2[1])
        k4 = rate(u + h*k3[0], p + h*k3[1])
        v = u + h/6*(k1[0] + 2*k2[0] + 2*k3[0] + k4[0])
        r = p + h/6*(k1[1] + 2*k2[1] + 2*k3[1] + k4[1])
        turned |= r <= 0
        if turned and v <= u1:
            part = (u - u1)/(u - v)
            return -(p + part*(r - p))/V
        if turned and r > 0:
            return 0
        u, p = v, r
