"""Forces of one law on a CUDA device: the launches of a step between its schedules and its motion.

Bytes on the device, in double precision:

    a beam bond   124 for bonds that differ in length only, else 164: ends 8, adjacency 4, constants 32 or 72,
                  integrity 8, force and torques 72
    a facet       196: ends 8, adjacency 4, integrity 8, k 8, levers 24, shares 24, H 24, normal 24, force and
                  torques 72, preceded there by V θ of both sides
    a cell        8, for λ / V, and 24 for its centre in the reference if walls hold any
"""

from typing import Any, NamedTuple, Protocol

import numpy as np

from bondem._compile_cuda import Array, launch, upload, zeros
from bondem.kernels.crack_tables import ACTIVE, FACET, STATUS
from bondem.kernels.cuda import sample
from bondem.kernels.cuda.bonds import bond_forces
from bondem.kernels.cuda.cells import facet_sums, stress_cells
from bondem.kernels.cuda.facets import facet_loads, swell
from bondem.kernels.cuda.guards import rotation_guard, turn_guard
from bondem.kernels.cuda.tables import DeviceBonds, DeviceElements, DeviceFacets, DeviceHolds, RowSchedules
from bondem.kernels.tables import Adjacency, GripTable, Rows, StepScheme
from bondem.model.cell_constants import CellConstants
from bondem.model.constraints import Constraints
from bondem.model.model import Model
from bondem.model.state import State


class DeviceRun(NamedTuple):
    """Data shared by the loop and the forces of its law."""

    clock: Array  #: the number of the present step, (1,)
    scheme: StepScheme
    elements: DeviceElements
    adjacency: Adjacency
    rows: Rows
    schedules: RowSchedules


class DeviceForces(Protocol):
    """Forces of a run."""

    m: int  #: bonds or facets
    forces: Array  #: force on j, torque on i and on j; (9, m)
    integrity: Array  #: 1 intact … 0 broken [-], (m,)

    def act(self, ahead: int, stream: Any = 0) -> None:
        """Compute the forces, `ahead` steps from the present one: 1, or 0 without a step."""
        ...

    def take_up(self) -> None:
        """Compute what a record needs, at the start of a run whose acceleration is known."""
        ...

    def guard(self, flags: Array) -> None:
        """Count bonds that are turned too far, as `kernels.cuda.guards` does."""
        ...

    def sums(self, parts: Array) -> None:
        """Write the four elastic energies into `parts`."""
        ...

    def keep(self, state: State) -> None:
        """Write data stored by bonds into the state."""
        ...


class BeamForces:
    """Forces of bonds that are beams."""

    def __init__(self, model: Model, state: State, run: DeviceRun) -> None:
        self._elements = run.elements
        layout, bonds = model.layout, model.bonds.stretched(state.eigenstrain)
        same = bonds.alike
        self.m = len(layout.i)
        constants = [bonds.direction, bonds.length]
        if same is None:
            constants += [bonds.kn, bonds.A, bonds.B, bonds.C, bonds.kt]
        arrays = (
            layout.i, layout.j, np.vstack(constants), np.zeros(4) if same is None else np.array(same),
            state.integrity, model.period,
        )  # fmt: skip
        self.bonds = DeviceBonds._make([self.m, *map(upload, arrays), zeros(9, self.m)])
        self.forces, self.integrity = self.bonds.forces, self.bonds.integrity

    def act(self, ahead: int, stream: Any = 0) -> None:
        """Compute the forces by one launch."""
        launch(bond_forces, self.m, self._elements, self.bonds, stream=stream)

    def take_up(self) -> None:
        """Do nothing: a record needs the poses only."""

    def guard(self, flags: Array) -> None:
        """Count by one thread per bond."""
        launch(rotation_guard, self.m, self._elements, self.bonds, flags)

    def sums(self, parts: Array) -> None:
        """Sum by one thread per part."""
        launch(sample.bond_sums, parts.shape[1], self._elements, self.bonds, parts)

    def keep(self, state: State) -> None:
        """Do nothing: beams store no data besides the poses."""


class DeviceFacetForces:
    """Forces of the facets of a body of cells, and of walls that hold some of them."""

    def __init__(self, model: Model, state: State, run: DeviceRun) -> None:
        assert model.cells is not None
        self._run = run
        layout, held = model.layout, model.constraints
        cells = model.cells.stretched(state.eigenstrain, layout)
        if model.softening is None:  # else they are weighed crack by crack
            cells = cells.damaged(state.integrity, layout.i, layout.j)
        self.m = m = len(layout.i)
        table = cells.rows(layout.i)
        arrays = (
            layout.i, layout.j, _left(state), model.period,
            table.k[:m], table.pitch, table.lever_i[:, :m], table.lever_j[:, :m], table.share_i[:, :m],
            table.share_j[:, :m], table.normal[:, :m], table.H[:, :m], table.weight,
        )  # fmt: skip
        self.facets = DeviceFacets._make([m, *map(upload, arrays), zeros(9, m)])
        self.forces, self.integrity = self.facets.forces, self.facets.integrity
        self.grips, self.holds = _holds(cells, held, model, state)

    def act(self, ahead: int, stream: Any = 0) -> None:
        """Compute the stresses of the cells, then the forces."""
        elements = self._run.elements
        self._stress(ahead, stream)
        launch(facet_loads, self.m, elements, self.facets, stream=stream)

    def take_up(self) -> None:
        """Compute the stresses, and bring walls and tractions to the present time."""
        self._stress(0, 0)

    def _stress(self, ahead: int, stream: Any) -> None:
        clock, scheme, elements, adjacency, rows, schedules = self._run
        pose, facets = elements.pose, self.facets
        launch(swell, self.m, elements, facets, stream=stream)
        # what a launch is given must fit into 4 KB: no whole tables where two of their arrays do
        launch(
            stress_cells, pose.shape[0], clock, ahead, scheme, pose, facets.weight, facets.forces, adjacency, rows,
            schedules, self.grips, self.holds, stream=stream,
        )  # fmt: skip

    def guard(self, flags: Array) -> None:
        """Count by one thread per facet."""
        launch(turn_guard, self.m, self._run.elements, self.facets, flags)

    def sums(self, parts: Array) -> None:
        """Sum by one thread per part."""
        launch(facet_sums, parts.shape[1], self._run.elements, self.facets, self.grips, self.holds, parts)

    def keep(self, state: State) -> None:
        """Do nothing: facets store no data besides the poses."""


def _left(state: State) -> np.ndarray:
    """Return integrities in the form of the loop over facets, without cracks that are treated one by one, (m,)."""
    left = state.integrity.copy()
    active = state.cracks[:, STATUS] == ACTIVE
    left[state.cracks[active, FACET].astype(np.int64)] = 0.0
    return left


def starts(rows: np.ndarray, count: int) -> np.ndarray:
    """Return the places where the entries of each row begin in `rows`, once sorted."""
    return np.concatenate([[0], np.cumsum(np.bincount(rows, minlength=count))]).astype(np.int64)


def _holds(cells: CellConstants, held: Constraints, model: Model, state: State) -> tuple[GripTable, DeviceHolds]:
    """Return walls and tractions in the order of the rows, those of a row in the order of the CPU."""
    rows = len(held.element)
    grips = cells.grips.table(model.layout, held.row_of, held.works[2], state.grips)
    order, count = np.argsort(grips.row, kind="stable"), len(grips.row)
    shared = ("rate", "times", "values", "start")
    each = {name: getattr(grips, name) for name in GripTable._fields if name != "place"}
    table = {name: upload(array if name in shared else array[order]) for name, array in each.items()}
    pressed = held.press_value[:, held.element].T  # (r, l)
    row, load = np.nonzero(pressed)
    factors = len(row)
    arrays = (
        state.rest if count else np.zeros((0, 3)), starts(grips.row, rows), starts(row, rows),
        held.press_schedule[load], pressed[row, load],
    )  # fmt: skip
    holds = DeviceHolds._make([count, *map(upload, arrays), zeros(factors), zeros(factors)])
    return GripTable(place=grips.place, **table), holds
