"""The state: all arrays that change during a solution."""

from collections.abc import Sequence

import numpy as np

from bondem._cache_lines import lines
from bondem._checks import array, instance, number, shown
from bondem._names import meant
from bondem._tables.columns import EventColumn, PlasticColumn, SoftColumn
from bondem._types import ArrayLike, Floats, Pairs, PerBond, PerElement
from bondem.boundary.loads import Eigenstrain
from bondem.boundary.wall_constraints import reference_base
from bondem.boundary.wall_rows import wall_rows, walls_at_rest
from bondem.boundary.walls import Wall
from bondem.damage.crack_columns import CRACK_COLUMNS, ONSET_STEP
from bondem.damage.crushing import crushing_of
from bondem.errors import InputError
from bondem.interactions.contact.contact_columns import CONTACT_COLUMNS, in_contact
from bondem.interactions.interaction import Arrays, Interaction
from bondem.model.state_compatibility import Origin, difference
from bondem.model.state_motion import StateMotion
from bondem.model.state_walls import known_walls, rows_of_walls, set_off
from bondem.specimen.local_origin import local_origin, local_rest
from bondem.specimen.particles import freeze

_INTERNAL = (
    "ARRAYS", "GROWING", "arrays", "layout", "local_position", "of_law", "origin", "rest", "rest_strain", "stale",
)  # fmt: skip
_SETTABLE = "position", "displacement", "orientation", "velocity", "angular_velocity", "bond_eigenstrain"


class State(StateMotion):
    """Positions, velocities and damage of all elements and bonds; see docs/decisions/0001-state.md.

    `model.state()` makes a state at rest. The properties `position`, `displacement`, `orientation`, `velocity`,
    `angular_velocity` and `bond_eigenstrain` can be assigned. Except for `position`, one value may be given for all:
    `state.velocity = (0, 0, -5.0)`. The arrays that properties return are read-only, in the user's order of elements
    and bonds.

    Attributes:
        model: model of the state, that of its last run.
        step: number of steps of the run; each run that continues from a state counts from zero.
        time: time [s], which continues.

    Arrays of the solvers, in internal order; `dir` does not list them:

    - `origin`: origin of x, y, z in `pose` [m], shape (3,); zero unless the specimen lies far from the origin.
    - `pose`: rows (x, y, z [m], stress λ θ of a cell [Pa], quaternion w x y z), shape (n, 8).
    - `motion`: rows (velocity [m/s], 1/m [1/kg], angular velocity [rad/s], 1/I [1/kg·m²]), shape (n, 8).
    - `acceleration`: accelerations at the present pose [m/s², rad/s²], shape (n, 6).
    - `integrity`: integrity of each bond, 1 intact … 0 broken, shape (m,).
    - `history`: data that the law stores per bond: force and moment of the incremental formulation, (6, m), or gap,
      extra force and its work of the non-local law, (7, m); else (6, 0).
    - `stress`: stress of each element in its own frame, xx, yy, zz, xy, xz, yz [Pa], (n, 6), for the non-local law;
      else (0, 6). A law may define arrays of other names, which follow all others in run files.
    - `eigenstrain`: ε* of each bond [-], whose rest length is L (1 + ε*); shape (m,), or (0,) if none was set.
    - `reaction`: minus the bond forces on the elements of `Constraints.element` [N, N·m], shape (r, 6).
    - `work`: work of loads, drives and walls that constrain cells on each of these elements since the start [J],
      (r,). The works of body forces on each element and of strains follow, if there are any.
    - `loss`: energy that damping has dissipated at each element, the present power of damping, and energy that
      friction has dissipated [J, W, J], shape (n, 3).
    - `touching`: internal pairs i < j in contact or with faces between them, sorted by j, then i, shape (c, 2).
    - `stretch`: memory of these contacts, columns of `contact_columns`, shape (c, 9).
    - `wall_touching`: internal element and wall of each contact with a wall, shape (b, 2).
    - `wall_stretch`: tangential stretch [m] and dashpot force [N] of these contacts, shape (b, 6).
    - `rolled`, `wall_rolled`: R̄ times the rotation that contacts store, if they resist it [m], (c, 3), (b, 3).
    - `walls`: positions, velocities and loads of the walls (`bondem.boundary.wall_rows`), shape (w, 27).
    - `broken`: breakages in order of time (`EventColumn` of `bondem._tables.columns`), shape (e, 10).
    - `released`: energy that breaking bonds have released since the start [J], shape (1,).
    - `crushed`: energy that facets or beams had released by crushing before the run began [J], shape (1,).
    - `cracks`: facets that have begun to crack, in order of time (`bondem.damage.crack_columns`), shape (c, 30).
    - `plastic`, `held_slip`: memory of cells that yield (`PlasticColumn`), shapes (n, 17) and (n,), or no rows.
    - `softened`: beams that have begun to soften, in order of time (`SoftColumn`), shape (c, 7).
    - `grips`: origins of walls that constrain facets of cells (`bondem.boundary.wall_constraints`), shape (g, 7).
    - `facet_force`: force of each facet on its cell i [N], (3, m), if facets may crack; else (3, 0).
    - `stale`: True if forces and accelerations must be computed anew from the pose, as at the start of each run.
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
        self.history, self.stress = np.zeros((6, 0)), np.zeros((0, 6))
        for field in model.interaction.fields:
            setattr(self, field.name, field.zeros(n=n, m=m))
        self.eigenstrain = np.zeros(0)
        self.reaction = np.zeros((rows, 6))
        self.work = np.zeros(model.constraints.works[-1])
        self.loss = np.zeros((n, 3))
        self.touching, self.stretch = np.zeros((0, 2), dtype=np.int64), np.zeros((0, CONTACT_COLUMNS))
        self.wall_touching = np.zeros((0, 2), dtype=np.int64)
        self.wall_stretch = np.zeros((0, 6))
        self.rolled, self.wall_rolled = np.zeros((2, 0, 3))
        self.walls = walls_at_rest(len(model.walls))
        set_off(self.walls, (), model.walls)
        self.broken = np.zeros((0, EventColumn.COUNT))
        self.released, self.crushed = np.zeros((2, 1))
        soft = model.softening
        self.cracks = np.zeros((0, CRACK_COLUMNS))
        self.plastic = np.zeros((n * len(model.yielding), PlasticColumn.COUNT))
        self.held_slip = np.zeros(len(self.plastic))
        self.facet_force = np.zeros((3, 0 if soft is None else m))
        self.softened = np.zeros((0, SoftColumn.COUNT))
        self.grips = reference_base(len(model.interaction.supports.cell))
        self.step, self.time, self.stale = 0, 0.0, True

    ARRAYS = (
        "pose", "motion", "acceleration", "integrity", "history", "stress", "eigenstrain", "reaction", "work", "loss",
        "touching", "stretch", "wall_touching", "wall_stretch", "rolled", "wall_rolled", "walls", "broken",
        "released", "crushed", "cracks", "plastic", "held_slip", "facet_force", "softened", "grips",
    )  # fmt: skip

    # Arrays whose number of rows changes during a run.
    GROWING = (
        "touching", "stretch", "wall_touching", "wall_stretch", "rolled", "wall_rolled", "broken", "cracks",
        "softened",
    )  # fmt: skip

    _SCALARS = ("model", "layout", "rest", "origin", "step", "time", "stale")

    def __setattr__(self, name: str, value: object) -> None:
        """Set a quantity of the state.

        Raises:
            InputError: The name is unknown, the quantity cannot be set, or the value is no array or time.
        """
        known = getattr(type(self), name, None)
        if isinstance(known, property):
            if known.fset is None:
                raise InputError(f"State: {name} cannot be set; it follows from {', '.join(_SETTABLE)}; set these")
        elif name in self.ARRAYS or (name not in self._SCALARS and name in self.arrays):
            instance("State", name, value, np.ndarray, "an array in the internal order, or set a property")
        elif name == "time":
            value = number("State", "time", value, unit="s", advice="a finite time")
        elif name not in self._SCALARS:
            raise InputError(f"State: there is no quantity '{name}' to set{meant(name, dir(self))}")
        object.__setattr__(self, name, value)

    def __dir__(self) -> list[str]:
        return [name for name in object.__dir__(self) if name not in {*self.arrays, *_INTERNAL}]

    @property
    def arrays(self) -> tuple[str, ...]:
        """Names of all arrays; those that only the bond law of the model defines come last."""
        own = (field.name for field in self.model.interaction.fields)
        return *self.ARRAYS, *(name for name in own if name not in self.ARRAYS)

    def copy(self) -> "State":
        """Return an independent copy."""
        twin = State.__new__(State)
        twin.__dict__.update(self.__dict__ | {name: getattr(self, name).copy() for name in self.arrays})
        return twin

    __copy__ = copy  # the module copy would share the arrays

    def begin(self, model: Origin) -> None:
        """Make this state the initial state of a new run of `model`.

        The model has the same elements and bonds, under the same or other conditions. Time, motion and bonds
        continue; steps, work and losses are counted from here. Boundary conditions, contacts and walls may differ. A
        wall that existed before stays at its current place; a new wall is where it is defined. The stiffness of bonds
        of the total formulation may differ too, because their forces follow from the poses.

        Raises:
            InputError: The state is of other elements, masses or bonds, or has damage unknown to the criterion.
        """
        other = difference(self.model, model)
        if other:
            raise InputError(f"state belongs to another {other}; start from one of this model, or set model.state()")
        fresh = State(model)
        for name in ("reaction", "work", "loss", "released", "grips"):
            setattr(self, name, getattr(fresh, name))
        for field in model.interaction.fields:
            getattr(self, field.name)[list(field.fresh)] = 0.0
        laws = model.contact_laws
        if not laws.laws:
            self.touching, self.stretch = fresh.touching, fresh.stretch
        if not laws.rolls:
            self.rolled, self.wall_rolled = fresh.rolled, fresh.wall_rolled
        before = self._take_walls(model.walls)
        set_off(self.walls, before, model.walls)
        wall_rows(self.walls)["work"] = 0.0
        self._take_damage(fresh)
        self.model, self.layout = model, model.layout
        self.step = 0
        self.stale = True

    def _take_damage(self, fresh: "State") -> None:
        """Continue with the present cracks and plastic strains, or take the arrays of a new state for them.

        Raises:
            InputError: The criterion of the model of the new state cannot describe the present damage.
        """
        model, soft = fresh.model, fresh.model.softening
        if soft is None and (len(self.cracks) or self.plastic.any()):
            raise InputError("the state has cracks or plastic strains; give the model a criterion that softens too")
        if model.beam_softening is None and len(self.softened):
            raise InputError("the state has beams that soften; give the model a criterion with a fracture_energy too")
        if self.facet_force.shape != fresh.facet_force.shape:
            self.facet_force = fresh.facet_force
        if self.plastic.shape != fresh.plastic.shape:
            if self.plastic.any():
                raise InputError("the state has cells that yielded; give the model a criterion by which cells yield")
            self.plastic, self.held_slip = fresh.plastic, fresh.held_slip
        self.plastic[:, PlasticColumn.HEAT] = 0.0
        for rows, column in ((self.cracks, ONSET_STEP), (self.softened, SoftColumn.BEGAN)):
            rows[:, column] -= self.step  # steps are counted from the start of this run
        self.crushed = crushing_of(soft, model.beam_softening, self.cracks, self.softened)

    def _take_walls(self, walls: Sequence[Wall]) -> list[Wall | None]:
        """Keep rows and contacts of walls defined as before; return the previous wall of each wall, or None."""
        previous = known_walls(self.model.walls, walls)
        if previous != list(range(len(self.walls))):
            rolled = self.wall_rolled if len(self.wall_rolled) else np.zeros((len(self.wall_stretch), 0))
            memory = np.hstack([self.wall_stretch, rolled])
            self.walls, self.wall_touching, memory = rows_of_walls(previous, self.walls, self.wall_touching, memory)
            self.wall_stretch = np.ascontiguousarray(memory[:, :6])
            self.wall_rolled = np.ascontiguousarray(memory[:, 6:]).reshape(-1, 3)
        return [None if before < 0 else self.model.walls[before] for before in previous]

    @property
    def bond_integrity(self) -> PerBond:
        """Integrity of each bond, 1 intact … 0 broken, in the user's order, shape (m,)."""
        return self._bonds_by_user(self.integrity)

    def _bonds_by_user(self, internal: PerBond) -> PerBond:
        values = np.empty_like(internal)
        values[self.layout.bond_order] = internal
        return freeze(values)

    @property
    def bond_eigenstrain(self) -> PerBond:
        """Stress-free strain ε* of each bond besides `Eigenstrain` [-], (m,). Assign as by `set_eigenstrain`."""
        if not self.eigenstrain.size:
            return freeze(np.zeros(len(self.integrity)))
        return self._bonds_by_user(self.eigenstrain)

    @bond_eigenstrain.setter
    def bond_eigenstrain(self, given: ArrayLike) -> None:
        self.set_eigenstrain(np.asarray(given))

    @property
    def stress_free_strain(self) -> PerBond:
        """Present eigenstrain ε* of the bonds [-]: that of the state plus `Eigenstrain`, user's order, shape (m,)."""
        strain = self.rest_strain
        return self._bonds_by_user(strain) if strain.size else freeze(np.zeros(len(self.integrity)))

    @property
    def slipped(self) -> PerElement:
        """Accumulated plastic slip Σ Δγ of each cell [-], user's order, shape (n,); zeros if no cell can yield."""
        if not len(self.plastic):
            return freeze(np.zeros(len(self.pose)))
        return self._by_user(self.plastic[:, PlasticColumn.GAMMA])

    @property
    def plastic_deformation(self) -> Floats:
        """Plastic deformation P of each cell in its frame [-], user's order, (n, 3, 3); P multiplies its levers."""
        P = np.tile(np.eye(3), (len(self.pose), 1, 1))
        if len(self.plastic):
            P += self._by_user(self.plastic[:, : PlasticColumn.GAMMA]).reshape(-1, 3, 3)
        return freeze(P)

    @property
    def contacts(self) -> Pairs:
        """Pairs of elements in contact, user's order, (c, 2); bonded pairs only if the law has `parallel=True`."""
        return freeze(self.layout.order[self.touching[in_contact(self.stretch)]])

    @property
    def wall_displacement(self) -> Floats:
        """Displacement of the point about which each wall turns [m], shape (w, 3)."""
        return freeze(wall_rows(self.walls)["displacement"].copy())

    @property
    def wall_growth(self) -> Floats:
        """Change of the radius of each cylinder or sphere [m], shape (w,)."""
        return freeze(wall_rows(self.walls)["growth"].copy())

    @property
    def wall_force(self) -> Floats:
        """Force of the elements on each wall [N], shape (w, 3)."""
        return freeze(wall_rows(self.walls)["force"].copy())

    @property
    def wall_torque(self) -> Floats:
        """Torque of the elements on each wall, about the point about which it turns [N·m], shape (w, 3)."""
        return freeze(wall_rows(self.walls)["torque"].copy())

    @property
    def wall_orientation(self) -> Floats:
        """Orientation of each wall against the reference, unit quaternions w x y z, shape (w, 4)."""
        return freeze(wall_rows(self.walls)["orientation"].copy())

    def set_eigenstrain(self, strain: float | np.ndarray) -> None:
        """Set a stress-free strain ε* of the bonds [-] (heat, shrinkage), user's order, (m,), or one value for all.

        Raises:
            InputError: The shape is wrong, a value is not finite or not above -1, or the formulation is incremental.
        """
        require_strains(self.model.interaction, "eigenstrain")
        count = len(self.integrity)
        values = array("State", "eigenstrain", strain, wanted=f"values above -1, one or ({count},)")
        if values.shape not in ((), (count,)) or not (np.isfinite(values) & (values > -1.0)).all():
            raise InputError(f"eigenstrain: give finite values above -1, one or ({count},), not {values.shape}")
        self.eigenstrain = np.broadcast_to(values, (count,))[self.layout.bond_order].copy()
        self.stale = True

    @property
    def of_law(self) -> Arrays:
        """Arrays of the state that the bond law reads, by name, internal order."""
        own = {field.name: getattr(self, field.name) for field in self.model.interaction.fields}
        return own | {"integrity": self.integrity, "rest_strain": self.rest_strain}

    @property
    def rest_strain(self) -> PerBond:
        """Present eigenstrain ε* of the bonds [-], of the state and `Eigenstrain`, internal order; (0,) if none."""
        strain = self.eigenstrain
        for condition in self.model.boundary:
            if isinstance(condition, Eigenstrain):
                part = condition.parts(self.model.lattice)[self.layout.bond_order]
                strain = (strain if strain.size else 0.0) + condition.schedule.at(self.time) * part
        return strain


def require_strains(law: Interaction, owner: str) -> None:
    """Raise InputError if bonds of a law have no rest lengths, which the stress-free strains of `owner` change."""
    if not law.strains:
        cure = "use formulation='total'" if law.evaluated == "force" else f"{law.name} has none; use bd.CellBond"
        raise InputError(f"{owner} needs stored rest lengths; {cure}")
