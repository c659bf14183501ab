# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Brute-force scattering of rigid bodies by a wall, to compare
scatteringIndicatrix with: every particle is marched in small steps, its
rotation by Runge and Kutta's method, and is in contact where a sampled point
of its surface dips under the wall. Rebounds solve equations (1) to (12) of
Panfilov & Tsirkunov, J. Appl. Mech. Tech. Phys. 49(2), 2008, 222-230, in
laboratory axes. Prints PASS and FAIL lines.

Usage: bruteForce.py CASE, a folder that this writes to"""
import csv
import os
import subprocess
import sys

import numpy as np


class Wall:
    def __init__(self, height, slope, top, period):
        self.height, self.slope = height, slope
        self.top, self.period = top, period


def smooth():
    return Wall(lambda x: np.zeros_like(x), lambda x: np.zeros_like(x), 0., 1.)


def sinusoidal(A, wavelength):
    k = 2*np.pi/wavelength
    return Wall(lambda x: A*np.sin(k*x), lambda x: A*k*np.cos(k*x),
                A, wavelength)


class Box:
    def __init__(self, size, perEdge=40):
        self.a = np.array(size)/2
        s = np.array([[i, j, k] for i in (-1, 1) for j in (-1, 1)
                      for k in (-1, 1)])
        pts = []
        u = np.linspace(-1, 1, perEdge)
        for axis in range(3):
            o = [i for i in range(3) if i != axis]
            for p in (-1, 1):
                for q in (-1, 1):
                    e = np.zeros((perEdge, 3))
                    e[:, axis], e[:, o[0]], e[:, o[1]] = u, p, q
                    pts.append(e)
        self.pts = np.concatenate(pts)*self.a
        self.corners = s*self.a
        L = np.array(size)
        self.J = np.array([L[1]**2 + L[2]**2, L[0]**2 + L[2]**2,
                           L[0]**2 + L[1]**2])/12
        self.radius = np.linalg.norm(self.a)

    def points(self, R, flat):
        p = self.corners if flat else self.pts
        return np.einsum('nij,pj->npi', R, p)


class Ellipsoid:
    def __init__(self, size, n=96):
        self.a = np.array(size)/2
        a = self.a
        self.J = np.array([a[1]**2 + a[2]**2, a[0]**2 + a[2]**2,
                           a[0]**2 + a[1]**2])/5
        self.radius = a.max()
        t = 2*np.pi*np.arange(n)/n
        self.c = np.stack([np.cos(t), np.sin(t)], 1)

    def points(self, R, flat):
        # support points for normals (c, s, 0): all of the shadow's outline
        nrm = np.array([[0., -1.]]) if flat else self.c
        u = np.einsum('nij,pi->npj', R[:, :2, :], nrm)*self.a  # body comps*a
        r = u*self.a/np.linalg.norm(u, axis=2, keepdims=True)
        return np.einsum('nij,npj->npi', R, r)


def orientations(rng, n, law):
    if law == 'isotropic':
        q = rng.standard_normal((n, 4))
        q /= np.linalg.norm(q, axis=1)[:, None]
        w, x, y, z = q.T
        R = np.empty((n, 3, 3))
        R[:, 0, 0], R[:, 0, 1] = 1 - 2*(y*y + z*z), 2*(x*y - w*z)
        R[:, 0, 2], R[:, 1, 0] = 2*(x*z + w*y), 2*(x*y + w*z)
        R[:, 1, 1], R[:, 1, 2] = 1 - 2*(x*x + z*z), 2*(y*z - w*x)
        R[:, 2, 0], R[:, 2, 1] = 2*(x*z - w*y), 2*(y*z + w*x)
        R[:, 2, 2] = 1 - 2*(x*x + y*y)
        return R
    a = rng.random((3, n))*2*np.pi

    def rot(axis, t):
        R = np.zeros((n, 3, 3))
        i, j = (axis + 1) % 3, (axis + 2) % 3
        R[:, axis, axis] = 1
        R[:, i, i] = R[:, j, j] = np.cos(t)
        R[:, i, j], R[:, j, i] = -np.sin(t), np.sin(t)
        return R
    return rot(1, a[0]) @ rot(2, a[1]) @ rot(0, a[2])


def rate(R, w, J):
    W = np.zeros_like(R)
    W[:, 0, 1], W[:, 0, 2], W[:, 1, 2] = -w[:, 2], w[:, 1], -w[:, 0]
    W -= W.transpose(0, 2, 1)
    return R @ W, np.cross(J*w, w)/J


def turn(R, w, J, dt):
    d = dt[:, None]
    D = d[:, :, None]
    r1, w1 = rate(R, w, J)
    r2, w2 = rate(R + D/2*r1, w + d/2*w1, J)
    r3, w3 = rate(R + D/2*r2, w + d/2*w2, J)
    r4, w4 = rate(R + D*r3, w + d*w3, J)
    R = R + D/6*(r1 + 2*r2 + 2*r3 + r4)
    w = w + d/6*(w1 + 2*w2 + 2*w3 + w4)
    # columns orthonormal again, to first order
    E = R.transpose(0, 2, 1) @ R
    return R @ (1.5*np.eye(3) - 0.5*E), w


def grantTabakoff(beta, v):
    return (((-0.49*beta + 1.56)*beta - 1.76)*beta + 0.993,
            ((-0.67*beta + 2.11)*beta - 1.66)*beta + 0.988)


def measured(beta, v):
    """A table over 10 and 60 deg, 40 and 160 m/s; -0.2 along the wall."""
    a = np.clip((np.degrees(beta) - 10)/50, 0, 1)
    s = np.clip((v - 40)/120, 0, 1)
    return ((1 - a)*(0.9 - 0.1*s) + a*(0.7 - 0.3*s), -0.2)


LAWS = {
    'constant': (lambda beta, v: (0.8, 0), 'normal 0.8; tangential 0;'),
    'fit': (grantTabakoff, 'normal GrantTabakoff; tangential GrantTabakoff;'),
    'table': (measured, """normal
{ type table; angles (10 60); speeds (40 160); values ((0.9 0.8) (0.7 0.4)); }
tangential -0.2;"""),
}


def scatter(body, wall, rng, n, incidence, restitution, speed=200.,
            law='isotropic', spin=(0, 0, 0), firstImpact=False, flat=False,
            angle=0.03, stride=0.02, maxImpacts=200):
    al = np.radians(incidence)
    V = np.tile([speed*np.cos(al), -speed*np.sin(al), 0.], (n, 1))
    R = orientations(rng, n, law)
    w = np.einsum('nij,i->nj', R, np.array(spin, float))
    P = np.stack([rng.random(n)*wall.period,
                  np.full(n, wall.top + body.radius)], 1)
    J = body.J
    impacts = np.zeros(n, int)
    micro = np.zeros(n, int)
    pulling = np.zeros(n, int)
    gaining = np.zeros(n, int)
    into = np.zeros(n, bool)
    live = np.arange(n)

    def lowest(P, R):
        p = body.points(R, flat)
        x = P[:, :1] + p[:, :, 0]
        g = P[:, 1:] + p[:, :, 1] - wall.height(x)
        k = g.argmin(1)
        i = np.arange(len(k))
        return g[i, k], p[i, k]

    def move(s, dt):
        R2, w2 = turn(R[s], w[s], J, dt)
        return P[s] + V[s, :2]*dt[:, None], R2, w2

    while len(live):
        s = live
        fast = np.linalg.norm(w[s], axis=1) + 1e-300
        dt = np.minimum(angle/fast, stride*2*body.radius
                        / np.linalg.norm(V[s], axis=1))
        P1, R1, w1 = move(s, dt)
        g, r = lowest(P1, R1)
        hit = g < 0
        ok = s[~hit]
        P[ok], R[ok], w[ok] = P1[~hit], R1[~hit], w1[~hit]
        h = s[hit]
        if len(h):
            lo = np.zeros(len(h))
            hi = dt[hit].copy()
            for _ in range(34):
                mid = 0.5*(lo + hi)
                Pm, Rm, wm = move(h, mid)
                gm, _ = lowest(Pm, Rm)
                lo, hi = np.where(gm < 0, lo, mid), np.where(gm < 0, mid, hi)
            P[h], R[h], w[h] = move(h, lo)
            _, r = lowest(P[h], R[h])
            sl = wall.slope(P[h, 0] + r[:, 0])
            nrm = np.stack([-sl, np.ones_like(sl), np.zeros_like(sl)], 1)
            nrm /= np.linalg.norm(nrm, axis=1)[:, None]
            om = np.einsum('nij,nj->ni', R[h], w[h])
            Vc = V[h] + np.cross(om, r)
            vn = (Vc*nrm).sum(1)[:, None]*nrm
            v = np.linalg.norm(Vc, axis=1)[:, None]
            beta = np.arcsin(np.minimum(
                np.linalg.norm(vn, axis=1)[:, None]/v, 1))
            en, et = restitution(beta, v)
            dVc = -(1 - et)*(Vc - vn) - (1 + en)*vn
            I = np.einsum('nij,j,nkj->nik', R[h], J, R[h])
            A = I + (r*r).sum(1)[:, None, None]*np.eye(3) \
                - r[:, :, None]*r[:, None, :]
            dw = np.linalg.solve(A, np.cross(r, dVc)[:, :, None])[:, :, 0]
            dV = dVc - np.cross(dw, r)
            T0 = (V[h]**2).sum(1) + np.einsum('ni,nij,nj->n', om, I, om)
            V[h] += dV
            om = om + dw
            T1 = (V[h]**2).sum(1) + np.einsum('ni,nij,nj->n', om, I, om)
            w[h] = np.einsum('nij,ni->nj', R[h], om)
            app = -(vn*nrm).sum(1)
            first = impacts[h] + micro[h] == 0
            into[h[first]] = V[h[first], 1] <= 0
            big = app > 1e-3*speed
            impacts[h] += big
            micro[h] += ~big
            pulling[h] += (dV*nrm).sum(1) < 0
            gaining[h] += T1 - T0 > 1e-12*T0
        total = impacts[s] + micro[s]
        out = (V[s, 1] > 0) & (P[s, 1] > wall.top + body.radius)
        if firstImpact:
            out |= total > 0
        live = s[~(out | (total >= maxImpacts))]
    a2 = np.degrees(np.arctan2(V[:, 1], V[:, 0]))
    b2 = np.degrees(np.arctan2(V[:, 2], np.hypot(V[:, 0], V[:, 1])))
    return dict(a2=a2, b2=b2, V=V, impacts=impacts, micro=micro,
                pulling=pulling, gaining=gaining, into=into,
                trans=(V**2).sum(1)/speed**2,
                rot=(J*w**2).sum(1)/speed**2)


def sampled(case, entries):
    """Summary, F and I of scatteringIndicatrix for this dictionary."""
    os.makedirs(case + '/system', exist_ok=True)
    with open(case + '/system/scatteringIndicatrixDict', 'w') as f:
        f.write(entries)
    subprocess.run(['scatteringIndicatrix', '-case', case, '-noPlot'],
                   check=True, stdout=subprocess.DEVNULL)
    folder = case + '/postProcessing/scatteringIndicatrix/'
    with open(folder + 'summary.csv') as f:
        rows = list(csv.reader(f))[1:]
    F = np.loadtxt(folder + 'F.csv', delimiter=',', skiprows=1)[:, 1]
    return {name: float(value) for name, value in rows}, F


def compare(case, name, shape, wallEntries, wall, n, flat, spin=(0, 0, 0),
            law='isotropic', incidence=15, impact='constant'):
    """Means within 4.5 standard errors, F within 5 of chi squared."""
    size = (32e-6, 25.6e-6, 25.6e-6) if shape == 'box' \
        else (32e-6, 20e-6, 12e-6)
    body = Box(size) if shape == 'box' else Ellipsoid(size)
    b = scatter(body, wall, np.random.default_rng(1), n, incidence,
                LAWS[impact][0], flat=flat, spin=spin, law=law)
    many = 400000
    s, F = sampled(case, f"""
shape {{ type {shape}; size ({' '.join(map(str, size))}); }}
wall {{ {wallEntries} }}
law {{ type restitution; {LAWS[impact][1]} }}
incidence {incidence}; speed 200; spin ({' '.join(map(str, spin))});
orientation {law}; nParticles {many};
""")
    struck = b['impacts'] + b['micro']
    worst = 0
    text = ''
    for key, x in (('meanAlpha2_deg', b['a2']), ('meanBeta2_deg', b['b2']),
                   ('keTranslationalRatio', b['trans']),
                   ('keRotationalRatio', b['rot']),
                   ('fractionIntoWall', b['into']),
                   ('fractionSecondImpact', struck > 1),
                   ('fractionBackward', abs(b['a2']) > 90),
                   ('sdAlpha2_deg', (b['a2'] - b['a2'].mean())**2),
                   ('sdBeta2_deg', (b['b2'] - b['b2'].mean())**2)):
        mean, error = x.mean(), x.std()/np.sqrt(n)
        expected = s[key]**2 if key.startswith('sd') else s[key]
        error = max(error, 1/n)*np.sqrt(1 + n/many)
        off = abs(mean - expected)/error
        if off > worst or np.isnan(off):
            worst = off
            text = f'{key} {mean:.5g} against {expected:.5g}'
    counted, _ = np.histogram(b['a2'], np.arange(0, 181, 5))
    expected = n*F.reshape(36, 5).sum(1)*np.pi/180
    used = expected > 8
    chi = ((counted - expected)[used]**2/expected[used]).sum()
    chi = (chi - used.sum())/np.sqrt(2*used.sum())
    if worst < 4.5 and chi < 5:
        print(f'PASS bruteForce-{name}')
    else:
        print(f'FAIL bruteForce-{name}: {text}, {worst:.1f} standard errors; '
              f'F {chi:.1f} deviations of chi squared')


def main():
    case = sys.argv[1]
    waves = 'type sinusoidal; amplitude 20e-6; wavelength 160e-6;'
    compare(case, 'box', 'box', 'type smooth;', smooth(), 4000, True)
    compare(case, 'spinningBox', 'box', 'type smooth;', smooth(), 4000, True,
            spin=(3e6, 5e6, -8e6))
    compare(case, 'triaxialEllipsoid', 'ellipsoid', 'type smooth;', smooth(),
            4000, True, law='uniformEuler', incidence=30)
    compare(case, 'boxByFit', 'box', 'type smooth;', smooth(), 4000, True,
            incidence=30, impact='fit')
    compare(case, 'boxByTable', 'box', 'type smooth;', smooth(), 4000, True,
            impact='table')
    compare(case, 'boxOnWaves', 'box', waves, sinusoidal(20e-6, 160e-6),
            600, False)
    compare(case, 'triaxialEllipsoidOnWaves', 'ellipsoid', waves,
            sinusoidal(20e-6, 160e-6), 600, False, incidence=60)


if __name__ == '__main__':
    main()
