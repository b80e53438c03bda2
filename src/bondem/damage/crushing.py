"""Energy that bonds have released beyond their fracture energy."""

from math import fsum

import numpy as np

from bondem._tables.columns import SoftColumn
from bondem._types import Floats
from bondem.damage.beam_softening import BeamSoftening
from bondem.damage.crack_columns import SPENT
from bondem.damage.softening_table import SofteningTable


def crushing_of(
    facets: SofteningTable | None, beams: BeamSoftening | None, cracks: Floats, softened: Floats
) -> Floats:
    """Return the energy that facets or softening beams have released beyond their fracture energy [J], (1,).

    The sum is rounded once, like that of the core. The crushing of a run that begins from damage is thus exactly zero
    at first.

    Args:
        facets: table of softening facets, or None.
        beams: table of softening beams, or None.
        cracks: rows of cracked facets (`bondem.damage.crack_columns`), (c, CRACK_COLUMNS).
        softened: rows of softening beams (`SoftColumn`), (c, 7).
    """
    beyond = np.zeros(0)
    if facets is not None:
        beyond = cracks[:, SPENT] - facets.absorbed_by(cracks)
    if beams is not None:
        beyond = np.append(beyond, softened[:, SoftColumn.SPENT] - beams.absorbed(softened))
    return np.array([fsum(np.maximum(beyond, 0.0))])
