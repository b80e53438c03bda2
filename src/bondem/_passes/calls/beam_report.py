"""Passes that Python calls, of `core/passes/beams/beam_report.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import Call
from bondem._tables.step_tables import BeamEnergies, Beams, BeamTurns, Poses


def count_turned_beams(poses: Poses, beams: Beams, beam_turns: BeamTurns) -> Call:
    """Counts unbroken beams beyond safe angles and beyond valid angles in given poses."""
    return Call("count_turned_beams", (poses, beams, beam_turns))


def measure_beam_energies(poses: Poses, beams: Beams, beam_energies: BeamEnergies) -> Call:
    """Measures normal, shear, bending and twisting energy of all beams in given poses [J]."""
    return Call("measure_beam_energies", (poses, beams, beam_energies))
