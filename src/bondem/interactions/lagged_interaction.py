"""Laws whose forces follow from the stresses of the elements in the previous step or iteration."""

from abc import abstractmethod
from typing import ClassVar, Protocol, Self

from scipy.sparse import bsr_array

from bondem._types import Floats, PerBond, PerBond3, PerElement6
from bondem.interactions.beams.bond_table import BondTable
from bondem.interactions.energy_parts import EnergyParts
from bondem.interactions.interaction import SteppingInteraction
from bondem.interactions.stiffness_product import Product


class LaggedStrain(Protocol):
    """Small deformation of all bonds from the reference, with forces of the previous iteration, user's order."""

    @property
    def gap(self) -> PerBond3: ...
    @property
    def extra(self) -> PerBond3: ...
    @property
    def force(self) -> PerBond3: ...
    @property
    def stress(self) -> PerElement6: ...
    @property
    def energy(self) -> EnergyParts: ...
    def moved(self, motion: PerElement6, slip: Floats | float = -0.0) -> Self: ...
    def lagged(self) -> Self: ...
    def carrying(self, extra: PerBond3) -> Self: ...
    def nodal(self, force: PerBond3) -> PerElement6: ...


class LaggedInteraction(SteppingInteraction):
    """A law without a potential, whose springs alone have a matrix.

    Attributes:
        settles: whether rounds of an equilibrium always settle, so that they may be mixed.
        normal_over_shear: stiffness of its springs along the normal over that across [-].
    """

    has_potential: ClassVar[bool] = False
    settles: bool
    normal_over_shear: float

    def product(self, pose: Floats, integrity: PerBond, table: BondTable) -> Product:
        """Return the product of the matrix of intact springs at rest with small motions, internal order."""
        matrix = self.stiffness()
        return lambda motion: (matrix @ motion.ravel()).reshape(motion.shape)

    @abstractmethod
    def springs(self, kn: PerBond, kt: PerBond) -> bsr_array:
        """Return the matrix of springs of other stiffnesses [N/m], internal order, (m,) each: (6 n, 6 n)."""

    @abstractmethod
    def at_rest(self) -> LaggedStrain:
        """Return the undeformed bonds."""

    @abstractmethod
    def small_steps(
        self, speed: PerElement6, weight: PerElement6, along: PerBond, across: PerBond, dt: float, gamma: float,
        steps: int,
    ) -> Floats:  # fmt: skip
        """Return Σ m v² after each step of small motions [J], (steps,), inf beyond 1e30 of its first.

        From velocities (u, θ) [m/s, rad/s] on, with masses and moments of inertia [kg, kg·m²] and dashpots along and
        across the normals of bonds [N·s/m], user's order; `gamma` is local damping [-].
        """
