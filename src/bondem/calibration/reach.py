"""Range of Poisson's ratios of a bond law, and the recommended law for a material."""

from dataclasses import dataclass
from typing import Any

from bondem._checks import count
from bondem.calibration.abacus import curve
from bondem.calibration.response import Response
from bondem.errors import UnreachableTargetError
from bondem.interactions.beams.bond_law import BondLaw
from bondem.interactions.law_catalogue import LAWS
from bondem.specimen.lattice import Lattice

# Least distance of ν from the ends of a curve: ν of single packings differs from it by about this [-].
_MARGIN = 0.01


@dataclass(frozen=True)
class Reach:
    """Poisson's ratio and stiffness ratio of a lattice as functions of the free parameter of its law.

    Attributes:
        law: family of bond laws.
        parameter: name of the varied parameter.
        values: values of the parameter, ascending [-].
        nu: Poisson's ratio at each value [-].
        stiffness_ratio: ratio E / E_μ at each value [-].
    """

    law: type[BondLaw]
    parameter: str
    values: tuple[float, ...]
    nu: tuple[float, ...]
    stiffness_ratio: tuple[float, ...]

    @property
    def smallest(self) -> float:
        """Smallest computed ν [-]."""
        return min(self.nu)

    @property
    def largest(self) -> float:
        """Largest computed ν [-]."""
        return max(self.nu)


@dataclass(frozen=True)
class Recommendation:
    """Recommended law for a material.

    Attributes:
        law: family of bond laws.
        reason: reason for the choice, as a sentence.
    """

    law: type[BondLaw]
    reason: str


def reach(
    lattice: Lattice, law: type[BondLaw], *, nu_mu: float = 0.3, points: int = 5, **fixed: Any
) -> Reach:
    """Compute ν and E / E_μ of a lattice over the range of the free parameter of a bond law.

    Args:
        lattice: the specimen, or a periodic cell.
        law: family of bond laws.
        nu_mu: Poisson's ratio of the bonds [-].
        points: number of values, two or more, in geometric progression.
        **fixed: further parameters of the law; radius_ratio is 1 by default if it is not the free parameter.

    Raises:
        InputError: `points` is not a whole number of at least 2, or the lattice has several bodies.
    """
    free, points = law.free, count("reach", "points", points, least=2)
    low, high = free.search
    values = tuple(low * (high / low) ** (k / (points - 1)) for k in range(points))
    found = [Response(lattice, law.at(value, E=1e9, nu=nu_mu, **fixed)) for value in values]
    return Reach(law, free.name, values, tuple(one.nu for one in found), tuple(one.E / 1e9 for one in found))


def recommend(nu: float) -> Recommendation:
    """Recommend a law for a Poisson's ratio: the first law of the catalogue whose curve covers ν by a margin of 0.01.

    The curves are those of `python -m validation abacus`, for packings of 6.2 contacts per sphere.

    Raises:
        UnreachableTargetError: no law covers ν.
    """
    reaches = []
    for law in LAWS.values():
        known = curve(law)
        if known is None:
            continue
        low, high = known.reach
        reaches.append(f"{law.__name__} {low:.2f} … {high:.2f}")
        if low + _MARGIN <= nu <= high - _MARGIN:
            passed = f"; not reached by {', '.join(reaches[:-1])}" if len(reaches) > 1 else ""
            return Recommendation(
                law, f"{law.__name__} bonds reach ν from {low:.2f} to {high:.2f} by {known.parameter}{passed}"
            )
    raise UnreachableTargetError(
        f"nu = {nu:g}: no bond law reaches it by more than {_MARGIN:g} ({', '.join(reaches)}); choose law= and"
        " search= yourself"
    )
