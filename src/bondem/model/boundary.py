"""Boundary conditions: which elements are held, driven or loaded."""

from dataclasses import dataclass

import numpy as np

from bondem._checks import instance, vector
from bondem._types import Floats, Ints
from bondem.errors import InputError
from bondem.model.balance import balanced_forces
from bondem.model.loads import (
    Absorbing,
    BodyForce,
    Eigenstrain,
    Pressure,
    facet_numbers,
    facets_on,
    is_face,
    on_nodes,
)
from bondem.model.schedules import Constant, Schedule, as_schedule
from bondem.specimen.lattice import Lattice
from bondem.specimen.regions import Region, as_region

_AXES = {"x": 0, "y": 1, "z": 2}


def _components(owner: str, axes: str) -> tuple[int, ...]:
    instance(owner, "translation= or rotation", axes, str, "axes as text: a subset of 'xyz', or '' for none")
    if any(axis not in _AXES for axis in axes):
        raise InputError(f"{owner}: '{axes}' names no axes; give a subset of 'xyz', or '' for none")
    return tuple(sorted({_AXES[axis] for axis in axes}))


@dataclass(frozen=True)
class Fix:
    """Hold elements still.

    Attributes:
        region: who.
        translation: axes along which the centres are held.
        rotation: axes about which the orientations are held.
    """

    region: Region
    translation: str = "xyz"
    rotation: str = "xyz"

    def __post_init__(self) -> None:
        as_region("Fix", self.region)
        if not self.components:
            raise InputError("Fix holds nothing; name axes in translation= or rotation=")

    @property
    def components(self) -> tuple[int, ...]:
        """Degrees of freedom held: 0, 1, 2 translations, 3, 4, 5 rotations."""
        turns = tuple(3 + axis for axis in _components("Fix", self.rotation))
        return _components("Fix", self.translation) + turns


@dataclass(frozen=True, init=False)
class Drive:
    """Prescribe the motion of elements; what is not named stays free.

    `Drive(Face("x_max"), x=Ramp(0, 1e-4, 1e-3))` moves the face along x. Numbers are constant schedules.
    Displacements and rotations count from the reference configuration, in static and explicit solutions alike. A
    static solution takes them at the end of their schedules. An explicit run cannot jump: its schedules must begin
    where the elements are, at 0 from rest.

    Attributes:
        region: who.
        motion: (degree of freedom, schedule, whether it is a velocity) triples.

    Args:
        x, y, z: displacements [m].
        vx, vy, vz: velocities [m/s].
        rx, ry, rz: rotations of each element [rad].
        wx, wy, wz: angular velocities [rad/s].
    """

    region: Region
    motion: tuple[tuple[int, Schedule, bool], ...]

    def __init__(self, region: Region, **components: float | Schedule) -> None:
        as_region("Drive", region)
        names = {}
        for k, axis in enumerate("xyz"):
            names |= {axis: (k, False), "v" + axis: (k, True), "r" + axis: (3 + k, False), "w" + axis: (3 + k, True)}
        unknown = sorted(set(components) - set(names))
        if unknown:
            raise InputError(f"Drive: unknown component '{unknown[0]}'; choose from {', '.join(names)}")
        if not components:
            raise InputError("Drive prescribes nothing; name a component, such as x= or vx=")
        motion = tuple(
            (names[key][0], as_schedule("Drive", key, value), names[key][1]) for key, value in components.items()
        )
        if len({dof for dof, _, _ in motion}) < len(motion):
            raise InputError("Drive: give the displacement or the velocity of a component, not both")
        object.__setattr__(self, "region", region)
        object.__setattr__(self, "motion", motion)


@dataclass(frozen=True)
class Load:
    """A total force and moment on a region, spread over its elements without a net moment of its own.

    The nodal forces are the smallest (in the sum of squares) whose resultant is `force` through the region's
    anchor (the centre of a face, else the centroid) and whose moment about it is `moment`. Where the elements
    cannot carry a moment by forces (one element, or a row), they get torques for the rest. On a face of a body of
    cells they are the smallest tractions, on the facets of the face. Forces and moments keep their direction; where
    the region turns, the forces that make up its moment turn with it, in explicit runs and at large rotations
    (`solve_static(nonlinear=True)`, `solve_relaxed`).

    Attributes:
        region: who.
        force: total force [N], (3,).
        moment: total moment [N·m], (3,).
        schedule: factor over time [-]; constant from t = 0 unless given; a number is constant.
    """

    region: Region
    force: tuple[float, float, float] = (0.0, 0.0, 0.0)
    moment: tuple[float, float, float] = (0.0, 0.0, 0.0)
    schedule: Schedule = Constant(1.0)

    def __post_init__(self) -> None:
        as_region("Load", self.region)
        for name in ("force", "moment"):
            object.__setattr__(self, name, vector("Load", name, getattr(self, name)))
        object.__setattr__(self, "schedule", as_schedule("Load", "schedule", self.schedule))

    def nodal(self, lattice: Lattice) -> tuple[Ints, Floats]:
        """Elements (k,) and the force and torque on each [N, N·m], (k, 6), at full load."""
        if lattice.cells is not None and is_face(self.region):
            return self._tractions(lattice)
        chosen = self.region.select(lattice)
        arms = lattice.centre[chosen] - self.region.anchor(lattice)
        values = np.zeros((len(chosen), 6))
        values[:, :3] = balanced_forces(arms, np.array(self.force), np.array(self.moment))
        rest = np.array(self.moment) - np.cross(arms, values[:, :3]).sum(axis=0)
        values[:, 3:] = rest / len(chosen)
        return chosen, values

    def points(self, lattice: Lattice) -> tuple[Ints, Floats, Floats]:
        """Where it acts: the element of each point, the arm from its centre [m], (k, 3), and its share of 1, (k,)."""
        if lattice.cells is None or not is_face(self.region):
            chosen = self.region.select(lattice)
            return chosen, np.zeros((len(chosen), 3)), np.full(len(chosen), 1.0 / len(chosen))
        chosen, owner, centre, area = facets_on(self.region, lattice)
        size = np.linalg.norm(area, axis=1)
        return chosen[owner], centre - lattice.centre[chosen[owner]], size / size.sum()

    def on_facets(self, body: Lattice) -> tuple[Ints, Floats]:
        """Facets of a face of a body, numbers in `cells.free`, and the force on each [N], (p, 3), at full load."""
        _, _, centre, area = facets_on(self.region, body)
        arms = centre - self.region.anchor(body)
        size = np.linalg.norm(area, axis=1)
        return facet_numbers(self.region, body), balanced_forces(
            arms, np.array(self.force), np.array(self.moment), size
        )

    def _tractions(self, body: Lattice) -> tuple[Ints, Floats]:
        """The same as `nodal` by tractions on the facets that cells have on a face."""
        chosen, owner, centre, area = facets_on(self.region, body)
        size = np.linalg.norm(area, axis=1)
        arms = centre - self.region.anchor(body)
        _, force = self.on_facets(body)
        values = on_nodes(body, chosen, owner, centre, force)
        rest = np.array(self.moment) - np.cross(arms, force).sum(axis=0)
        values[:, 3:] += rest * (np.bincount(owner, weights=size) / size.sum())[:, None]
        return chosen, values


BoundaryCondition = Fix | Drive | Load | Pressure | BodyForce | Absorbing | Eigenstrain
