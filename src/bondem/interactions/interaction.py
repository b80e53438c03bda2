"""Interface between a law of bonds and the rest of the package.

An interaction has the elements and bonds of a specimen, but neither model nor state. Its methods receive the arrays
of the state that belong to the law. Defaults are those of beams, which have a potential and no memory. A solver that
needs more checks `Interaction.has_potential` or the class `LaggedInteraction`.
"""

from abc import ABC, abstractmethod
from collections.abc import Callable, Mapping, Sequence
from copy import copy
from dataclasses import dataclass
from functools import cached_property
from typing import Any, ClassVar, Literal, NamedTuple, Protocol, Self

import numpy as np
from scipy.sparse import bsr_array

from bondem._cache_lines import lines
from bondem._core import run_pass
from bondem._passes import calls
from bondem._tables.damage_tables import Candidates, EventLog, FailureIndices, Postponed, Strengths
from bondem._tables.step_tables import Beams, BeamSums, Dashpots, LaggedStresses, Ledger, Moving, Poses, StepBlocks
from bondem._tables.stiffness_tables import BondTangents
from bondem._types import Floats, Ints, PerBond, PerBond3, PerElement, PerElement3, PerElement6
from bondem.boundary.conditions import BoundaryCondition, Load
from bondem.boundary.loads import Pressure
from bondem.boundary.wall_constraints import Supports
from bondem.errors import InputError
from bondem.interactions.beams.beam_tables import beam_energies, beam_tables, load_beams
from bondem.interactions.beams.bond_law import BondStiffness
from bondem.interactions.beams.bond_strain import BondStrain
from bondem.interactions.beams.bond_table import BondTable
from bondem.interactions.energy_parts import EnergyParts
from bondem.interactions.row_sums import row_sums
from bondem.interactions.step_part import Part, Passes
from bondem.interactions.stiffness import Stiffness
from bondem.interactions.stiffness_product import Product, loads_in, product_by
from bondem.specimen.lattice import Lattice
from bondem.specimen.ordering import Layout

#: Arrays of a state that belong to a law, by name, with the integrity of its bonds.
Arrays = Mapping[str, np.ndarray]
#: Boundary conditions of a model.
Boundary = Sequence[BoundaryCondition]
#: Quantity that a criterion evaluates: forces of beams, tractions of facets, or the mean stress of two elements.
Evaluated = Literal["force", "traction", "stress"]


@dataclass(frozen=True)
class StateField:
    """Array of the state that belongs to a law.

    Attributes:
        name: name in `State` and in run files.
        shape: axes: a number, "n" for elements, or "m" for bonds.
        fresh: rows that a new run sets to zero.
    """

    name: str
    shape: tuple[int | str, ...]
    fresh: tuple[int, ...] = ()

    def zeros(self, **sizes: int) -> np.ndarray:
        """Return the array of a new state, filled with zeros, for the sizes n= and m=."""
        return np.zeros([sizes[axis] if isinstance(axis, str) else axis for axis in self.shape])


class SurfaceState(NamedTuple):
    """Walls that constrain facets, and tractions on facets, at one time.

    `base` are initial places of the walls, (g, 7), and `motion` their displacements [m], (g, 3). `pressed` is the
    contribution of tractions to V θ, volume times dilatation, of each cell [m³], internal order, (n,).
    """

    base: Floats
    motion: Floats
    pressed: PerElement


class DamageOfRun(Protocol):
    """Interface of the tables by which bonds of a run fail, as far as laws use them."""

    @property
    def candidates(self) -> Candidates: ...
    @property
    def postponed(self) -> Postponed: ...
    @property
    def log(self) -> EventLog: ...
    @property
    def strengths(self) -> Strengths: ...


@dataclass(frozen=True, eq=False)
class Run:
    """Tables of a run from which a law composes its passes.

    Attributes:
        moving: motion of the elements.
        blocks: division of a step into domains and blocks.
        ledger: sums of energies for a record or for a check of the energy.
        arrays: arrays of the state that belong to the law.
        dashpots: dashpots parallel to the bonds, or None.
        damage: tables by which bonds fail, or None if they do not.
        failing: function that returns the part of failing bonds, given passes that find failing bonds, passes
            that remove them, and the integrity that the latter write.
        touches: True if elements may touch.
    """

    moving: Moving
    blocks: StepBlocks
    ledger: Ledger
    arrays: Arrays
    dashpots: Dashpots | None
    damage: DamageOfRun | None
    failing: Callable[[Passes, Passes, PerBond], Part]
    touches: bool


@dataclass(frozen=True, eq=False)
class LawParts:
    """Parts of a step that a law provides.

    Attributes:
        parts: parts of a step.
        integrity: integrity of the bonds that these parts write [-], (m,) or longer.
        stresses: stresses of elements to which contacts contribute, or None.
    """

    parts: list[Part]
    integrity: PerBond
    stresses: LaggedStresses | None = None


class Interaction(ABC):
    """Interaction of the elements of a specimen by a law of its bonds, in any pose and for small motions.

    Attributes:
        lattice: elements and bonds.
        layout: internal order of both.
        law: class of the parameters of the law (class attribute).
        bond: word for a bond in messages (class attribute).
        turned: consequence of bonds that have turned far, for messages (class attribute).
        title: common name of the law, for messages (class attribute).
        name: word for bonds of this law in messages (class attribute).
        formulation: "total" or "incremental" (class attribute).
        fields: arrays of the state that belong to the law (class attribute).
        has_potential: True if forces are the derivative of an energy (class attribute).
        evaluated: quantity that a criterion evaluates (class attribute).
        on_facets: True if elements interact by facets, which also carry loads and conditions (class attribute).
        corrects_mass: True if the law has a dispersion-corrected mass matrix (class attribute).
        isotropic_springs: True if springs are as stiff across as along the normal (class attribute).
        strains: True if rest lengths of bonds may change (class attribute).
    """

    law: ClassVar[type]
    bond: ClassVar[str] = "bond"
    turned: ClassVar[str] = "the bond energy is no longer that of a beam: use shorter bonds or lower loads"
    title: ClassVar[str] = "law of beams"
    name: ClassVar[str] = "beams"
    formulation: ClassVar[str] = "total"
    fields: ClassVar[tuple[StateField, ...]] = ()
    has_potential: ClassVar[bool] = True
    evaluated: ClassVar[Evaluated] = "force"
    on_facets: ClassVar[bool] = False
    corrects_mass: ClassVar[bool] = False
    isotropic_springs: ClassVar[bool] = False
    strains: ClassVar[bool] = True

    def __init__(self, lattice: Lattice, layout: Layout) -> None:
        self.lattice, self.layout = lattice, layout

    @classmethod
    @abstractmethod
    def join(cls, lattice: Lattice, layout: Layout, bond: Any, boundary: Boundary, may_fail: bool) -> "Interaction":
        """Return the interaction of a specimen by a law, or laws by region, under boundary conditions.

        Raises:
            InputError: The laws do not fit each other or the specimen.
        """

    def question(self) -> None:
        """Warn about a specimen for which the law is inaccurate."""
        return

    @classmethod
    def require_facets(cls, refusal: str) -> None:
        """Raise InputError with the text `refusal` if elements do not interact by facets."""
        raise InputError(refusal)

    @classmethod
    def refuse_facets(cls, refusal: str) -> None:
        """Raise InputError with the text `refusal` if elements interact by facets."""
        return

    def on_elements(self, boundary: Boundary) -> Boundary:
        """Return the conditions that act on elements, without those that act by walls on facets.

        Raises:
            InputError: A platen with friction has no facets to slide on it.
        """
        if any(getattr(one, "friction", None) is not None for one in boundary):
            raise InputError("friction= of Fix and Drive acts on cells only; press spheres by walls= with friction")
        return boundary

    def facet_forces(self, load: Load | Pressure) -> tuple[Ints, Floats]:
        """Return the facets on the surface that a load acts on, (p,), and its forces there [N], (p, 3)."""
        return np.zeros(0, dtype=np.int64), np.zeros((0, 3))

    def under(self, boundary: Boundary) -> "Interaction":
        """Return the same law under other boundary conditions."""
        return self

    @property
    def supports(self) -> Supports:
        """Free facets whose displacement walls prescribe; none for laws without facets."""
        return Supports.none()

    def strained(self, strain: PerBond, base: Floats, motion: Floats, pressed: PerElement) -> Self:
        """Return the law with strains ε* [-], (m,) or (0,), and the arrays of a `SurfaceState`, in internal order."""
        twin = copy(self)
        twin.__dict__["table"] = self.table.stretched(strain)
        return twin

    def pressed(self, facet: Ints, force: Floats) -> PerElement:
        """Return the volume changes V θ [m³], (n,), due to forces on free facets [N], (k, 3); user's order."""
        return np.zeros(len(self.layout.order))

    def dilatational_stress(self, swelling: PerElement) -> PerElement:
        """Return the stress λ θ [Pa], (n,), of elements with the volume changes V θ [m³], (n,); user's order."""
        return np.zeros(len(swelling))

    @property
    def moments_at_contact(self) -> bool:
        """True if moments at the contact points, not those at the ends, count for failure."""
        return False

    def own_strength(self) -> PerBond:
        """Return the tensile force at which the law itself breaks each bond [N], user's order, (m,); inf for never.

        A law that breaks bonds also provides the passes that find and remove them.
        """
        return np.full(len(self.lattice.pairs), np.inf)

    @property
    @abstractmethod
    def bonds(self) -> BondStiffness:
        """Stiffnesses of beams that are equal, or approximately equal, to those of the bonds; user's order."""

    @cached_property
    def table(self) -> BondTable:
        """Constants of the beams of `bonds`, internal order."""
        return BondTable.of(self.lattice, self.layout, self.bonds)

    @property
    def period(self) -> Floats:
        """Edge lengths of the periodic cell and their inverses, zeros without a periodic cell, shape (6,)."""
        edges = self.lattice.particles.period
        return np.zeros(6) if edges is None else np.concatenate([edges, 1.0 / edges])

    @abstractmethod
    def stiffness(self) -> Stiffness:
        """Return the second derivative of the energy at rest, or that of the springs alone; internal order."""

    @abstractmethod
    def loads(self, pose: Floats, arrays: Arrays) -> Floats:
        """Return force on j, torque on i and torque on j of each bond in a pose [N, N·m], internal order, (m, 9).

        Raises:
            InputError: Bonds have no loads of their own.
        """

    @abstractmethod
    def small_loads(self, displacement: PerElement3, rotation: PerElement3, strain: PerBond) -> Floats:
        """Return force on j, torque on i and torque on j [N, N·m] by small motions [m, rad], user's order, (m, 9).

        Raises:
            InputError: Bonds have no loads of their own, or these do not follow from motions.
        """

    @abstractmethod
    def joints(self) -> tuple[PerBond, PerBond, PerBond3]:
        """Return area [m²], length [m] and place [m] of each bond for criteria, user's order, (m,), (m,), (m, 3)."""

    @abstractmethod
    def modulus(self, volume: float) -> float:
        """Return Young's modulus of the material [Pa], or its estimate for a specimen of the volume `volume` [m³]."""

    def wave_speed(self, mass: PerElement) -> float:
        """Return the speed of a wave in a chain of bonds or a thin rod [m/s], for masses [kg], user's order, (n,)."""
        i, j = self.lattice.pairs.T
        return float(np.median(self.lattice.length * np.sqrt(2.0 * self.bonds.kn / (mass[i] + mass[j]))))

    # ---- small motions

    def strain_load(self, strain: PerBond, pressed: PerElement) -> PerElement6:
        """Return forces on elements at rest by strained bonds and moving walls [N, N·m], internal order, (n, 6).

        Strains ε* [-] are in internal order, and `pressed`, volume changes V θ by tractions [m³], in the user's.
        """
        layout, bonds = self.layout, self.table
        push = bonds.kn * bonds.length * strain * bonds.direction
        load = np.zeros((len(layout.order), 6))
        load[:, :3] = row_sums(layout.j, push.T, len(load)) - row_sums(layout.i, push.T, len(load))
        return load

    def swelling_load(self, pressed: PerElement) -> PerElement6:
        """Return loads on elements at rest [N, N·m], (n, 6), by volume changes V θ [m³], (n,); user's order."""
        return np.zeros((len(pressed), 6))

    def of_walls(
        self, displacement: PerElement3, rotation: PerElement3, strain: PerBond, pressed: PerElement
    ) -> PerElement6:
        """Return loads of walls on elements [N, N·m], user's order, (n, 6); arguments as in `small_energy`."""
        return np.zeros((len(displacement), 6))

    def small_energy(
        self, displacement: PerElement3, rotation: PerElement3, strain: PerBond, pressed: PerElement,
        traction: Floats,
    ) -> EnergyParts:  # fmt: skip
        """Return the energy of small motions of the elements [m, rad], (n, 3) each, user's order.

        Strains ε* [-], (m,), are in internal order. `pressed` are volume changes V θ by tractions [m³], (n,).
        `traction` is the force on each free facet [N], (k, 3).
        """
        lattice, k = self.lattice, self.bonds
        bonds = BondStrain.of(lattice, k.lever, displacement, rotation)
        elongation, order = bonds.normal.copy(), self.layout.bond_order
        elongation[order] -= lattice.length[order] * strain
        return EnergyParts(
            normal=0.5 * float((k.kn * elongation**2).sum()),
            shear=0.5 * float((k.ks * (bonds.shear**2).sum(axis=1)).sum()),
            bending=0.5 * float((k.kb * (bonds.bend**2).sum(axis=1)).sum()),
            twisting=0.5 * float((k.kt * bonds.twist**2).sum()),
        )

    def surface_motion(self, displacement: PerElement3, rotation: PerElement3, traction: Floats) -> Floats:
        """Return displacements of free facets [m], (k, 3), by motions [m, rad] and tractions [Pa], user's order."""
        cells = self.lattice.elements.require_cells().cells
        free, arm = cells.free, cells.free.centroid - cells.centroid[cells.free.cell]
        return displacement[free.cell] + np.cross(rotation[free.cell], arm)

    # ---- large motions

    def energy(
        self, pose: Floats, rest: Floats, integrity: PerBond, strain: PerBond, surface: SurfaceState | None = None
    ) -> EnergyParts:
        """Return the energy of bonds at poses (n, 8), centres at rest [m], (n, 3), and strains ε* [-], (m,) or (0,).

        All are in internal order. Walls and tractions are those of `surface`, else those of the law at final values.
        """
        return EnergyParts(*beam_energies(pose, self._beams(strain, integrity)))

    def indices(self, pose: Floats, arrays: Arrays, kind: str, strengths: Strengths) -> PerBond:
        """Return the failure index of each bond by a criterion [-], 0 for broken bonds, internal order, (m,).

        `pose` (n, 8) must contain the stresses λ θ of cells [Pa], and `kind` is `BondCriterion.kind`.
        """
        beams = self._beams(arrays["rest_strain"], arrays["integrity"])
        found = FailureIndices(np.zeros(len(beams.i)))
        run_pass(calls.INDEX_BEAMS_BY[kind](Poses(pose), beams, strengths, found))
        return found.index[: len(self.layout.i)]

    def _beams(self, strain: PerBond, integrity: PerBond) -> Beams:
        stretched = self.table.stretched(strain)
        return beam_tables(stretched, self.layout, self.period, integrity, may_share=False)[0]

    def product(self, pose: Floats, integrity: PerBond, table: BondTable) -> Product:
        """Return the function K u of small motions u, K the stiffness in a pose; internal order, walls at rest."""
        beams, _ = beam_tables(table, self.layout, self.period, integrity, may_share=False)
        return product_by(len(pose), lambda by: calls.multiply_beams(Poses(pose), by, beams))

    def gradient(self, pose: Floats) -> tuple[PerElement6, PerElement6]:
        """Return the derivative of the energy of intact bonds, and wall loads [N, N·m], internal order, (n, 6)."""
        beams, sums = self._beams(np.zeros(0), np.ones(len(self.layout.i))), lines(len(pose))
        load_beams(pose, beams, BeamSums(beams.i, beams.j, sums))
        return -loads_in(sums), np.zeros((len(pose), 6))

    def bond_tangents(self, pose: Floats) -> Floats:
        """Return the second derivative of each bond's energy, as if intact, by (u, θ) of its two elements in a pose.

        Its shape is (12, 12, m) in internal order, and its units are N/m, N and N·m.
        """
        beams = self._beams(np.zeros(0), np.ones(len(self.layout.i)))
        found = BondTangents(np.empty((12, 12, len(beams.i))))
        run_pass(calls.differentiate_beams(Poses(pose), beams, found))
        return found.tangent[:, :, : len(self.layout.i)]

    def tangent(self, pose: Floats, data: Floats, pattern: bsr_array) -> Stiffness:
        """Return the second derivative of the energy at a pose, given its blocks `data` in the pattern at rest."""
        return Stiffness(bsr_array((data, pattern.indices, pattern.indptr), shape=pattern.shape))


class SteppingInteraction(Interaction):
    """Law of bonds that provides its own parts of a time step."""

    strains: ClassVar[bool] = False

    @abstractmethod
    def parts(self, run: Run) -> LawParts:
        """Return the parts of a step by which the law acts in a run."""
