"""Passes that Python calls, of `core/passes/beams`; written by `python -m tests.core.passes`."""

from bondem._passes import Call
from bondem._tables.step_tables import AlikeBeams, BeamEnergies, Beams, BeamSums, BeamTurns, Poses


def count_turned_beams(poses: Poses, beams: Beams, beam_turns: BeamTurns) -> Call:
    """Counts unbroken beams turned wide and lost among all beams in any poses."""
    return Call("count_turned_beams", (poses, beams, beam_turns))


def load_alike_beams(poses: Poses, beams: Beams, alike_beams: AlikeBeams, beam_sums: BeamSums) -> Call:
    """Adds forces and torques of all beams in any poses that differ in length only."""
    return Call("load_alike_beams", (poses, beams, alike_beams, beam_sums))


def load_beams(poses: Poses, beams: Beams, beam_sums: BeamSums) -> Call:
    """Adds forces and torques of all beams in any poses; rows of the sums are given."""
    return Call("load_beams", (poses, beams, beam_sums))


def measure_beam_energies(poses: Poses, beams: Beams, beam_energies: BeamEnergies) -> Call:
    """Measures normal, shear, bending and twisting energy of all beams in any poses [J]."""
    return Call("measure_beam_energies", (poses, beams, beam_energies))
