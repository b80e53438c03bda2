"""Part of a step that writes energies and gauges to the history, and checks the energy."""

from bondem._passes import steps
from bondem._tables.step_tables import Gauges, HistoryRows
from bondem.dynamics.parts.shared_tables import SharedTables
from bondem.interactions.step_part import Part, Passes


def history(shared: SharedTables, gauges: Gauges, kinetic: Passes) -> Part:
    """Return the part that checks the energy and writes energies and gauges; it must follow all other parts.

    `kinetic` are the passes that correct the kinetic energies of elements.
    """
    moving, rows, ledger = shared.moving, shared.rows, shared.ledger
    elements: Passes = [steps.sum_element_energies(moving, ledger), *kinetic]

    def record(to: HistoryRows) -> Passes:
        passes: Passes = [*elements, steps.write_ledger(rows, ledger, to)]
        if len(gauges.quantity):
            passes.append(steps.read_gauges(moving, rows, gauges, to))
        return passes

    return Part({"guard": [*elements, steps.judge_energy(rows, ledger)]}, record)
