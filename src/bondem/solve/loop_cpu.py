"""The loop of the CPU: what the compiled steps are given, gathered once."""

import numpy as np

from bondem._compile import current_threads
from bondem.errors import InputError
from bondem.kernels.advance import (
    CONTACT,
    FINE,
    FIXED_COLUMNS,
    NOT_FINITE,
    SERIAL_BONDS,
    TRANSLATION,
    WALL_DISPLACEMENT,
    advance,
    evaluate,
)
from bondem.kernels.contact_pass import Contacts
from bondem.kernels.sweep import TILE
from bondem.laws.damping import DampingTerms
from bondem.model.blocks import Blocks
from bondem.model.bond_table import BondTable, alike
from bondem.model.gauges import QUANTITIES, REDUCTIONS, WALL_QUANTITIES, AnyGauge, Gauge
from bondem.model.model import Model
from bondem.model.state import State
from bondem.solve.added import added, changing_strain
from bondem.solve.neighbour_list import ContactList
from bondem.solve.plan import Plan

# Elements of a block: they stay in the L2 cache from their bonds to their motion.
BLOCK = 4000
# Elements that move by this share of their radius a step have an energy that no guard minds.
_STILL = 1e-6


def rested(bonds: BondTable, eigenstrain: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Constants, shear stiffness and lever with rest lengths L (1 + ε*)."""
    table = bonds.stretched(eigenstrain)
    return table.constants, table.shear, table.lever


class CpuLoop:
    """The arguments of the compiled loop, gathered once."""

    def __init__(self, model: Model, plan: Plan, state: State, dt: float) -> None:
        self.state = state
        self.plan = plan
        self.origin = state.time - state.step * dt
        self.dt = dt
        layout, bonds, held = model.layout, model.bonds, model.constraints
        self.width = FIXED_COLUMNS + 3 * len(plan.gauges)
        constants, shear, lever = rested(bonds, state.eigenstrain)
        same = alike(constants)
        if len(held.strain_part):  # they change while it runs
            constants, shear, lever, same = constants.copy(), shear.copy(), lever.copy(), None
        domains = current_threads() if len(layout.i) >= SERIAL_BONDS else 1
        blocks = Blocks.of(layout, BLOCK, domains)
        rows = np.zeros((2, len(held.element), 6))
        terms = DampingTerms.of(plan.damping)
        self.scheme = (*plan.scheme.coefficients(dt), terms.gamma)
        self.arrays = (
            state.pose, state.motion, state.acceleration, layout.i, layout.j, constants, same, shear,
            bonds.bending, lever, state.integrity, state.history, model.period,
            np.empty((domains, 9, TILE)), blocks.row_i, blocks.row_j, np.zeros((blocks.rows, 8)),
            blocks.domain, blocks.bond, blocks.move, blocks.ready, blocks.ready_row, blocks.shared, blocks.shared_row,
            blocks.parts, blocks.part,
            held.times, held.values, held.start, held.drive_row, held.drive_dof, held.drive_schedule,
            held.drive_rate, held.load_row, held.load_schedule, held.load_value,
            held.row_of, held.fixed, np.zeros((len(held.element), 6)), rows[0], rows[1], state.reaction,
            state.work, state.loss, state.rest,
            *gauge_tables(model, plan),
        )  # fmt: skip
        self.contacts = None if model.contacts is None else ContactList(model, model.contacts, state)
        self.budget = np.zeros(2)  # as `kernels.advance.guard` has it
        self._still = 0.5 * float(model.mass.sum()) * (_STILL * model.lattice.particles.mean_radius / dt) ** 2
        contact = None if self.contacts is None else self.contacts.arrays.load
        self.added = added(model, terms, contact, blocks.rows), changing_strain(model, state)

    def look(self) -> np.ndarray:
        """Bring the acceleration up to date and record the present."""
        records = np.empty((1, self.width))
        evaluate(
            self.state.step, self.origin, self.dt, self.scheme[3], self.state.stale, *self.arrays,
            self._contact_arrays, *self.added, records,
        )  # fmt: skip
        self.state.stale = False
        self.budget[0] = max(self.budget[0], self._still + records[0, TRANSLATION : CONTACT + 1].sum())
        return records

    @property
    def _contact_arrays(self) -> Contacts | None:
        return None if self.contacts is None else self.contacts.arrays

    def run(self, steps: int) -> tuple[np.ndarray, int, int, int]:
        """Go on; the records written, bonds turned wide, bonds lost, and what `kernels.advance.guard` found."""
        if self.state.stale:
            self.look()
        every = int(self.plan.every)
        state = self.state
        records = np.empty((steps // every + 1 if every else 0, self.width))
        done, written, wide, lost = 0, 0, 0, 0
        sick, moved = FINE, False
        while sick == FINE:
            gone, new, turned, lost, sick, moved = advance(
                state.step + done, steps - done, every, self.origin, self.dt, moved, *self.scheme, *self.arrays,
                self._contact_arrays, *self.added, self.budget, records[written:],
            )  # fmt: skip
            done, written, wide = done + gone, written + new, max(wide, turned)
            if not moved or self.contacts is None:
                break
            self.contacts.keep()
            sick = FINE if self.contacts.renew(state.step + done) else NOT_FINITE
        state.step += done
        state.time = self.origin + state.step * self.dt
        if self.contacts is not None and sick == FINE:
            self.contacts.keep()
        return records[:written], wide, lost, sick


def gauge_tables(model: Model, plan: Plan) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Gauges as kernels take them: where the elements (or walls) of each begin, these, its quantity and reduction."""
    gauges = list(plan.gauges.values())
    members = [_members(model, gauge) for gauge in gauges]
    return (
        np.concatenate([[0], np.cumsum([len(part) for part in members])]).astype(np.int64),
        np.concatenate(members) if members else np.zeros(0, dtype=np.int64),
        np.array([_quantity(gauge) for gauge in gauges], dtype=np.int64),
        np.array([_reduction(gauge) for gauge in gauges], dtype=np.int64),
    )


def _members(model: Model, gauge: AnyGauge) -> np.ndarray:
    """Elements of a gauge, internal order, or the number of its wall.

    Raises:
        InputError: no such wall.
    """
    if isinstance(gauge, Gauge):
        return np.sort(model.layout.rank[gauge.region.select(model.lattice)])
    if not 0 <= gauge.wall < len(model.walls):
        raise InputError(f"WallGauge: there is no wall {gauge.wall}; give one from 0 to {len(model.walls) - 1}")
    return np.array([gauge.wall], dtype=np.int64)


def _quantity(gauge: AnyGauge) -> int:
    if isinstance(gauge, Gauge):
        return QUANTITIES.index(gauge.quantity)
    return WALL_DISPLACEMENT + WALL_QUANTITIES.index(gauge.quantity)


def _reduction(gauge: AnyGauge) -> int:
    return REDUCTIONS.index(gauge.reduction) if isinstance(gauge, Gauge) else 0
