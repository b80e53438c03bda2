"""Properties by which users read and set positions, orientations and velocities of a state."""

import numpy as np

from bondem._checks import array, vector
from bondem._types import ArrayLike, Floats, PerElement3, Triple
from bondem.errors import InputError
from bondem.model.state_compatibility import Origin
from bondem.specimen.ordering import Layout
from bondem.specimen.particles import freeze
from bondem.specimen.regions import Region, as_region


class StateMotion:
    """Positions, orientations and velocities of the n elements of a state, as properties in the user's order."""

    model: Origin
    layout: Layout
    origin: Floats
    rest: Floats
    pose: Floats
    motion: Floats
    stale: bool

    def _by_user(self, internal: np.ndarray) -> np.ndarray:
        return freeze(internal[self.layout.rank])

    def _rows(self, name: str, given: ArrayLike, columns: int, *, broadcast: bool = True) -> Floats:
        """Return rows of all elements, internal order, from one row, or from one row per element in user's order.

        Raises:
            InputError: The shape is wrong, or a value is not finite.
        """
        shape = len(self.pose), columns
        one = f"({columns},) for all elements, or " if broadcast else ""
        wanted = f"finite numbers of shape {one}{shape} in the user's order"
        values = array("State", name, given, wanted=wanted)
        uniform = broadcast and (values.shape == (columns,) or (columns == 3 and values.ndim == 0 and values == 0.0))
        if not (uniform or values.shape == shape) or not np.isfinite(values).all():
            raise InputError(f"State: {name} has shape {values.shape} or is not finite; give {wanted}")
        return np.broadcast_to(values, shape)[self.layout.order]

    @property
    def position(self) -> PerElement3:
        """Centres [m], shape (n, 3). Assign finite values of this shape; others raise InputError."""
        return freeze(self.local_position + self.origin)

    @position.setter
    def position(self, given: ArrayLike) -> None:
        self.pose[:, :3] = self._rows("position", given, 3, broadcast=False) - self.origin
        self.stale = True

    @property
    def local_position(self) -> PerElement3:
        """Centres relative to `origin` [m], shape (n, 3), for accurate differences."""
        return self._by_user(self.pose[:, :3])

    @property
    def displacement(self) -> PerElement3:
        """Displacements [m], (n, 3). Assign finite (n, 3), or (3,) for all; others raise InputError."""
        return self._by_user(self.pose[:, :3] - self.rest)

    @displacement.setter
    def displacement(self, given: ArrayLike) -> None:
        self.pose[:, :3] = self.rest + self._rows("displacement", given, 3)
        self.stale = True

    @property
    def orientation(self) -> np.ndarray:
        """Orientations, unit quaternions w x y z, (n, 4). Assign (n, 4), or (4,) for all; others raise InputError."""
        return self._by_user(self.pose[:, 4:])

    @orientation.setter
    def orientation(self, given: ArrayLike) -> None:
        rows = self._rows("orientation", given, 4)
        if np.abs((rows**2).sum(axis=1) - 1.0).max() > 1e-6:
            raise InputError("orientations are not unit quaternions (w, x, y, z); divide each by its length")
        self.pose[:, 4:8] = rows
        self.stale = True

    @property
    def velocity(self) -> PerElement3:
        """Velocities of the centres [m/s], (n, 3). Assign finite (n, 3), or (3,) for all; others raise InputError."""
        return self._by_user(self.motion[:, :3])

    @velocity.setter
    def velocity(self, given: ArrayLike) -> None:
        self.motion[:, 0:3] = self._rows("velocity", given, 3)

    @property
    def angular_velocity(self) -> PerElement3:
        """Angular velocities [rad/s], (n, 3). Assign finite (n, 3), or (3,) for all; others raise InputError."""
        return self._by_user(self.motion[:, 4:7])

    @angular_velocity.setter
    def angular_velocity(self, given: ArrayLike) -> None:
        self.motion[:, 4:7] = self._rows("angular_velocity", given, 3)

    def set_motion(self, *, velocity: np.ndarray | None = None, angular_velocity: np.ndarray | None = None) -> None:
        """Set velocities [m/s] or angular velocities [rad/s] of the elements, user's order, (n, 3), or (3,) for all.

        Raises:
            InputError: An array has the wrong shape or a value that is not finite.
        """
        for name, value in (("velocity", velocity), ("angular_velocity", angular_velocity)):
            if value is not None:
                setattr(self, name, value)

    def set_velocity(
        self, region: Region, velocity: Triple, *, spin: Triple = (0.0, 0.0, 0.0), about: Triple | None = None
    ) -> None:
        """Set velocities of a region to those of a rigid body, v + ω × (x - about), and angular velocities to ω.

        Args:
            region: elements to move, rattlers included; others keep their velocities.
            velocity: v [m/s], (3,).
            spin: ω [rad/s], (3,).
            about: point that moves with v [m], (3,); the centre of mass of the elements unless given.

        Raises:
            InputError: `region` is no region, or a vector is not three finite components.
            EmptyRegionError: No element matches.
        """
        owner, lattice = "State.set_velocity", self.model.lattice
        chosen = np.flatnonzero(as_region(owner, region).with_rattlers(lattice))
        v, w = (np.array(vector(owner, *given)) for given in (("velocity", velocity), ("spin", spin)))
        position = self.position[chosen]
        if about is None:
            centre = np.average(position, axis=0, weights=self.model.mass[chosen])
        else:
            centre = np.array(vector(owner, "about", about, unit="m"))
        rows = self.layout.rank[chosen]
        self.motion[rows, 0:3] = v + np.cross(w, position - centre)
        self.motion[rows, 4:7] = w

    def set_pose(self, *, position: np.ndarray | None = None, orientation: np.ndarray | None = None) -> None:
        """Move the elements to centres [m] (n, 3) and unit quaternions (n, 4), user's order.

        Raises:
            InputError: An array has the wrong shape, a value is not finite, or a quaternion has not unit length.
        """
        for name, value in (("position", position), ("orientation", orientation)):
            if value is not None:
                setattr(self, name, value)
