"""Rows of the history: the energies of a run and its gauges, and the guard of its energy."""

from bondem._core_steps import StepPass
from bondem._tables.step_tables import Gauges, HistoryRows, Moving, Portions, Rows
from bondem.dynamics.parts.shared_tables import SharedTables
from bondem.interactions.step_part import Part, Passes

_sum_element_energies = StepPass("sum_element_energies", Moving, Portions)
_judge_energy = StepPass("judge_energy", Rows, Portions)
_write_ledger = StepPass("write_ledger", Rows, Portions, HistoryRows)
_read_gauges = StepPass("read_gauges", Moving, Rows, Gauges, HistoryRows)


def history(shared: SharedTables, gauges: Gauges, kinetic: Passes) -> Part:
    """Return the part that checks the energy, and writes it and the gauges; it comes after all others.

    `kinetic` are the passes that correct the kinetic energies of elements.
    """
    moving, rows, portions = shared.moving, shared.rows, shared.portions
    elements: Passes = [(_sum_element_energies, moving, portions), *kinetic]

    def record(to: HistoryRows) -> Passes:
        passes: Passes = [*elements, (_write_ledger, rows, portions, to)]
        if len(gauges.quantity):
            passes.append((_read_gauges, moving, rows, gauges, to))
        return passes

    return Part({"guard": [*elements, (_judge_energy, rows, portions)]}, record)
