"""Contact of elastic spheres after Hertz and Mindlin, with the damping of Tsuji and Coulomb friction."""

import math
import warnings
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from bondem._checks import instance, number
from bondem._names import users_line
from bondem._plausibility import physical
from bondem._types import Floats
from bondem.errors import ContactWarning
from bondem.interactions.contact.adhesion import Adhesion, numbers_of
from bondem.interactions.contact.contact_law import (
    HERTZIAN_DASHPOT,
    ContactLaw,
    check_options,
    fastest,
    passage,
    rebound,
    slowest_root,
)
from bondem.specimen.material import Material, of_material

# Least restitution: the dashpot of a lower one would make the time step useless.
_LEAST_REBOUND = 0.01
# Duration of an elastic collision over √(m̄ / k), k = dF/du at its deepest overlap.
_DURATION = 2.9432 * math.sqrt(15.0 / 8.0)
# Overlap over the smaller radius up to which strains are small: the contact then has a third of that radius.
_DEEPEST = 0.1


@of_material
@dataclass(frozen=True)
class HertzMindlin(ContactLaw):
    """Point contact of elastic spheres of one material, for elements without an intact bond and for walls.

        F_n = 4/3 E* √R* u^(3/2) + cn u',    ks = 8 G* √(R* u)    (stick; |F_t| <= μ F_n)

    with the overlap u, E* = E / 2(1 − ν²), G* = G / 2(2 − ν) and R* = Ri Rj / (Ri + Rj). A wall is rigid: E* and G*
    are doubled, and R* = R. The dashpots are cn = 2 √(5/6) β √(m̄ kn), with kn = 2 E* √(R* u) and the reduced mass m̄,
    and likewise with ks. They give the requested restitution at all speeds, with contacts that only repel. A
    tangential spring of stretch ξ stores ½ ks(u) ξ² and adds ½ ks'(u) ξ² to F_n, about μ² kn / 6 ks of F_n where it
    slides. A contact that does not slide is therefore elastic, and does not creep under oscillating loads
    (docs/decisions/0053-tangential-potential-and-rolling.md). Friction acts up to F_t / F_n = √(3 ks / 2 kn), 1.1 for
    ν = 0.3.

    A pair whose bond is broken acts as a linear spring with the kn of that bond and the same ks / kn. The reason is
    that crack faces meet over their whole area. With `stress_free=False` such a pair is like any other. References:
    Mindlin and Deresiewicz, J. Appl. Mech. 20 (1953); Tsuji, Tanaka and Ishida, Powder Technology 71 (1992) 239–250;
    Antypov and Elliott, EPL 94 (2011) 50004.

    `bd.HertzMindlin(glass)` takes E and ν from a `bd.Material`.

    Attributes:
        E: Young's modulus of the spheres [Pa].
        nu: Poisson's ratio of the spheres [-].
        friction: Coulomb's coefficient μ [-]; 0 for no tangential force at all.
        restitution: speed after over speed before a collision along the normal, in [0.01, 1] [-].
        overlap: deepest overlap over the radius for which the time step is computed [-]; stiffness grows as its root.
        stress_free: see `LinearContact`.
        rolling: see `LinearContact`; ks of its spring is that at the overlap `overlap`, a constant of each pair.
        twisting: see `LinearContact`.
        adhesion: see `LinearContact`.

    Raises:
        InputError: A value is outside its range.

    Warns:
        ContactWarning: `friction` is more than the tangential spring can transmit.
    """

    E: float
    nu: float
    friction: float = 0.0
    restitution: float = 1.0
    overlap: float = 0.01
    stress_free: bool = True
    rolling: float = 0.0
    twisting: float = 0.0
    adhesion: Adhesion | None = None

    if TYPE_CHECKING:

        def __init__(
            self, E: float | Material, nu: float | Material = ..., friction: float = 0.0, restitution: float = 1.0,
            overlap: float = 0.01, stress_free: bool = True, rolling: float = 0.0, twisting: float = 0.0,
            adhesion: Adhesion | None = None,
        ) -> None: ...  # fmt: skip

    def __post_init__(self) -> None:
        law = "HertzMindlin"
        physical(law, "E", self.E, quantity="contact")
        number(law, "nu", self.nu, above=-1.0, below=0.5, advice="a Poisson's ratio in (-1, 0.5)")
        number(law, "friction", self.friction, least=0.0, advice="a coefficient of zero or more")
        e, most = self.restitution, math.nextafter(1.0, 2.0)
        number(law, "restitution", e, least=_LEAST_REBOUND, below=most, advice="one in [0.01, 1]")
        number(law, "overlap", self.overlap, above=0.0, below=1.0, advice="a share of the radius in (0, 1)")
        instance(law, "stress_free", self.stress_free, bool, "True or False")
        check_options(law, self.rolling, self.twisting, self.adhesion)
        most = math.sqrt(1.5 / self.kappa)
        if self.friction > most:
            warnings.warn(
                f"friction = {self.friction:.4g} of HertzMindlin acts as {most:.3g}, the largest of its spring;"
                " give less, or use bd.LinearContact",
                ContactWarning, stacklevel=users_line(),
            )  # fmt: skip

    @property
    def modulus(self) -> float:
        """Effective modulus E* of two spheres [Pa]."""
        return self.E / (2.0 * (1.0 - self.nu**2))

    @property
    def kappa(self) -> float:
        """Ratio kn / ks of the stiffnesses dF/du at any overlap, (2 − ν) / 2(1 − ν) [-]."""
        return (2.0 - self.nu) / (2.0 * (1.0 - self.nu))

    @cached_property
    def damping(self) -> float:
        """Share β of the critical damping that gives the restitution [-]."""
        low, high = 0.0, 1.0
        while rebound(high) > self.restitution:
            high *= 2.0
        while True:
            middle = 0.5 * (low + high)
            if not low < middle < high:
                return low
            low, high = (middle, high) if rebound(middle) >= self.restitution else (low, middle)

    @property
    def hertzian(self) -> bool:
        return True

    @property
    def parameters(self) -> Floats:
        soft, mu, beta = 1.0 / self.kappa, self.friction, self.damping
        own = [self.modulus, soft, mu, beta, self.rolling, self.twisting, self.overlap]
        return np.array([*own, *numbers_of(self.adhesion)])

    def stiffest(self, radius: Floats, mass: Floats, platens: Floats) -> tuple[tuple[float, float], ...]:
        """Return bounds of the fastest motions of spheres at the deepest overlap; see `ContactLaw.stiffest`."""
        kn = 2.0 * self.modulus * radius * math.sqrt(0.5 * self.overlap)
        delay = 2.0 * HERTZIAN_DASHPOT * self.damping * float(np.sqrt(0.5 * mass / kn).max())
        return fastest(kn, self.kappa, delay, mass, platens, rough=self.friction > 0.0, rolls=self.rolls)

    @property
    def deepest(self) -> float:
        """Overlap over the smaller radius up to which the law is valid [-]: 0.1, or `overlap` if larger."""
        return max(_DEEPEST, self.overlap)

    def shortest(self, radius: Floats, mass: Floats, platens: Floats, *, walled: bool) -> float:
        """Return the shortest duration of an elastic collision at `overlap` [s]; arguments as in `ContactLaw`."""
        kn = 2.0 * self.modulus * radius * math.sqrt(0.5 * self.overlap)
        elastic = _DURATION * slowest_root(kn, 2.0 * math.sqrt(2.0) * kn, mass, platens, walled=walled)
        return min(elastic, passage(self.adhesion, radius, mass, platens, walled=walled))
