"""Boxes of cells with a flat plane of facets: cells beside the plane are mirrored about it."""

import warnings
from dataclasses import dataclass
from functools import cache

import numpy as np
from scipy.spatial import KDTree

import bondem as bd
from validation.studies.paths.driving import Floats

# How far from the plane cells are mirrored, over their size; rounds in which cells move to their centroids.
_BAND, _ROUNDS = 1.5, 6
_FLAT = 1e-6


@dataclass(frozen=True, eq=False)
class Halves:
    """A body in two parts with a flat plane between them.

    Attributes:
        body: cells of a box.
        above, below: the parts.
        area: of the facets between them [m²].
        facets: their numbers.
    """

    body: bd.Lattice
    above: bd.Index
    below: bd.Index
    area: float
    facets: np.ndarray


@cache
def halves(edges: tuple[float, float, float], normal: tuple[float, float, float], seed: int, count: int) -> Halves:
    """A box about whose middle runs a plane of facets.

    Args:
        edges: of the box [m].
        normal: of the plane, of length 1.
        seed, count: of the packing it is made from; the body has about as many cells.

    Raises:
        RuntimeError: a facet between both parts that does not lie in the plane.
    """
    box, n, size = bd.Box(edges), np.array(normal), np.array(edges)
    middle = 0.5 * size
    cell = (box.volume / count) ** (1.0 / 3.0)

    def mirrored(place: Floats) -> Floats:
        return place - 2.0 * ((place - middle) @ n)[:, None] * n

    place = bd.pack(box, count=count, method="even", seed=seed).position
    height = (place - middle) @ n
    margin = 0.02 * cell
    whole = bool(np.isclose(np.abs(n), 1.0).any())  # the box is its own mirror image
    near = np.abs(height) < (np.inf if whole else _BAND * cell)
    one = place[near & (height > 0.0)]
    one = one[((mirrored(one) > margin) & (mirrored(one) < size - margin)).all(axis=1)]
    pairs = len(one)
    place = np.concatenate([one, mirrored(one), place[~near]])
    for _ in range(_ROUNDS):
        cells = cut(place, box, cell).cells
        assert cells is not None
        centroid = cells.centroid
        one = 0.5 * (centroid[:pairs] + mirrored(centroid[pairs : 2 * pairs]))
        for _ in range(_ROUNDS):  # back into the box, both of each pair
            one = mirrored(np.clip(mirrored(np.clip(one, margin, size - margin)), margin, size - margin))
        rest = centroid[2 * pairs :]
        height = (rest - middle) @ n
        off = np.maximum(_BAND * cell - np.abs(height), 0.0) * np.sign(height)
        rest = np.clip(rest + off[:, None] * n, margin, size - margin)  # away from the plane, which they would tilt
        place = np.concatenate([one, mirrored(one), rest])
    body = cut(place, box, cell)
    above = (place - middle) @ n > 0.0
    i, j = body.pairs.T
    across = np.flatnonzero(above[i] != above[j])
    assert body.facets is not None
    tilted = np.abs(np.abs(body.facets.normal[across] @ n) - 1.0) > _FLAT
    area = body.facets.area[across]
    if area[tilted].sum() > _FLAT * area.sum():
        raise RuntimeError(f"{tilted.sum()} of {len(across)} facets are not in the plane; take another packing")
    return Halves(body, bd.Index(np.flatnonzero(above)), bd.Index(np.flatnonzero(~above)), float(area.sum()), across)


def cut(place: Floats, shape: bd.Shape, cell: float) -> bd.Lattice:
    """Cells about points in a shape; of spheres of one size, which are as large as the nearest two points allow."""
    apart = KDTree(place).query(place, k=2)[0][:, 1].min()
    radius = np.full(len(place), min(0.5 * cell, 0.5 * apart))  # of equal ones nothing depends on it
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", bd.errors.FillingWarning)  # spheres are small where pairs are close
        return bd.connect(bd.Particles(place, radius, shape=shape), method="laguerre")
