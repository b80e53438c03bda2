"""A ball as a specimen: what crushing and impact have in common, before the run and after it."""

import math
from dataclasses import dataclass

import numpy as np

from bondem._types import Floats
from bondem.errors import InputError
from bondem.fracture.fragments import Fragments, fragments
from bondem.laws.contact import ContactLaw, LinearContact
from bondem.model.model import Model
from bondem.model.state import State
from bondem.specimen.lattice import Lattice

# How far the extents of a ball may differ, and its volume from that of a sphere [-].
_ROUND, _FULL = 1e-6, 0.01
# Friction between pieces, where no law of contact is given [-].
_FRICTION = 0.4


@dataclass(frozen=True, eq=False)
class FragmentSizes:
    """How the mass of a broken ball is distributed over the sizes of its pieces.

    The diameter of a piece is that of the sphere of its mass, as a share of the ball's: D (m / M)^(1/3). Elements
    that were loose from the start (rattlers) do not count.

    Attributes:
        diameter: of the pieces, ascending [m], shape (f,).
        passing: share of the mass in pieces of at most this diameter [-], shape (f,).
    """

    diameter: Floats
    passing: Floats

    @classmethod
    def of(cls, pieces: Fragments, lattice: Lattice, diameter: float) -> "FragmentSizes":
        """Sizes of the pieces of a ball of a diameter [m]."""
        whole = np.bincount(pieces.label[lattice.connected], minlength=len(pieces)) > 0
        mass = pieces.mass[whole][::-1]
        return cls(diameter * np.cbrt(mass / mass.sum()), np.cumsum(mass) / mass.sum())

    def below(self, diameter: float) -> float:
        """Share of the mass in pieces smaller than a diameter [m]."""
        found = int(np.searchsorted(self.diameter, diameter))
        return float(self.passing[found - 1]) if found else 0.0


@dataclass(frozen=True, eq=False)
class BrokenBall:
    """What is left of a ball.

    Attributes:
        pieces: the heaviest first.
        sizes: of the pieces.
        damage: broken bonds or facets over all [-].
        fines: share of the mass in pieces smaller than the size that was asked for [-].
    """

    pieces: Fragments
    sizes: FragmentSizes
    damage: float
    fines: float

    @property
    def largest(self) -> float:
        """Share of the mass in the heaviest piece [-]."""
        return float(self.pieces.mass[0] / self.pieces.mass.sum())


@dataclass(frozen=True, eq=False)
class BallSpecimen:
    """A ball of cells or bonded spheres, and the places where its elements touch walls.

    Attributes:
        lattice: the elements.
        middle: of the ball [m], (3,).
        diameter: [m].
        radius: of the elements in contact [m], (n,).
        stiffness: k_n of the median bond or facet [N/m].
        mass: [kg].
    """

    lattice: Lattice
    middle: Floats
    diameter: float
    radius: Floats
    stiffness: float
    mass: float

    @classmethod
    def of(cls, test: str, model: Model) -> "BallSpecimen":
        """The ball of a model.

        Raises:
            InputError: another shape.
        """
        shape = model.lattice.particles.envelope
        lower, upper = shape.bounds
        extent = upper - lower
        diameter = float(extent.mean())
        full = 6.0 * shape.volume / (math.pi * diameter**3)
        if float(np.ptp(extent)) > _ROUND * diameter or abs(full - 1.0) > _FULL:
            raise InputError(f"labtests.{test}: a {type(shape).__name__} is no ball; pack bd.Ball(radius)")
        return cls(
            model.lattice, 0.5 * (lower + upper), diameter, model.contact_radius,
            float(np.median(model.stiffness.kn)), float(model.mass.sum()),
        )  # fmt: skip

    def reach(self, direction: Floats) -> float:
        """How far elements reach along a direction, from the origin [m]."""
        return float((self.lattice.centre @ direction + self.radius).max())

    def contact(self, given: ContactLaw | None) -> ContactLaw:
        """The law that was given, or one by which a wall is as stiff as the median bond, with friction of 0.4."""
        if given is not None:
            return given
        return LinearContact(E=self.stiffness / (math.pi * float(np.median(self.radius))), friction=_FRICTION)

    def broken(self, state: State, fine: float) -> BrokenBall:
        """What is left of it in a state; `fine` is a share of the diameter."""
        pieces = fragments(self.lattice, state)
        sizes = FragmentSizes.of(pieces, self.lattice, self.diameter)
        damage = float(np.mean(state.bond_integrity <= 0.0))
        return BrokenBall(pieces, sizes, damage, sizes.below(fine * self.diameter))
