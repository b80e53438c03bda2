"""Aggregates in a matrix: a region of the elements inside balls."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from scipy.spatial import KDTree

from bondem._checks import array, possible
from bondem._types import ArrayLike, Floats, Mask, PerElement3
from bondem.errors import InputError
from bondem.specimen.lattice import Lattice
from bondem.specimen.regions import Everything, Region


@dataclass(frozen=True)
class Aggregates(Region):
    """The elements inside balls: coarse aggregates of a concrete, or inclusions in another body.

    `bd.pack(..., around=aggregates)` places centres of cells on both sides of the surfaces of the balls, so that
    cells end there.

    Attributes:
        position: centres of the balls [m], shape (k, 3).
        radius: radius of each ball [m], shape (k,).

    Raises:
        InputError: An array has the wrong shape, is empty or not finite, a radius is not positive, or balls overlap.
    """

    position: Sequence[Sequence[float]] | ArrayLike
    radius: Sequence[float] | ArrayLike

    def __post_init__(self) -> None:
        wanted = "centres of shape (k, 3) and k radii [m]"
        position, radius = (array("Aggregates", name, getattr(self, name), wanted=wanted)
                            for name in ("position", "radius"))  # fmt: skip
        if position.ndim != 2 or position.shape != (len(position), 3) or radius.shape != (len(position),):
            raise InputError(f"Aggregates: position {position.shape} and radius {radius.shape}; give {wanted}")
        if not len(radius) or not (possible(position) and possible(radius) and (radius > 0.0).all()):
            raise InputError("Aggregates: give at least one ball, finite centres and positive radii [m]")
        # tuples, so that regions can be compared and written to run files
        object.__setattr__(self, "position", tuple(map(tuple, position.tolist())))
        object.__setattr__(self, "radius", tuple(radius.tolist()))
        if len(radius) > 1 and self.gap < 0.0:
            raise InputError(f"Aggregates: balls overlap by {-self.gap:.3g} m; move them apart")

    def __len__(self) -> int:
        return len(self._radii)

    @cached_property
    def _centres(self) -> Floats:
        return np.array(self.position, dtype=float)

    @cached_property
    def _radii(self) -> Floats:
        return np.array(self.radius, dtype=float)

    @property
    def volume(self) -> float:
        """Total volume of the balls [m³]."""
        return 4.0 / 3.0 * np.pi * float((self._radii**3).sum())

    @property
    def matrix(self) -> Region:
        """Region of all elements outside the balls."""
        return Everything() - self

    @property
    def gap(self) -> float:
        """Smallest distance between the surfaces of two balls [m]; inf for a single ball."""
        x, R = self._centres, self._radii
        if len(R) == 1:
            return float("inf")
        # the pair with the smallest gap is at most this far apart
        distance, other = (np.asarray(found)[:, 1] for found in KDTree(x).query(x, k=2))
        reach = float((distance - R - R[other]).min()) + 2.0 * float(R.max())
        pairs = KDTree(x).query_pairs(max(reach, 0.0) * (1.0 + 1e-12), output_type="ndarray")
        i, j = pairs.T if len(pairs) else (np.arange(len(R)), other)
        return float((np.linalg.norm(x[i] - x[j], axis=1) - R[i] - R[j]).min())

    def depth(self, points: PerElement3) -> Floats:
        """Return the distance of points (n, 3) [m] from the nearest surface, positive inside a ball [m], (n,)."""
        x, R = self._centres, self._radii
        # a loop over the balls is fast enough for the thousands that occur
        found = np.full(len(points), -np.inf)
        for centre, radius in zip(x, R, strict=True):
            near = np.abs(points - centre).max(axis=1) < radius - found
            found[near] = np.maximum(found[near], radius - np.linalg.norm(points[near] - centre, axis=1))
        return found

    def mask(self, lattice: Lattice) -> Mask:
        """Return a mask of the elements whose particle has its centre inside a ball, shape (n,)."""
        return self.depth(lattice.particles.position) > 0.0
