"""A wave along a specimen: velocities of the faces, snapshots, place over time, and celerity over the criterion."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib import colormaps
from matplotlib.cm import ScalarMappable
from matplotlib.collections import PatchCollection
from matplotlib.colors import Normalize
from matplotlib.patches import Circle

from bondem.labtests.wave import Wave
from bondem.report.style import BLUE, DIVERGING, GREY, INK, ORANGE, PURPLE, sheet
from bondem.specimen.lattice import Lattice

_TITLES = {"held": "x_max held at v", "free": "x_max given v, then free"}
_DASHED = (0, (4, 3))
# The plateaus v and 2 v lie in the middle and at the end of the scale: three colours, not two and a grey.
_PLATEAUS = "viridis"
# Colours of the snapshots are few and have sharp edges: thousands of circles, and still a small file.
_STEPS = 16
_VOID = "#d5dbe1"


def draw_faces(
    path: Path, waves: Mapping[str, Wave], *, passage: float, crossings: Mapping[str, tuple[float, float]]
) -> None:
    """Mean velocities of both faces over time.

    Args:
        path: PNG to write.
        waves: by the way of striking, "held" and "free".
        passage: L / √(E/ρ) [s].
        crossings: when [s] and at what velocity [m/s] the wave is said to have arrived.
    """
    with sheet(path, 8.2, 3.3, 1, 2) as (_, axes):
        for ax, (way, wave) in zip(axes, waves.items(), strict=True):
            time = wave.time * 1e6
            ax.plot(time, wave.near, color=GREY, label="x_max, struck")
            ax.plot(time, wave.far, color=BLUE, label="x_min, free")
            moment, level = crossings[way]
            ax.plot([moment * 1e6], [level], "D", color=ORANGE, markersize=6, zorder=5,
                    label="half of the plateau" if way == "held" else "half of the first peak")  # fmt: skip
            top = max(float(wave.near.max()), float(wave.far.max()))
            low = min(float(wave.near.min()), float(wave.far.min()), 0.0)
            ax.plot([passage * 1e6] * 2, [low, top], color=INK, linewidth=1.0, linestyle=_DASHED, label="L / √(E/ρ)")
            ax.set(xlabel="time [µs]", ylabel="mean velocity towards x_min [m/s]", title=_TITLES[way],
                   xlim=(0.0, time[-1]), ylim=(low - 0.06 * (top - low), top + 0.45 * (top - low)))  # fmt: skip
            ax.legend(loc="upper left", ncols=2, columnspacing=1.0, handlelength=1.5)


def draw_snapshots(
    path: Path, lattice: Lattice, waves: Mapping[str, Wave], *, passage: float, velocity: float
) -> None:
    """The elements that a plane through the axis cuts, coloured by axial velocity, at several times.

    Args:
        path: PNG to write.
        lattice: the specimen.
        waves: by the way of striking.
        passage: L / √(E/ρ) [s].
        velocity: v of the strike [m/s].
    """
    particles = lattice.particles
    away = np.abs(particles.position[:, 2])
    cut = np.flatnonzero((away < particles.radius) & lattice.connected)
    radius = np.sqrt(particles.radius[cut] ** 2 - away[cut] ** 2) * 1e3
    x, y = particles.position[cut, :2].T * 1e3
    circles = [Circle((a, b), c) for a, b, c in zip(x, y, radius, strict=True)]
    rows = max(len(wave.snapshots) for wave in waves.values())
    with sheet(path, 8.2, 0.98 * rows + 0.9, rows, len(waves), sharex=True, sharey=True) as (figure, axes):
        for column, (way, wave) in enumerate(waves.items()):
            if way == "held":
                scale, colours = Normalize(0.0, 2.0), colormaps[_PLATEAUS].resampled(_STEPS)
            else:
                most = max(float(np.quantile(np.abs(one[cut, 0]), 0.99)) for _, one in wave.snapshots) / velocity
                scale, colours = Normalize(-most, most), colormaps[DIVERGING].resampled(_STEPS + 1)
            for row, (moment, velocities) in enumerate(wave.snapshots):
                ax = axes[row, column]
                drawn = PatchCollection(circles, cmap=colours, norm=scale, linewidth=0.0, antialiased=False)
                drawn.set_array(-velocities[cut, 0] / velocity)
                ax.add_collection(drawn)
                ax.set_aspect("equal")
                ax.grid(visible=False)
                ax.set_facecolor(_VOID)
                ax.set(xlim=(-0.3, x.max() + 0.8), ylim=(y.min() - 0.7, y.max() + 0.7), yticks=(-4, 0, 4))
                name = f"{moment * 1e6:.1f} µs = {moment / passage:.1f} L/c"
                ax.set_title(f"{_TITLES[way]}: {name}" if row == 0 else name, fontsize=8.5, pad=3.0)
                if column == 0:
                    ax.set_ylabel("y [mm]")
            axes[rows - 1, column].set_xlabel("x [mm]   (struck at the right)")
            figure.colorbar(
                ScalarMappable(scale, colours), ax=axes[:, column], location="bottom", shrink=0.8, aspect=40,
                pad=0.01, label="velocity towards x_min, over v [-]",
            )  # fmt: skip


def draw_travel(path: Path, waves: Mapping[str, Wave], *, length: float, speed: float, velocity: float) -> None:
    """Mean velocity of the cross-sections over place and time.

    Args:
        path: PNG to write.
        waves: by the way of striking.
        length: of the specimen [m].
        speed: √(E/ρ) [m/s].
        velocity: v of the strike [m/s].
    """
    with sheet(path, 8.2, 3.7, 1, 2, sharey=True) as (figure, axes):
        for ax, (way, wave) in zip(axes, waves.items(), strict=True):
            field = wave.sections / velocity
            if way == "held":
                low, high, colours = 0.0, 2.0, _PLATEAUS
            else:
                high = float(np.nanquantile(np.abs(field[len(field) // 10 :]), 0.995))
                low, colours = -high, DIVERGING
            drawn = ax.pcolormesh(
                wave.place * 1e3, wave.time * 1e6, field, cmap=colours, vmin=low, vmax=high, rasterized=True
            )
            corners = [length * 1e3, 0.0, length * 1e3, 0.0]
            moments = np.arange(4) * length / speed * 1e6
            ax.plot(corners, moments, color="white" if way == "held" else INK, linewidth=1.2, linestyle=_DASHED)
            ax.grid(visible=False)
            ax.set(xlabel="x [mm]", title=_TITLES[way], xlim=(0.0, length * 1e3), ylim=(0.0, wave.time[-1] * 1e6))
            figure.colorbar(drawn, ax=ax, label="velocity towards x_min, over v [-]")
        axes[0].set_ylabel("time [µs]")


def draw_arrival(path: Path, levels: Sequence[float], summary: Mapping[str, Any]) -> None:
    """Error of the celerity over the level of arrival."""
    percent = 100.0 * np.array(levels)
    with sheet(path, 8.2, 3.4) as (_, ax):
        ways = ("held", BLUE, "held, over the plateau"), ("free", PURPLE, "free, over the first peak")
        for way, colour, name in ways:
            for kind, style in (("error", "-"), ("error_refined", _DASHED)):
                mean = 100.0 * np.array([one["mean"] for one in summary[way][kind]])
                scatter = 100.0 * np.array([one["std"] or 0.0 for one in summary[way][kind]])
                ax.plot(percent, mean, color=colour, linestyle=style, marker="o", markersize=3.5,
                        label=name if kind == "error" else None)  # fmt: skip
                ax.fill_between(percent, mean - scatter, mean + scatter, color=colour, alpha=0.15, linewidth=0.0)
        ax.axhline(0.0, color=INK, linewidth=0.9)
        ax.axvline(50.0, color=ORANGE, linewidth=1.1, linestyle=_DASHED, label="criterion: half")
        ax.set(xlabel="level at which the wave has arrived [%]", ylabel="celerity / √(E/ρ) − 1 [%]", xscale="log")
        ax.set_xticks(percent, [f"{one:g}" for one in percent])
        ax.minorticks_off()
        ax.legend(loc="lower left")
