"""Passes that steps are composed of, of `core/passes/record/record.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import StepEntry
from bondem._tables.step_tables import Gauges, HistoryRows, Ledger, Moving, Rows


def judge_energy(rows: Rows, ledger: Ledger) -> StepEntry:
    """Finds whether a number is not finite, or the kinetic energy is far above all energy supplied.

    Over single numbers, such as those of a record.
    """
    return StepEntry("judge_energy", (rows, ledger))


def read_gauges(moving: Moving, rows: Rows, gauges: Gauges, history_rows: HistoryRows) -> StepEntry:
    """Writes three components of each gauge of elements.

    Over rows of a table, in the order of the table.
    """
    return StepEntry("read_gauges", (moving, rows, gauges, history_rows))


def sum_element_energies(moving: Moving, ledger: Ledger) -> StepEntry:
    """Sums kinetic energies and losses of a portion of elements [J].

    Over elements, in portions.
    """
    return StepEntry("sum_element_energies", (moving, ledger))


def write_ledger(rows: Rows, ledger: Ledger, history_rows: HistoryRows) -> StepEntry:
    """Writes time and the entries of the energy balance.

    Over single numbers, such as those of a record.
    """
    return StepEntry("write_ledger", (rows, ledger, history_rows))
