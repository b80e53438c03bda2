"""Contact areas of spheres, with the weights of the authors of the non-local law.

A bond between radii R1 and R2 begins with A0 = π ((R1 + R2)/2)². At each element these areas are scaled so that their
sum is the surface of a polyhedron of as many faces about its sphere: the regular one for 4, 6, 8, 12 and 20 faces,
and linear interpolation between these. A bond has the mean of the areas scaled at its two elements. An element at the
surface has no closed polyhedron: its bonds have the area scaled at the inner element. Between two elements at the
surface A0 is scaled by the average factor of inner elements.

The paper (Celigueta et al. 2020) refers to an earlier one for areas. These follow the authors' published code.
"""

import math

import numpy as np

from bondem._types import Floats, Mask, PerBond
from bondem.interactions.row_sums import row_sums
from bondem.specimen.lattice import Lattice

# Regular polyhedra: faces, and surface over that of the sphere inside, S / 4 π r².
_FACES = (4.0, 6.0, 8.0, 12.0, 20.0)
_SURFACES = (
    6.0 * math.sqrt(3.0) / math.pi,
    6.0 / math.pi,
    3.0 * math.sqrt(3.0) / math.pi,
    3.0 * math.sqrt(25.0 + 10.0 * math.sqrt(5.0)) / (2.5 + 1.1 * math.sqrt(5.0)) / math.pi,
    60.0 * math.sqrt(3.0) / (3.0 + math.sqrt(5.0)) ** 2 / math.pi,
)
# |Σ A0 n| / Σ A0, the open share of the sum of areas, above which an element is at the surface.
_OPEN = 0.25


def weighted_areas(lattice: Lattice) -> PerBond:
    """Return the weighted contact area A of each bond [m²], user's order, shape (m,)."""
    i, j = lattice.pairs.T
    radius = lattice.particles.radius
    plain = math.pi * (0.5 * (radius[i] + radius[j])) ** 2
    n = len(radius)
    number = np.bincount(i, minlength=n) + np.bincount(j, minlength=n)
    total = np.bincount(i, weights=plain, minlength=n) + np.bincount(j, weights=plain, minlength=n)
    wanted = 4.0 * math.pi * radius**2 * np.interp(number, _FACES, _SURFACES)
    scale = wanted / np.where(total > 0.0, total, 1.0)
    skin = _open(lattice, plain, total.astype(float)) | (number < 4)
    usual = scale[~skin & (number > 0)].mean() if (~skin & (number > 0)).any() else scale[number > 0].mean()
    of_i = np.where(skin[i], np.where(skin[j], usual, scale[j]), scale[i])
    of_j = np.where(skin[j], np.where(skin[i], usual, scale[i]), scale[j])
    return 0.5 * (of_i + of_j) * plain


def _open(lattice: Lattice, plain: PerBond, total: Floats) -> Mask:
    """Return a mask of the elements at the surface, (n,), given `plain` A0 of bonds and its sums per element."""
    i, j = lattice.pairs.T
    areas = plain[:, None] * (lattice.branch / lattice.length[:, None])
    left = row_sums(i, areas, len(total)) - row_sums(j, areas, len(total))
    return np.linalg.norm(left, axis=1) > _OPEN * total
