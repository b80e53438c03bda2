"""Cracked area of a body with aggregates: in its matrix, along aggregates, and through them."""

import numpy as np

from bondem.model.state import State
from bondem.specimen.aggregates import Aggregates
from bondem.specimen.lattice import Lattice

#: Parts of a body, by the number of the two cells of a facet that lie in aggregates: none, one and two.
PARTS = "matrix", "interface", "aggregate"


def lost_area(body: Lattice, state: State, aggregates: Aggregates) -> dict[str, float]:
    """Return the cracked area Σ A (1 - integrity) of the facets of each of `PARTS` [m²].

    Args:
        body: body cut into cells.
        state: state of these cells.
        aggregates: aggregates in the body.
    """
    inside = aggregates.mask(body)[body.pairs].sum(axis=1)
    lost = (1.0 - state.bond_integrity) * body.elements.require_cells().facets.area
    found = np.bincount(inside, weights=lost, minlength=len(PARTS))
    return dict(zip(PARTS, found.tolist(), strict=True))
