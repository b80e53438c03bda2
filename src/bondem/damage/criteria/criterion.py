"""Common part of all failure criteria: the data of a bond that they use, and their evaluation.

A criterion gives four coefficients per bond, from which a function of the core (`core/laws/criteria/`) computes an
index of the loads of the bond. The bond breaks where the index reaches 1. Only bonds whose force and moments reach a
bound are evaluated. One pass over all bonds checks this bound for every criterion.
"""

from abc import ABC, abstractmethod
from dataclasses import dataclass
from typing import ClassVar, Literal

import numpy as np

from bondem._checks import choice, instance
from bondem._tables.columns import FailureMode
from bondem._types import Floats, Ints, PerBond, PerBond3
from bondem.damage.cohesive_softening import Softening
from bondem.damage.scatter import Normal, Weibull
from bondem.interactions.beams.bond_law import BondStiffness, Section

#: Names of the modes of breakage: the mode is the largest part of the index. States and run files store its number.
MODES = tuple(mode.name.lower() for mode in FailureMode)

#: Stresses by which criteria evaluate facets.
On = Literal["stress", "traction"]

# Number of coefficients per bond.
COEFFICIENTS = 4


@dataclass(frozen=True, eq=False)
class Joint:
    """Geometry and stiffness of each bond or facet in the reference, the input of a criterion, shape (m,) each.

    Attributes:
        area: area of the section or facet [m²].
        length: length of the bond [m].
        volume: area times length [m³], by which strengths scatter.
        place: middle of the bond, or centroid of the facet [m], shape (m, 3).
        stiffness: stiffness of the bond; None for a facet, which has a traction and no section.
    """

    area: PerBond
    length: PerBond
    volume: PerBond
    place: PerBond3
    stiffness: BondStiffness | None

    def take(self, chosen: Ints) -> "Joint":
        """Return the data of a subset of the bonds."""
        stiffness = None if self.stiffness is None else self.stiffness.take(chosen)
        return Joint(self.area[chosen], self.length[chosen], self.volume[chosen], self.place[chosen], stiffness)

    @property
    def section(self) -> Section:
        """Sections of the bonds."""
        return Section(self.beam.radius)

    @property
    def beam(self) -> BondStiffness:
        """Stiffnesses of the bonds."""
        assert self.stiffness is not None
        return self.stiffness


@dataclass(frozen=True, kw_only=True)
class Criterion(ABC):
    """A criterion for the failure of bonds or cells.

    Attributes:
        scatter: scatter of strengths from bond to bond: `bd.Weibull` or `bd.Normal`, or None for none.
        on: stress by which a `bd.Rankine`, or a `bd.MohrCoulomb` with a fracture energy, evaluates facets of cells.
            "stress" is the principal stress of their cells, as in a material. "traction" is that of the facet itself,
            as on an interface, a joint or a bedding plane. None means "traction" for an entry of `failure=` between
            two regions, and "stress" for all others.
    """

    scatter: Weibull | Normal | None = None
    on: On | None = None

    def __post_init__(self) -> None:
        if self.scatter is not None:
            wanted = "bd.Weibull(...), bd.Normal(...) or None"
            instance(type(self).__name__, "scatter", self.scatter, (Weibull, Normal), wanted)
        if self.on is not None:
            choice(type(self).__name__, "on", self.on, On)

    @property
    @abstractmethod
    def softening(self) -> Softening | None:
        """Data for cracks and yielding cells; None for a criterion that breaks single bonds."""

    @property
    def _softenings(self) -> tuple[Softening, ...]:
        """Data for cracks and yielding cells, none or one."""
        return () if (softening := self.softening) is None else (softening,)

    @property
    def principal(self) -> tuple[float, float, float] | None:
        """Factors a, b and c [1/Pa] of the limit max(a σ1, b σ1 - c σ3) = 1 of bonds that mean stresses break.

        The value is None for a criterion that is not a function of principal stresses; such bonds do not accept it.
        """
        return None

    def factors(self, volume: PerBond, place: PerBond3, period: Floats | None, body: float) -> PerBond:
        """Return the strength of each bond over that of the criterion [-], user's order, (m,).

        Args:
            volume: volumes of bonds or facets [m³], (m,).
            place: middle of the bonds [m], (m, 3).
            period: edges of a periodic cell [m], (3,), or None.
            body: volume of the whole body [m³].
        """
        return np.ones_like(volume) if self.scatter is None else self.scatter.factors(volume, place, period, body)


@dataclass(frozen=True, kw_only=True)
class BondCriterion(Criterion):
    """A criterion for single bonds or facets, which break at once, or soften if beams have a fracture energy.

    Attributes:
        kind: name of the header of the criterion in `core/laws/criteria/`, and of its passes (class attribute).
        needs_beams: True if it applies to beams only, not to facets of cells (class attribute).
    """

    kind: ClassVar[str]
    needs_beams: ClassVar[bool] = True

    @property
    def softening(self) -> Softening | None:
        return None

    @property
    def energies(self) -> tuple[float, float] | None:
        """Fracture energies G_f of opening and G_II of shear of softening beams [J/m²]; None for brittle beams."""
        return None

    @abstractmethod
    def coefficients(self, joint: Joint, factor: PerBond) -> Floats:
        """Return the coefficients of the failure index of the bonds `joint`, (m, 4).

        Args:
            joint: geometry of the bonds.
            factor: strength of each bond over that of the criterion [-], (m,).
        """

    @abstractmethod
    def bounds(self, joint: Joint, coefficients: Floats) -> tuple[PerBond, PerBond]:
        """Return a [1/N] and b [1/(N·m)] of each bond, so that an index of 1 requires a |F| + b |M| ≥ 1.

        F is the force of the bond and M the root of the sum of squares of its two torques on the elements' centres.

        Args:
            joint: geometry of the bonds.
            coefficients: result of `coefficients`, (m, 4).
        """

    def pulled(self, joint: Joint, coefficients: Floats) -> PerBond:
        """Return the tensile force that alone makes each bond fail [N], (m,): the inverse of its first coefficient.

        A criterion whose first coefficient has another meaning overrides this.

        Args:
            joint: geometry of the bonds.
            coefficients: result of `coefficients`, (m, 4).
        """
        return 1.0 / coefficients[:, 0]

    def pulled_and_sheared(self, joint: Joint, factor: PerBond, arm: PerBond) -> tuple[PerBond, PerBond]:
        """Return the tensile force and the shear force that alone make each beam soften [N], (m,) each.

        Args:
            joint: geometry of the beams.
            factor: strength of each beam over that of the criterion [-], (m,).
            arm: arm from the contact point to the section whose moment may break the bond [m], (m,).
        """
        raise NotImplementedError(f"{type(self).__name__} does not soften")


def columns(*values: PerBond | float) -> Floats:
    """Return coefficients of all bonds, with zeros in columns that a criterion does not use, shape (m, 4)."""
    shape = np.broadcast(*values).shape
    table = np.zeros((*shape, COEFFICIENTS))
    for c, value in enumerate(values):
        table[:, c] = value
    return table
