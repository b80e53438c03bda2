"""Damage pipeline of a run: the passes that find failing bonds, remove them and write events.

This module contains the passes common to beams, facets of cells and bonds of the non-local law.
"""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from bondem._passes import steps
from bondem._tables.beam_softening_tables import SofteningBounds
from bondem._tables.cell_tables import ElasticFacets, FacetsOfCells
from bondem._tables.columns import CrackStatus, EventColumn, LogCount, SoftColumn
from bondem._tables.crack_tables import CohesiveCracks, CrackLists, FacetStrengths
from bondem._tables.damage_tables import Candidates, EventLog, FailureBounds, Postponed, Strengths
from bondem._tables.step_tables import Dashpots, LaggedStresses, StepBlocks
from bondem._types import PerBond
from bondem.damage.crack_columns import FACET, STATUS, TOP
from bondem.damage.failing_state import FailingState, StepTables
from bondem.damage.failure_table import FailureTable
from bondem.interactions.step_part import Part, Passes


@dataclass(frozen=True, eq=False)
class DamageTables:
    """Tables of the damage pipeline of a run, for beams, facets or bonds of the non-local law.

    Attributes:
        table: criteria of the bonds.
        bounds: bounds of the loads below which bonds cannot fail.
        candidates: bonds that are near to failure, and those that fail.
        postponed: elements whose motion a failure postpones.
        log: events of failure since the last call of the core.
    """

    table: FailureTable
    bounds: FailureBounds
    candidates: Candidates
    postponed: Postponed
    log: EventLog

    @classmethod
    def of(
        cls, table: FailureTable | None, state: FailingState, blocks: StepBlocks, filled: int
    ) -> "DamageTables | None":
        """Return the tables of a run from a state, or None if its bonds do not fail.

        Args:
            table: criteria of the bonds, or None.
            state: state with the bonds that have failed before.
            blocks: division of a step, with one additional row of sums per element.
            filled: number of bonds, padded to a group of vector lanes.
        """
        if table is None:
            return None
        n, m = len(state.pose), len(state.integrity)
        limit = np.full(filled, np.inf, dtype=np.float32)
        limit[:m] = table.limit
        limit[state.softened[:, SoftColumn.BOND].astype(np.int64)] = np.inf
        first = len(blocks.sums) - n
        return cls(
            table=table,
            bounds=FailureBounds(limit, table.of_force, table.of_moment),
            candidates=Candidates(
                begin=blocks.bond, marked=np.empty(m, dtype=np.int64), mode=np.empty(m, dtype=np.int64),
                count=np.zeros(len(blocks.bond) - 1, dtype=np.int64), any=np.zeros(1, dtype=np.int64),
            ),
            postponed=Postponed(
                flag=np.zeros(n, dtype=np.uint8), element=np.empty(n, dtype=np.uint32),
                row=np.empty(n, dtype=np.uint32), first_row=first, sum=blocks.sums[first:],
            ),
            log=new_event_log(state),
        )  # fmt: skip

    @property
    def strengths(self) -> Strengths:
        """Coefficients of the criteria in the layout of the core."""
        return self.table.strengths

    def part(self, shared: StepTables, judge: Passes, remove: Passes, dashpots: Dashpots | None) -> Part:
        """Return the part of a step by which bonds fail, given the passes that depend on the kind of bonds.

        Args:
            shared: tables of the run.
            judge: passes that find failing bonds.
            remove: passes that remove failing bonds.
            dashpots: dashpots of the bonds, or None.
        """
        keep: Passes = [steps.keep_sums(shared.blocks, self.postponed)]
        if dashpots is not None:
            keep.append(steps.keep_dashpots(dashpots, self.postponed))
        return Part(
            {
                "judge": [*judge, steps.postpone_elements(shared.blocks, self.candidates, self.postponed)],
                "keep": keep,
                "apply": remove,
                "resume": [steps.list_postponed(shared.rows, self.candidates, self.postponed)],
            },
            record=lambda history: [steps.write_released(self.log, history)],
        )

    def keep(self, integrity: np.ndarray, state: FailingState) -> None:
        """Write the events since the last call, if any, and the integrity of bonds, (m,) or longer, into a state."""
        if keep_events(self.log, state):
            state.integrity[:] = integrity[: len(state.integrity)]


class CrackJoints(NamedTuple):
    """Cracked facets of a run, which join their cells until their faces separate."""

    cracks: CohesiveCracks
    lists: CrackLists
    facets: ElasticFacets
    of_cells: FacetsOfCells
    strengths: FacetStrengths
    log: EventLog


@dataclass(frozen=True, eq=False)
class Joints:
    """Bonds as joints: two elements cannot touch as long as their bond joins them.

    Attributes:
        integrity: integrity of each bond, above 0 while it joins its elements, (m,) or longer; the passes write it.
        apart: distance of the centres at which the elements of a bond touch once it has failed [m], (m,).
        damage: tables of the damage pipeline, or None if bonds do not fail.
        pressed: table with the pressure on softening beams, or None if none soften.
        cracks: cracked facets whose faces may part, or None.
    """

    integrity: PerBond
    apart: PerBond
    damage: DamageTables | None
    pressed: SofteningBounds | None = None
    cracks: CrackJoints | None = None

    @classmethod
    def of_cracks(cls, apart: PerBond, state: FailingState, cracks: CrackJoints) -> "Joints":
        """Return the facets of a body with cracks as joints, which last until the faces of a facet separate.

        Args:
            apart: distance of the centres at which the cells of each facet touch once it has failed [m], (m,).
            state: state with the present cracks.
            cracks: cracked facets of the run.
        """
        joined, apart = (state.integrity > 0.0).astype(float), apart.copy()
        facet, parted = state.cracks[:, FACET].astype(np.int64), state.cracks[:, STATUS] == CrackStatus.PARTED
        joined[facet] = np.where(parted, 0.0, 1.0)
        apart[facet[parted]] = np.minimum(apart[facet[parted]], state.cracks[parted, TOP])
        return cls(joined, apart, None, cracks=cracks)


@dataclass(frozen=True, eq=False)
class BondParts:
    """Parts of a step that belong to the bonds of a run.

    Attributes:
        parts: parts of a step.
        joints: bonds as joints of their elements.
        stresses: stresses of elements to which contacts contribute, or None for laws without them.
    """

    parts: list[Part]
    joints: Joints
    stresses: LaggedStresses | None = None


def new_event_log(state: FailingState) -> EventLog:
    """Return an empty log of events for a run, which shares the released energies of the state."""
    room = np.empty((len(state.integrity), EventColumn.COUNT))
    return EventLog(room, np.empty(len(room)), np.zeros(2, dtype=np.int64), state.released, state.crushed)


def keep_events(log: EventLog, state: FailingState) -> int:
    """Move the events of a log to those of a state, and return their number."""
    count = int(log.written[LogCount.EVENTS])
    if count:
        state.broken = np.concatenate([state.broken, log.event[:count]])
        log.written[:] = 0
    return count
