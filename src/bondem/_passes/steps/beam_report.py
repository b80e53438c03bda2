"""Passes that steps are composed of, of `core/passes/beams/beam_report.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import StepEntry
from bondem._tables.step_tables import Beams, Ledger, Moving


def check_beams(moving: Moving, beams: Beams, ledger: Ledger) -> StepEntry:
    """Counts unbroken beams of a portion beyond safe angles (c1 or c2 < 0.7, w² < 0.75) and valid ones (0, 0.25);
    c, w as in `laws/beam.hpp`.

    Over bonds, in portions. Reads `pose` at both ends.
    """
    return StepEntry("check_beams", (moving, beams, ledger))


def sum_beam_energies(moving: Moving, beams: Beams, ledger: Ledger) -> StepEntry:
    """Sums normal, shear, bending and twisting energy of the beams of a portion [J].

    Over bonds, in portions. Reads `pose` at both ends.
    """
    return StepEntry("sum_beam_energies", (moving, beams, ledger))
