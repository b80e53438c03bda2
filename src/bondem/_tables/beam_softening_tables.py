"""Tables of `core/tables/beam_softening_tables.hpp`, written by `python -m tests.core.tables` from the header."""

from typing import NamedTuple

from bondem._types import Floats, Ints, Singles


class SofteningBounds(NamedTuple):
    """Beams that may soften: bounds of whole beams, their criterion, and the data that softening changes."""

    limit: Singles  #: bound of the size of a load as in `FailureBounds`, inf once a beam softens, (m,)
    of_force: float  #: factor of |F|² in the size of a load [1/N²]
    of_moment: float  #: factor of |M|² in the size of a load [1/(N·m)²]
    coefficient: Floats  #: coefficients of the criterion, as in `Strengths`, (bonds, 4)
    station: Floats  #: place where the moment counts, as in `Strengths`, (bonds,)
    tear: Floats  #: fracture energy of opening, G_f A [J], (bonds,)
    slide: Floats  #: fracture energy of sliding, G_II A [J], (bonds,)
    integrity: Floats  #: 1 whole … 0 broken [-], (m,)
    per_length: Floats  #: integrity over rest length of beams that share their constants [1/m], (*,)
    press: Floats  #: stiffness of the softened part of a beam in compression, (1 - s) kn [N/m], (m,)
    #: of beams that begin to soften in this step: first and last λ [√J], Y and dissipation [J], (bonds, 4)
    onset: Floats


class SofteningBeams(NamedTuple):
    """Beams that soften: their rows, and lists of the unbroken ones."""

    row: Floats  #: beams in the order of their onset, columns by `soft_column`, (bonds, 7)
    rows: Ints  #: number of rows, (1,)
    listed: Ints  #: unbroken rows; those of a portion begin at the number of its first bond, (bonds,)
    number: Ints  #: number of unbroken rows of each portion, (bond_portions,)
    parted: Ints  #: number of rows that break in this step, listed after the others, (bond_portions,)
    lost: Ints  #: exact sum of the energy dissipated in this step [J], (1, 68)
