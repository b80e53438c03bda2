"""Uniaxial tension of a free specimen, which measures E and ν."""

import math
import warnings
from dataclasses import dataclass

import numpy as np

from bondem._drawing import Coloured, Plotted, columns_of
from bondem._names import users_line
from bondem._progress import staged
from bondem._types import Floats
from bondem.boundary.conditions import Load
from bondem.errors import InputError, ShortSpecimenWarning
from bondem.interactions.beams.bond_strain import BondStrain
from bondem.interactions.law_catalogue import AnyLaw
from bondem.labtests.arguments import check
from bondem.labtests.faces import specimen_faces
from bondem.labtests.gauge_length import AffineField, at_generators, middle_half
from bondem.model.model import Model
from bondem.observables.cell_stress import cell_stress
from bondem.specimen.lattice import Lattice
from bondem.specimen.regions import Face
from bondem.statics.static import StaticResult, Statics


@dataclass(frozen=True, eq=False)
class Tension(Plotted):
    """Result of a tension test along x.

    Attributes:
        E: Young's modulus F / (S ε_xx), with the section S of the shape and ε_xx of the affine fit [Pa].
        nu: Poisson's ratio -(ε_yy + ε_zz) / (2 ε_xx) of the affine fit [-].
        E_paper: Young's modulus of eq (14) of André et al. (2012), with L_M of eq (12) and R_M of eq (13) [Pa].
        nu_paper: Poisson's ratio of eq (15) [-]; None for a shape without a face "side".
        stress: axial stress F / S [Pa].
        strain: strain tensor of the affine fit [-], (3, 3).
        gyration: ⟨y²⟩ and ⟨z²⟩ of the axial force in the section [m²], (2,); see `force_gyration`.
        solution: static equilibrium of the test.
    """

    E: float
    nu: float
    E_paper: float
    nu_paper: float | None
    stress: float
    strain: Floats
    gyration: Floats
    solution: StaticResult

    @property
    def table(self) -> dict[str, Floats]:
        """Moduli, stress and strain by name and unit, one row."""
        paper = {} if self.nu_paper is None else {"nu by eq (15) [-]": self.nu_paper}
        components = self.strain.reshape(1, 9)[:, [0, 4, 8, 1, 5, 2]]
        strain = columns_of("strain {} [-]", ("xx", "yy", "zz", "xy", "yz", "xz"), components)
        found = {"E [Pa]": self.E, "E by eq (14) [Pa]": self.E_paper, "nu [-]": self.nu, **paper}
        return {name: np.array([value]) for name, value in (found | {"stress [Pa]": self.stress}).items()} | strain

    @property
    def drawn(self) -> dict[str, Floats]:
        """Young's modulus by the affine fit and by eq (14) of André et al. (2012) [Pa], by name and unit."""
        return {name: self.table[name] for name in ("E [Pa]", "E by eq (14) [Pa]")}

    @property
    def _pictures(self) -> tuple[Coloured, ...]:
        return self.solution._pictures


@staged("static tension")
def static_tension(lattice: Lattice, law: AnyLaw, *, stress: float = 1e6, depth: float = 0.02) -> Tension:
    """Measure E and ν of a free specimen under equal and opposite forces along x on its faces x_min and x_max.

    The strain is that of the affine least-squares fit to the displacements of all connected elements in the middle
    half of the length. It excludes the rigid motion.

    Args:
        lattice: the specimen.
        law: bond law, cell law or non-local law of the specimen.
        stress: axial stress F / S [Pa]; moduli do not depend on it, as the solution is linear.
        depth: depth of the loaded face regions, in mean radii [-].

    Raises:
        EmptyRegionError: a face has no connected element.
        InputError: fewer than 12 elements in the middle half, or a value out of range.

    Warns:
        ShortSpecimenWarning: the specimen has no cells and is shorter than wide.
    """
    check("static_tension", lattice, stress=stress, depth=depth)
    lower, upper = lattice.particles.envelope.bounds
    length, *widths = (float(extent) for extent in upper - lower)
    spheres = lattice.cells is None
    if spheres and depth * lattice.particles.mean_radius >= length:
        raise InputError(f"static_tension: depth = {depth:g}: each end has all elements; give less, in mean radii")
    if spheres and length < max(widths):
        warnings.warn(
            f"static_tension: the specimen is {length:.4g} m long along x and {max(widths):.4g} m wide; its ends"
            " govern E and ν, which differ from those of the packing; measure them on a longer specimen, or on a"
            " periodic cell with bd.bulk_moduli",
            ShortSpecimenWarning, stacklevel=users_line(),
        )  # fmt: skip
    return tension_of(Statics(tension_model(lattice, law, stress=stress, depth=depth)), stress=stress, depth=depth)


def tension_model(lattice: Lattice, law: AnyLaw, *, stress: float = 1e6, depth: float = 0.02) -> Model:
    """Create the model of `static_tension`, a free specimen with equal and opposite forces on its ends.

    `stress` is the force over the section [Pa], `depth` the depth of the loaded layers in mean radii [-].
    """
    force = stress * lattice.particles.envelope.section()
    pull = [(Face("x_max", depth), force), (Face("x_min", depth), -force)]
    loads = [Load(face, force=(along, 0.0, 0.0)) for face, along in pull]
    return Model(lattice, law, 1.0, boundary=loads)  # statics do not depend on the density


def tension_of(
    statics: Statics, *, stress: float = 1e6, depth: float = 0.02, guess: StaticResult | None = None
) -> Tension:
    """Solve and evaluate a tension test, from the solution `guess` of a similar one if it is given.

    `stress` [Pa] and `depth` [-] are those of `tension_model`, which creates the model of `statics`.
    """
    model = statics.model
    lattice = model.lattice
    solution = statics.equilibrium(guess=guess)
    chosen = middle_half(lattice)
    position, moved = at_generators(lattice, solution.displacement, solution.rotation)
    field = AffineField.fit(position[chosen], moved[chosen])
    axial, *lateral = np.diag(field.strain)
    E_paper, nu_paper = _paper_moduli(model, solution, field, stress * lattice.particles.envelope.section(), depth)
    return Tension(
        E=stress / axial, nu=-0.5 * sum(lateral) / axial, E_paper=E_paper, nu_paper=nu_paper, stress=stress,
        strain=field.strain, gyration=force_gyration(model, solution), solution=solution,
    )  # fmt: skip


def force_gyration(model: Model, solution: StaticResult) -> Floats:
    """Compute the squared radii of gyration of the axial force, ⟨y²⟩ and ⟨z²⟩ about its centre [m²], (2,).

    The mean is over the bonds in the middle half of the length, weighted with axial force times extent along x. For
    cells it is over the cells, weighted with mean axial stress times volume. A homogeneous section gives I/S. A
    section with a soft skin gives less, and its bending stiffness is lower in the same ratio.
    """
    lattice = model.lattice
    if model.interaction.on_facets:
        return _stress_gyration(model, solution)
    i, j = lattice.pairs.T
    position = lattice.particles.position
    lower, upper = lattice.particles.envelope.bounds
    x = 0.5 * (position[i, 0] + position[j, 0])
    chosen = np.abs(x - 0.5 * (lower[0] + upper[0])) <= 0.25 * (upper[0] - lower[0])
    weight = (static_bond_forces(model, solution)[:, 0] * lattice.branch[:, 0])[chosen]
    a, b = position[i[chosen], 1:], position[j[chosen], 1:]
    centre = weight @ (0.5 * (a + b)) / weight.sum()
    return weight @ ((a * a + a * b + b * b) / 3.0) / weight.sum() - centre**2


def _stress_gyration(model: Model, solution: StaticResult) -> Floats:
    body = model.lattice
    cells, chosen = body.elements.require_cells().cells, middle_half(body)
    weight = (cell_stress(model, solution)[:, 0, 0] * cells.volume)[chosen]
    weight /= weight.sum()
    place = body.centre[chosen, 1:]
    return weight @ (place**2 + cells.spread[chosen, 1:]) - (weight @ place) ** 2


def static_bond_forces(model: Model, solution: StaticResult) -> Floats:
    """Return the forces of bonds on their elements i in a linear equilibrium [N], (m, 3), in tension towards j."""
    k = model.stiffness
    return BondStrain.of(model.lattice, k.lever, solution.displacement, solution.rotation).forces(k)


def _paper_moduli(
    model: Model, solution: StaticResult, field: AffineField, force: float, depth: float
) -> tuple[float, float | None]:
    """Compute E_M [Pa] and ν_M [-] of eqs (12)-(15) of André et al. (2012), from motions less the rigid motion.

    For cells both follow from the motion of the surface. ν_M is None for a shape without a face "side".
    """
    lattice = model.lattice
    faces = specimen_faces(lattice, depth)
    place, displacement, outside = faces.outside(model, solution)
    moved = field.without_rigid_motion(place, displacement)
    first, last = (outside[name][1] @ moved[outside[name][0], 0] for name in ("x_min", "x_max"))
    strain = float((last - first) / faces.paper_length)
    envelope = lattice.particles.envelope
    if "side" not in envelope.faces:
        return force / envelope.section() / strain, None
    side, share = outside["side"]
    y, z = place[side, 1:].T
    distance = np.hypot(y, z)
    radius = faces.paper_radius
    outward = np.stack([y, z], axis=1) / np.where(distance > 0.0, distance, 1.0)[:, None]
    swell = float(share @ (outward * moved[side, 1:]).sum(axis=1))
    reach = faces.side_distance(distance, share)
    return force / (math.pi * radius**2) / strain, -swell / reach / strain
