"""Mean radius R̄ of the body that each element belongs to."""

import numpy as np
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from bondem._types import PerElement
from bondem.specimen.lattice import Lattice


def mean_radii(lattice: Lattice) -> PerElement:
    """Return R̄ of the body of each element [m], (n,); bodies that bonds join are one.

    A body therefore has the bonds in a scene that it has alone, and halves that are bonded across those of the whole.
    """
    radius, count = lattice.particles.radius, len(lattice.names)
    if count == 1:
        return np.full(len(radius), lattice.particles.mean_radius)
    i, j = lattice.body[lattice.pairs].T
    bonded = coo_array((np.ones(len(i), dtype=bool), (i, j)), shape=(count, count))
    joined = connected_components(bonded, directed=False)[1][lattice.body]
    found = np.empty(len(radius))
    order = np.argsort(joined, kind="stable")
    for own in np.split(order, np.cumsum(np.bincount(joined))[:-1]):
        found[own] = radius[own].mean()
    return found
