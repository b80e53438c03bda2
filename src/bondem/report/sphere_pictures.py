"""Pictures of bonded spheres, at rest or in the pose of a state."""

import numpy as np
from matplotlib.axes import Axes

from bondem._types import Floats, Mask
from bondem.report.spheres import View, render
from bondem.specimen.lattice import Lattice

# Width of a picture in pixels, and the distance over the size of the specimen beyond which fragments are left out.
_PIXELS, _FLOWN = 900, 0.5


def draw_spheres(
    ax: Axes, lattice: Lattice, colour: Floats, *, view: View, moved: Floats | None = None, shown: Mask | None = None,
    scale: float = 1e3,
) -> None:  # fmt: skip
    """Draw elements as spheres, without elements far from the specimen.

    Elements are far if their displacement differs from the median by more than half the specimen's largest extent.

    Args:
        ax: axes to draw on.
        lattice: the specimen.
        colour: red, green and blue of each element in 0 … 1, (n, 3).
        view: direction of view.
        moved: displacements as drawn [m], (n, 3); None for zero.
        shown: mask of the elements to draw, (n,); None for all.
        scale: units of the axes per metre.
    """
    centre, radius = lattice.centre, lattice.particles.radius
    here = np.ones(len(radius), dtype=bool) if shown is None else shown
    if moved is not None:
        away = np.linalg.norm(moved - np.median(moved, axis=0), axis=1)
        here = here & (away <= _FLOWN * float(np.ptp(centre, axis=0).max()))
        centre = centre + moved
    centre, radius = centre[here], radius[here]
    image = render(centre, radius, colour[here], view=view, width=_PIXELS)
    placed, margin = centre @ view.axes.T, 1.02 * radius.max()
    low, high = scale * (placed[:, :2].min(axis=0) - margin), scale * (placed[:, :2].max(axis=0) + margin)
    ax.imshow(image, extent=(low[0], high[0], low[1], high[1]), interpolation="lanczos", zorder=1)
    ax.axis("off")
