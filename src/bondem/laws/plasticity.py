"""Cells that yield on their mean stress: cohesion that falls with slip, constant friction.

Mohr–Coulomb:

    F = (σ1 - σ3)/2 + (σ1 + σ3)/2 sin φ - r c cos φ,     r = 1 - Σ Δγ V^(1/3) c / 2 G_II, at least 0
    Δγ = F / 2 G, half of it per step,     Δε = ½ Δγ [(1 + sin ψ) e1⊗e1 - (1 - sin ψ) e3⊗e3]

Drucker–Prager, for compressive mean stress, and with k in place of c in r:

    F = √J2 + α I1 - r k,     Δε = Δγ [s / 2√J2 + β 1],     s the deviator
    Δγ = F / (G + 9 K α β), half of it per step

so that in pure shear τ both dissipate τ Δγ.

Stresses and strains have the components xx, yy, zz, xy, xz, yz; tension is positive. The plastic strain is an
eigenstrain of the cell: its levers are P b, P ← (1 + Δε) P. The dissipation is therefore V σ:Δε exactly, also at
large strain.
"""

import math

from bondem._compile import device

# Share of the return to the yield surface that is made in a step: the stress is that of the step before.
_SHARE = 0.5
_THIRD = 1.0 / 3.0
_ROOT_THIRD = math.sqrt(_THIRD)


@device
def invariants(s):
    """Return the mean stress, and the square root of the second invariant of the deviator."""
    p = _THIRD * (s[0] + s[1] + s[2])
    a, b, c = s[0] - p, s[1] - p, s[2] - p
    return p, math.sqrt(0.5 * (a * a + b * b + c * c) + s[3] * s[3] + s[4] * s[4] + s[5] * s[5])


@device
def largest_at_most(p, q):
    """Return a bound on the largest principal stress, from `invariants`: its value in uniaxial tension."""
    return p + 2.0 * math.sqrt(_THIRD) * q


@device
def largest_pressure(s):
    """Return -σ3 of a stress, at least 0."""
    p, q = invariants(s)
    cube = q * q * q
    if cube == 0.0:
        return max(-p, 0.0)
    a, b, c = s[0] - p, s[1] - p, s[2] - p
    third = a * (b * c - s[5] * s[5]) - s[3] * (s[3] * c - s[5] * s[4]) + s[4] * (s[3] * s[5] - b * s[4])
    angle = _THIRD * math.acos(max(-1.0, min(1.0, 1.5 * math.sqrt(3.0) * third / cube)))
    return max(-p - 2.0 * math.sqrt(_THIRD) * q * math.cos(angle + _THIRD * 2.0 * math.pi), 0.0)


@device
def rotated(a, v, p, q):
    """Apply one Jacobi rotation, which clears (p, q), to a symmetric matrix (6 entries by place) and its vectors."""
    apq = a[p, q]
    if apq == 0.0:
        return
    h = 0.5 * (a[q, q] - a[p, p]) / apq
    t = (1.0 if h >= 0.0 else -1.0) / (abs(h) + math.sqrt(h * h + 1.0))
    c = 1.0 / math.sqrt(t * t + 1.0)
    s = t * c
    r = 3 - p - q
    arp, arq = a[r, p], a[r, q]
    a[p, p] -= t * apq
    a[q, q] += t * apq
    a[p, q] = a[q, p] = 0.0
    a[r, p] = a[p, r] = c * arp - s * arq
    a[r, q] = a[q, r] = s * arp + c * arq
    for d in range(3):
        vp, vq = v[d, p], v[d, q]
        v[d, p], v[d, q] = c * vp - s * vq, s * vp + c * vq


@device
def principal(s, a, v):
    """Compute principal stresses (σ1 ≥ σ2 ≥ σ3) of s, and their directions in the columns of v.

    Both a and v are work arrays (3, 3).

    Returns:
        (σ1, σ3, column of e1, column of e3).
    """
    a[0, 0], a[1, 1], a[2, 2] = s[0], s[1], s[2]
    a[0, 1] = a[1, 0] = s[3]
    a[0, 2] = a[2, 0] = s[4]
    a[1, 2] = a[2, 1] = s[5]
    for d in range(3):
        for e in range(3):
            v[d, e] = 1.0 if d == e else 0.0
    for _ in range(5):  # sweeps; the third leaves rounding
        rotated(a, v, 0, 1)
        rotated(a, v, 0, 2)
        rotated(a, v, 1, 2)
    high = low = 0
    for d in range(1, 3):
        if a[d, d] > a[high, high]:
            high = d
        if a[d, d] <= a[low, low]:
            low = d
    return a[high, high], a[low, low], high, low


@device
def yield_bound(p, q, sine, strength):
    """Return a bound on F, from `invariants`; `strength` is r c cos φ."""
    return q + sine * (p + _ROOT_THIRD * q) - strength


@device
def flow(high, low, sine, strength, G):
    """Return Δγ of a step, 0 if the cell does not yield."""
    F = 0.5 * (high - low) + 0.5 * (high + low) * sine - strength
    # slip takes no more than the shear there is: cohesionless cells under tension do not flow
    return _SHARE * max(min(F, high - low), 0.0) / (2.0 * G)


@device
def cone_flow(p, q, slope, strength, stiffness):
    """Return Δγ of a step on Drucker–Prager's cone, from `invariants`; 0 if the cell does not yield.

    `stiffness` is G + 9 K α β, the decrease of F per Δγ in a constrained cell. Under tension facets crack on this
    surface, and cells do not flow.
    """
    if p > 0.0:
        return 0.0
    F = q + 3.0 * slope * p - strength
    return _SHARE * max(min(F, 2.0 * q), 0.0) / stiffness


@device
def below(s, limit):
    """Return True if all principal stresses are below a limit, that is, if limit - s is positive definite."""
    a, b, c = limit - s[0], limit - s[1], limit - s[2]
    if not (a > 0.0 and a * b - s[3] * s[3] > 0.0):
        return False
    return a * (b * c - s[5] * s[5]) - s[3] * (s[3] * c + s[5] * s[4]) - s[4] * (s[3] * s[5] + b * s[4]) > 0.0
