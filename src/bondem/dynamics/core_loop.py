"""Loop over the steps of a run on the CPU, where the core calls lists of passes on its own threads."""

import numpy as np

from bondem._core import return_free_memory, run_pass
from bondem._core_steps import Composer
from bondem._passes import calls
from bondem._tables.columns import HistoryColumn
from bondem._tables.step_tables import HistoryRows, StepPasses, StepScheme, StepSpan
from bondem._threads import current_threads
from bondem.dynamics.damping import DampingTerms
from bondem.dynamics.gauge_tables import gauge_tables
from bondem.dynamics.parts.parts_of_model import parts_of
from bondem.dynamics.plan import FINE, NOT_FINITE, RUNAWAY, Plan
from bondem.interactions.step_part import FORCES, STAGES, composed
from bondem.model.domain_blocks import Blocks
from bondem.model.model import Model
from bondem.model.state import State

# Number of bonds and elements in contact below which threads cost more than they gain, and least number per domain.
SERIAL_BONDS = 2000
_DOMAIN = SERIAL_BONDS // 4

#: Columns of kinetic and elastic energies in a record.
STORED = slice(HistoryColumn.TRANSLATION, HistoryColumn.CONTACT + 1)
# Elements of a block: their data stay in the L2 cache from the loads of their bonds to their motion.
BLOCK = 4000
# Motion per step over the mean radius: guards ignore energies below that of all elements in this motion.
_STILL = 1e-6

_ENDINGS = {"sound": FINE, "not_finite": NOT_FINITE, "runaway": RUNAWAY}


class CoreLoop:
    """Lists of passes of one run, with the calls of the core that take its steps."""

    def __init__(self, model: Model, plan: Plan, state: State, dt: float) -> None:
        self.state = state
        self._every = int(plan.every)
        self._width = HistoryColumn.COUNT + 3 * len(plan.gauges)
        self._origin = state.time - state.step * dt
        self._n, self._m = len(state.pose), len(model.layout.i)
        terms = DampingTerms.of(plan.damping)
        self._scheme = StepScheme(dt, *plan.scheme.coefficients(dt), terms.gamma, self._origin)
        busy = self._m + len(model.contacts.radius)
        self._threads = current_threads() if busy >= SERIAL_BONDS else 1
        domains = min(self._threads, max(busy // _DOMAIN, 1))
        # elements that a failure delays keep their sums in rows of their own
        postponed = 0 if model.breaking is None else self._n
        # the corrected mass needs the sums of all elements at once, but rows of sums are reused by later blocks
        size = BLOCK if model.correction is None else max(self._n, 1)
        blocks = Blocks.of(model.layout, size, domains, model.constraints.row_of >= 0).table(postponed)
        self._tables, self._parts = parts_of(model, terms, state, blocks, gauge_tables(model, plan), dt)
        self._still = noticeable(model, dt)
        # tables of the parts without neighbour lists, which stay the same during a run
        self._lasting = Composer()
        self._lasting(composed([part for part in self._parts if part.renewed is None], *STAGES))
        self._make_lists()
        self._begin()
        return_free_memory(self._m)

    def _make_lists(self) -> None:
        """Compose the lists of passes that the core calls from the parts of the step."""
        self._compose = Composer(self._lasting)
        stages = ("present", "opening", "travel", "resume", "reopening", "guard")
        lists = {stage: self._list(stage) for stage in stages}
        self._lists = StepPasses(**lists, forces=self._list(*FORCES), record=self._compose([]))

    def _begin(self) -> None:
        """Call the passes that prepare a run, those of the stage "begin", at the time of the state."""
        first = composed(self._parts, "begin")
        if not first:
            return
        nothing = self._compose([])
        lists = StepPasses(*[nothing] * len(StepPasses._fields))
        lists = lists._replace(present=self._compose([*composed(self._parts, "present"), *first]))
        done = np.zeros(4, dtype=np.int64)
        span = StepSpan(self.state.step, 0, 0, True, False, False, self._n, self._m, done)
        t = self._tables
        run_pass(calls.take_steps(lists, t.blocks, self._scheme, span, t.ledger), threads=self._threads)

    def _list(self, *stages: str) -> np.ndarray:
        return self._compose(composed(self._parts, *stages))

    def _renew(self) -> bool:
        """Search for contacts again and renew the lists of passes; return False if a centre is not finite."""
        parts = [part if part.renewed is None else part.renewed() for part in self._parts]
        self._parts = [part for part in parts if part is not None]
        self._make_lists()
        return None not in parts

    def _take(
        self, steps: int, records: np.ndarray, *, records_present: bool = False, moved: bool = False
    ) -> tuple[str, list[int]]:
        """Take steps, or record the present state, in one call of the core.

        Returns:
            The reason for the end of the call; the numbers of steps and of records; and the two numbers of strongly
            rotated bonds that `Loop.run` returns.
        """
        state, t, done = self.state, self._tables, np.zeros(4, dtype=np.int64)
        stale = records_present and state.stale
        span = StepSpan(state.step, steps, self._every, records_present, stale, moved, self._n, self._m, done)
        compose, history = Composer(self._compose), HistoryRows(records)  # live as long as this call
        lists = self._lists._replace(record=compose(one for part in self._parts for one in part.record(history)))
        ending = run_pass(calls.take_steps(lists, t.blocks, self._scheme, span, t.ledger), threads=self._threads)
        if done[0]:
            state.step += int(done[0])
            state.time = self._origin + state.step * self._scheme.dt
        for part in self._parts:
            part.keep()
        return ending, done.tolist()

    def record_present(self) -> np.ndarray:
        """Update the acceleration and return a record of the present state, (1, columns)."""
        state, budget = self.state, self._tables.ledger.budget
        begins = state.stale or budget[0] == 0.0  # set at the start only: energy gained later must not raise it
        records = np.zeros((1, self._width))
        self._take(0, records, records_present=True)
        state.stale = False
        if begins:
            budget[0] = max(budget[0], self._still + np.abs(records[0, STORED]).sum())
        return records

    def run(self, steps: int) -> tuple[np.ndarray, int, int, int]:
        """Take steps and return records, two numbers of strongly rotated bonds, and the verdict, as `Loop.run`."""
        if self.state.stale:
            self.record_present()
        records = np.zeros((steps // self._every + 1 if self._every else 0, self._width))
        done, written, wide, moved = 0, 0, 0, False
        while True:
            ending, (taken, new, turned, lost) = self._take(steps - done, records[written:], moved=moved)
            done, written, wide = done + taken, written + new, max(wide, turned)
            if ending != "out_of_date":
                break
            if not self._renew():
                ending = "not_finite"
                break
            moved = True
        return records[:written], wide, lost, _ENDINGS[ending]


def noticeable(model: Model, dt: float) -> float:
    """Return the energy below which checks of the energy ignore changes [J].

    This is the energy of negligible motion plus the largest energy that adhesion may release.
    """
    rest = 0.5 * float(model.mass.sum()) * (_STILL * model.lattice.particles.mean_radius / dt) ** 2
    return rest + model.contact_laws.released(model.contact_radius)
