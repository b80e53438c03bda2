"""The loop of the CPU, which gathers the arguments of the compiled steps once."""

import numpy as np

from bondem._compile import current_threads
from bondem.errors import InputError
from bondem.kernels import tables
from bondem.kernels.advance import FINE, NOT_FINITE, SERIAL_BONDS, advance
from bondem.kernels.cell_strain import strain_body
from bondem.kernels.crack_tables import FACET
from bondem.kernels.facet_breaking import weigh_all
from bondem.kernels.tables import (
    CONTACT,
    FIXED_COLUMNS,
    TRANSLATION,
    Body,
    ContactTable,
    Elements,
    Gauges,
    PressTable,
    Run,
    Span,
)
from bondem.laws.damping import DampingTerms
from bondem.model.blocks import Blocks
from bondem.model.bond_table import with_zeros
from bondem.model.gauges import AnyGauge, Gauge
from bondem.model.model import Model
from bondem.model.state import State
from bondem.solve.added import added, changing_cells, changing_strain
from bondem.solve.breakage import breaking, keep_broken, keep_softened, soft_bonds
from bondem.solve.contact_check import ContactCheck
from bondem.solve.cracks import crack_table, joints, keep_cracks, take_up, with_forces
from bondem.solve.neighbour_list import ContactList
from bondem.solve.plan import Plan

# Elements of a block: they stay in the L2 cache from their bonds to their motion.
BLOCK = 4000
# Bonds of a thread at least.
_DOMAIN = SERIAL_BONDS // 4
# Elements that move by this share of their radius a step have an energy that no guard minds.
_STILL = 1e-6

_QUANTITIES = {
    "displacement": tables.OF_DISPLACEMENT,
    "velocity": tables.OF_VELOCITY,
    "rotation": tables.OF_ROTATION,
    "angular_velocity": tables.OF_SPIN,
    "force": tables.OF_FORCE,
}
_WALL_QUANTITIES = {
    "displacement": tables.WALL_DISPLACEMENT, "velocity": tables.WALL_VELOCITY, "force": tables.WALL_FORCE,
    "growth": tables.WALL_GROWTH,
}  # fmt: skip
_REDUCTIONS = {"mean": tables.MEAN, "sum": tables.SUM, "max_abs": tables.LARGEST}


class CpuLoop:
    """The tables of one run, and the calls that advance it."""

    def __init__(self, model: Model, plan: Plan, state: State, dt: float) -> None:
        self.state = state
        self._every = int(plan.every)
        self._origin = state.time - state.step * dt
        self._width = FIXED_COLUMNS + 3 * len(plan.gauges)
        layout, held = model.layout, model.constraints
        terms = DampingTerms.of(plan.damping)
        self._scheme = tables.StepScheme(dt, *plan.scheme.coefficients(dt), terms.gamma, self._origin)
        bonds = model.bonds.stretched(state.eigenstrain)
        changing = len(held.strain_part) > 0 and model.cells is None
        if changing:  # their lengths change while it runs
            bonds = bonds.separate()
        self._same = None if changing or model.cells is not None or model.non_local is not None else bonds.alike
        domains = 1
        if len(layout.i) >= SERIAL_BONDS:
            domains = min(current_threads(), len(layout.i) // _DOMAIN)
        blocks = Blocks.of(layout, BLOCK, domains, held.row_of >= 0)
        # elements that wait for breaking bonds keep their sums in rows of their own
        waiting = 0 if model.breaking is None else len(layout.order)
        self._breaks = breaking(model, state, blocks)
        cracked = np.zeros(len(layout.i), dtype=bool)
        cracked[state.cracks[:, FACET].astype(np.int64)] = True
        # facets that crack are no part of the loop over facets
        left = np.where(cracked, 0.0, state.integrity)
        rows = bonds.rows(layout, model.period, left, alike=self._same is not None)
        self._contacts = None
        if model.contacts is not None:
            self._contacts = ContactList(model, model.contacts, state, joints(model, state, rows.integrity))
            self._check = ContactCheck(model.contacts, dt)
        load = np.zeros(0)
        if self._contacts is not None:
            load = self._contacts.arrays.load
        elif model.softening is not None or model.beam_softening is not None:
            load = np.zeros((len(state.pose), 6))
        self._soft = soft_bonds(model, state, load)
        self._run = Run(
            elements=Elements(state.pose, state.motion, state.acceleration, state.loss, state.rest, load),
            bonds=rows,
            cut=blocks.table(waiting),
            rows=held.rows(state.reaction, state.work),
            schedules=held.schedules,
            gauges=gauge_tables(model, plan),
            budget=np.zeros(2),  # as `kernels.advance.guard` has it
        )
        self._still = noticeable(model, dt)
        self._body, self._cracks = None, None
        if model.cells is not None:
            strained = model.cells.stretched(state.eigenstrain, layout)
            if model.softening is None:
                strained = strained.damaged(state.integrity, layout.i, layout.j)
            grips = strained.grips.table(layout, held.row_of, held.works[2], state.grips)
            presses = PressTable(
                value=held.press_value, schedule=held.press_schedule, place=held.works[2],
                factor=np.zeros(len(held.press_schedule)), came=np.zeros(len(held.press_schedule)),
            )  # fmt: skip
            table = strained.rows(blocks.own_places(layout))
            if model.softening is not None:
                table = with_forces(table, model, state, blocks.rows)
            self._cracks = crack_table(model, state, table, grips, load, dt)
            self._body = Body(table, grips, presses, self._cracks, changing_cells(model, state))
            now = self._origin + state.step * dt
            strain_body(now, dt, True, held.schedules, self._body, self._body.strain)
            if self._cracks is not None:
                take_up(state.pose, self._run.bonds, table, grips, self._cracks)
            if self._breaks is not None:  # as they are weighed anew where a facet breaks, to the bit
                weigh_all(self._run.bonds, self._body.cells, self._breaks)
        self._added = added(model, terms, state, blocks.rows + waiting)
        self._strain = changing_strain(model, state) if model.cells is None else None
        self._history = with_zeros(state.history) if model.formulation == "incremental" else None
        self._non_local = None
        if model.non_local is not None and self._history is not None:
            self._non_local = model.non_local.rows(self._history, state.stress, blocks.own_places(layout))

    @property
    def _touching(self) -> ContactTable | None:
        return None if self._contacts is None else self._contacts.arrays

    def look(self) -> np.ndarray:
        """Bring the acceleration up to date and record the present state."""
        state, budget = self.state, self._run.budget
        begins = state.stale or budget[0] == 0.0  # what a run gains as it goes on is no budget of its own
        records = np.empty((1, self._width))
        self._advance(Span(state.step, 0, 0, moved=False, looks=True, stale=state.stale), records)
        if state.stale:
            self._keep()
            state.stale = False
        if begins:
            budget[0] = max(budget[0], self._still + records[0, TRANSLATION : CONTACT + 1].sum())
        return records

    def _advance(self, span: Span, records: np.ndarray) -> tuple[int, int, int, int, int, bool]:
        """Call `kernels.advance.advance` for this run."""
        law = self._same, self._history, self._body, self._non_local, self._soft
        return advance(
            span, self._scheme, self._run, law, self._touching, self._added, self._strain, self._breaks, records
        )

    def run(self, steps: int) -> tuple[np.ndarray, int, int, int]:
        """Carry out steps; see `Loop`."""
        if self.state.stale:
            self.look()
        state, every = self.state, self._every
        records = np.empty((steps // every + 1 if every else 0, self._width))
        done, written, wide, lost = 0, 0, 0, 0
        sick, moved = FINE, False
        while sick == FINE:
            span = Span(state.step + done, steps - done, every, moved, looks=False, stale=False)
            gone, new, turned, lost, sick, moved = self._advance(span, records[written:])
            done, written, wide = done + gone, written + new, max(wide, turned)
            if not moved or self._contacts is None:
                break
            self._contacts.keep()
            now = self._origin + (state.step + done) * self._scheme.dt
            self._check.look(self._contacts.listed, state.motion, now)
            sick = FINE if self._contacts.renew(state.step + done) else NOT_FINITE
        state.step += done
        state.time = self._origin + state.step * self._scheme.dt
        self._keep()
        if self._contacts is not None and sick == FINE:
            self._contacts.keep()
            self._check.look(self._contacts.listed, state.motion, state.time)
        return records[:written], wide, lost, sick

    def _keep(self) -> None:
        """Write data stored by bonds into the state, if the kernels use a longer table of them."""
        if self._history is not None and self._history is not self.state.history:
            self.state.history[:] = self._history[:, : self._run.bonds.m]
        if self._breaks is not None:
            keep_broken(self._breaks, self._run.bonds.integrity, self.state)
        if self._soft is not None:
            keep_softened(self._soft, self._run.bonds.integrity, self.state)
        if self._cracks is not None and self._body is not None:
            keep_cracks(self._body.cells, self._cracks.facets, self.state)


def noticeable(model: Model, dt: float) -> float:
    """Return the kinetic energy below which no guard acts on a run [J]."""
    return 0.5 * float(model.mass.sum()) * (_STILL * model.lattice.particles.mean_radius / dt) ** 2


def gauge_tables(model: Model, plan: Plan) -> Gauges:
    """Return gauges in the kernels' form."""
    gauges = list(plan.gauges.values())
    members = [_members(model, gauge) for gauge in gauges]
    return Gauges(
        start=np.concatenate([[0], np.cumsum([len(part) for part in members])]).astype(np.int64),
        element=np.concatenate(members) if members else np.zeros(0, dtype=np.int64),
        quantity=np.array([_quantity(gauge) for gauge in gauges], dtype=np.int64),
        reduction=np.array([_reduction(gauge) for gauge in gauges], dtype=np.int64),
    )


def _members(model: Model, gauge: AnyGauge) -> np.ndarray:
    """Return the elements of a gauge, internal order, or the index of its wall.

    Raises:
        InputError: The wall does not exist.
    """
    if isinstance(gauge, Gauge):
        return np.sort(model.layout.rank[gauge.region.select(model.lattice)])
    if not 0 <= gauge.wall < len(model.walls):
        raise InputError(f"WallGauge: wall = {gauge.wall} does not exist; give 0 to {len(model.walls) - 1}")
    return np.array([gauge.wall], dtype=np.int64)


def _quantity(gauge: AnyGauge) -> int:
    if isinstance(gauge, Gauge):
        return _QUANTITIES[gauge.quantity]
    return _WALL_QUANTITIES[gauge.quantity]


def _reduction(gauge: AnyGauge) -> int:
    return _REDUCTIONS[gauge.reduction] if isinstance(gauge, Gauge) else tables.MEAN
