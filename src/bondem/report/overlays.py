"""Additions to pictures of a model: coordinates, walls, and arrows of motions and loads."""

from itertools import product

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection, PolyCollection

from bondem._types import Floats, Ints
from bondem.boundary.wall_motions import Driven, Free, Servo
from bondem.boundary.wall_outlines import wall_outlines
from bondem.boundary.wall_rows import walls_at_rest
from bondem.boundary.walls import Wall
from bondem.model.model import Model
from bondem.model.state import State
from bondem.report.spheres import View
from bondem.report.style import GREY, INK

_WALL, _AXES = "#9fb3c8", ("#d55e00", "#00896b", "#0b6fa4")
# Length of arrows, over the diagonal of the box.
_ARROW = 0.16
# Pictures are in millimetres.
SCALE = 1e3


def seen_from(point: Floats, view: View) -> Floats:
    """Project points [m], (k, 3), to horizontal and vertical place and depth in the picture [mm], (k, 3)."""
    return SCALE * np.atleast_2d(point) @ view.axes.T


def box_edges(lower: Floats, upper: Floats) -> tuple[Floats, Ints]:
    """Return the corners of a box [m], (8, 3), and the numbers of the corners at the ends of its edges, (12, 2)."""
    pairs = [(a, b) for a in range(8) for b in range(a + 1, 8) if (a ^ b).bit_count() == 1]
    return np.array(list(product(*zip(lower, upper, strict=True)))), np.array(pairs)


def draw_box(ax: Axes, lower: Floats, upper: Floats, view: View) -> None:
    """Draw the rear edges of a box from `lower` to `upper` [m], its coordinates in mm, and the axes."""
    corner, pairs = box_edges(lower, upper)
    place = seen_from(corner, view)
    rear = pairs[(pairs == np.argmin(place[:, 2])).any(axis=1)]
    ax.add_collection(LineCollection(list(place[rear, :2]), colors=GREY, linewidths=0.7, zorder=0))
    diagonal = SCALE * float(np.linalg.norm(upper - lower))
    anchor, long = place[:, :2].min(axis=0) - 0.02 * diagonal, 0.13 * diagonal
    for k, (name, colour) in enumerate(zip("xyz", _AXES, strict=True)):
        along = long * view.axes[:2, k]
        ax.annotate("", tuple(anchor + along), tuple(anchor),
                    arrowprops={"arrowstyle": "-|>", "color": colour, "linewidth": 1.4},
                    annotation_clip=False)  # fmt: skip
        x, y = anchor + 1.22 * along
        ax.text(x, y, name, color=colour, ha="center", va="center", fontsize=9.0, clip_on=False)
    ends = ", ".join(
        f"{name} {SCALE * low:.4g} … {SCALE * high:.4g}" for name, low, high in zip("xyz", lower, upper, strict=True)
    )
    ax.text(0.5, -0.06, f"{ends} mm", transform=ax.transAxes, ha="center", va="top", fontsize=8.5, color=INK)


def draw_walls(ax: Axes, model: Model, state: State | None, lower: Floats, upper: Floats, view: View) -> None:
    """Draw walls in a state (None: at rest) about a box from `lower` to `upper` [m], with arrows of their motions."""
    if not model.walls:
        return
    outlines = wall_outlines(model.walls, lower, upper)
    moved = outlines.moved(walls_at_rest(len(model.walls)) if state is None else state.walls)
    place = seen_from(moved, view)
    middle = seen_from(0.5 * (lower + upper), view)[0, 2]
    for number, wall in enumerate(model.walls):
        mine = np.flatnonzero(outlines.wall == number)
        loops = [place[outlines.start[k] : outlines.start[k + 1]] for k in mine]
        every = np.concatenate(loops)
        ax.add_collection(PolyCollection(
            [loop[:, :2] for loop in loops], facecolors=_WALL, edgecolors=GREY, alpha=0.28,
            linewidths=0.8 if len(loops) == 1 else 0.0, zorder=0.5 if every[:, 2].mean() < middle else 5,
        ))  # fmt: skip
        along = _motion_of(wall)
        if along is not None:
            start = np.concatenate([moved[outlines.start[k] : outlines.start[k + 1]] for k in mine])
            draw_arrow(ax, start.mean(axis=0), along, lower, upper, view, INK)


def _motion_of(wall: Wall) -> Floats | None:
    """Return a vector of any length along the motion of a wall, (3,); None for a wall without translation."""
    along = np.zeros(3)
    match wall.motion:
        case Driven(motion=motion):
            for component, schedule, _ in motion:
                if component < 3:
                    along[component] = schedule.table[1][-1]
        case Free(velocity=velocity):
            along = np.array(velocity)
        case Servo():
            along = np.array(getattr(wall, "normal", np.zeros(3)))
    return along if np.linalg.norm(along) > 0.0 else None


def draw_arrow(
    ax: Axes, start: Floats, along: Floats, lower: Floats, upper: Floats, view: View, colour: str
) -> None:
    """Draw an arrow of a length that suits the body.

    Args:
        ax: axes to draw on.
        start: foot of the arrow [m], (3,).
        along: direction of the arrow, of any length, (3,).
        lower, upper: corners of the box about the body [m].
        view: direction of view.
        colour: colour of the arrow.
    """
    long = _ARROW * float(np.linalg.norm(upper - lower))
    tip = start + long * np.asarray(along) / np.linalg.norm(along)
    ends = seen_from(np.array([start, tip]), view)[:, :2]
    ax.annotate("", ends[1], ends[0], zorder=7, annotation_clip=False,
                arrowprops={"arrowstyle": "-|>", "color": colour, "linewidth": 2.0, "mutation_scale": 14.0},
    )  # fmt: skip
    ax.update_datalim(ends)
