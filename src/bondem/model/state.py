"""The state: all arrays that change during a solution."""

from collections.abc import Sequence

import numpy as np

from bondem._checks import array, shown
from bondem._types import Floats, Pairs, PerBond, PerElement, PerElement3
from bondem.errors import InputError
from bondem.kernels.crack_tables import CRACK_COLUMNS, DEFORMATION, GAMMA, HEAT, PLASTIC_COLUMNS
from bondem.kernels.non_local import STORED, TAKEN
from bondem.kernels.soft_tables import SOFT_COLUMNS
from bondem.kernels.tables import BROKEN_COLUMNS, lines
from bondem.kernels.walls import COLUMNS, FORCE, RATE, WORK
from bondem.model.grips import reference_base
from bondem.model.loads import Eigenstrain
from bondem.model.local_origin import local_origin, local_rest
from bondem.model.origin import Origin, difference
from bondem.model.walls import Free, Servo, Wall


class State:
    """Positions, velocities and damage of all elements and bonds; see docs/decisions/0001-state.md.

    `model.state()` makes a state at rest; `set_motion`, `set_pose` and `set_eigenstrain` change it. Internal arrays
    are in the kernels' order; the properties are in the user's order.

    Attributes:
        model: model of the state, that of its last run.
        origin: origin of x, y, z in `pose` [m], shape (3,); zero unless the specimen lies far from the origin.
        pose: rows (x, y, z, spare, quaternion w x y z), shape (n, 8).
        motion: rows (velocity, 1/m, angular velocity, 1/I), shape (n, 8).
        acceleration: translational and rotational accelerations at the present pose, shape (n, 6).
        integrity: integrity of each bond, 1 intact … 0 broken, shape (m,).
        history: force and moment of each bond for the incremental formulation, (6, m), else (6, 0). For the non-local
            law: gap, extra force and its work (`bondem.kernels.non_local`), (7, m).
        stress: stress of each element in its own frame, xx, yy, zz, xy, xz, yz [Pa], (n, 6), for the non-local law;
            else (0, 6).
        eigenstrain: stress-free strain ε* of each bond [-], whose rest length is L (1 + ε*); shape (m,), or (0,)
            if none was set.
        reaction: minus the bond forces on the rows of the boundary [N, N·m], shape (r, 6).
        work: work of loads and drives on each row since the start [J], shape (r,). The works of body forces on each
            element and of strains follow, if there are any.
        loss: energy that damping has taken from each element, its present power, and energy lost to friction
            [J, W, J], shape (n, 3).
        touching: internal pairs i < j in contact, sorted by j, then i, shape (c, 2).
        stretch: tangential stretch [m] and dashpot force [N] of these contacts, shape (c, 6).
        wall_touching: internal element and wall of each contact with a wall, shape (b, 2).
        wall_stretch: tangential stretch [m] and dashpot force [N] of these contacts, shape (b, 6).
        walls: positions, velocities and loads of the walls (`bondem.kernels.walls`), shape (w, 14).
        broken: breakages in order of time: time [s], step, internal bond, mode, gap at breakage [m], energy
            released [J] and place [m]; shape (e, 9).
        released: energy that breaking bonds have released since the start [J], shape (1,).
        cracks: facets that have begun to crack, in order of time (`bondem.kernels.crack_tables`), shape (c, 13).
        plastic: plastic strain of cells and related data (`bondem.kernels.crack_tables`), (n, 17), or (0, 17) if no
            cell can yield.
        softened: beams that have begun to soften, in order of time (`bondem.kernels.soft_tables`), shape (c, 6).
        grips: initial places of the walls that hold facets of cells (`bondem.model.grips`), shape (g, 7).
        facet_force: force of each facet on its cell i [N], shape (3, m), for a body whose facets may crack; else (3,
            0).
        step: number of steps done.
        time: time [s].
        stale: True if the acceleration must be recomputed before the next step.
    """

    def __init__(self, model: Origin) -> None:
        if not hasattr(model, "layout") or not hasattr(model, "constraints"):
            raise InputError(f"State: model = {shown(model)}; give a bd.Model, or take its model.state()")
        self.model = model
        order = model.layout.order
        n, m, rows = len(order), len(model.layout.i), len(model.constraints.element)
        self.layout = model.layout
        self.rest = np.zeros((n, 3))
        self.origin = local_origin(model.lattice)
        self.rest[:] = local_rest(model.lattice)[order]
        self.pose = lines(n)
        self.pose[:, :3] = self.rest
        self.pose[:, 4] = 1.0
        self.motion = lines(n)
        self.motion[:, 3] = 1.0 / model.mass[order]
        self.motion[:, 7] = 1.0 / model.inertia[order]
        self.acceleration = np.zeros((n, 6))
        self.integrity = np.ones(m)
        stored = STORED if model.non_local is not None else 6
        self.history = np.zeros((stored, m if model.formulation == "incremental" else 0))
        self.stress = np.zeros((n if model.non_local is not None else 0, 6))
        self.eigenstrain = np.zeros(0)
        self.reaction = np.zeros((rows, 6))
        self.work = np.zeros(model.constraints.works[-1])
        self.loss = np.zeros((n, 3))
        self.touching = np.zeros((0, 2), dtype=np.int64)
        self.stretch = np.zeros((0, 6))
        self.wall_touching = np.zeros((0, 2), dtype=np.int64)
        self.wall_stretch = np.zeros((0, 6))
        self.walls = np.zeros((len(model.walls), COLUMNS))
        self._set_off((), model.walls)
        self.broken = np.zeros((0, BROKEN_COLUMNS))
        self.released = np.zeros(1)
        soft = model.softening
        self.cracks = np.zeros((0, CRACK_COLUMNS))
        self.plastic = np.zeros((n if soft is not None and soft.slip is not None else 0, PLASTIC_COLUMNS))
        self.facet_force = np.zeros((3, 0 if soft is None else m))
        self.softened = np.zeros((0, SOFT_COLUMNS))
        self.grips = reference_base(0 if model.cells is None else len(model.cells.grips.cell))
        self.step = 0
        self.time = 0.0
        self.stale = True

    ARRAYS = (
        "pose", "motion", "acceleration", "integrity", "history", "stress", "eigenstrain", "reaction", "work", "loss",
        "touching", "stretch", "wall_touching", "wall_stretch", "walls", "broken", "released",
        "cracks", "plastic", "facet_force", "softened", "grips",
    )  # fmt: skip

    # Those with as many rows as there are contacts, or broken bonds.
    GROWING = ("touching", "stretch", "wall_touching", "wall_stretch", "broken", "cracks", "softened")

    def copy(self) -> "State":
        """Return an independent copy."""
        twin = State.__new__(State)
        twin.__dict__.update(self.__dict__)
        for name in self.ARRAYS:
            setattr(twin, name, getattr(self, name).copy())
        return twin

    def begin(self, model: Origin) -> None:
        """Make this the initial state of a new run of `model`.

        The model has the same elements and bonds, under these or other conditions.
        Time, motion and bonds continue; steps, work and losses are counted from here. Boundary conditions, contacts
        and walls may differ. A wall that existed before stays at its current place; a new wall is where it is
        defined. The stiffness of bonds of the total formulation may differ too, because their forces follow from the
        poses.

        Raises:
            InputError: The state belongs to a model with other elements, masses or bonds.
        """
        other = difference(self.model, model)
        if other:
            raise InputError(
                f"state belongs to another {other}; start from a state of this model, or set positions and velocities"
                " of model.state() by set_pose and set_motion"
            )
        rows = len(model.constraints.element)
        self.reaction = np.zeros((rows, 6))
        self.work = np.zeros(model.constraints.works[-1])
        self.loss[:] = 0.0
        if model.non_local is not None:
            self.history[TAKEN] = 0.0
        if model.contact is None:
            self.touching, self.stretch = np.zeros((0, 2), dtype=np.int64), np.zeros((0, 6))
        before = self._take_walls(model.walls)
        self._set_off(before, model.walls)
        self.walls[:, WORK] = 0.0
        self.released = np.zeros(1)
        self.grips = reference_base(0 if model.cells is None else len(model.cells.grips.cell))
        self._take_damage(model)
        self.model, self.layout = model, model.layout
        self.step = 0
        self.stale = True

    def _take_damage(self, model: Origin) -> None:
        """Continue with the present cracks and plastic strains, or prepare arrays for them.

        Raises:
            InputError: The criterion of the model cannot describe the present damage.
        """
        soft, fresh = model.softening, State(model)
        if soft is None and (len(self.cracks) or self.plastic.any()):
            raise InputError("the state has cracks or plastic strains; give the model a criterion that softens too")
        if model.beam_softening is None and len(self.softened):
            raise InputError("the state has beams that soften; give the model a criterion with a fracture_energy too")
        if self.facet_force.shape != fresh.facet_force.shape:
            self.facet_force = fresh.facet_force
        if self.plastic.shape != fresh.plastic.shape:
            if self.plastic.any():
                raise InputError("the state has cells that yielded; give the model a criterion by which cells yield")
            self.plastic = fresh.plastic
        self.plastic[:, HEAT] = 0.0

    def _set_off(self, before: Sequence[Wall | None], walls: Sequence[Wall]) -> None:
        """Set velocities of walls that stand still from now on, or that become free."""
        for k, wall in enumerate(walls):
            was = before[k] if k < len(before) else None
            goes_on = was is not None and type(wall.motion) is type(was.motion)
            if isinstance(wall.motion, Free) and not goes_on:
                self.walls[k, RATE : RATE + 4] = [*wall.motion.velocity, 0.0]
            elif not (goes_on and isinstance(wall.motion, Free | Servo)):
                self.walls[k, RATE : RATE + 4] = 0.0

    def _take_walls(self, walls: Sequence[Wall]) -> list[Wall | None]:
        """Carry over displacement and contacts of walls of the same definition; return the previous wall of each."""
        rows = [wall.row.tolist() for wall in self.model.walls]
        came: list[int] = []
        for wall in walls:
            row = wall.row.tolist()
            came.append(rows.index(row) if row in rows else -1)
            if came[-1] >= 0:
                rows[came[-1]] = []  # of two walls in one place each goes on by itself
        were = [None if before < 0 else self.model.walls[before] for before in came]
        if came == list(range(len(self.walls))):
            return were
        old, number = self.walls, np.full(len(self.walls), -1)
        self.walls = np.zeros((len(came), COLUMNS))
        for new, before in enumerate(came):
            if before >= 0:
                self.walls[new], number[before] = old[before], new
        kept = number[self.wall_touching[:, 1]] >= 0
        element, wall = self.wall_touching[kept, 0], number[self.wall_touching[kept, 1]]
        order = np.lexsort((wall, element))
        self.wall_touching = np.column_stack([element, wall])[order]
        self.wall_stretch = self.wall_stretch[kept][order]
        return were

    def _by_user(self, internal: np.ndarray) -> np.ndarray:
        return internal[self.layout.rank]

    @property
    def position(self) -> PerElement3:
        """Centres [m], shape (n, 3)."""
        return self.local_position + self.origin

    @property
    def local_position(self) -> PerElement3:
        """Centres relative to `origin` [m], shape (n, 3), for accurate differences."""
        return self._by_user(self.pose[:, :3])

    @property
    def displacement(self) -> PerElement3:
        """Displacements of the centres from the reference configuration [m], shape (n, 3)."""
        return self._by_user(self.pose[:, :3] - self.rest)

    @property
    def orientation(self) -> np.ndarray:
        """Orientations as unit quaternions (w, x, y, z), shape (n, 4)."""
        return self._by_user(self.pose[:, 4:])

    @property
    def velocity(self) -> PerElement3:
        """Velocities [m/s], shape (n, 3)."""
        return self._by_user(self.motion[:, :3])

    @property
    def angular_velocity(self) -> PerElement3:
        """Angular velocities [rad/s], shape (n, 3)."""
        return self._by_user(self.motion[:, 4:7])

    @property
    def bond_integrity(self) -> PerBond:
        """Integrity of each bond, 1 intact … 0 broken, in the user's order, shape (m,)."""
        values = np.empty_like(self.integrity)
        values[self.layout.bond_order] = self.integrity
        return values

    @property
    def slipped(self) -> PerElement:
        """Accumulated plastic slip Σ Δγ of each cell [-], user's order, shape (n,); zeros if no cell can yield."""
        if not len(self.plastic):
            return np.zeros(len(self.pose))
        return self._by_user(self.plastic[:, GAMMA])

    @property
    def plastic_deformation(self) -> Floats:
        """Plastic deformation P of each cell in its frame, which scales its levers [-], user's order, (n, 3, 3)."""
        P = np.tile(np.eye(3), (len(self.pose), 1, 1))
        if len(self.plastic):
            P += self._by_user(self.plastic[:, DEFORMATION : DEFORMATION + 9]).reshape(-1, 3, 3)
        return P

    @property
    def contacts(self) -> Pairs:
        """Pairs of elements in contact, without bonded pairs, user's order, shape (c, 2)."""
        return self.layout.order[self.touching]

    @property
    def wall_displacement(self) -> Floats:
        """Displacement of each wall [m], shape (w, 3)."""
        return self.walls[:, :3].copy()

    @property
    def wall_growth(self) -> Floats:
        """Change of the radius of each cylinder or sphere [m], shape (w,)."""
        return self.walls[:, 3].copy()

    @property
    def wall_force(self) -> Floats:
        """Force of the elements on each wall [N], shape (w, 3)."""
        return self.walls[:, FORCE : FORCE + 3].copy()

    def set_motion(
        self, *, velocity: np.ndarray | None = None, angular_velocity: np.ndarray | None = None
    ) -> None:
        """Set velocities [m/s] or angular velocities [rad/s] of the elements, user's order, shape (n, 3).

        Raises:
            InputError: An array has the wrong shape or a value that is not finite.
        """
        for value, columns in ((velocity, slice(0, 3)), (angular_velocity, slice(4, 7))):
            if value is None:
                continue
            given = array("State", "velocity", value, wanted=f"finite ({len(self.pose)}, 3)")
            if given.shape != (len(self.pose), 3) or not np.isfinite(given).all():
                raise InputError(f"velocities have shape {given.shape}; give finite ({len(self.pose)}, 3)")
            self.motion[:, columns] = given[self.layout.order]
            self.stale = True

    def set_eigenstrain(self, strain: float | np.ndarray) -> None:
        """Set a stress-free strain ε* of the bonds [-] (heat, shrinkage, initial stress), user's order, (m,).

        Raises:
            InputError: The array has the wrong shape, a value is at or below -1, or the formulation is incremental.
        """
        if self.history.shape[1] > 0:
            raise InputError("eigenstrain needs stored rest lengths; use formulation='total'")
        count = len(self.integrity)
        values = array("State", "eigenstrain", strain, wanted=f"values above -1, one or ({count},)")
        if values.shape not in ((), (count,)) or not (np.isfinite(values) & (values > -1.0)).all():
            raise InputError(f"eigenstrain: give finite values above -1, one or ({count},), not {values.shape}")
        self.eigenstrain = np.broadcast_to(values, (count,))[self.layout.bond_order].copy()
        self.stale = True

    @property
    def stress_free_strain(self) -> PerBond:
        """Present strain ε* of the bonds [-], by the state and `Eigenstrain`, kernels' order, (m,); (0,) if none."""
        strain = self.eigenstrain
        for condition in self.model.boundary:
            if isinstance(condition, Eigenstrain):
                part = condition.parts(self.model.lattice)[self.layout.bond_order]
                strain = (strain if strain.size else 0.0) + condition.schedule.at(self.time) * part
        return strain

    def set_pose(self, *, position: np.ndarray | None = None, orientation: np.ndarray | None = None) -> None:
        """Move the elements to centres [m] (n, 3) and unit quaternions (n, 4), user's order.

        Raises:
            InputError: An array has the wrong shape, a value is not finite, or a quaternion has not unit length.
        """
        for value, columns in ((position, slice(0, 3)), (orientation, slice(4, 8))):
            if value is None:
                continue
            shape = self.pose[:, columns].shape
            given = array("State", "pose", value, wanted=f"finite {shape}")
            if given.shape != shape or not np.isfinite(given).all():
                raise InputError(f"poses have shape {given.shape}; give finite {shape}")
            if shape[1] == 4 and np.abs((given**2).sum(axis=1) - 1.0).max() > 1e-6:
                raise InputError("orientations are not unit quaternions (w, x, y, z); divide each by its length")
            self.pose[:, columns] = (given - self.origin if shape[1] == 3 else given)[self.layout.order]
            self.stale = True
