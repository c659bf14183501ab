# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""The spatial indicatrix drawn on the half-sphere of directions."""
import numpy as np
from matplotlib.colors import LogNorm

KEY = (r'seen from above the wall, forwards to the right; numbers: $\alpha_2$;'
       r' lines of $\alpha_2$ and $\beta_2$ every 30°')


def onMap(alpha, beta):
    """Where directions [deg] lie on the map: the half-sphere seen from above
    the wall, its normal in the middle, forwards to the right, in Lambert's
    projection, which keeps areas. KEY says so in a picture."""
    alpha, beta = np.radians(alpha), np.radians(beta)
    up = np.sqrt(1 + np.clip(np.cos(beta)*np.sin(alpha), 0, 1))
    return np.cos(beta)*np.cos(alpha)/up, np.sin(beta)/up


def perSteradian(result):
    """I over the solid angle: the share of the particles per steradian."""
    beta = np.radians(np.linspace(-90, 90, len(result.alpha) + 1))
    return result.I*result.width/np.diff(np.sin(beta))


def norm(*results, decades=3):
    """Logarithmic colours that maps have in common."""
    top = max(perSteradian(r).max() for r in results) or 1
    return LogNorm(top*10.0**-decades, top, clip=True)


def halfSphere(axes, result, colours):
    """Draw the map of a result; returns what a colour bar wants."""
    bins = len(result.alpha)
    alpha, beta = np.meshgrid(np.linspace(0, 180, bins + 1),
                              np.linspace(-90, 90, bins + 1), indexing='ij')
    density = perSteradian(result)
    image = axes.pcolormesh(*onMap(alpha, beta),
                            np.ma.masked_equal(density, 0), norm=colours,
                            cmap='viridis', rasterized=True)
    turn, tilt = np.linspace(0, 180, 91), np.linspace(-90, 90, 91)
    line = dict(color='0.5', lw=0.5, alpha=0.7)
    for angle in range(0, 181, 30):
        axes.plot(*onMap(angle, tilt), **line)
        axes.plot(*onMap(turn, angle - 90), **line)
    for a, side in ((0, 'left'), (90, 'center'), (180, 'right')):
        axes.text(*onMap(a, 0), f'{a}°', fontsize=7, ha=side, va='center',
                  bbox=dict(fc='w', ec='none', pad=0.4, alpha=0.7))
    axes.set(aspect='equal', xlim=(-1.2, 1.15), ylim=(-1.02, 1.02))
    axes.axis('off')
    return image
