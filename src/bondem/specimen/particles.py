"""Particles: spheres with a centre and a radius."""

from dataclasses import dataclass

import numpy as np
from scipy.spatial import KDTree

from bondem._checks import array, instance, shown
from bondem._types import ArrayLike, PerElement, PerElement3, Vector
from bondem.errors import InputError
from bondem.geometry.elementary_shapes import BoundingBox, Cell, Shape
from bondem.specimen.filling import check_filling

# Limits of radii and coordinates [m], beyond which masses or moments of inertia overflow or vanish.
_SMALLEST, _LARGEST = 1e-60, 1e60


def freeze(values: np.ndarray) -> np.ndarray:
    """Make an array read-only and return it."""
    values.setflags(write=False)
    return values


@dataclass(frozen=True, eq=False)
class Particles:
    """Spheres in the user's order.

    Attributes:
        position: centres [m], shape (n, 3).
        radius: radii [m], shape (n,); one number may be given for all.
        period: edge lengths of the periodic cell [m], (3,), or None; taken from `shape` if that is a Cell.
        shape: shape filled by the spheres; with a period and no shape it is the periodic cell. None is allowed: faces
            and sections then use the bounding box of the spheres.

    Raises:
        InputError: An array has the wrong shape, a value is not finite, or a radius is not positive. Two spheres
            overlap by more than half the smaller radius. More than 1 % of the centres lie outside the shape. An edge
            of the periodic cell is shorter than two of the largest diameters.

    Warns:
        FillingWarning: Spheres stick out of the shape or do not reach all of its faces.
    """

    position: PerElement3
    radius: PerElement
    period: Vector | None = None
    shape: Shape | None = None

    def __init__(
        self, position: ArrayLike, radius: ArrayLike, period: ArrayLike | None = None, shape: Shape | None = None
    ) -> None:
        x = array("", "position", position, wanted="centres as an array of shape (n, 3) [m]")
        r = array("", "radius", radius, wanted="one radius, or shape (n,) [m]")
        if x.ndim != 2 or x.shape[1] != 3 or len(x) == 0:
            raise InputError(f"position has shape {x.shape}; give centres as an array of shape (n, 3)")
        if r.ndim == 0:
            r = np.full(len(x), float(r))
        if r.shape != (len(x),):
            raise InputError(f"radius has shape {r.shape} for {len(x)} centres; give shape ({len(x)},)")
        _check_finite("position", x)
        _check_finite("radius", r)
        if (r <= 0.0).any():
            worst = int(np.argmin(r))
            raise InputError(f"radius[{worst}] = {r[worst]} m; every radius must be positive")
        for name, values in (("position", x), ("radius", r)):
            far = np.abs(values)
            if far.max() > _LARGEST or (name == "radius" and far.min() < _SMALLEST):
                worst = far.max() if far.max() > _LARGEST else far.min()
                raise InputError(f"{name} {worst:.3g} m is not a plausible length; check its units (metres)")
        if shape is not None:
            instance("Particles", "shape", shape, Shape, "a shape such as bd.Box(...), or None")
        if period is None and shape is not None:
            period = shape.period
        cell = None
        if period is not None:
            cell = array("Particles", "period", period, wanted="three positive edge lengths in metres")
            if cell.shape != (3,) or not (np.isfinite(cell) & (cell > 0.0)).all():
                raise InputError(f"period = {shown(period)}; give three positive edge lengths in metres")
            if cell.min() < 4.0 * r.max():
                raise InputError(f"period {cell.min():.4g} m is below two of the largest diameters; enlarge the cell")
            x = np.mod(x, cell)
            x[x >= cell] = 0.0  # rounding may move a place just below 0 to the far end, which is the same as 0
            freeze(cell)
        own = Cell(cell) if shape is None and cell is not None else shape
        for name, value in (("position", freeze(x)), ("radius", freeze(r)), ("period", cell), ("shape", own)):
            object.__setattr__(self, name, value)
        self._check_overlap()
        if shape is not None:
            check_filling(shape, x, r)

    def _check_overlap(self) -> None:
        tree = KDTree(self.position, boxsize=self.period)
        # if radii have another unit than centres, nearly all pairs overlap, too many for memory: check a few first
        some = np.linspace(0, len(self) - 1, min(len(self), 100)).astype(int)
        two = np.asarray(tree.query(self.position[some], k=2)[1])
        nearest = np.where(two[:, 1] == some, two[:, 0], two[:, 1])  # either of two coincident centres comes first
        known = nearest < len(self)
        self._refuse_overlap(np.column_stack([some, nearest])[known])
        self._refuse_overlap(tree.query_pairs(1.5 * self.radius.max(), output_type="ndarray"))

    def _refuse_overlap(self, close: np.ndarray) -> None:
        if len(close) == 0:
            return
        i, j = close.T
        smaller = np.minimum(self.radius[i], self.radius[j])
        overlap = self.radius[i] + self.radius[j] - np.linalg.norm(self.separation(i, j), axis=1)
        bad = np.flatnonzero(overlap > 0.5 * smaller)
        if bad.size:
            a, b = sorted(close[bad[0]])
            raise InputError(
                f"elements {a} and {b} overlap by {overlap[bad[0]]:.3g} m, more than half the smaller radius"
                f" (at least {bad.size} such pairs); remove doubled or coincident spheres, and give"
                " centres and radii both in metres"
            )

    def separation(self, i: np.ndarray, j: np.ndarray) -> np.ndarray:
        """Return vectors from centres i to centres j over the nearest periodic image [m], shape (k, 3)."""
        return self.nearest(self.position[j] - self.position[i])

    def nearest(self, branch: np.ndarray) -> np.ndarray:
        """Return the vectors (k, 3) reduced to the nearest periodic image [m]."""
        if self.period is None:
            return branch
        return branch - self.period * np.rint(branch / self.period)

    def __len__(self) -> int:
        return len(self.radius)

    @property
    def mean_radius(self) -> float:
        """Mean radius R̄ of all elements [m]."""
        return float(self.radius.mean())

    @property
    def volume(self) -> PerElement:
        """Volumes of the spheres [m³], shape (n,)."""
        return 4.0 / 3.0 * np.pi * self.radius**3

    @property
    def envelope(self) -> Shape:
        """Shape of the particles, or the bounding box of the spheres if no shape is given."""
        return self.shape if self.shape is not None else BoundingBox.of(self.position, self.radius)


def filled(particles: Particles, shape: Shape | None) -> Particles:
    """Return the same particles with `shape` as their shape, without a check that they fill it.

    Particles packed into the shape need no check; particles cut to it may stick out.
    """
    same = Particles.__new__(Particles)
    for name, value in (*vars(particles).items(), ("shape", shape)):
        object.__setattr__(same, name, value)
    return same


def _check_finite(name: str, values: np.ndarray) -> None:
    bad = np.argwhere(~np.isfinite(values))
    if len(bad):
        where = "".join(f"[{k}]" for k in bad[0])
        value = values[tuple(bad[0])]
        raise InputError(f"{name}{where} is {value}; every {name} must be a finite number of metres")
