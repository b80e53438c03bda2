"""The model: all data that stay constant during a solution."""

from collections.abc import Sequence
from copy import copy
from dataclasses import dataclass, field, fields
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, cast, get_args

import numpy as np

from bondem._checks import array, choice, instance, possible, several
from bondem._core import return_free_memory
from bondem._outlets import OUTLETS
from bondem._plausibility import physical, question_strength
from bondem._types import ArrayLike, Floats, PerElement
from bondem.boundary.conditions import BoundaryCondition
from bondem.boundary.wall_table import WallTable
from bondem.boundary.walls import Wall, check_walls
from bondem.damage.beam_softening import BeamSoftening
from bondem.damage.criteria.criterion import BondCriterion
from bondem.damage.failure_assignment import FailureAssignment, FailurePart, failure_parts
from bondem.damage.failure_table import FailureTable, check_failure
from bondem.damage.implied_fracture import ImpliedFracture, implied_fracture
from bondem.damage.softening_table import SlipTable, SofteningTable
from bondem.errors import InputError
from bondem.interactions.beams.bond_law import BondStiffness
from bondem.interactions.beams.bond_table import BondTable
from bondem.interactions.cells.cell_constants import CellConstants
from bondem.interactions.cells.cell_interaction import CellInteraction
from bondem.interactions.cells.cell_plausibility import question_joint
from bondem.interactions.cells.corrected_mass import correction_factors
from bondem.interactions.contact.contact_assignment import ContactAssignment, ContactLaws
from bondem.interactions.contact.contact_model import ContactModel
from bondem.interactions.interaction import Interaction
from bondem.interactions.law_catalogue import AnyLaw, kind_of
from bondem.model.constraints import Constraints
from bondem.model.state import State, require_strains
from bondem.specimen.elements import Elements
from bondem.specimen.lattice import Lattice
from bondem.specimen.local_origin import local_origin
from bondem.specimen.material import Material, of_material
from bondem.specimen.ordering import Layout
from bondem.specimen.particles import freeze

#: Mass matrices of a model.
MassMatrix = Literal["lumped", "dispersion-corrected"]


@of_material
@dataclass(frozen=True, eq=False)
class Model:
    """A lattice with bonds, masses and boundary conditions.

    A model has only the features that are passed to it. Contacts and walls act in explicit runs only; static
    solutions and modes reject a model that has them.

    Attributes:
        lattice: elements and bonds.
        bond: a bond law, or laws by region: {region: law, (region, region): law}; None for a lattice without bonds.
            Use `CellBond`, or {region: CellBond}, for a body cut into cells.
        density: density of the elements, ρ_μ [kg/m³], or of the material in a body of cells; a number, shape (n,), or
            a `bd.Material`. Static solutions without body forces are independent of the density.
        boundary: one boundary condition or several: supports, drives, loads, absorbing boundaries, strains.
        contact: law of contacts with walls and between elements without an intact bond, or laws of one class by
            region: {region: law, (region, region): law, (region, wall): law, wall: law}. None for no contacts.
        walls: rigid planes, cylinders and spheres; they need a `contact` law.
        failure: criterion by which bonds or facets break, such as `bd.PeripheralStress(...)`, or criteria of one kind
            by region: {region: criterion, (region, region): criterion}. None for bonds that never break. Bonds break
            in `solve_explicit` and `solve_quasistatic`; other solvers reject a model with criteria.
        mass_matrix: "lumped", the mass and inertia of each element, or "dispersion-corrected" for cells that cannot
            fail, in explicit runs and modes: waves of pressure have their celerity to 0.5 % at 10 elements per wave.
            A step takes longer, and energy is not conserved exactly where cells rotate.

    Raises:
        InputError: A density is not positive, laws, criteria, walls or conditions contradict the lattice or each
            other, or masses and stiffnesses exceed the range of numbers.
        EmptyRegionError: A region selects no connected element.
    """

    lattice: Lattice
    bond: AnyLaw | None
    density: float | ArrayLike
    boundary: Sequence[BoundaryCondition] = field(default=())
    contact: ContactAssignment | None = None
    walls: Sequence[Wall] = field(default=())
    failure: FailureAssignment | None = None
    mass_matrix: MassMatrix = "lumped"

    if TYPE_CHECKING:

        def __init__(
            self, lattice: Lattice, bond: AnyLaw | None,
            density: float | ArrayLike | Material, boundary: Sequence[BoundaryCondition] = (),
            contact: ContactAssignment | None = None, walls: Sequence[Wall] = (),
            failure: FailureAssignment | None = None, mass_matrix: MassMatrix = "lumped",
        ) -> None: ...  # fmt: skip

    # Attributes for solvers, in internal order and types, which neither `dir` nor the reference lists.
    _INTERNAL = (
        "beam_softening", "bonds", "breaking", "by", "cell_constants", "cell_law", "constraints",
        "contact_laws", "contacts", "correction", "fails",
        "failure_parts", "hands_over", "interaction", "layout", "period", "pressed", "softening", "yielding",
    )  # fmt: skip

    def __dir__(self) -> list[str]:
        return [name for name in object.__dir__(self) if name not in self._INTERNAL]

    def __post_init__(self) -> None:
        instance("Model", "lattice", self.lattice, Lattice, "a lattice, from bd.connect or bd.Lattice")
        density = array("Model", "density", self.density, wanted="a positive number [kg/m³], or one per element")
        if density.shape not in ((), (len(self.lattice.particles),)):
            raise InputError(f"density has shape {density.shape}; give a number or one value per element")
        if not possible(density) or not (density > 0.0).all():
            raise InputError("density has values that are not positive and finite; give positive values [kg/m³]")
        physical("Model", "density", float(density.min()))
        object.__setattr__(self, "boundary", _conditions(self.boundary))
        law = self.interaction
        law.on_elements(self.boundary)  # raises for platens with friction under some laws
        object.__setattr__(self, "walls", check_walls(self.walls))
        beams, contact = law.evaluated == "force", self.contact_laws
        if (option := contact.of_beams) and not beams:
            raise InputError(f"contact= with {option}= applies to beams; leave out {option}= for {law.name}")
        if self.walls and self.contact is None:
            raise InputError("walls= need a contact law; give contact=bd.LinearContact(E=...)")
        choice("Model", "mass_matrix", self.mass_matrix, MassMatrix)
        corrected = law.corrects_mass and self.failure is None and self.contact is None
        if self.mass_matrix != "lumped" and not corrected:
            raise InputError(
                'mass_matrix="dispersion-corrected" applies to cells (bd.CellBond) without failure= and contact=;'
                " leave these out, or mass_matrix="
            )
        self._check_magnitudes()
        self.constraints  # noqa: B018  regions are checked when the model is made
        self.breaking  # noqa: B018  as is the criterion of failure
        self.beam_softening  # noqa: B018  and whether bonds are short enough to soften
        self._check_strain()
        law.question()
        for one in self.failure_parts if law.evaluated == "traction" else ():
            if one.between:
                question_joint(self.lattice, one.between, one.bonds)
        implied = self.implied_fracture
        if implied is not None:
            question_strength(implied.strength, implied.E, implied.density, implied.fracture_energy)
        return_free_memory(len(self.lattice.pairs))

    def _check_magnitudes(self) -> None:
        with np.errstate(all="ignore"):
            mass, inertia, stiffness = self.mass, self.inertia, self.stiffness
        stiffnesses = [(item.name, getattr(stiffness, item.name)) for item in fields(stiffness)]
        for name, values in (("masses", mass), ("moments of inertia", inertia), *stiffnesses):
            if not np.isfinite(values).all() or (name.startswith("m") and not (values > 0.0).all()):
                raise InputError(
                    f"the {name} of this model exceed the range of numbers; check the units of density, bonds, radii"
                )

    def _check_strain(self) -> None:
        if len(self.constraints.strain_part):
            require_strains(self.interaction, "Eigenstrain")
        if len(self.constraints.strain_part) and self.fails and self.contact is not None:
            raise InputError("Eigenstrain shifts where broken bonds touch; leave out contact= or failure= beside it")
        if len(self.constraints.strain_part) and self.beam_softening is not None:
            raise InputError("Eigenstrain does not apply to beams that soften; leave out fracture_energy= beside it")

    @cached_property
    def layout(self) -> Layout:
        """Internal order of elements and bonds."""
        return Layout.of(self.lattice)

    @property
    def cell_law(self) -> CellInteraction:
        """Interaction of the cells of a `CellBond` model."""
        return cast(CellInteraction, self.interaction)

    @property
    def cell_constants(self) -> CellConstants:
        """Constants of the cell law, in the user's order. Requires a `CellBond` model."""
        return self.cell_law.by_user

    @cached_property
    def correction(self) -> PerElement | None:
        """Factors ρ β / V of `correction_factors` [kg/m⁶], user's order, (n,); None for lumped masses."""
        if self.mass_matrix == "lumped":
            return None
        constants = self.cell_constants
        density = np.broadcast_to(np.asarray(self.density, dtype=float), constants.volume.shape)
        return correction_factors(self.lattice, constants.G, constants.lame, density)

    @cached_property
    def interaction(self) -> Interaction:
        """Interaction by the bonds or facets, with all their constants."""
        may_fail = self.failure is not None
        with np.errstate(all="ignore"):  # magnitudes are checked later
            return kind_of(self.bond).join(self.lattice, self.layout, self.bond, self.boundary, may_fail)

    @property
    def stiffness(self) -> BondStiffness:
        """Stiffnesses of the bonds, in the user's order."""
        return self.interaction.bonds

    @property
    def formulation(self) -> str:
        """Formulation of the bond law, "total" or "incremental"."""
        return self.interaction.formulation

    @property
    def bonds(self) -> BondTable:
        """Constants of the bonds, in internal order."""
        return self.interaction.table

    @cached_property
    def contact_laws(self) -> ContactLaws:
        """Laws of contacts by kinds of elements."""
        return ContactLaws.of(self.lattice, self.contact, self.walls)

    @cached_property
    def contacts(self) -> ContactModel:
        """Contact laws, walls and contacts of the reference configuration, as tables of the core."""
        laws, mass, origin = self.contact_laws, float(self.mass.sum()), local_origin(self.lattice)
        table = WallTable.of(self.walls, mass, origin, self.lattice.centre, self.contact_radius)
        own = self.bonds.kn if laws.stress_free and not laws.parallel else None
        return ContactModel.of(self.lattice, self.layout, laws, table, own, self.contact_radius)

    @property
    def hands_over(self) -> bool:
        """True if contacts carry the compression of bonds that have broken."""
        return self.contacts.own is not None

    @property
    def contact_radius(self) -> PerElement:
        """Contact radii of the elements; for a cell, that of a sphere of its volume [m], user's order, shape (n,)."""
        return self._elements.equal_radius

    @cached_property
    def fails(self) -> bool:
        """True if bonds may fail, by a criterion or by their law."""
        return self.failure is not None or bool(np.isfinite(self.interaction.own_strength()).any())

    @cached_property
    def failure_parts(self) -> tuple[FailurePart, ...]:
        """Criteria with the bonds and elements that they apply to, user's order."""
        return () if self.failure is None else failure_parts(self.lattice, self.failure)

    @cached_property
    def breaking(self) -> FailureTable | None:
        """Criteria by which single bonds break or begin to soften, in internal order; None if there are none."""
        if self.failure is None:
            return FailureTable.of_law(self.interaction) if self.fails else None
        check_failure(self.failure, self.interaction, self.contact_laws)
        if self.softening is not None or not self._by_bond:
            return None
        return FailureTable.of(self.interaction, self.failure_parts)

    @property
    def _by_bond(self) -> bool:
        """True if criteria evaluate single bonds."""
        of_stress = self.interaction.evaluated == "stress"
        return of_stress or any(isinstance(one.criterion, BondCriterion) for one in self.failure_parts)

    @cached_property
    def beam_softening(self) -> BeamSoftening | None:
        """Fracture energies of softening beams, in internal order; None if no beam softens."""
        if self.interaction.evaluated != "force" or not self._by_bond:
            return None
        law = self.interaction
        return BeamSoftening.of(law.lattice, law.layout, self.failure_parts, law.bonds, law.moments_at_contact)

    @cached_property
    def softening(self) -> SofteningTable | None:
        """Parameters of cracking facets and yielding cells, in internal order; None if there are none."""
        if self.interaction.evaluated != "traction":
            return None
        return SofteningTable.of(self.lattice, self.layout, self.cell_law.constants, self.failure_parts)

    @property
    def yielding(self) -> tuple[SlipTable, ...]:
        """Tables of the cells that yield, in internal order: none or one."""
        return () if self.softening is None else self.softening.yielding

    @property
    def implied_fracture(self) -> ImpliedFracture | None:
        """Fracture properties implied by the criterion and these elements; None if no bond can fail."""
        return implied_fracture(self.interaction, self.failure_parts, self.mass) if self.fails else None

    @property
    def pressed(self) -> PerElement:
        """Volume change V θ of each cell by tractions at the end of all schedules [m³], user's order, (n,)."""
        return self.constraints.final_press()[self.layout.rank]

    @cached_property
    def constraints(self) -> Constraints:
        """Boundary conditions resolved to elements."""
        law = self.interaction
        return Constraints.of(self.lattice, self.layout, law.on_elements(self.boundary), self.mass, law)

    @property
    def _elements(self) -> Elements:
        """Elements that define the masses: for beams between cells, the spheres of their particles."""
        own = self.lattice.elements
        return Elements(own.particles, own.pairs, own.bodies) if self.interaction.evaluated == "force" else own

    @cached_property
    def mass(self) -> PerElement:
        """Masses of the elements, ρ_μ 4/3 π R³, or ρ V of a cell [kg], user's order, shape (n,)."""
        return freeze(np.asarray(self.density, dtype=float) * self._elements.volume)

    @cached_property
    def inertia(self) -> PerElement:
        """Moments of inertia, 2/5 m R², or a third of the trace of a cell's tensor [kg·m²], user's order, (n,)."""
        return freeze(self._elements.inertia(np.asarray(self.density, dtype=float)))

    @property
    def period(self) -> Floats:
        """Edge lengths of the periodic cell and their inverses, zeros without a periodic cell, shape (6,)."""
        return self.interaction.period

    def plot(
        self, path: str | Path | None = None, *, solution: Any = None, reach: float | None = None,
        view: tuple[float, float] = (28.0, 24.0),
    ) -> Any:  # fmt: skip
        """Draw the specimen with its supports, loads and walls, or in the pose of a solution.

        Args:
            path: PNG, PDF or SVG to write; nothing is written when None.
            solution: a state, run or equilibrium of this model, whose displacements colour the elements.
            reach: factor on displacements [-]; None for a factor that makes them visible.
            view: azimuth and elevation of the camera [degree].

        Returns:
            A `matplotlib.figure.Figure`, which Jupyter shows; its `show()` opens a window.

        Raises:
            InputError: The solution is of another model, the file cannot be written, or the view is not two angles.
        """
        return OUTLETS.draw_model(self, path, solution=solution, reach=reach, view=view)

    def with_boundary(self, boundary: Sequence[BoundaryCondition]) -> "Model":
        """Return a model of the same bonds and masses under other conditions; invalid conditions raise InputError."""
        other = Model.__new__(Model)
        for item in fields(self):
            object.__setattr__(other, item.name, getattr(self, item.name))
        object.__setattr__(other, "boundary", _conditions(boundary))
        other.__dict__["interaction"] = self.interaction.under(other.boundary)
        for name in ("layout", "mass", "inertia", "failure_parts", "breaking", "softening", "beam_softening"):
            other.__dict__[name] = getattr(self, name)
        other.constraints  # noqa: B018  regions are checked now
        other._check_strain()
        return other

    def by(self, law: Interaction) -> "Model":
        """Return a copy of the model with another interaction, for solvers."""
        twin = copy(self)
        twin.__dict__["interaction"] = law
        return twin

    def state(self) -> State:
        """Return a new state: the reference configuration, at rest, at time 0.

        Set velocities, poses or strains of this state before a run.
        """
        return State(self)


def _conditions(boundary: object) -> tuple[BoundaryCondition, ...]:
    wanted = "Fix, Drive, Load, Pressure, BodyForce, Absorbing or Eigenstrain, one or a sequence of them"
    return several("Model", "boundary", boundary, get_args(BoundaryCondition), wanted)
