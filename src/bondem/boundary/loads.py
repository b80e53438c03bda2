"""Loads on faces, volumes and bonds: body forces, pressure, absorbing boundaries and stress-free strain."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, cast

import numpy as np

from bondem._checks import array, instance, number, possible, shown, vector
from bondem._plausibility import physical
from bondem._types import Floats, Ints, PerBond, PerElement, PerElement3, Triple
from bondem.boundary.balanced_forces import balanced_forces
from bondem.boundary.schedules import Constant, Schedule, as_schedule, refuse_schedule
from bondem.errors import InputError
from bondem.specimen.lattice import Lattice
from bondem.specimen.material import Material, of_material
from bondem.specimen.regions import Difference, Everything, Face, Intersection, Region, Union, as_region


@dataclass(frozen=True)
class BodyForce:
    """A force on every element in proportion to its mass, such as weight.

    In explicit runs the force also acts on rattlers in the region; static solutions exclude rattlers. Where the
    acceleration varies in space, as in a spinning body, each element keeps the value of its reference position.

    Attributes:
        acceleration: force over mass [m/s²]. Give (3,) for a uniform field, or (n, 3), one row per element in the
            user's order, where rows outside the region have no effect. Or give a function of the reference centres
            [m], (n, 3), that returns (n, 3). A run file cannot store a function; give its values instead.
        region: elements to load.
        schedule: factor over time [-].

    Raises:
        InputError: An array has another shape or a value that is not finite. A function is checked when the model is
            made.
    """

    acceleration: Triple | Sequence[Sequence[float]] | Callable[[PerElement3], PerElement3]
    region: Region = Everything()
    schedule: Schedule = Constant(1.0)

    def __post_init__(self) -> None:
        refuse_schedule("BodyForce", "acceleration", self.acceleration)
        if not callable(self.acceleration):
            object.__setattr__(self, "acceleration", _accelerations(self.acceleration))
        as_region("BodyForce", self.region)
        object.__setattr__(self, "schedule", as_schedule("BodyForce", "schedule", self.schedule))

    def parts(self, lattice: Lattice) -> list[tuple[PerElement, tuple[float, float, float]]]:
        """Return pairs of factors per element [-], (n,), and a uniform acceleration [m/s²].

        The acceleration of an element is the sum of factor times acceleration over all pairs, at a schedule of 1.
        Elements are in the user's order.

        Raises:
            InputError: The acceleration, or the value of the function, has another shape or is not finite.
        """
        inside, n = self.region.with_rattlers(lattice).astype(float), len(lattice.particles)
        given = self.acceleration
        if not callable(given) and np.ndim(given[0]) == 0:
            return [(inside, cast(tuple[float, float, float], given))]
        values = np.asarray(given(lattice.centre.copy()) if callable(given) else given, dtype=float)
        if values.shape != (n, 3) or not possible(values):
            raise InputError(
                f"BodyForce: acceleration = {shown(given)}: its values have shape {values.shape} or are not finite;"
                f" give ({n}, 3) [m/s²], a row per element, or a function of (n, 3) centres that does"
            )
        axes = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)
        return [(inside * values[:, d], axis) for d, axis in enumerate(axes) if values[:, d].any()]


def _accelerations(given: object) -> tuple[float, float, float] | tuple[tuple[float, float, float], ...]:
    """Return an acceleration [m/s²] as a tuple of three components, or of one row of three per element."""
    values = array("BodyForce", "acceleration", given, wanted="(3,), or (n, 3) [m/s²], or a function of centres")
    if values.ndim < 2:
        return vector("BodyForce", "acceleration", given, unit="m/s²")
    if values.ndim > 2 or values.shape[1] != 3 or not possible(values):
        raise InputError(
            f"BodyForce: acceleration has shape {values.shape} or values that are not finite; give (3,), (n, 3)"
            " [m/s²], or a function of centres"
        )
    return tuple((x, y, z) for x, y, z in values.tolist())


def Gravity(
    g: float = 9.81, direction: Triple = (0.0, 0.0, -1.0), region: Region | None = None
) -> BodyForce:
    """Return the weight of elements, a `BodyForce`.

    Args:
        g: acceleration [m/s²].
        direction: vector of any length along which the weight acts, (3,).
        region: elements that have weight; None for all.

    Raises:
        InputError: g is not finite, or the direction has no length.
    """
    size = number("Gravity", "g", g, unit="m/s²")
    x, y, z = vector("Gravity", "direction", direction)
    length = math.hypot(x, y, z)
    if not length > 0.0:
        raise InputError(f"Gravity: direction = {shown(direction)} has no length; give a vector such as (0, 0, -1)")
    down = size / length
    return BodyForce((down * x, down * y, down * z), Everything() if region is None else region)


@dataclass(frozen=True)
class Pressure:
    """A pressure on a face, against its outward normal: the force is -∫ p n dA.

    The face is cut into patches of a quarter of the mean radius. Each patch passes its force to the nearest element
    of the face. The resultant and the moment are those of the patches: the smallest correcting forces remove the
    moment that arises when the forces move to the centres of the elements. In a body of cells the pressure acts on
    the facets. The normals are those of the reference, unless `follows`: then they rotate with the cells, as under a
    membrane, also those of detached pieces. A pressure that does not follow may spin up a body that is free to turn,
    and then pull on it; runs warn about this. Static solutions use the normals of the reference.

    Attributes:
        region: a face, or part of one: `Face("side") & Within(...)`, `Face("x_max") - Index(...)`.
        pressure: pressure [Pa]; negative for tension.
        schedule: factor over time [-].
        follows: True if the normals rotate with the cells; only for bodies of cells.

    Raises:
        InputError: The region is not on a face, or the pressure is not finite.
    """

    region: Region
    pressure: float
    schedule: Schedule = Constant(1.0)
    follows: bool = False

    def __post_init__(self) -> None:
        face_of("Pressure", self.region)
        refuse_schedule("Pressure", "pressure", self.pressure)
        object.__setattr__(self, "pressure", number("Pressure", "pressure", self.pressure, unit="Pa"))
        object.__setattr__(self, "schedule", as_schedule("Pressure", "schedule", self.schedule))
        instance("Pressure", "follows", self.follows, bool, "True or False")

    def on_facets(self, body: Lattice) -> tuple[Ints, Floats]:
        """Return the loaded facets of a body (indices into `cells.free`) and the forces at full load [N], (p, 3)."""
        _, _, _, area = patches_on("Pressure", self.region, body)
        return facet_numbers(self.region, body), -self.pressure * area

    def nodal(self, lattice: Lattice) -> tuple[Ints, Floats]:
        """Return elements (k,) and the force and torque on each [N, N·m], (k, 6), at full load."""
        chosen, owner, centre, area = patches_on("Pressure", self.region, lattice)
        force = -self.pressure * area
        values = on_nodes(lattice, chosen, owner, centre, force)
        if lattice.cells is not None:
            return chosen, values
        position = lattice.centre[chosen]
        missing = np.cross(centre - position[owner], force).sum(axis=0)
        arms = position - position.mean(axis=0)
        turning = balanced_forces(arms, np.zeros(3), missing)
        values[:, :3] += turning
        values[:, 3:] = (missing - np.cross(arms, turning).sum(axis=0)) / len(chosen)
        return chosen, values


@of_material
@dataclass(frozen=True)
class Absorbing:
    """A boundary that absorbs waves by dashpots ρ cp A along the normal and ρ cs A across.

    cp and cs are the speeds of pressure and shear waves, and A is the area. Waves at normal incidence are absorbed
    entirely, oblique waves in part. Static solutions ignore the boundary.

    `bd.Absorbing(face, granite)` takes density, E and ν from a `bd.Material`.

    Attributes:
        region: a face, or part of one, as for `Pressure`; its area is divided in the same way.
        density: density of the specimen, mass over volume [kg/m³]; not that of the elements.
        E: Young's modulus of the specimen [Pa].
        nu: Poisson's ratio of the specimen [-].
        c: speed of the waves along the normal [m/s], such as √(E/ρ) in a thin bar; None for that of plane waves.

    Raises:
        InputError: The region is not on a face, or a constant is out of range.

    Reference: Lysmer and Kuhlemeyer, J. Eng. Mech. Div. ASCE 95 (1969) 859–877.
    """

    region: Region
    density: float
    E: float
    nu: float
    c: float | None = None

    if TYPE_CHECKING:

        def __init__(
            self, region: Region, density: float | Material, E: float | Material = ..., nu: float | Material = ...,
            c: float | None = None,
        ) -> None: ...  # fmt: skip

    def __post_init__(self) -> None:
        face_of("Absorbing", self.region)
        for name in ("density", "E"):
            object.__setattr__(self, name, physical("Absorbing", name, getattr(self, name)))
        nu = number("Absorbing", "nu", self.nu, above=-1.0, below=0.5, advice="Poisson's ratio in (-1, 0.5)")
        object.__setattr__(self, "nu", nu)
        if self.c is not None:
            number("Absorbing", "c", self.c, unit="m/s", above=0.0, advice="a positive celerity, or None")

    @property
    def celerities(self) -> tuple[float, float]:
        """Speeds of the absorbed waves along the normal and across [m/s]."""
        E, nu = self.E, self.nu
        plane = math.sqrt(E * (1.0 - nu) / ((1.0 + nu) * (1.0 - 2.0 * nu)) / self.density)
        return self.c if self.c is not None else plane, math.sqrt(0.5 * E / (1.0 + nu) / self.density)

    def dashpots(self, lattice: Lattice) -> tuple[Ints, Floats]:
        """Return elements (k,) and their dashpot coefficients xx, yy, zz, xy, xz, yz [N·s/m], (k, 6).

        Raises:
            InputError: The region is not on a face, or has no patches.
        """
        chosen, owner, _, area = patches_on("Absorbing", self.region, lattice)
        along, across = (self.density * c for c in self.celerities)
        size = np.linalg.norm(area, axis=1)
        normal = area / size[:, None]
        values = np.zeros((len(chosen), 6))
        for d, (a, b) in enumerate(((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))):
            part = size * ((along - across) * normal[:, a] * normal[:, b] + (across if a == b else 0.0))
            values[:, d] = np.bincount(owner, weights=part, minlength=len(chosen))
        return chosen, values


@dataclass(frozen=True)
class Eigenstrain:
    """A stress-free strain of the bonds, such as that of heat, shrinkage, swelling or initial stress.

    Rest lengths become L (1 + ε*(t)). Each bond gets the mean of the strains of its two elements, because half of its
    length lies inside each; outside the region the strain is 0. A free specimen grows by a uniform ε* without stress;
    a bar fixed at both ends has the stress -E ε*. Strains on the same bond add up. For a field whose pattern changes
    with time, give several strains, each with its own schedule. A field that varies over the thickness of a body of
    cells bends it too little, by 4 to 9 % where it is 4 cells thick and 2 to 3 % at 7, and leaves stresses of 2 to
    6 % of E ε* that a continuum would not have.

    Attributes:
        strain: ε* at factor 1 [-], such as α ΔT: a number, the same everywhere; or (n,), one per element in the
            user's order, where elements outside the region are ignored; or a function of the reference centres [m],
            (n, 3), that returns (n,). A run file cannot store a function; give its values instead.
        region: elements that are strained.
        schedule: factor over time [-].

    Raises:
        InputError: The strain has another shape, is not finite, or reaches -1 in time. The model checks functions.
    """

    strain: float | Sequence[float] | Callable[[PerElement3], PerElement]
    region: Region = Everything()
    schedule: Schedule = Constant(1.0)

    def __post_init__(self) -> None:
        as_region("Eigenstrain", self.region)
        object.__setattr__(self, "schedule", as_schedule("Eigenstrain", "schedule", self.schedule))
        refuse_schedule("Eigenstrain", "strain", self.strain)
        if callable(self.strain):
            return
        values = array("Eigenstrain", "strain", self.strain, wanted="one strain, or (n,), or a function of centres")
        if values.ndim > 1:
            raise InputError(f"Eigenstrain: strain has shape {values.shape}; give a number, (n,), or a function")
        self._check_size(values)
        object.__setattr__(self, "strain", float(values) if values.ndim == 0 else tuple(values.tolist()))

    def _check_size(self, values: Floats) -> None:
        if not possible(values):
            raise InputError("Eigenstrain: strain holds values that are not finite; give finite ones above -1")
        ends = np.outer([values.min(initial=0.0), values.max(initial=0.0)], self.schedule.table[1])
        if not (1.0 + ends > 0.0).all():
            raise InputError(
                f"Eigenstrain: strain = {shown(self.strain)} times its schedule reaches {ends.min():.4g}; give values"
                " that stay above -1"
            )

    def parts(self, lattice: Lattice) -> PerBond:
        """Return the strain of each bond at factor 1 [-], user's order, (m,).

        Raises:
            InputError: The array or result of the function has another length, is not finite, or reaches -1 in time.
        """
        inside, given = self.region.with_rattlers(lattice).astype(float), self.strain
        values = np.asarray(given(lattice.centre.copy()) if callable(given) else given, dtype=float)
        if values.shape not in ((), inside.shape):
            raise InputError(
                f"Eigenstrain: strain = {shown(given)}: its values have shape {values.shape}; give a number,"
                f" ({len(inside)},), one value per element, or a function of centres ({len(inside)}, 3) that does"
            )
        self._check_size(values)
        return (values * inside)[lattice.pairs].mean(axis=1)


def is_face(region: Region) -> bool:
    """Return True if a region is a face, part of one, or a union of such regions."""
    return bool(faces_in(region))


def is_mixed(region: Region) -> bool:
    """Return True if a region joins faces with elements that are not on faces."""
    if is_face(region) or not isinstance(region, Union | Intersection | Difference):
        return False
    sides = (region.first,) if isinstance(region, Difference) else (region.first, region.second)
    return any(is_face(one) or is_mixed(one) for one in sides)


def acts_on_facets(region: Region, lattice: Lattice) -> bool:
    """Return True if a force on a region acts on facets, as it does on a face of a body of cells."""
    return lattice.cells is not None and is_face(region)


def face_of(owner: str, region: Region) -> Face:
    """Return the face that a region equals or is part of; raise InputError if there is none."""
    faces = faces_in(as_region(owner, region))
    if len(faces) != 1:
        raise InputError(
            f'{owner}: {region} is not a face; give bd.Face("x_min") or a part of one, and one {owner} for each face'
        )
    return faces[0][1]


def faces_in(region: Region) -> list[tuple[Region, Face]]:
    """Return the parts of a region that each lie on one face, with this face; [] if not all of it is on faces."""
    match region:
        case Face():
            return [(region, region)]
        case Union(first=first, second=second):
            parts = faces_in(first), faces_in(second)
            return parts[0] + parts[1] if all(parts) else []
        case Difference(first=first, second=second):
            return [(part - second, face) for part, face in faces_in(first)]
        case Intersection(first=first, second=second):
            found = [(part & second, face) for part, face in faces_in(first)]
            return found or [(first & part, face) for part, face in faces_in(second)]
    return []


def facet_numbers(region: Region, body: Lattice) -> Ints:
    """Return the facets of a face, of a part of one, or of a union, as indices into `cells.free`, ascending."""
    cell, chosen, found = body.elements.surface, region.select(body), []
    parts = faces_in(region)
    for part, face in parts:
        inside = chosen if len(parts) == 1 else np.intersect1d(chosen, np.flatnonzero(part.mask(body)))
        on = body.on_face(face.name, face.body)
        found.append(on[np.isin(cell[on], inside)])
    return np.unique(np.concatenate(found))


def patches_on(owner: str, region: Region, lattice: Lattice) -> tuple[Ints, Ints, Floats, Floats]:
    """Return the elements on a face or on a part of one, and their patches, which are facets for cells.

    Cells may be on a union of faces.

    Returns:
        The elements (k,), and for each of p patches the index of its element among these, (p,), its centroid [m],
        (p, 3), and its area times normal [m²], (p, 3).

    Raises:
        InputError: The region is not on a face, or no patch is nearest to its elements.
    """
    chosen = region.select(lattice)
    if acts_on_facets(region, lattice):
        free, found = lattice.elements.require_cells().cells.free, facet_numbers(region, lattice)
        owner_of = np.searchsorted(chosen, free.cell[found])
        return chosen, owner_of, free.centroid[found], free.area[found, None] * free.normal[found]
    face = face_of(owner, region)
    whole = chosen if region is face else face.select(lattice)
    patches = lattice.elements.face_patches(face.name, face.body, whole, chosen)
    if not len(patches[0]):
        raise InputError(f"{owner}: no patch is nearest to an element of {region}; select a larger part of the face")
    return chosen, *patches


def on_nodes(body: Lattice, chosen: Ints, owner: Ints, centre: Floats, force: Floats) -> Floats:
    """Return forces and torques on the cells `chosen`, (k,), by forces on their surface [N, N·m], (k, 6).

    Each `force` [N], (p, 3), acts at the point `centre` [m], (p, 3), of the cell chosen[owner].
    """
    both = np.hstack([force, np.cross(centre - body.centre[chosen][owner], force)])
    parts = [np.bincount(owner, weights=column, minlength=len(chosen)) for column in both.T]
    return np.stack(parts, axis=1).astype(float)
