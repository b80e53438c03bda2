"""Bonding of elements, by gap, by reach or by the facets of Laguerre cells."""

from collections.abc import Callable
from typing import Literal

import numpy as np
from scipy.spatial import KDTree

from bondem._checks import choice, instance, number
from bondem._names import warn_user
from bondem._progress import staged
from bondem.errors import FillingWarning, InputError
from bondem.specimen.lattice import Lattice
from bondem.specimen.particles import Particles
from bondem.specimen.tessellation.cutting import tessellate

#: Methods of bonding elements.
Method = Literal["distance", "laguerre"]

# Gap over R̄ up to which spheres touch, because contacts of a packing are closed only to rounding.
_TOUCH = 1e-9
# Reach over the largest radius from which pairs are counted before they are listed, and largest number per element.
_FAR, _MOST = 6.0, 500


@staged("connecting")
def connect(
    particles: Particles,
    *,
    tolerance: float | None = None,
    reach: float | None = None,
    method: Method = "distance",
    progress: Callable[[float], None] | None = None,
) -> Lattice:
    """Bond neighbouring elements, either by distance or by cutting the shape into cells.

    Args:
        particles: the elements.
        tolerance: bond where gap <= tolerance · R̄ [-], with gap = L - (Ri + Rj) and the mean radius R̄; None for 0.
        reach: bond where L <= reach · (Ri + Rj) [-], the contact-radius multiplier η_r of Chen et al. (2022).
        method: "distance" or "laguerre". The latter cuts the shape into Laguerre cells, one per element, and bonds
            cells that share a facet; the lattice then has `facets` and `cells`. Particles without a shape use the
            bounding box of the spheres.
        progress: function called repeatedly with the completed share, 0 … 1; only for "laguerre".

    Returns:
        The lattice; its pairs are sorted and have i < j.

    Raises:
        InputError: Both `tolerance` and `reach` are given, or one with "laguerre"; they reach too far, or no pair is
            near enough; a centre lies outside the shape to be cut, or an element has no Laguerre cell.
        DisconnectedError: The specimen consists of two large pieces.

    Warns:
        FillingWarning: Equal spheres have so few bonds that they are probably centres of cells.
    """
    choice("connect", "method", method, Method)
    instance("connect", "particles", particles, Particles, "bd.Particles")
    if method == "laguerre":
        if tolerance is not None or reach is not None:
            raise InputError("connect: all cells that share a facet are bonded; leave out tolerance= and reach=")
        pairs, facets, cells = tessellate(particles, progress)
        return Lattice(particles, pairs, facets=facets, cells=cells)
    if tolerance is not None and reach is not None:
        raise InputError("connect: tolerance= and reach= exclude each other; leave one out")
    stretch, slack = 1.0, _TOUCH * particles.mean_radius
    if reach is not None:
        stretch = number("connect", "reach", reach, above=0.0, advice="a positive multiple of the radii [-]")
    if tolerance is not None:
        advice = "a finite bonding distance, in mean radii [-]"
        slack += number("connect", "tolerance", tolerance, advice=advice) * particles.mean_radius
    r = particles.radius
    farthest = stretch * 2.0 * r.max() + slack
    if particles.period is not None and 2.0 * farthest >= particles.period.min():
        raise InputError(f"bonds up to {farthest:.3g} m need a periodic cell of more than twice that; enlarge it")
    if farthest <= 0.0:
        raise InputError(f"connect: tolerance = {tolerance} requires overlaps that no two spheres have; raise it")
    tree = KDTree(particles.position, boxsize=particles.period)
    if farthest > _FAR * r.max() and len(r) > _MOST:
        each = (tree.count_neighbors(tree, farthest) - len(r)) / len(r)
        if each > _MOST:
            raise InputError(
                f"bonds up to {farthest:.3g} m are {each:.0f} per element; lower tolerance= or reach= (in radii)"
            )
    near = tree.query_pairs(farthest, output_type="ndarray")
    near = np.sort(near.astype(np.int64).reshape(-1, 2), axis=1)
    gap = np.linalg.norm(particles.separation(near[:, 0], near[:, 1]), axis=1)
    pairs = near[gap <= stretch * (r[near[:, 0]] + r[near[:, 1]]) + slack]
    if len(pairs) == 0:
        raise InputError("no two elements are near enough to bond; raise tolerance= or check the units (metres)")
    if tolerance is None and reach is None and len(pairs) < len(r) / 2 and np.ptp(r) == 0.0:
        warn_user(
            f"connect: {len(r)} equal spheres touch in only {len(pairs)} places; if they are centres of cells,"
            ' as of bd.pack(method="even"), give method="laguerre"; for bonded spheres pack without method="even"',
            FillingWarning,
        )
    return Lattice(particles, pairs[np.lexsort((pairs[:, 1], pairs[:, 0]))])
