"""What kernels take of stress-free strains of cells that change in time."""

from typing import NamedTuple

import numpy as np


class StrainedCells(NamedTuple):
    """Strains on top of those of a state, g of them, each with a schedule; kernels write the last three.

    A facet's levers are 1 + ε* times those of the reference, and so are those of walls, of which there are w.
    """

    schedule: np.ndarray  #: (g,)
    base_i: np.ndarray  #: levers of the reference [m], (3, m)
    base_j: np.ndarray
    still: np.ndarray  #: 1 + ε* of the state, (m,)
    part: np.ndarray  #: strain of each facet at factor 1, (g, m)
    wall_base: np.ndarray  #: levers of walls [m], (w, 3)
    wall_still: np.ndarray  #: (w,)
    wall_part: np.ndarray  #: (g, w)
    place: int  #: of their work in the list of works
    factor: np.ndarray  #: of each strain: now, what it has come by, ∂U/∂factor before and now [J], (4, g)
    power: np.ndarray  #: sums of portions of facets [J], (portions, g)
    due: np.ndarray  #: whether ∂U/∂factor is needed, (1,)


class Strain(NamedTuple):
    """Stress-free strains that change in time; e bonds, g strains."""

    schedule: np.ndarray  #: (g,)
    bond: np.ndarray  #: uint32, (e,)
    part: np.ndarray  #: strain of each bond at factor 1 [-], (g, e)
    still: np.ndarray  #: 1 and what does not change [-], (e,)
    length: np.ndarray  #: L [m], (e,)
    shear: np.ndarray  #: ks [N/m], (e,)
    lever: np.ndarray  #: a [m], (e,)
    factor: np.ndarray  #: rows: present factors, those to come, energy by factor [J] a step ago and now, (4, g)
    place: int  #: in the list of works
