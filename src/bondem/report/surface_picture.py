"""Pictures of surfaces with the names of their patches."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patheffects import withStroke
from scipy.ndimage import distance_transform_edt

from bondem._types import Floats, Ints
from bondem.geometry.smooth_patches import Patch
from bondem.geometry.surface import Surface
from bondem.report.cell_pictures import light_on
from bondem.report.overlays import seen_from
from bondem.report.piece_colours import piece_palette
from bondem.report.spheres import View
from bondem.report.style import INK

# Pixels along the longer side, largest number of names, and least distance of a name from the edge of its patch
# [pixels].
_PIXELS, _NAMED, _ROOM = 1000, 60, 5.0


def draw_patches(ax: Axes, surface: Surface, view: View) -> str:
    """Draw a surface in the colours of its patches, with their names where they are visible.

    Patches are the parts that the file of the surface names, or else the numbered smooth parts.

    Returns:
        Text with the number of names in this view, such as "5 of 8 patches".
    """
    patches = surface.patches[: len(surface.named)] or surface.patches
    label = np.full(len(surface.triangles), len(patches))
    for k, one in enumerate(patches):
        label[one.triangles] = k
    corner = seen_from(surface.vertices, view)[surface.triangles]
    normal = np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0])
    triangle, extent = _raster(corner, normal)
    seen = triangle >= 0
    patch = np.where(seen, label[triangle], -1)
    unit = normal / np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-300)
    colour = 0.5 + 0.5 * np.vstack([piece_palette(len(patches)), np.full((1, 3), 0.8)])
    image = np.ones((*patch.shape, 4))
    image[..., :3] = np.clip(colour[patch] * light_on(unit)[triangle][..., None], 0.0, 1.0)
    image[_borders(patch), :3] = 0.25
    image[~seen & ~_borders(patch), 3] = 0.0
    ax.imshow(image, extent=extent, origin="lower", interpolation="antialiased", zorder=1)
    ax.set(aspect="equal")
    ax.axis("off")
    named = _write_names(ax, patches, patch, extent)
    return f"{named} of {len(patches)} patches"


def _raster(corner: Floats, normal: Floats) -> tuple[Ints, tuple[float, float, float, float]]:
    """Find the nearest triangle of each pixel from places and depths of corners in the picture, (t, 3, 3) [mm].

    Returns:
        Number of the triangle of each pixel, or -1, and the left, right, lower and upper side of the picture [mm].
    """
    lower, upper = corner.min(axis=(0, 1)), corner.max(axis=(0, 1))
    pixel = float((upper - lower)[:2].max()) / _PIXELS
    low = lower[:2] - 2.0 * pixel
    across, up = (int(n) for n in np.ceil((upper[:2] + 2.0 * pixel - low) / pixel))
    nearest, triangle = np.full((up, across), -np.inf), np.full((up, across), -1)
    place = (corner[:, :, :2] - low) / pixel - 0.5  # pixel k has its middle at k
    for k in np.flatnonzero(normal[:, 2] > 0.0):
        (a, b, c), depth = place[k], corner[k, :, 2]
        first = np.ceil(place[k].min(axis=0)).astype(int)
        last = np.floor(place[k].max(axis=0)).astype(int) + 1
        if (first >= last).any():
            continue
        x, y = np.arange(first[0], last[0]), np.arange(first[1], last[1])[:, None]
        whole = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
        v = ((x - a[0]) * (c[1] - a[1]) - (y - a[1]) * (c[0] - a[0])) / whole
        w = ((b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0])) / whole
        at = depth[0] + v * (depth[1] - depth[0]) + w * (depth[2] - depth[0])
        here = np.s_[first[1] : last[1], first[0] : last[0]]
        nearer = (v >= 0.0) & (w >= 0.0) & (v + w <= 1.0) & (at > nearest[here])
        nearest[here][nearer], triangle[here][nearer] = at[nearer], k
    high = low + pixel * np.array([across, up])
    return triangle, (float(low[0]), float(high[0]), float(low[1]), float(high[1]))


def _borders(patch: Ints) -> np.ndarray:
    """Return a mask of the pixels on a border between patches or at the outline, (height, width)."""
    found = np.zeros(patch.shape, dtype=bool)
    for axis in (0, 1):
        for shift in (1, -1):
            found |= patch != np.roll(patch, shift, axis=axis)
    return found


def _write_names(ax: Axes, patches: tuple[Patch, ...], patch: Ints, extent: tuple[float, ...]) -> int:
    """Write the names of patches in the middle of their visible parts, and return the number of names."""
    named, (height, width) = 0, patch.shape
    for k, one in enumerate(patches[:_NAMED]):
        rows, columns = np.nonzero(patch == k)
        if not len(rows):
            continue
        low = np.array([rows.min(), columns.min()])
        own = np.zeros((np.ptp(rows) + 3, np.ptp(columns) + 3), dtype=bool)  # with an empty margin
        own[rows - low[0] + 1, columns - low[1] + 1] = True
        room = distance_transform_edt(own)
        if room.max() < _ROOM:
            continue
        # of the places with about the most room, the one nearest to the middle
        wide = np.argwhere(room >= 0.9 * room.max()) + low - 1
        row, column = wide[np.hypot(*(wide - [rows.mean(), columns.mean()]).T).argmin()]
        x = extent[0] + (column + 0.5) / width * (extent[1] - extent[0])
        y = extent[2] + (row + 0.5) / height * (extent[3] - extent[2])
        ax.text(x, y, one.name, ha="center", va="center", fontsize=8.0, color=INK, zorder=6,
                path_effects=[withStroke(linewidth=2.0, foreground="white")])  # fmt: skip
        named += 1
    return named
