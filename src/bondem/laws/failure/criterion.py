"""What all criteria of failure share: what they know of a bond, and how they are judged.

A criterion is data too. For each bond it gives four coefficients, by which a `@device` function of its own makes an
index of what the bond bears; the bond breaks where the index reaches 1. That function is called for few bonds only:
those whose force and moments reach a bound, which the loop over all bonds looks at and which no criterion changes.
"""

from abc import ABC, abstractmethod
from dataclasses import dataclass
from typing import ClassVar, Literal

import numpy as np

from bondem._checks import instance
from bondem._types import Floats, Ints, PerBond, PerBond3
from bondem.errors import InputError
from bondem.laws.bond import BondStiffness, Section
from bondem.laws.failure.scatter import Normal, Weibull
from bondem.laws.failure.softening import Softening

#: What broke a bond: the larger part of the index. The number is what states and run files hold.
INTACT, TENSION, SHEAR, BENDING, TWISTING = range(5)
MODES = ("intact", "tension", "shear", "bending", "twisting")

# Columns of the coefficients of a bond.
COEFFICIENTS = 4


@dataclass(frozen=True, eq=False)
class Joint:
    """What a criterion may know of each bond or facet in the reference, shape (m,) each.

    Attributes:
        area: of the section or facet [m²].
        length: of the bond [m].
        volume: area times length [m³], by which strengths scatter.
        place: middle of the bond, or centroid of the facet [m], shape (m, 3).
        stiffness: of the bond; None of a facet, which has a traction and no section.
    """

    area: PerBond
    length: PerBond
    volume: PerBond
    place: PerBond3
    stiffness: BondStiffness | None

    def take(self, chosen: Ints) -> "Joint":
        """The same for a subset of the bonds."""
        stiffness = None if self.stiffness is None else self.stiffness.take(chosen)
        return Joint(self.area[chosen], self.length[chosen], self.volume[chosen], self.place[chosen], stiffness)

    @property
    def section(self) -> Section:
        """The section of bonds."""
        return Section(self.beam.radius)

    @property
    def beam(self) -> BondStiffness:
        """The stiffness of bonds."""
        assert self.stiffness is not None
        return self.stiffness


@dataclass(frozen=True, kw_only=True)
class Criterion(ABC):
    """When and how bonds or cells fail.

    Attributes:
        scatter: how strengths differ from bond to bond: `bd.Weibull` or `bd.Normal`, or None for the same in all.
        on: what a `bd.Rankine`, or a `bd.MohrCoulomb` with a fracture energy, judges facets of cells by: "stress",
            the principal stresses of their cells, as in a material; or "traction", that of the facet itself, as on an
            interface, a joint or a bedding plane. None: "traction" for an entry of `failure=` between two regions,
            "stress" for all others.
    """

    scatter: Weibull | Normal | None = None
    on: Literal["stress", "traction"] | None = None

    def __post_init__(self) -> None:
        if self.scatter is not None:
            wanted = "bd.Weibull(...), bd.Normal(...) or None"
            instance(type(self).__name__, "scatter", self.scatter, (Weibull, Normal), wanted)
        if self.on not in (None, "stress", "traction"):
            raise InputError(f"{type(self).__name__}: on = {self.on!r}; give 'stress', 'traction' or None")

    @property
    @abstractmethod
    def softening(self) -> Softening | None:
        """What cracks and cells that yield need of it; None of a criterion that breaks single bonds."""

    @property
    def principal(self) -> tuple[float, float, float] | None:
        """a, b, c [1/Pa] of max(a σ1, b σ1 - c σ3) ≥ 1, by which bonds of `bd.NonLocal` break; None of others."""
        return None

    def factors(self, volume: PerBond, place: PerBond3, period: Floats | None) -> PerBond:
        """Strengths over the parameter [-], user's order, (m,).

        Args:
            volume: of bonds or facets [m³], (m,).
            place: their middle [m], (m, 3).
            period: edges of a periodic cell [m], (3,), or None.
        """
        return np.ones_like(volume) if self.scatter is None else self.scatter.factors(volume, place, period)


@dataclass(frozen=True, kw_only=True)
class BondCriterion(Criterion):
    """When a single bond or facet breaks for good: at once, or beams with a fracture energy little by little.

    Attributes:
        kind: number of the function that judges (of the class; see `bondem.kernels.judging`).
        needs_beams: whether it is about beams, and means nothing for facets of cells (of the class).
    """

    kind: ClassVar[int]
    needs_beams: ClassVar[bool] = True

    @property
    def softening(self) -> Softening | None:
        return None

    @property
    def energies(self) -> tuple[float, float] | None:
        """G_f of opening and G_II of shear of beams that soften [J/m²], or None where they break at once."""
        return None

    @abstractmethod
    def coefficients(self, joint: Joint, factor: PerBond) -> Floats:
        """What judges each bond, shape (m, 4); strengths are multiplied by `factor`, (m,)."""

    @abstractmethod
    def bounds(self, joint: Joint, coefficients: Floats) -> tuple[PerBond, PerBond]:
        """a and b of each bond for which the index reaches 1 only where a |F| + b |M| does too [1/N, 1/(N·m)].

        F is the force of the bond and M the root of the sum of squares of its two torques on the elements' centres.
        """

    def pulled_and_sheared(self, joint: Joint, factor: PerBond, arm: PerBond) -> tuple[PerBond, PerBond]:
        """Tension, and shear without tension, at which a beam that softens begins to [N], (m,) each.

        Args:
            joint: bonds.
            factor: strengths over the parameter.
            arm: from the contact point to where the moment of shear counts [m], (m,).
        """
        raise NotImplementedError(f"{type(self).__name__} does not soften")


def columns(*values: PerBond | float) -> Floats:
    """Coefficients of all bonds, with zeros in columns that a criterion does not use, shape (m, 4)."""
    shape = np.broadcast(*values).shape
    table = np.zeros((*shape, COEFFICIENTS))
    for c, value in enumerate(values):
        table[:, c] = value
    return table
