"""Boundary conditions: elements that are fixed, driven or loaded."""

from dataclasses import dataclass

import numpy as np

from bondem._checks import instance, number, vector
from bondem._types import Floats, Ints, Triple
from bondem.boundary.balanced_forces import balanced_forces
from bondem.boundary.loads import (
    Absorbing,
    BodyForce,
    Eigenstrain,
    Pressure,
    acts_on_facets,
    faces_in,
    facet_numbers,
    on_nodes,
    patches_on,
)
from bondem.boundary.schedules import Constant, Schedule, as_schedule, refuse_schedule
from bondem.errors import InputError
from bondem.specimen.lattice import Lattice
from bondem.specimen.regions import Region, as_region

_AXES = {"x": 0, "y": 1, "z": 2}
#: Degree of freedom of each argument of `Drive`, and True for a velocity.
MOTIONS = {
    name: (dof, rate) for rate, names in ((False, "x y z rx ry rz"), (True, "vx vy vz wx wy wz"))
    for dof, name in enumerate(names.split())
}  # fmt: skip

#: Errors of conditions that contradict each other.
DRIVEN_TWICE = "{} is driven twice in one component; remove one Drive"
FIXED_AND_DRIVEN = "an element is both fixed and driven in one component; subtract the regions"


def _components(owner: str, axes: str) -> tuple[int, ...]:
    instance(owner, "translation= or rotation", axes, str, "axes as text: a subset of 'xyz', or '' for none")
    if any(axis not in _AXES for axis in axes):
        raise InputError(
            f"{owner}: '{axes}' has letters that are no axes; give 'xyz' for all, a subset of it, or '' for none"
        )
    return tuple(sorted({_AXES[axis] for axis in axes}))


@dataclass(frozen=True)
class Fix:
    """Constraint that keeps elements at their positions and orientations.

    Attributes:
        region: constrained elements.
        translation: axes along which the centres are constrained, a subset of "xyz".
        rotation: axes about which the orientations are constrained, a subset of "xyz". None is "xyz", but "" where
            facets of a face of cells are held, which stay in their plane; name axes to hold their cells as well.
        friction: coefficient of friction μ of a platen [-], on a face of cells constrained along one axis. Facets
            do not slide along the face up to a shear force of μ times their normal force. None is a smooth platen,
            as is 0 in explicit runs. In static solutions facets do not slide for any number, also for 0.

    Raises:
        InputError: No axis is named or one is unknown; friction is negative, or not along a single axis on a face.
    """

    region: Region
    translation: str = "xyz"
    rotation: str | None = None
    friction: float | None = None

    def __post_init__(self) -> None:
        as_region("Fix", self.region)
        _check_friction("Fix", self.region, self.components, self.friction)
        if not self.components:
            raise InputError("Fix: no degree of freedom is held; name axes in translation= or rotation=")

    @property
    def across(self) -> int:
        """Axis along which a platen with friction presses, 0, 1 or 2."""
        return self.components[0]

    @property
    def components(self) -> tuple[int, ...]:
        """Constrained degrees of freedom: 0, 1, 2 for translations and 3, 4, 5 for rotations."""
        turns = tuple(3 + axis for axis in _components("Fix", "xyz" if self.rotation is None else self.rotation))
        return _components("Fix", self.translation) + turns


@dataclass(frozen=True, init=False)
class Drive:
    """Prescribed motion of elements; components that are not named stay free.

    `Drive(Face("x_max"), x=Ramp(0, 1e-4, 1e-3))` moves the face along x. Numbers are constant schedules.
    Displacements and rotations are measured from the reference configuration, in static and explicit solutions. A
    static solution uses the final values of the schedules. An explicit run cannot jump: schedules of displacements
    must begin at the current one of the elements, which is 0 at rest, and have no jumps afterwards.

    Attributes:
        region: elements to move.
        motion: triples of degree of freedom, schedule, and True for a velocity.

    Args:
        x, y, z: displacements [m].
        vx, vy, vz: velocities [m/s].
        rx, ry, rz: rotations of each element [rad].
        wx, wy, wz: angular velocities [rad/s].
        friction: coefficient of friction of a platen [-], see `Fix`.

    Raises:
        InputError: A component is unknown or given twice, none is given, or the friction is invalid as in `Fix`.
    """

    region: Region
    motion: tuple[tuple[int, Schedule, bool], ...]
    friction: float | None

    def __init__(self, region: Region, *, friction: float | None = None, **components: float | Schedule) -> None:
        as_region("Drive", region)
        unknown = sorted(set(components) - set(MOTIONS))
        if unknown:
            raise InputError(f"Drive: unknown component '{unknown[0]}'; choose from {', '.join(MOTIONS)}")
        if not components:
            raise InputError("Drive: no component is prescribed; name one, such as x= or vx=")
        numbers = {key: MOTIONS[key] for key in components}
        motion = tuple((k, as_schedule("Drive", key, components[key]), rate) for key, (k, rate) in numbers.items())
        if len({dof for dof, _, _ in motion}) < len(motion):
            raise InputError("Drive: give the displacement or the velocity of a component, not both")
        _check_friction("Drive", region, tuple(dof for dof, *_ in motion), friction)
        object.__setattr__(self, "friction", friction)
        object.__setattr__(self, "region", region)
        object.__setattr__(self, "motion", motion)

    @property
    def across(self) -> int:
        """Axis along which a platen with friction presses, 0, 1 or 2."""
        return self.motion[0][0]

    @property
    def arguments(self) -> dict[str, Schedule]:
        """Schedules by the name of their component, such as "x" or "wz"."""
        names = {number: name for name, number in MOTIONS.items()}
        return {names[dof, rate]: schedule for dof, schedule, rate in self.motion}


def _check_friction(owner: str, region: Region, components: tuple[int, ...], friction: object) -> None:
    """Raise InputError if a friction is negative, or its condition is not along a single axis on a face."""
    if friction is None:
        return
    number(owner, "friction", friction, least=0.0, advice="a coefficient of zero or more, or None")
    if len(components) != 1 or components[0] > 2 or len(faces_in(region)) != 1:
        raise InputError(
            f"{owner}: friction is that of a platen, which is constrained along one axis on a face; give one axis and"
            ' a bd.Face, such as bd.Fix(bd.Face("x_min"), translation="x", rotation="", friction=0.3)'
        )


@dataclass(frozen=True)
class Load:
    """A total force and moment on a region, distributed over its elements.

    Among all nodal forces with the given resultant and moment, those with the least sum of squares are applied. The
    resultant is `force` through the anchor of the region: the centre of a face, else the mean centre of its elements.
    The moment about the anchor is `moment`. Where forces on the elements cannot produce the moment (one element, or a
    row), torques supply the rest. On a face of a body of cells the load consists of the smallest tractions on the
    facets of the face.

    Forces and moments keep their direction. If the region rotates, the forces that make up its moment rotate with it,
    in explicit runs and at large rotations (`solve_static(nonlinear=True)`, `solve_relaxed`).

    Attributes:
        region: elements to load.
        force: total force [N], (3,).
        moment: total moment [N·m], (3,).
        schedule: factor over time [-], or a number for a constant factor; 1 from t = 0 by default.

    Raises:
        InputError: A vector is not three finite numbers, or a region or schedule is another object.
    """

    region: Region
    force: Triple = (0.0, 0.0, 0.0)
    moment: Triple = (0.0, 0.0, 0.0)
    schedule: Schedule = Constant(1.0)

    def __post_init__(self) -> None:
        as_region("Load", self.region)
        for name in ("force", "moment"):
            refuse_schedule("Load", name, getattr(self, name))
            object.__setattr__(self, name, vector("Load", name, getattr(self, name)))
        object.__setattr__(self, "schedule", as_schedule("Load", "schedule", self.schedule))

    def nodal(self, lattice: Lattice) -> tuple[Ints, Floats]:
        """Return elements (k,) and the force and torque on each [N, N·m], (k, 6), at full load."""
        if acts_on_facets(self.region, lattice):
            return self._tractions(lattice)
        chosen = self.region.select(lattice)
        arms = lattice.centre[chosen] - self.region.anchor(lattice)
        values = np.zeros((len(chosen), 6))
        values[:, :3] = balanced_forces(arms, np.array(self.force), np.array(self.moment))
        rest = np.array(self.moment) - np.cross(arms, values[:, :3]).sum(axis=0)
        values[:, 3:] = rest / len(chosen)
        return chosen, values

    def points(self, lattice: Lattice) -> tuple[Ints, Floats, Floats]:
        """Return the points of application of the load.

        Returns:
            The element of each point (k,), the arm from its centre [m], (k, 3), and its share of the load [-], (k,).
        """
        if not acts_on_facets(self.region, lattice):
            chosen = self.region.select(lattice)
            return chosen, np.zeros((len(chosen), 3)), np.full(len(chosen), 1.0 / len(chosen))
        chosen, owner, centre, area = patches_on("Load", self.region, lattice)
        size = np.linalg.norm(area, axis=1)
        return chosen[owner], centre - lattice.centre[chosen[owner]], size / size.sum()

    def on_facets(self, body: Lattice) -> tuple[Ints, Floats]:
        """Return the loaded facets of a body (indices into `cells.free`) and the forces at full load [N], (p, 3)."""
        _, _, centre, area = patches_on("Load", self.region, body)
        arms = centre - self.region.anchor(body)
        size = np.linalg.norm(area, axis=1)
        return facet_numbers(self.region, body), balanced_forces(
            arms, np.array(self.force), np.array(self.moment), size
        )

    def _tractions(self, body: Lattice) -> tuple[Ints, Floats]:
        """Return cells (k,) and their forces and torques [N, N·m], (k, 6), due to tractions on facets of a face."""
        chosen, owner, centre, area = patches_on("Load", self.region, body)
        size = np.linalg.norm(area, axis=1)
        arms = centre - self.region.anchor(body)
        _, force = self.on_facets(body)
        values = on_nodes(body, chosen, owner, centre, force)
        rest = np.array(self.moment) - np.cross(arms, force).sum(axis=0)
        values[:, 3:] += rest * (np.bincount(owner, weights=size) / size.sum())[:, None]
        return chosen, values


BoundaryCondition = Fix | Drive | Load | Pressure | BodyForce | Absorbing | Eigenstrain
