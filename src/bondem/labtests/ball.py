"""Ball specimens: common parts of the crushing and impact tests."""

import math
from dataclasses import dataclass

import numpy as np

from bondem._drawing import Plotted
from bondem._types import Floats
from bondem.errors import InputError
from bondem.fracture.fragments import Fragments, fragments
from bondem.interactions.contact.contact_law import ContactLaw
from bondem.labtests.fragment_contact import fragment_contact
from bondem.model.model import Model
from bondem.model.state import State
from bondem.specimen.lattice import Lattice

# Largest relative differences between the extents of a ball, and between its volume and that of a sphere [-].
_ROUND, _FULL = 1e-6, 0.01


@dataclass(frozen=True, eq=False)
class FragmentSizes(Plotted):
    """Size distribution of the fragments of a broken ball, by mass.

    The diameter of a fragment of mass m is D (m / M)^(1/3), with the diameter D of the ball and the sum M of the
    masses. Fragments that consist of rattlers only are left out of the distribution and of M, because rattlers were
    loose from the start.

    Attributes:
        diameter: diameters of the fragments, ascending [m], shape (f,).
        passing: mass share of fragments of at most this diameter [-], shape (f,).
    """

    diameter: Floats
    passing: Floats

    @property
    def table(self) -> dict[str, Floats]:
        """Diameters and mass shares of fragments of at most these diameters, by name and unit, (f,) each."""
        return {"diameter [m]": self.diameter, "mass share of smaller fragments [-]": self.passing}

    @classmethod
    def of(cls, pieces: Fragments, lattice: Lattice, diameter: float) -> "FragmentSizes":
        """Compute the size distribution of the fragments of a ball with an initial diameter [m]."""
        whole = np.bincount(pieces.label[lattice.connected], minlength=len(pieces)) > 0
        mass = pieces.mass[whole][::-1]
        return cls(diameter * np.cbrt(mass / mass.sum()), np.cumsum(mass) / mass.sum())

    def below(self, diameter: float) -> float:
        """Return the mass share [-] of the fragments smaller than a diameter [m]."""
        found = int(np.searchsorted(self.diameter, diameter))
        return float(self.passing[found - 1]) if found else 0.0


@dataclass(frozen=True, eq=False)
class BrokenBall(Plotted):
    """Fragments of a broken ball.

    Attributes:
        pieces: fragments, the heaviest first.
        sizes: size distribution of the fragments.
        damage: share of broken bonds or facets [-].
        fines: mass share of the fragments smaller than a limit, the share `fine` of the ball's diameter [-].
    """

    pieces: Fragments
    sizes: FragmentSizes
    damage: float
    fines: float

    @property
    def table(self) -> dict[str, Floats]:
        """Size distribution of the fragments; see `FragmentSizes`."""
        return self.sizes.table

    @property
    def largest(self) -> float:
        """Mass share of the heaviest fragment [-]."""
        return float(self.pieces.mass[0] / self.pieces.mass.sum())


@dataclass(frozen=True, eq=False)
class BallSpecimen:
    """Ball of cells or bonded spheres, with the geometry of its contacts at walls.

    Attributes:
        lattice: the elements.
        middle: centre of the ball [m], (3,).
        diameter: diameter of the ball [m].
        radius: contact radii of the elements [m], (n,).
        stiffness: median normal stiffness k_n of the bonds or facets [N/m].
        mass: mass of the ball [kg].
    """

    lattice: Lattice
    middle: Floats
    diameter: float
    radius: Floats
    stiffness: float
    mass: float

    @classmethod
    def of(cls, test: str, model: Model) -> "BallSpecimen":
        """Create the ball of a model; `test` is the name of the test in messages.

        Raises:
            InputError: the shape is not a ball.
        """
        shape = model.lattice.particles.envelope
        lower, upper = shape.bounds
        extent = upper - lower
        diameter = float(extent.mean())
        full = 6.0 * shape.volume / (math.pi * diameter**3)
        if float(np.ptp(extent)) > _ROUND * diameter or abs(full - 1.0) > _FULL:
            raise InputError(f"labtests.{test}: a {type(shape).__name__} is not a ball; pack bd.Ball(radius)")
        return cls(
            model.lattice, 0.5 * (lower + upper), diameter, model.contact_radius,
            float(np.median(model.stiffness.kn)), float(model.mass.sum()),
        )  # fmt: skip

    def reach(self, direction: Floats) -> float:
        """Return the largest coordinate [m] of the surfaces of all elements along a unit vector, (3,)."""
        return float((self.lattice.centre @ direction + self.radius).max())

    def contact(self, given: ContactLaw | None) -> ContactLaw:
        """Return the given contact law, or for None that of `fragment_contact` for this ball."""
        return fragment_contact(self.stiffness, self.radius) if given is None else given

    def broken(self, state: State, fine: float) -> BrokenBall:
        """Evaluate the fragments in a state; `fine` is the largest size of fines over the ball's diameter [-]."""
        pieces = fragments(self.lattice, state)
        sizes = FragmentSizes.of(pieces, self.lattice, self.diameter)
        damage = float(np.mean(state.bond_integrity <= 0.0))
        return BrokenBall(pieces, sizes, damage, sizes.below(fine * self.diameter))
