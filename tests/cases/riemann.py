# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Exact solution of the Riemann problem of a calorically perfect gas."""

import numpy as np


def riemann(left, right, xi, gamma):
    """Density, velocity and pressure at the speeds xi = x/t, for the states
    (rho, u, p) on both sides: pressure and velocity agree across the contact,
    each side is joined to it by a shock (Rankine-Hugoniot) or by a fan
    (Riemann invariants). No vacuum between them."""
    def side(state, p):
        """Change of velocity across the wave of one side, as a magnitude."""
        rho, _, p0 = state
        a = np.sqrt(gamma*p0/rho)
        if p > p0:
            m = np.sqrt(0.5*rho*((gamma + 1)*p + (gamma - 1)*p0))
            return (p - p0)/m
        return 2*a/(gamma - 1)*((p/p0)**(0.5*(gamma - 1)/gamma) - 1)

    low, high = 1e-12*min(left[2], right[2]), 1e3*max(left[2], right[2])
    for _ in range(200):
        p = np.sqrt(low*high)
        if side(left, p) + side(right, p) + right[1] - left[1] > 0:
            high = p
        else:
            low = p
    u = 0.5*(left[1] - side(left, p) + right[1] + side(right, p))

    xi = np.asarray(xi, float)
    out = np.empty((3,) + xi.shape)
    for state, sign in (left, 1), (right, -1):
        rho0, u0, p0 = state[0], sign*state[1], state[2]
        s, us = sign*xi, sign*u     # as seen by a left side
        a0 = np.sqrt(gamma*p0/rho0)
        here = s <= us if sign > 0 else s < us
        if p > p0:
            ratio = p/p0
            g = (gamma - 1)/(gamma + 1)
            rho1 = rho0*(ratio + g)/(g*ratio + 1)
            speed = u0 - a0*np.sqrt(0.5*(gamma + 1)/gamma*ratio
                                    + 0.5*(gamma - 1)/gamma)
            inner, outer = s > speed, s <= speed
            fan = np.zeros_like(inner)
        else:
            rho1 = rho0*(p/p0)**(1/gamma)
            a1 = np.sqrt(gamma*p/rho1)
            outer, inner = s <= u0 - a0, s > us - a1
            fan = ~outer & ~inner
        a = (2*a0 + (gamma - 1)*(u0 - s))/(gamma + 1)
        ratio = np.where(fan, np.abs(a)/a0, 1)**(2/(gamma - 1))
        rho = np.where(outer, rho0, np.where(inner, rho1, rho0*ratio))
        v = np.where(outer, u0, np.where(inner, us, s + a))
        q = np.where(outer, p0, np.where(inner, p, p0*ratio**gamma))
        for k, value in enumerate((rho, sign*v, q)):
            out[k][here] = value[here]
    return out
