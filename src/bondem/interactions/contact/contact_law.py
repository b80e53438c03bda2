"""Contact of spheres with each other and with walls, by springs, dashpots and Coulomb friction.

    F_n = max(kn u + cn u', 0)        |F_t| <= μ F_n,  F_t = ks ξ + cs ξ' while it sticks

with u the overlap and ξ the stretch of the tangential spring, which turns with the pair and slides at Coulomb's
limit. The linear law takes its stiffness from an effective modulus, as a bond does: kn = E A / L with A = π min(Ri,
Rj)² and L = Ri + Rj (at a wall A = π R², L = R). The stiffness of `HertzMindlin` grows with the overlap. Contacts
only repel, unless the law has `Adhesion`. A pair whose bond is broken carries compression as the bond did, from its
rest length on and with its kn (docs/decisions/0020-contact-after-breakage.md). References: Cundall and Strack,
Géotechnique 29 (1979) 47–65; Luding, Granular Matter 10 (2008) 235–246, for the turning of the spring.
"""

import math
from abc import ABC, abstractmethod
from dataclasses import dataclass

import numpy as np

from bondem._checks import instance, number
from bondem._plausibility import physical
from bondem._types import Floats
from bondem.interactions.contact.adhesion import Adhesion, numbers_of

# Contacts a sphere can have with spheres of its size: the kissing number bounds the stiffness around it.
KISSING = 12
# Overlap over the smaller radius beyond which a linear law no longer describes touching bodies.
_DEEPEST = 0.5
# A Hertzian dashpot over a linear one of the same stiffness dF/du: both lose the same share of a collision.
HERTZIAN_DASHPOT = math.sqrt(5.0 / 6.0)


class ContactLaw(ABC):
    """Law of the forces between elements that touch, and between elements and walls."""

    @property
    @abstractmethod
    def friction(self) -> float:
        """Coulomb's coefficient μ [-]."""

    @property
    @abstractmethod
    def stress_free(self) -> bool:
        """True if overlaps of the reference configuration carry no force."""

    @property
    def parallel(self) -> bool:
        """True if the contact also acts in parallel with intact bonds."""
        return False

    @property
    def hertzian(self) -> bool:
        """True if the stiffness is that of Hertz and Mindlin."""
        return False

    @property
    def adhesion(self) -> Adhesion | None:
        """Attraction in addition to the repulsion of the contact; None for repulsion only."""
        return None

    @property
    @abstractmethod
    def parameters(self) -> Floats:
        """Parameters of the law that the compiled core reads as a `ContactRow`, (9,).

        They are the modulus [Pa], ks / kn, friction μ, damping β, μ_r and μ_w of rolling and twisting, the overlap
        over the radius at which the stiffness against rolling is taken, and strength [Pa] and reach [m] of adhesion.
        """

    @property
    def rolls(self) -> bool:
        """True if contacts resist rolling or twisting."""
        return bool(self.parameters[4:6].any())

    @abstractmethod
    def stiffest(self, radius: Floats, mass: Floats, platens: Floats) -> tuple[tuple[float, float], ...]:
        """Return bounds of the fastest motions of spheres in contact, for the time step.

        Args:
            radius: radii of the spheres [m], (n,).
            mass: masses of the spheres [kg], (n,).
            platens: masses of the walls that a force moves [kg], (s,).

        Returns:
            Angular frequency [rad/s] and ratio c / k of dashpot to spring [s], each for motion along the normal, and
            for rolling if the contact has friction or resists rolling.
        """

    @property
    @abstractmethod
    def deepest(self) -> float:
        """Overlap over the smaller radius up to which the law describes a contact [-]."""

    @abstractmethod
    def shortest(self, radius: Floats, mass: Floats, platens: Floats, *, walled: bool) -> float:
        """Return the shortest duration of an elastic collision of two free spheres, or of a sphere with a wall [s].

        Motion within the reach of adhesion counts as a collision.

        Args:
            radius: radii of the spheres [m], (n,).
            mass: masses of the spheres [kg], (n,).
            platens: masses of the walls that a force moves [kg], (s,).
            walled: True if there are walls.
        """


def rebound(beta: float) -> float:
    """Return the restitution e of a collision with the share β of the critical damping [-].

    The collision ends where the force vanishes. The formula is valid for a linear spring and dashpot. It is also
    valid for a Hertzian contact, because its overlap to the power 5/4 oscillates as a linear one (Antypov and
    Elliott, EPL 94, 2011). The force vanishes before the overlap (Schwager and Pöschel, Granular Matter 9, 2007).
    """
    if beta < 1.0:
        omega = math.sqrt(1.0 - beta * beta)
        # atan2 covers both branches of the formula, below and above β = 1/√2
        return math.exp(-beta / omega * (math.pi - math.atan2(2.0 * beta * omega, 1.0 - 2.0 * beta * beta)))
    if beta == 1.0:
        return math.exp(-2.0)
    omega = math.sqrt(beta * beta - 1.0)
    return math.exp(-2.0 * beta / omega * math.asinh(omega))


def fastest(
    kn: Floats, kappa: float, delay: float, mass: Floats, platens: Floats, *, rough: bool, rolls: bool
) -> tuple[tuple[float, float], ...]:
    """Return the result of `ContactLaw.stiffest` for spheres whose contacts have the stiffness kn.

    Every contact counts with a twelfth of both masses, because at most twelve spheres of equal size touch another.
    Two such masses against each other have ω² = 2 · 12 kn / m, and rolling on each other ω² = 7 · 12 ks / m. A spring
    against rolling adds R̄² ks / I < 2.5 · 12 ks / m. A platen may have to carry all spheres.

    Args:
        kn: normal stiffness [N/m], (n,).
        kappa: kn / ks [-].
        delay: largest c / kn [s].
        mass: masses of the spheres [kg], (n,).
        platens: masses of the walls that a force moves [kg], (s,).
        rough: True if the contact has friction.
        rolls: True if the contact resists rolling or twisting.
    """
    light = mass / (1.0 + len(mass) * mass / KISSING / platens.min()) if len(platens) else mass
    along = math.sqrt(float((2.0 * KISSING * kn / light).max())), delay
    if not (rough or rolls):
        return (along,)
    rolling = math.sqrt(float(((9.5 if rolls else 7.0) * KISSING * kn / kappa / light).max()))
    return along, (rolling, delay * math.sqrt(kappa))


def slowest_root(pair: Floats, wall: Floats, mass: Floats, platens: Floats, *, walled: bool) -> float:
    """Return the least √(m̄ / k) [s], with the reduced mass m̄, of pairs of equal spheres and of spheres at a wall.

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


def passage(
    adhesion: Adhesion | None, radius: Floats, mass: Floats, platens: Floats, *, walled: bool
) -> float:  # fmt: skip
    """Return the least duration π √(m̄ D / F_c) of motion within the reach D of adhesion [s]; inf without adhesion.

    F_c is the pull-off force and m̄ the reduced mass. Further arguments are those of `ContactLaw.shortest`.
    """
    if adhesion is None:
        return math.inf
    slope = adhesion.pull_off(radius) / adhesion.reach
    return math.pi * slowest_root(slope, slope, mass, platens, walled=walled)


def check_options(law: str, rolling: float, twisting: float, adhesion: Adhesion | None) -> None:
    """Raise InputError if a coefficient of rolling or twisting is negative, or `adhesion` is another object."""
    for name, value in (("rolling", rolling), ("twisting", twisting)):
        number(law, name, value, least=0.0, advice="a coefficient of zero or more")
    if adhesion is not None:
        instance(law, "adhesion", adhesion, Adhesion, "bd.Adhesion(strength=, reach=), or None")


@dataclass(frozen=True)
class LinearContact(ContactLaw):
    """Linear contact with Coulomb friction between elements without an intact bond, and at walls.

    With `parallel=True` bonded elements touch like any others. This is the unbonded component of PFC's linear
    parallel bond model (Potyondy and Cundall 2004). It acts in parallel with the bond from the start and continues
    when the bond is broken.

    Attributes:
        E: effective modulus [Pa] in kn = E A / L; a pair whose bond is broken has the kn of that bond.
        friction: Coulomb's coefficient μ [-]; 0 for no tangential force at all.
        kappa: kn / ks [-].
        damping: share β of the critical damping of a pair, in [0, 1) [-]: cn = 2 β √(kn m̄), cs = 2 β √(ks m̄), with
            its reduced mass m̄.
        stress_free: True if overlaps of the reference configuration carry no force, so that a packing is at rest.
            Gaps are then measured from min(0, reference gap). The gap of a pair whose bond is broken is measured from
            the rest length of the bond. False to measure all gaps from the spheres, with kn of this law.
        parallel: True if the contact also acts in parallel with intact bonds, with kn of this law before and after
            they break; gaps of bonded pairs are then those of any pair. For beams only.
        rolling: coefficient μ_r of resistance to rolling [-], 0 for none. A spring of stiffness ks R̄² without
            a dashpot acts against the rotation of one sphere on the other, up to the moment μ_r R̄ F_n. R̄ is
            Ri Rj / (Ri + Rj), at a wall R. This is type C of Ai et al., Powder Technology 206 (2011) 269–282.
        twisting: coefficient μ_w of resistance to rotation about the normal of the contact, like μ_r [-].
        adhesion: attraction up to a gap, in addition to repulsion; None for none. For beams and loose spheres.

    Raises:
        InputError: A value is outside its range.
    """

    E: float
    friction: float = 0.0
    kappa: float = 2.0
    damping: float = 0.0
    stress_free: bool = True
    parallel: bool = False
    rolling: float = 0.0
    twisting: float = 0.0
    adhesion: Adhesion | None = None

    def __post_init__(self) -> None:
        law = "LinearContact"
        physical(law, "E", self.E, quantity="contact")
        number(law, "friction", self.friction, least=0.0, advice="a coefficient of zero or more")
        number(law, "kappa", self.kappa, above=0.0, advice="a positive ratio kn / ks")
        number(law, "damping", self.damping, least=0.0, below=1.0, advice="a share of critical damping in [0, 1)")
        instance(law, "stress_free", self.stress_free, bool, "True or False")
        instance(law, "parallel", self.parallel, bool, "True or False")
        check_options(law, self.rolling, self.twisting, self.adhesion)

    @property
    def restitution(self) -> float:
        """Coefficient of normal restitution e of two spheres that collide without friction [-] (`rebound`)."""
        return rebound(self.damping)

    @property
    def parameters(self) -> Floats:
        own = [self.E, 1.0 / self.kappa, self.friction, self.damping, self.rolling, self.twisting, 0.0]
        return np.array([*own, *numbers_of(self.adhesion)])

    def stiffest(self, radius: Floats, mass: Floats, platens: Floats) -> tuple[tuple[float, float], ...]:
        kn = 0.5 * math.pi * self.E * radius
        delay = 2.0 * self.damping * float(np.sqrt(0.5 * mass / kn).max())
        return fastest(kn, self.kappa, delay, mass, platens, rough=self.friction > 0.0, rolls=self.rolls)

    @property
    def deepest(self) -> float:
        return _DEEPEST

    def shortest(self, radius: Floats, mass: Floats, platens: Floats, *, walled: bool) -> float:
        """Return the shortest duration π √(m̄ / k) of a collision, or that of `passage` [s]; see `ContactLaw`."""
        kn = 0.5 * math.pi * self.E * radius
        elastic = math.pi * slowest_root(kn, 2.0 * kn, mass, platens, walled=walled)
        return min(elastic, passage(self.adhesion, radius, mass, platens, walled=walled))
