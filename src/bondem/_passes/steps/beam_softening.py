"""Passes that steps are composed of, of `core/passes/damage/beam_softening.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import StepEntry
from bondem._tables.beam_softening_tables import SofteningBeams, SofteningBounds
from bondem._tables.damage_tables import Candidates, EventLog
from bondem._tables.step_tables import Beams, HistoryRows, Ledger, Moving


def begin_softening(
    candidates: Candidates, softening_bounds: SofteningBounds, softening_beams: SofteningBeams, event_log:
    EventLog
) -> StepEntry:
    """Writes the rows of beams that have begun to soften in this step, and adds up their dissipation.

    Over events of the step, such as failures, in their order.
    """
    return StepEntry("begin_softening", (candidates, softening_bounds, softening_beams, event_log))


def log_softened_beams(
    moving: Moving, beams: Beams, softening_beams: SofteningBeams, event_log: EventLog
) -> StepEntry:
    """Adds up the dissipation of all portions, and logs broken beams.

    Over events of the step, such as failures, in their order. Reads `pose` at both ends.
    """
    return StepEntry("log_softened_beams", (moving, beams, softening_beams, event_log))


def soften_beams(
    moving: Moving, beams: Beams, softening_bounds: SofteningBounds, softening_beams: SofteningBeams
) -> StepEntry:
    """Lowers the integrity of the softening beams of a portion, before forces are computed.

    Over bonds, in portions. Reads `motion`, `pose` at both ends.
    """
    return StepEntry("soften_beams", (moving, beams, softening_bounds, softening_beams))


def sum_pressed_energies(
    moving: Moving, beams: Beams, softening_bounds: SofteningBounds, ledger: Ledger
) -> StepEntry:
    """Adds the energy of the pressure on softened beams of a portion to their normal energy.

    Over bonds, in portions. Reads `pose` at both ends.
    """
    return StepEntry("sum_pressed_energies", (moving, beams, softening_bounds, ledger))


def write_crushing_of_beams(
    softening_bounds: SofteningBounds, softening_beams: SofteningBeams, event_log: EventLog, history_rows:
    HistoryRows
) -> StepEntry:
    """Writes the energy that beams have released beyond their fracture energy in this run [J].

    Over rows of a table, in the order of the table.
    """
    return StepEntry("write_crushing_of_beams", (softening_bounds, softening_beams, event_log, history_rows))
