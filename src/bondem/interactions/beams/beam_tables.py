"""Tables of beams in the layout of the core, and passes that evaluate beams in any pose.

`core/tables/step_tables.hpp` declares types and shapes.
"""

import numpy as np

from bondem._cache_lines import lines
from bondem._core import run_pass
from bondem._passes import calls
from bondem._tables.step_tables import BeamEnergies, Beams, BeamSums, BeamTurns, Poses, UniformBeams
from bondem._types import Floats, PerBond
from bondem.interactions.beams.bond_table import BondTable, with_twins, with_zeros
from bondem.specimen.ordering import Layout


def beam_tables(
    bonds: BondTable, layout: Layout, period: Floats, integrity: PerBond, *, may_share: bool = True
) -> tuple[Beams, UniformBeams | None]:
    """Return the table of beams, and the table of constants that all share, or None if they differ.

    Args:
        bonds: constants of the beams.
        layout: elements of the beams.
        period: edges of the periodic cell and their inverses, (6,).
        integrity: integrity of each beam [-], (m,).
        may_share: True if common constants may be used; False if lengths change.
    """
    same = bonds.uniform if may_share else None
    X0, Y0, Z0 = bonds.direction
    per_length = integrity / bonds.length if same is not None else np.zeros(0)
    beams = Beams(
        i=with_twins(layout.i), j=with_twins(layout.j), X0=with_twins(X0), Y0=with_twins(Y0), Z0=with_twins(Z0),
        length=with_twins(bonds.length), kn=with_zeros(bonds.kn), A=with_zeros(bonds.A), B=with_zeros(bonds.B),
        C=with_zeros(bonds.C), kt=with_zeros(bonds.kt), ks=with_zeros(bonds.ks), lever=with_zeros(bonds.lever),
        integrity=with_zeros(integrity), period=period,
    )  # fmt: skip
    return beams, None if same is None else UniformBeams(with_zeros(per_length), *same)


def load_beams(pose: Floats, beams: Beams, sums: BeamSums) -> None:
    """Add force and torque of all beams in a pose, (n, 8), to the rows of `sums` for both ends [N, N·m]."""
    run_pass(calls.load_beams(Poses(pose), beams, sums))


def loads_of_each(pose: Floats, beams: Beams, m: int) -> tuple[Floats, Floats]:
    """Return force, 0, torque, 0 of each of the first m beams on i and on j [N, N·m], (m, 8) each."""
    sums = lines(2 * m)  # every beam adds to two rows of its own
    own = np.arange(m, dtype=np.uint32)
    load_beams(pose, beams, BeamSums(with_twins(own), with_twins(own + np.uint32(m)), sums))
    return sums[:m], sums[m:]


def count_turned(pose: Floats, beams: Beams) -> tuple[int, int, bool]:
    """Count unbroken beams turned beyond the valid range of their energy, and beyond its end.

    Returns:
        Number of beams with c1 or c2 < 0.7 or w² < 0.75, number with c1 or c2 <= 0 or w² <= 0.25, and True if a
        number is not finite. c1 and c2 are the cosines of the bending angles of both ends, w of half the
        relative rotation.
    """
    found = np.empty(3, dtype=np.int64)
    run_pass(calls.count_turned_beams(Poses(pose), beams, BeamTurns(found)))
    wide, lost, sick = found.tolist()
    return wide, lost, bool(sick)


def beam_energies(pose: Floats, beams: Beams) -> tuple[float, float, float, float]:
    """Return normal, shear, bending and twisting energy of all beams [J]."""
    found = np.empty(4)
    run_pass(calls.measure_beam_energies(Poses(pose), beams, BeamEnergies(found)))
    normal, shear, bending, twisting = found.tolist()
    return normal, shear, bending, twisting
