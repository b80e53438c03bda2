"""Contact of spheres with each other and with walls: springs and dashpots, Coulomb friction.

    F_n = max(kn u + cn u', 0)        |F_t| <= μ F_n,  F_t = ks ξ + cs ξ' while it sticks

with u the overlap and ξ the stretch of the tangential spring, which turns with the pair and slides where Coulomb's
limit holds it. Stiffness of the linear law follows from an effective modulus, kn = E A / L with A = π min(Ri, Rj)²
and L = Ri + Rj (at a wall A = π R², L = R), as that of a bond does; that of `HertzMindlin` grows with the overlap.
Repulsion only. A pair whose bond is broken carries compression as the bond did: from its rest length on, with its kn
(docs/decisions/0020-contact-after-breakage.md). References: Cundall and Strack, Géotechnique 29 (1979) 47–65; Luding,
Granular Matter 10 (2008) 235–246, for the turning of the spring.
"""

import math
from abc import ABC, abstractmethod
from dataclasses import dataclass

import numpy as np

from bondem._calls import picked
from bondem._checks import instance, number
from bondem._compile import device
from bondem._types import Floats

# Contacts a sphere can have with spheres of its size: the kissing number bounds the stiffness around it.
KISSING = 12
# Places in the parameters of a law.
MODULUS, SOFT, FRICTION, DASHPOT, HERTZIAN = range(5)
# Overlap over the smaller radius from which spheres of a linear law are no bodies that touch any more.
_DEEPEST = 0.5
# A Hertzian dashpot over a linear one of the same stiffness dF/du: both lose the same share of a collision.
HERTZIAN_DASHPOT = math.sqrt(5.0 / 6.0)


class ContactLaw(ABC):
    """Forces between elements, and between elements and walls, where they touch."""

    friction: float
    stress_free: bool
    parallel: bool = False

    @property
    @abstractmethod
    def parameters(self) -> Floats:
        """Modulus [Pa], ks / kn, μ, β, and 1 for a Hertzian law or 0, in the kernels' form, (5,)."""

    @abstractmethod
    def stiffest(self, radius: Floats, mass: Floats, platens: Floats) -> tuple[tuple[float, float], ...]:
        """Return bounds of the fastest motions of spheres in contact, for the time step.

        Args:
            radius: radii of the spheres [m], (n,).
            mass: masses of the spheres [kg], (n,).
            platens: masses of the walls that a force moves [kg], (s,).

        Returns:
            For motion along the normal, and for rolling if there is friction: the angular frequency [rad/s]
            and the ratio c / k of dashpot to spring [s].
        """

    @property
    @abstractmethod
    def deepest(self) -> float:
        """Overlap over the smaller radius up to which the law describes a contact [-]."""

    @abstractmethod
    def shortest(self, radius: Floats, mass: Floats, platens: Floats, *, walled: bool) -> float:
        """Return the duration of the shortest elastic collision of two free spheres, or of one with a wall [s].

        Args:
            radius: radii of the spheres [m], (n,).
            mass: masses of the spheres [kg], (n,).
            platens: masses of the walls that a force moves [kg], (s,).
            walled: True if there are walls.
        """


def rebound(beta: float) -> float:
    """Return the restitution e of a collision with the share β of the critical damping [-].

    The collision ends where the force vanishes. The formula holds for a linear spring and dashpot. It also holds for
    a Hertzian one, whose overlap to the power 5/4 oscillates as a linear one does (Antypov and Elliott, EPL 94,
    2011). The force vanishes before the overlap does (Schwager and Pöschel, Granular Matter 9, 2007).
    """
    if beta < 1.0:
        omega = math.sqrt(1.0 - beta * beta)
        # atan2 takes both of their branches, below and above β = 1/√2
        return math.exp(-beta / omega * (math.pi - math.atan2(2.0 * beta * omega, 1.0 - 2.0 * beta * beta)))
    if beta == 1.0:
        return math.exp(-2.0)
    omega = math.sqrt(beta * beta - 1.0)
    return math.exp(-2.0 * beta / omega * math.asinh(omega))


def fastest(
    kn: Floats, kappa: float, delay: float, mass: Floats, platens: Floats, *, rough: bool
) -> tuple[tuple[float, float], ...]:
    """Return the result of `ContactLaw.stiffest` for spheres whose contacts have the stiffness kn.

    Every contact has a twelfth of the masses that it joins, because at most twelve spheres of equal size touch
    another. Two such masses against each other have ω² = 2 · 12 kn / m, and rolling on each other ω² = 7 · 12 ks / m.
    A platen may have to carry all spheres.

    Args:
        kn: normal stiffness [N/m], (n,).
        kappa: kn / ks [-].
        delay: largest c / kn [s].
        mass: masses of the spheres [kg], (n,).
        platens: masses of the walls that a force moves [kg], (s,).
        rough: True if there is friction.
    """
    light = mass / (1.0 + len(mass) * mass / KISSING / platens.min()) if len(platens) else mass
    along = math.sqrt(float((2.0 * KISSING * kn / light).max())), delay
    if not rough:
        return (along,)
    rolling = math.sqrt(float((7.0 * KISSING * kn / kappa / light).max()))
    return along, (rolling, delay * math.sqrt(kappa))


def slowest_root(pair: Floats, wall: Floats, mass: Floats, platens: Floats, *, walled: bool) -> float:
    """Return the least √(m̄ / k) of two equal spheres, and of a sphere at a wall [s].

    Args:
        pair: stiffness of two spheres of each size [N/m], (n,).
        wall: stiffness of a sphere of each size and a wall [N/m], (n,).
        mass: masses of the spheres [kg], (n,).
        platens: masses of the walls that a force moves [kg], (s,).
        walled: True if there are walls.
    """
    least = float((0.5 * mass / pair).min())
    if walled:
        meets = mass if not len(platens) else mass * platens.min() / (mass + platens.min())
        least = min(least, float((meets / wall).min()))
    return math.sqrt(least)


@dataclass(frozen=True)
class LinearContact(ContactLaw):
    """Linear contact with Coulomb friction between elements without an intact bond, and at walls.

    With `parallel=True` bonded elements touch like any others. This is the unbonded component of PFC's linear
    parallel bond model (Potyondy and Cundall 2004). It acts beside the bond from the start and continues when the
    bond is broken.

    Attributes:
        E: effective modulus [Pa] in kn = E A / L; a pair whose bond is broken has the kn of that bond.
        friction: Coulomb's coefficient μ [-]; 0 for no tangential force at all.
        kappa: kn / ks [-].
        damping: share β of the critical damping of a pair, in [0, 1) [-]: cn = 2 β √(kn m̄), cs = 2 β √(ks m̄).
        stress_free: True if overlaps of the reference configuration carry no force, so that a packing is at rest.
            Gaps are then measured from min(0, reference gap). The gap of a pair whose bond is broken is measured from
            the rest length of the bond. False to measure all gaps from the spheres, with kn of this law.
        parallel: True if the contact also acts beside intact bonds, with kn of this law before and after they break;
            gaps of bonded pairs are then those of any pair. For beams only.
    """

    E: float
    friction: float = 0.0
    kappa: float = 2.0
    damping: float = 0.0
    stress_free: bool = True
    parallel: bool = False

    def __post_init__(self) -> None:
        law = "LinearContact"
        number(law, "E", self.E, unit="Pa", above=0.0, advice="a positive effective modulus in Pa")
        number(law, "friction", self.friction, least=0.0, advice="a coefficient of zero or more")
        number(law, "kappa", self.kappa, above=0.0, advice="a positive ratio kn / ks")
        number(law, "damping", self.damping, least=0.0, below=1.0, advice="a share of critical damping in [0, 1)")
        instance(law, "stress_free", self.stress_free, bool, "True or False")
        instance(law, "parallel", self.parallel, bool, "True or False")

    @property
    def restitution(self) -> float:
        """Coefficient of normal restitution e of two spheres that collide without friction [-] (`rebound`)."""
        return rebound(self.damping)

    @property
    def parameters(self) -> Floats:
        """E [Pa], ks / kn, μ, β and 0, in the kernels' form, (5,)."""
        return np.array([self.E, 1.0 / self.kappa, self.friction, self.damping, 0.0])

    def stiffest(self, radius: Floats, mass: Floats, platens: Floats) -> tuple[tuple[float, float], ...]:
        """Return bounds of the fastest motions of spheres in contact; see `ContactLaw.stiffest`."""
        kn = 0.5 * math.pi * self.E * radius
        delay = 2.0 * self.damping * float(np.sqrt(0.5 * mass / kn).max())
        return fastest(kn, self.kappa, delay, mass, platens, rough=self.friction > 0.0)

    @property
    def deepest(self) -> float:
        """Overlap over the smaller radius up to which the law describes a contact [-]."""
        return _DEEPEST

    def shortest(self, radius: Floats, mass: Floats, platens: Floats, *, walled: bool) -> float:
        """Return the duration of the shortest elastic collision [s]; see `ContactLaw.shortest`.

        It is π √(m / k) at every speed.
        """
        kn = 0.5 * math.pi * self.E * radius
        return math.pi * slowest_root(kn, 2.0 * kn, mass, platens, walled=walled)


@device
def pair_spring(law, own, ra, rb, overlap):
    """Return the normal stiffness dF/du of two spheres [N/m], F over it and u [-], and the share of their dashpot.

    `own` is the stiffness of a pair that has its own, else 0. The function takes one pair or many, like
    `contact_force`.
    """
    if law[HERTZIAN] == 0.0:
        small = picked(rb - ra, ra, rb)
        k = law[MODULUS] * math.pi * small * small / (ra + rb)
        return picked(own, own, k), picked(own, 1.0, 1.0), picked(own, law[DASHPOT], law[DASHPOT])
    k = 2.0 * law[MODULUS] * math.sqrt(ra * rb / (ra + rb) * overlap)
    hertzian = HERTZIAN_DASHPOT * law[DASHPOT]
    return picked(own, own, k), picked(own, 1.0, 2.0 / 3.0), picked(own, law[DASHPOT], hertzian)


@device
def wall_spring(law, r, overlap):
    """Return the spring of a sphere at a rigid wall, in the form of `pair_spring`."""
    if law[HERTZIAN] == 0.0:
        return law[MODULUS] * math.pi * r, 1.0, law[DASHPOT]
    return 4.0 * law[MODULUS] * math.sqrt(r * overlap), 2.0 / 3.0, HERTZIAN_DASHPOT * law[DASHPOT]


@device
def spring_energy(kn, share, ks, overlap, slip):
    """Return the elastic energy of a contact [J], given the square of its stretch [m²]."""
    return 0.5 * (kn * overlap * overlap * share * (1.0 if share == 1.0 else 0.8) + ks * slip)


@device
def _dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


@device
def _tangential(v, n):
    along = _dot(v, n)
    return v[0] - along * n[0], v[1] - along * n[1], v[2] - along * n[2]


@device
def _turned(s, n, angle):
    """Return a tangential vector one step later, rotated with the pair.

    It is rotated about the normal, and then into the new plane at its old length.
    """
    x = s[0] + angle * (n[1] * s[2] - n[2] * s[1])
    y = s[1] + angle * (n[2] * s[0] - n[0] * s[2])
    z = s[2] + angle * (n[0] * s[1] - n[1] * s[0])
    o = _tangential((x, y, z), n)
    after = _dot(o, o)
    keep = picked(after, math.sqrt(_dot(s, s) / after), 0.0)
    return keep * o[0], keep * o[1], keep * o[2]


@device
def contact_force(spring, friction, overlap, now, last, twist, s, p, dt):
    """Return the force on the second body of a contact, and its memory; for one contact, or for many in lanes.

    A tangential spring that is stiffer than a step ago keeps its force, and one that is softer keeps its stretch. Its
    stored energy therefore never grows by the change (Thornton, Cummins and Cleary, Powder Technology 233, 2013).
    Work on the spring that it does not store counts as friction.

    Args:
        spring: stiffness dF/du [N/m]; force over it and overlap [-]; ks, and ks a step ago [N/m]; dashpots cn, cs
            [N·s/m].
        friction: μ [-].
        overlap: overlap [m]; 0 if the bodies have just separated.
        now: unit normal from the first body to the second (3), velocity of the second against the first at the
            contact over the step (3) [m/s].
        last: these quantities one step earlier.
        twist: rate at which the pair rotates about the normal [rad/s].
        s: stretch of the tangential spring [m] a step ago, (3).
        p: force of the dashpots [N] a step ago, (3).
        dt: time step [s].

    Returns:
        Force [N] (3), stretch (3), force of the dashpots (3), energy lost to dashpots and to friction over the step
        [J]: the trapezoid of force over displacement, second order as the step is.
    """
    kn, share, ks, before, cn, cs = spring
    (nx, ny, nz), v = now
    opening = _dot(v, now[0])
    elastic = share * kn * overlap
    pressed = elastic - cn * opening
    normal = picked(overlap, picked(pressed, pressed, 0.0), 0.0)
    resist = normal - elastic
    hx, hy, hz = resist * nx, resist * ny, resist * nz
    fx, fy, fz = normal * nx, normal * ny, normal * nz
    rubbed = 0.0 * overlap
    sx, sy, sz = s
    if friction > 0.0:
        t = _tangential(v, now[0])
        came = _turned(_tangential(last[1], last[0]), now[0], dt * twist)
        ox, oy, oz = _turned(s, now[0], dt * twist)
        less = picked(ks - before, before / ks, 1.0)
        ox, oy, oz = less * ox, less * oy, less * oz
        half = 0.5 * dt
        ux, uy, uz = ox + half * (came[0] + t[0]), oy + half * (came[1] + t[1]), oz + half * (came[2] + t[2])
        limit = friction * normal
        pull = ks * math.sqrt(ux * ux + uy * uy + uz * uz)
        held = picked(pull - limit, limit / pull, picked(overlap, 1.0, 0.0))
        sx, sy, sz = held * ux, held * uy, held * uz
        given = half * (before * _dot(s, last[1]) + ks * _dot((sx, sy, sz), v))
        rubbed = given - 0.5 * (ks * _dot((sx, sy, sz), (sx, sy, sz)) - before * _dot(s, s))
        gx, gy, gz = ks * sx + cs * t[0], ks * sy + cs * t[1], ks * sz + cs * t[2]
        slides = gx * gx + gy * gy + gz * gz - limit * limit  # the dashpot never makes it slide
        gx, gy, gz = picked(slides, ks * sx, gx), picked(slides, ks * sy, gy), picked(slides, ks * sz, gz)
        hx, hy, hz = hx - (gx - ks * sx), hy - (gy - ks * sy), hz - (gz - ks * sz)
        fx, fy, fz = fx - gx, fy - gy, fz - gz
    damped = -0.5 * dt * (_dot(p, last[1]) + _dot((hx, hy, hz), v))
    return (fx, fy, fz), (sx, sy, sz), (hx, hy, hz), damped, rubbed
