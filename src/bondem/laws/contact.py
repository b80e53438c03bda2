"""Contact of spheres with each other and with walls: linear spring and dashpot, Coulomb friction.

    F_n = max(kn u + cn u', 0)        |F_t| <= μ F_n,  F_t = ks ξ + cs ξ' while it sticks

with u the overlap and ξ the stretch of the tangential spring, which turns with the pair and slides where
Coulomb's limit holds it. Stiffness follows from an effective modulus, kn = E A / L with A = π min(Ri, Rj)² and
L = Ri + Rj (at a wall A = π R², L = R), as that of a bond does. Repulsion only. References: Cundall and Strack,
Géotechnique 29 (1979) 47–65; Luding, Granular Matter 10 (2008) 235–246, for the turning of the spring.
"""

import math
from dataclasses import dataclass

import numpy as np

from bondem._checks import instance, number
from bondem._compile import device
from bondem._types import Floats

# Contacts a sphere can have with spheres of its size: the kissing number bounds the stiffness around it.
_KISSING = 12


@dataclass(frozen=True)
class LinearContact:
    """Linear contact with Coulomb friction between elements that no intact bond joins, and at walls.

    Attributes:
        E: effective modulus [Pa] of kn = E A / L.
        friction: Coulomb's coefficient μ [-]; 0 has no tangential force at all.
        kappa: kn / ks [-].
        damping: share β of the critical damping of a pair, in [0, 1) [-]: cn = 2 β √(kn m̄), cs = 2 β √(ks m̄).
        stress_free: whether overlaps of the reference configuration bear no force, so that a packing is at rest;
            the gap of a pair is then measured from min(0, reference gap).
    """

    E: float
    friction: float = 0.0
    kappa: float = 2.0
    damping: float = 0.0
    stress_free: bool = True

    def __post_init__(self) -> None:
        law = "LinearContact"
        number(law, "E", self.E, unit="Pa", above=0.0, advice="a positive effective modulus in Pa")
        number(law, "friction", self.friction, least=0.0, advice="a coefficient of zero or more")
        number(law, "kappa", self.kappa, above=0.0, advice="a positive ratio kn / ks")
        number(law, "damping", self.damping, least=0.0, below=1.0, advice="a share of critical damping in [0, 1)")
        instance(law, "stress_free", self.stress_free, bool, "True or False")

    @property
    def restitution(self) -> float:
        """Coefficient of normal restitution e of two spheres that collide without friction [-].

        The contact ends where its force vanishes, before the overlap does (Schwager and Pöschel, Granular
        Matter 9, 2007).
        """
        beta = self.damping
        omega = math.sqrt(1.0 - beta * beta)
        # atan2 takes both of their branches, below and above β = 1/√2
        return math.exp(-beta / omega * (math.pi - math.atan2(2.0 * beta * omega, 1.0 - 2.0 * beta * beta)))

    @property
    def parameters(self) -> Floats:
        """E [Pa], ks / kn, μ and β, as the kernels take them, (4,)."""
        return np.array([self.E, 1.0 / self.kappa, self.friction, self.damping])

    def stiffest(self, radius: Floats, mass: Floats, platens: Floats) -> tuple[tuple[float, float], ...]:
        """Bounds of the fastest motions of spheres in contact, for the time step.

        Every contact takes a twelfth of the masses it joins (at most twelve spheres of its size touch another): two
        such masses against each other, ω² = 2 · 12 kn / m, or rolling on each other, ω² = 7 · 12 ks / m. A
        platen may have all spheres to bear.

        Args:
            radius: of the spheres [m], (n,).
            mass: of the spheres [kg], (n,).
            platens: masses of the walls that a force moves [kg], (s,).

        Returns:
            For motion along the normal, and for rolling where there is friction: the angular frequency [rad/s]
            and the ratio c / k of dashpot to spring [s].
        """
        kn = 0.5 * math.pi * self.E * radius
        light = mass / (1.0 + len(mass) * mass / _KISSING / platens.min()) if len(platens) else mass
        delay = 2.0 * self.damping * float(np.sqrt(0.5 * mass / kn).max())
        along = math.sqrt(float((2.0 * _KISSING * kn / light).max())), delay
        if self.friction == 0.0:
            return (along,)
        rolling = math.sqrt(float((7.0 * _KISSING * kn / self.kappa / light).max()))
        return along, (rolling, delay * math.sqrt(self.kappa))


@device
def pair_stiffness(modulus, ra, rb):
    """kn [N/m] of two spheres."""
    small = min(ra, rb)
    return modulus * math.pi * small * small / (ra + rb)


@device
def contact_force(kn, ks, cn, cs, friction, overlap, nx, ny, nz, vx, vy, vz, twist, sx, sy, sz, px, py, pz, dt):
    """Force on the second body of a contact, and how its memory goes on.

    Args:
        kn, ks: stiffnesses [N/m].
        cn, cs: dashpots [N·s/m].
        friction: μ [-].
        overlap: [m]; 0 where the bodies have just parted.
        nx, ny, nz: unit normal from the first body to the second.
        vx, vy, vz: velocity of the second against the first at the contact [m/s].
        twist: rate at which the pair turns about the normal [rad/s].
        sx, sy, sz: stretch of the tangential spring [m] a step ago.
        px, py, pz: force of the dashpots [N] a step ago.
        dt: the step [s].

    Returns:
        Force [N] (3), stretch (3), force of the dashpots (3), energy lost to dashpots and to friction over the step
        [J]: the trapezoid of force over displacement, second order as the step is.
    """
    opening = vx * nx + vy * ny + vz * nz
    elastic = kn * overlap
    normal = max(elastic - cn * opening, 0.0) if overlap > 0.0 else 0.0
    resist = normal - elastic
    hx, hy, hz = resist * nx, resist * ny, resist * nz
    fx, fy, fz = normal * nx, normal * ny, normal * nz
    rubbed = 0.0
    if friction > 0.0:
        tx, ty, tz = vx - opening * nx, vy - opening * ny, vz - opening * nz
        # the spring turns with the pair: about the normal, then into the new tangential plane at its old length
        before = sx * sx + sy * sy + sz * sz
        ox, oy, oz = (
            sx + dt * twist * (ny * sz - nz * sy),
            sy + dt * twist * (nz * sx - nx * sz),
            sz + dt * twist * (nx * sy - ny * sx),
        )
        out = ox * nx + oy * ny + oz * nz
        ox, oy, oz = ox - out * nx, oy - out * ny, oz - out * nz
        after = ox * ox + oy * oy + oz * oz
        keep = math.sqrt(before / after) if after > 0.0 else 0.0
        ox, oy, oz = keep * ox, keep * oy, keep * oz
        ux, uy, uz = ox + dt * tx, oy + dt * ty, oz + dt * tz
        limit = friction * normal
        pull = ks * math.sqrt(ux * ux + uy * uy + uz * uz)
        held = limit / pull if pull > limit else 1.0
        sx, sy, sz = held * ux, held * uy, held * uz
        rubbed = 0.5 * ks * ((ox + sx) * (ux - sx) + (oy + sy) * (uy - sy) + (oz + sz) * (uz - sz))
        gx, gy, gz = ks * sx + cs * tx, ks * sy + cs * ty, ks * sz + cs * tz
        if gx * gx + gy * gy + gz * gz > limit * limit:  # the dashpot never makes it slide
            gx, gy, gz = ks * sx, ks * sy, ks * sz
        hx, hy, hz = hx - (gx - ks * sx), hy - (gy - ks * sy), hz - (gz - ks * sz)
        fx, fy, fz = fx - gx, fy - gy, fz - gz
    damped = -0.5 * dt * ((px + hx) * vx + (py + hy) * vy + (pz + hz) * vz)
    return fx, fy, fz, sx, sy, sz, hx, hy, hz, damped, rubbed
