"""Figure of a shear compaction: the grains at the start, in the middle and at the end, and the walls over time."""

import math
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from matplotlib import colormaps
from matplotlib.axes import Axes
from matplotlib.patches import Polygon

from bondem._types import Floats
from bondem.dynamics.history import History
from bondem.report.spheres import View, render
from bondem.report.style import BLUE, GREY, INK, ORANGE, SEQUENTIAL, sheet

_VIEW = View(azimuth=math.radians(28.0), elevation=math.radians(20.0))
_PIXELS = 1500
# Volume fraction of random close packing of equal spheres far from walls [-].
_CLOSE = 0.636


@dataclass(frozen=True, eq=False)
class Course:
    """Record of a shear compaction along z in a square box, whose walls across x oscillate.

    Attributes:
        parts: histories of the falling platen and then of each cycle, with the gauges "platen" and "sway"
            (displacements of the pressure wall and of the shear wall at x_max) and "force" (on the pressure wall).
        frames: centres at the start and after each part [m], each (n, 3).
        radius: radii of the grains [m], (n,).
        width: width of the box at rest [m].
        top: initial height of the pressure wall [m].
        pressure: target pressure [Pa].
    """

    parts: tuple[History, ...]
    frames: tuple[Floats, ...]
    radius: Floats
    width: float
    top: float
    pressure: float

    @property
    def time(self) -> Floats:
        """Time of each record [s], (s,)."""
        return np.concatenate([part.time for part in self.parts])

    @property
    def height(self) -> Floats:
        """Height of the pressure wall [m], (s,)."""
        return self.top + self._gauge("platen", 2)

    @property
    def sway(self) -> Floats:
        """Outward displacement of the shear wall at x_max [m], (s,)."""
        return self._gauge("sway", 0)

    @property
    def pressed(self) -> Floats:
        """Pressure of the grains on the pressure wall over the target pressure [-], (s,)."""
        return self._gauge("force", 2) / (self.pressure * self.width**2)

    @property
    def fraction(self) -> Floats:
        """Volume fraction of the grains between the walls [-], (s,)."""
        solid = 4.0 / 3.0 * math.pi * float((self.radius**3).sum())
        return solid / (self.height * self.width * (self.width + 2.0 * self.sway))

    @property
    def reached(self) -> tuple[float, float]:
        """Mean and standard deviation of `pressed` over the last cycle [-]."""
        last = self.pressed[-len(self.parts[-1]) :]
        return float(last.mean()), float(last.std())

    def _gauge(self, name: str, component: int) -> Floats:
        return np.concatenate([part[name][:, component] for part in self.parts])


def draw_compaction(path: Path, course: Course) -> None:
    """Draw into a PNG grains at three times, coloured by initial height, and walls, pressure and density in time."""
    with sheet(path, 8.2, 8.4, 0, 0) as (figure, _):
        grid = figure.add_gridspec(4, 1, height_ratios=(3.3, 1.0, 1.0, 1.0))
        _grains(figure.add_subplot(grid[0]), course)
        walls = figure.add_subplot(grid[1])
        pressure, density = (figure.add_subplot(grid[k], sharex=walls) for k in (2, 3))
        begin = course.parts[1].time[0]
        period = course.parts[1].time[-1] - begin
        cycle = (course.time - begin) / period
        walls.plot(cycle, 1e3 * course.height, color=ORANGE, label="pressure wall, height")
        walls.plot(cycle, 1e3 * (0.5 * course.width + course.sway), color=BLUE, label="shear wall, from the middle")
        walls.set(title="The walls", ylabel="[mm]", ylim=(0.0, None))
        walls.legend(loc="upper right", ncols=2)
        pressure.plot(cycle, course.pressed, color=ORANGE, linewidth=0.7, label="each record")
        middle = np.array([part.time.mean() for part in course.parts[1:]])
        force = np.array([part["force"][:, 2].mean() for part in course.parts[1:]])
        mean = force / (course.pressure * course.width**2)
        pressure.plot((middle - begin) / period, mean, "o", color=INK, markersize=4.0, label="mean of a cycle")
        pressure.axhline(1.0, color=GREY, linewidth=1.0, linestyle="--", zorder=0)
        pressure.set(title="Pressure on the pressure wall", ylabel="held / asked  [-]", ylim=(0.0, None))
        pressure.legend(loc="upper right", ncols=2)
        density.plot(cycle, course.fraction, color=INK, label="between the walls")
        density.axhline(_CLOSE, color=GREY, linewidth=1.0, linestyle="--", label="random close packing, 0.636")
        density.legend(loc="lower right", ncols=2)
        density.set(title="Volume fraction", ylabel="φ  [-]", xlabel="cycles of shear", xlim=(cycle[0], cycle[-1]))
        for ax in (walls, pressure):
            ax.tick_params(labelbottom=False)


def _grains(ax: Axes, course: Course) -> None:
    last = len(course.frames) - 1
    middle = (last + 1) // 2
    right, up, _ = _VIEW.axes
    pitch = 2.1 * course.width
    began = course.frames[0][:, 2]
    colour = colormaps[SEQUENTIAL]((began - began.min()) / np.ptp(began))[:, :3]
    chosen = {0: "on the grid", middle: f"after {middle - 1} cycles", last: f"after {last - 1} cycles"}
    spheres = np.concatenate([course.frames[k] + n * pitch * right for n, k in enumerate(chosen)])
    image = render(
        spheres, np.tile(course.radius, len(chosen)), np.tile(colour, (len(chosen), 1)), view=_VIEW, width=_PIXELS
    )
    margin = 1.02 * course.radius.max()
    placed = spheres @ _VIEW.axes[:2].T
    lower, upper = placed.min(axis=0) - margin, placed.max(axis=0) + margin
    ax.imshow(image, extent=(lower[0], upper[0], lower[1], upper[1]), interpolation="lanczos")
    w, h = course.width, [course.top, *(course.top + part["platen"][-1, 2] for part in course.parts)]
    for n, (k, title) in enumerate(chosen.items()):
        lid = [(0, 0, h[k]), (w, 0, h[k]), (w, w, h[k]), (0, w, h[k])]
        side = [(w, 0, 0), (w, w, 0), (w, w, h[k]), (w, 0, h[k])]
        for corners, tint in ((side, BLUE), (lid, ORANGE)):
            outline = np.array(corners) @ np.array([right, up]).T + (n * pitch, 0.0)
            ax.add_patch(Polygon(outline, facecolor=tint, alpha=0.2, edgecolor="none"))
            ax.add_patch(Polygon(outline, fill=False, edgecolor=tint, linewidth=1.4, clip_on=False))
            lower, upper = np.minimum(lower, outline.min(axis=0)), np.maximum(upper, outline.max(axis=0))
        ax.text(n * pitch + 0.5 * w * (right[0] + right[1]), lower[1] - 0.08 * w, title, ha="center", va="top")
    ax.set_xlim(lower[0], upper[0])
    ax.set_ylim(lower[1] - 0.25 * w, upper[1])
    ax.axis("off")
