"""Tables of `core/tables/beam_softening_tables.hpp`, written by `python -m tests.core.tables` from the header."""

from typing import NamedTuple

from bondem._types import Floats, Ints, Singles


class SofteningBounds(NamedTuple):
    """Beams that may soften: bounds of whole beams, their criterion, and the data that softening changes."""

    limit: Singles  #: as of `FailureBounds`, inf of beams that have begun, (m,)
    of_force: float  #: [1/N²]
    of_moment: float  #: [1/(N·m)²]
    coefficient: Floats  #: as of `Strengths`, (bonds, 4)
    station: Floats  #: (bonds,)
    tear: Floats  #: G_f A [J], (bonds,)
    slide: Floats  #: G_II A [J], (bonds,)
    integrity: Floats  #: 1 whole … 0 broken [-], (m,)
    per_length: Floats  #: integrity over rest length of beams that share their constants [1/m], (*,)
    press: Floats  #: stiffness of the softened part of a beam in compression, (1 - s) kn [N/m], (m,)
    onset: Floats  #: openings [√J] and energies [J] of beams that begin in this step, (bonds, 4)


class SofteningBeams(NamedTuple):
    """Beams that soften."""

    row: Floats  #: beams in the order in which they began, columns of `SoftColumn`, (bonds, 7)
    rows: Ints  #: number of rows, (1,)
    listed: Ints  #: rows that have not broken, those of a portion of bonds from its first bond on, (bonds,)
    number: Ints  #: number of rows of each portion, (bond_portions,)
    parted: Ints  #: number of those that break in this step, after the others, (bond_portions,)
    lost: Ints  #: exact sum of the energy dissipated in this step [J], (1, 68)
