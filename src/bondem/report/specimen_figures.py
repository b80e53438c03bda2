"""Figures of the specimen: elements and bonds in three dimensions."""

import math
from pathlib import Path

import numpy as np
from matplotlib import colormaps
from matplotlib.axes import Axes
from matplotlib.cm import ScalarMappable
from matplotlib.collections import PolyCollection
from matplotlib.colors import Normalize, to_rgb

from bondem.report.spheres import View, render, tubes
from bondem.report.style import BLUE, DIVERGING, GREEN, INK, ORANGE, SEQUENTIAL, colour_bar, sheet
from bondem.specimen.direction_sphere import direction_sphere
from bondem.specimen.fabric import Fabric
from bondem.specimen.lattice import Lattice

_VIEW = View(azimuth=math.radians(28.0), elevation=math.radians(24.0))


def draw_specimen(path: Path, lattice: Lattice) -> None:
    """Draw elements coloured by radius on one half of a specimen, and its bonds alone on the other, into a PNG."""
    particles = lattice.particles
    x = particles.position[:, 0]
    shown = x < x.min() + 0.55 * np.ptp(x)
    ratio = particles.radius / particles.mean_radius
    norm = Normalize(ratio.min(), ratio.max())
    bare = lattice.pairs[~shown[lattice.pairs].all(axis=1)]
    thin = 0.13 * particles.mean_radius
    start = particles.position[bare[:, 0]]
    beads, _ = tubes(start, start + particles.separation(bare[:, 0], bare[:, 1]), thin)
    image = render(
        np.concatenate([particles.position[shown], beads]),
        np.concatenate([particles.radius[shown], np.full(len(beads), thin)]),
        np.concatenate([colormaps[SEQUENTIAL](norm(ratio[shown]))[:, :3], np.tile(to_rgb(ORANGE), (len(beads), 1))]),
        view=_VIEW,
        width=1300,
    )
    height, width = image.shape[:2]
    with sheet(path, 8.2, 8.2 * height / width + 0.75) as (figure, axes):
        axes.imshow(image, interpolation="lanczos")
        axes.axis("off")
        colour_bar(figure, ScalarMappable(norm, SEQUENTIAL), "element radius over mean radius,  R / R̄  [-]",
                   ax=axes, orientation="horizontal", shrink=0.35)  # fmt: skip


def draw_contacts(path: Path, lattice: Lattice) -> None:
    """Draw the distributions of the number of bonds per element and of the size of elements."""
    particles = lattice.particles
    bonds = np.bincount(lattice.pairs.ravel(), minlength=len(particles))
    share = np.bincount(bonds) / len(bonds)
    with sheet(path, 8.2, 2.9, 1, 2) as (_, (left, right)):
        left.bar(np.arange(len(share)), 100.0 * share, color=BLUE, width=0.8)
        left.axvline(bonds.mean(), color=ORANGE, label=f"mean z = {bonds.mean():.3f}")
        left.set(xlabel="bonds of an element [-]", ylabel="elements [%]")
        left.grid(axis="x", visible=False)
        left.legend()
        count, edges = np.histogram(particles.radius / particles.mean_radius, bins=24)
        right.stairs(100.0 * count / len(bonds), edges, fill=True, color=GREEN)
        right.set(xlabel="radius over mean radius,  R / R̄ [-]", ylabel="elements [%]", ylim=(0.0, None))
        right.grid(axis="x", visible=False)


def draw_geode(path: Path, quality: Fabric) -> None:
    """Draw the density of bond directions over an isotropic density, in two views of a sphere and a histogram."""
    sphere = direction_sphere()
    density = quality.face_density
    spread = max(0.05, float(np.abs(density - 1.0).max()))
    norm = Normalize(1.0 - spread, 1.0 + spread)
    corners = sphere.vertices[sphere.faces]
    normal = corners.mean(axis=1)
    with sheet(path, 8.2, 3.4, 1, 3, width_ratios=(1, 1, 0.95)) as (figure, axes):
        for ax, view, title in (
            (axes[0], _VIEW, "from the side"),
            (axes[1], View(azimuth=0.5 * math.pi, elevation=0.0), "along the axis x"),
        ):
            near = normal @ view.axes[2] > -0.12
            flat = corners[near] @ view.axes[:2].T
            order = np.argsort(normal[near] @ view.axes[2])
            ax.add_collection(
                PolyCollection(list(flat[order]), facecolors=colormaps[DIVERGING](norm(density[near][order])),
                               edgecolors="white", linewidths=0.4)
            )  # fmt: skip
            _draw_axes(ax, view)
            ax.set(xlim=(-1.25, 1.25), ylim=(-1.25, 1.25), aspect="equal", title=title)
            ax.axis("off")
        colour_bar(figure, ScalarMappable(norm, DIVERGING), "bonds over those of an isotropic fabric [-]",
                   ax=list(axes[:2]), orientation="horizontal", shrink=0.6, aspect=35)  # fmt: skip
        axes[2].hist(density, bins=20, color=BLUE, label="faces of the geode")
        # a bond counts on a face and on its opposite, so that counts scatter by the root of their mean
        chance = math.sqrt(len(density) / quality.face_counts.sum())
        axes[2].axvline(1.0, color=INK, linewidth=1.0)
        for side in (-1.0, 1.0):
            axes[2].axvline(1.0 + side * chance, color=ORANGE, linestyle=(0, (4, 3)), linewidth=1.2,
                            label="± chance, one deviation" if side > 0.0 else None)  # fmt: skip
        axes[2].set(xlabel="bonds over isotropic [-]", ylabel="faces")
        axes[2].set_title(f"rms beyond chance: {quality.rms_excess:.3f}")
        axes[2].legend(loc="upper center", bbox_to_anchor=(0.5, -0.24), fontsize=8.0)
        axes[2].grid(axis="x", visible=False)


def _draw_axes(ax: Axes, view: View) -> None:
    """Write the names of the coordinate axes at their ends."""
    for name, direction in zip("xyz", np.eye(3), strict=True):
        right, up, toward = view.axes @ direction
        if toward > -0.5 and math.hypot(right, up) > 0.2:
            ax.plot([right, 1.12 * right], [up, 1.12 * up], color=INK, linewidth=1.0)
            ax.annotate(name, (1.2 * right, 1.2 * up), ha="center", va="center", color=INK)
