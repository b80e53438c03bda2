"""Spheres and tubes in parallel projection, with soft shadows between close neighbours.

A sphere in parallel projection is a disc of known depth. A depth buffer in NumPy therefore draws ten thousand spheres
in a second, without a graphics driver or window system, and identically on every machine.
"""

import math
from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from scipy.ndimage import gaussian_filter

from bondem._types import Floats, Ints

_LIGHT = np.array([-0.45, 0.60, 0.66])
_OVERSAMPLING = 2
_BATCH = 4_000_000


@dataclass(frozen=True)
class View:
    """Direction of view.

    Attributes:
        azimuth: rotation of the camera about z, from a view along +y [rad].
        elevation: elevation of the camera above the horizon [rad].
    """

    azimuth: float = 0.35
    elevation: float = 0.45

    @property
    def axes(self) -> Floats:
        """Axes of the view as rows: right, up and towards the viewer, (3, 3)."""
        s, c = math.sin(self.azimuth), math.cos(self.azimuth)
        toward = np.array([math.cos(self.elevation) * s, -math.cos(self.elevation) * c, math.sin(self.elevation)])
        right = np.array([c, s, 0.0])
        return np.array([right, np.cross(toward, right), toward])


def render(position: Floats, radius: Floats, colour: Floats, *, view: View, width: int) -> Floats:
    """Draw spheres into an array of pixels.

    Args:
        position: centres in any unit of length, (n, 3).
        radius: radii in the same unit, (n,).
        colour: red, green, blue in 0 … 1, (n, 3).
        view: direction of view.
        width: width of the picture [pixels].

    Returns:
        Red, green, blue and opacity in 0 … 1, (height, width, 4), read-only.
    """
    arrays = (np.ascontiguousarray(one, dtype=float).tobytes() for one in (position, radius, colour))
    return _rendered(*arrays, view, width)


# Each figure of a report is drawn twice, wide and for phones, from the same pictures of spheres, three at most.
@lru_cache(maxsize=3)
def _rendered(positions: bytes, radii: bytes, colours: bytes, view: View, width: int) -> Floats:
    position, radius = np.frombuffer(positions).reshape(-1, 3), np.frombuffer(radii)
    colour = np.frombuffer(colours).reshape(-1, 3)
    placed = position @ view.axes.T
    margin = 1.02 * radius.max()
    lower, upper = placed[:, :2].min(axis=0) - margin, placed[:, :2].max(axis=0) + margin
    scale = _OVERSAMPLING * width / (upper[0] - lower[0])
    columns = _OVERSAMPLING * width
    rows = _OVERSAMPLING * math.ceil((upper[1] - lower[1]) * scale / _OVERSAMPLING)
    centre = np.column_stack([(placed[:, :2] - lower) * scale, placed[:, 2] * scale])
    size = radius * scale
    depth = np.full(rows * columns, -np.inf)
    owner = np.full(rows * columns, -1)
    for _, pixel, height in _covered(centre, size, columns, rows):
        np.maximum.at(depth, pixel, height)
    for number, pixel, height in _covered(centre, size, columns, rows):
        seen = height == depth[pixel]
        owner[pixel[seen]] = number[seen]
    image = _shaded(depth.reshape(rows, columns), owner.reshape(rows, columns), centre, size, colour)
    fine = image.reshape(rows // _OVERSAMPLING, _OVERSAMPLING, columns // _OVERSAMPLING, _OVERSAMPLING, 4)
    coarse = fine.mean(axis=(1, 3))
    opacity = coarse[:, :, 3:]
    coarse[:, :, :3] = np.where(opacity > 0.0, coarse[:, :, :3] / np.maximum(opacity, 1e-9), 1.0)
    picture = coarse[::-1].clip(0.0, 1.0)
    picture.flags.writeable = False
    return picture


def tubes(start: Floats, end: Floats, radius: float) -> tuple[Floats, Ints]:
    """Represent segments between points (k, 3) by overlapping spheres; return their centres and segment numbers."""
    count = np.maximum(2, np.ceil(np.linalg.norm(end - start, axis=1) / (0.7 * radius))).astype(int)
    segment = np.repeat(np.arange(len(start)), count)
    step = np.arange(len(segment)) - np.repeat(np.cumsum(count) - count, count)
    share = (step / (count[segment] - 1))[:, None]
    return start[segment] * (1.0 - share) + end[segment] * share, segment


def _covered(
    centre: Floats, size: Floats, columns: int, rows: int
) -> Iterator[tuple[Ints, Ints, Floats]]:
    """Yield batches of (sphere, pixel, depth) over all pixels covered by spheres."""
    order = np.argsort(size, kind="stable")
    first = 0
    while first < len(order):
        reach = math.ceil(size[order[first]]) + 1
        batch = max(1, _BATCH // (2 * reach + 1) ** 2)
        chosen = order[first : first + batch]
        chosen = chosen[size[chosen] <= 1.3 * size[chosen[0]] + 1.0]
        first += len(chosen)
        reach = math.ceil(size[chosen].max())
        offset = np.arange(-reach, reach + 1)
        corner = np.floor(centre[chosen, :2]).astype(int)
        column = corner[:, 0, None] + offset
        row = corner[:, 1, None] + offset
        aside = (column + 0.5 - centre[chosen, 0, None]) ** 2
        above = (row + 0.5 - centre[chosen, 1, None]) ** 2
        rest = size[chosen, None, None] ** 2 - above[:, :, None] - aside[:, None, :]
        which, i, j = np.nonzero(rest > 0.0)
        row, column = row[which, i], column[which, j]
        yield chosen[which], row * columns + column, centre[chosen[which], 2] + np.sqrt(rest[which, i, j])


def _shaded(depth: Floats, owner: Ints, centre: Floats, size: Floats, colour: Floats) -> Floats:
    drawn = owner >= 0
    who = owner[drawn]
    row, column = np.nonzero(drawn)
    place = np.column_stack([column + 0.5, row + 0.5, depth[drawn]])
    normal = (place - centre[who]) / size[who, None]
    facing = np.clip(normal @ (_LIGHT / np.linalg.norm(_LIGHT)), 0.0, None)
    # shadow where neighbours are nearer to the viewer: blurred depth less depth (Luft et al. 2006)
    coarse = float(size.max())
    height = np.where(drawn, depth, 0.0)
    hidden = np.zeros(len(who))
    for reach in (0.5 * coarse, 1.5 * coarse):
        blurred = _blurred(height, reach)[drawn] / _blurred(drawn.astype(float), reach)[drawn]
        hidden += np.clip(blurred - depth[drawn], 0.0, None) / reach
    light = (0.50 + 0.55 * facing) * (0.35 + 0.65 * np.exp(-0.6 * hidden))
    shine = 0.18 * facing**24
    image = np.zeros((*depth.shape, 4))
    image[drawn, :3] = colour[who] * light[:, None] + shine[:, None]
    image[drawn, 3] = 1.0
    return image


def _blurred(field: Floats, reach: float) -> Floats:
    """Blur a field over `reach` pixels by a Gaussian, on means of blocks of at most a quarter of `reach`."""
    block = max(1, int(0.25 * reach))
    rows, columns = field.shape
    padded = np.pad(field, ((0, -rows % block), (0, -columns % block)))
    means = padded.reshape(len(padded) // block, block, -1, block).mean(axis=(1, 3))
    smooth = gaussian_filter(means, sigma=reach / block, truncate=2.5, mode="constant")
    return np.repeat(np.repeat(smooth, block, axis=0), block, axis=1)[:rows, :columns]
