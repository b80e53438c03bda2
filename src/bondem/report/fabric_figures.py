"""Figures of the fabric: layering at walls and order among neighbours."""

from pathlib import Path

import numpy as np

from bondem.report.findings import Examined
from bondem.report.style import BLUE, GREEN, GREY, INK, ORANGE, PURPLE, legend_columns, sheet
from bondem.specimen.radial_distribution import RadialDistribution

_COLOURS = (BLUE, ORANGE, GREEN, PURPLE, INK, GREY)


def draw_layering(path: Path, specimen: Examined) -> None:
    """Draw the solid fraction of a packing of spheres over the distance from each wall, and that of its core."""
    layering, quality = specimen.layering, specimen.quality
    inside = np.nan if quality is None else quality.core_volume_fraction
    with sheet(path, 8.2, 3.0) as (_, ax):
        for k, (face, one) in enumerate(layering.items()):
            # opposite faces share a colour: six walls of a box are three pairs
            dashes = (0, (4, 2)) if face.endswith("max") else "-"
            colour = _COLOURS[(k // 2 if len(layering) == 6 else k) % len(_COLOURS)]
            ax.plot(one.distance, one.volume_fraction, color=colour, linestyle=dashes, label=face)
        if np.isfinite(inside):
            ax.axhline(inside, color=GREY, linewidth=1.0, label=f"core, φ = {inside:.3f}")
        ax.set(xlabel="distance from the wall over mean diameter [-]", ylabel="solid fraction [-]", ylim=(0.0, 1.0),
               xlim=(0.0, None))  # fmt: skip
        ax.legend(loc="upper right", ncols=legend_columns(4, 2))


def draw_distribution(path: Path, distribution: RadialDistribution) -> None:
    """Draw the radial distribution function of the centres away from the walls."""
    with sheet(path, 8.2, 2.9) as (_, ax):
        ax.axhline(1.0, color=GREY, linewidth=1.0, label="spheres without order")
        ax.plot(distribution.distance, distribution.density, color=BLUE)
        ax.set(xlabel="distance of centres over mean diameter,  r / 2R̄ [-]", ylabel="g(r) [-]", ylim=(0.0, None),
               xlim=(0.0, None))  # fmt: skip
        ax.legend(loc="upper right")
