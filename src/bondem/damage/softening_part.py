"""Part of a step for beams that soften: their integrity, pressure and events."""

from dataclasses import dataclass

import numpy as np

from bondem._cache_lines import exact_sums
from bondem._passes import steps
from bondem._tables.beam_softening_tables import SofteningBeams, SofteningBounds
from bondem._tables.columns import BONDS_OF_PORTION, SoftColumn
from bondem._tables.step_tables import Beams, UniformBeams
from bondem.damage.beam_softening import BeamSoftening
from bondem.damage.damage_part import DamageTables, keep_events
from bondem.damage.failing_state import FailingState, StepTables
from bondem.interactions.step_part import Part


@dataclass(frozen=True, eq=False)
class SofteningTables:
    """Tables of the beams of a run that soften.

    Attributes:
        bounds: bounds, criterion, integrity and pressure stiffness of the beams.
        soft: rows and lists of the beams that soften.
    """

    bounds: SofteningBounds
    soft: SofteningBeams

    @classmethod
    def of(
        cls, energies: BeamSoftening, damage: DamageTables, state: FailingState, beams: Beams,
        uniform: UniformBeams | None, *, handed: bool,
    ) -> "SofteningTables":  # fmt: skip
        """Return the tables of a run from a state with the beams that have begun to soften.

        If `handed`, contacts carry the pressure of broken beams, else the beams themselves.
        """
        m, rows = len(state.integrity), len(state.softened)
        row = np.zeros((m, SoftColumn.COUNT))
        row[:rows] = state.softened
        bond = state.softened[:, SoftColumn.BOND].astype(np.int64)
        press = np.zeros(len(beams.i))
        press[bond] = (1.0 - state.integrity[bond]) * beams.kn[bond]
        if handed:
            press[bond[state.integrity[bond] <= 0.0]] = 0.0
        portions = -(-m // BONDS_OF_PORTION)
        listed, count = np.zeros(m, dtype=np.int64), np.zeros(portions, dtype=np.int64)
        for c in np.flatnonzero(state.integrity[bond] > 0.0):
            q = bond[c] // BONDS_OF_PORTION
            listed[q * BONDS_OF_PORTION + count[q]] = c
            count[q] += 1
        return cls(
            bounds=SofteningBounds(
                *damage.bounds, *damage.strengths, energies.tear, energies.shear, beams.integrity,
                np.zeros(0) if uniform is None else uniform.per_length, press, np.zeros((m, 4)),
            ),
            soft=SofteningBeams(
                row=row, rows=np.array([rows], dtype=np.int64), listed=listed, number=count,
                parted=np.zeros(portions, dtype=np.int64), lost=exact_sums(),
            ),
        )  # fmt: skip


def softening(
    tables: SofteningTables, damage: DamageTables, state: FailingState, shared: StepTables, beams: Beams
) -> Part:
    """Return the part of a step by which beams soften and break."""
    moving, bounds, soft, candidates = shared.moving, tables.bounds, tables.soft, damage.candidates

    def keep() -> None:
        state.softened = soft.row[: soft.rows[0]].copy()
        state.integrity[:] = beams.integrity[: len(state.integrity)]
        keep_events(damage.log, state)

    return Part(
        {
            "prepare": [
                steps.soften_beams(moving, beams, bounds, soft),
                steps.log_softened_beams(moving, beams, soft, damage.log),
            ],
            "apply": [steps.begin_softening(candidates, bounds, soft, damage.log)],
        },
        record=lambda history: [
            steps.sum_pressed_energies(moving, beams, bounds, shared.ledger),
            steps.write_released(damage.log, history),
            steps.write_crushing_of_beams(bounds, soft, damage.log, history),
        ],
        keep=keep,
    )  # fmt: skip
