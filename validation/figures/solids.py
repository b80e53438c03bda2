"""Triangles drawn in parallel projection, with a depth buffer: small closed surfaces, lit from above the left."""

import numpy as np

from bondem._types import Floats
from bondem.report.spheres import View

_LIGHT = np.array([-0.45, 0.60, 0.66])
_OVERSAMPLING = 3


def render_triangles(corner: Floats, colour: Floats, *, view: View, width: int, reach: float) -> Floats:
    """Draw triangles.

    Args:
        corner: of each triangle, (k, 3, 3).
        colour: red, green, blue in 0 … 1, (k, 3).
        view: where one looks from.
        width: of the square picture [pixel].
        reach: half the width of what is seen, about the origin.

    Returns:
        Red, green, blue and opacity in 0 … 1, (width, width, 4).
    """
    size = _OVERSAMPLING * width
    placed = corner @ view.axes.T
    normal = np.cross(placed[:, 1] - placed[:, 0], placed[:, 2] - placed[:, 0])
    length = np.linalg.norm(normal, axis=1)
    # Seen from either side, lit on the side one sees.
    normal *= np.where(normal[:, 2] < 0.0, -1.0, 1.0)[:, None] / np.maximum(length, 1e-300)[:, None]
    light = 0.62 + 0.32 * np.clip(normal @ (_LIGHT / np.linalg.norm(_LIGHT)), 0.0, None)
    shaded = np.clip(colour * light[:, None], 0.0, 1.0)
    pixel = (placed[:, :, :2] / reach + 1.0) * 0.5 * size
    depth = np.full((size, size), -np.inf)
    image = np.zeros((size, size, 4))
    for k in np.flatnonzero(length > 0.0):
        lower = np.clip(np.floor(pixel[k].min(axis=0)).astype(int), 0, size)
        upper = np.clip(np.ceil(pixel[k].max(axis=0)).astype(int), 0, size)
        x, y = np.meshgrid(np.arange(lower[0], upper[0]) + 0.5, np.arange(lower[1], upper[1]) + 0.5)
        (ax, ay), (bx, by), (cx, cy) = pixel[k]
        whole = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay)
        if x.size == 0 or abs(whole) < 1e-9:
            continue
        v = ((x - ax) * (cy - ay) - (cx - ax) * (y - ay)) / whole
        w = ((bx - ax) * (y - ay) - (x - ax) * (by - ay)) / whole
        u = 1.0 - v - w
        height = u * placed[k, 0, 2] + v * placed[k, 1, 2] + w * placed[k, 2, 2]
        window = np.s_[lower[1] : upper[1], lower[0] : upper[0]]
        seen = (u >= 0.0) & (v >= 0.0) & (w >= 0.0) & (height > depth[window])
        depth[window][seen] = height[seen]
        image[window][seen] = (*shaded[k], 1.0)
    coarse = image.reshape(width, _OVERSAMPLING, width, _OVERSAMPLING, 4).mean(axis=(1, 3))
    opacity = coarse[:, :, 3:]
    coarse[:, :, :3] = np.where(opacity > 0.0, coarse[:, :, :3] / np.maximum(opacity, 1e-9), 1.0)
    return coarse[::-1]
