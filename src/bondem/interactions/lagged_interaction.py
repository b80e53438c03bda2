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
    """Interface of a small deformation of all bonds, with extra forces of the previous iteration; user's order."""

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
    """Law of bonds without a potential, for which only the springs have a stiffness matrix.

    Attributes:
        settles: True if the iteration to an equilibrium always converges, so that mixing may accelerate it.
        normal_over_shear: stiffness of the springs along the normal over that across [-].
    """

    has_potential: ClassVar[bool] = False
    settles: bool
    normal_over_shear: float

    def product(self, pose: Floats, integrity: PerBond, table: BondTable) -> Product:
        """Return the function K u of small motions u, with the matrix K of intact springs at rest, internal order."""
        matrix = self.stiffness()
        return lambda motion: (matrix @ motion.ravel()).reshape(motion.shape)

    @abstractmethod
    def springs(self, kn: PerBond, kt: PerBond) -> bsr_array:
        """Return the matrix, (6 n, 6 n), of springs kn and kt [N/m], (m,) each, internal order."""

    @abstractmethod
    def at_rest(self) -> LaggedStrain:
        """Return the deformation of bonds at rest, which is zero."""

    @abstractmethod
    def small_steps(
        self, speed: PerElement6, weight: PerElement6, along: PerBond, across: PerBond, dt: float, gamma: float,
        steps: int,
    ) -> Floats:  # fmt: skip
        """Return Σ m v² after each step of small motions [J], (steps,); inf once it exceeds 1e30 times the first.

        The steps begin with the velocities `speed` [m/s, rad/s], (n, 6). `weight` are masses and moments of inertia
        [kg, kg·m²], (n, 6). `along` and `across` are dashpots of bonds along and across the normal [N·s/m], (m,).
        All are in the user's order. `dt` is the time step [s] and `gamma` local damping [-].
        """
