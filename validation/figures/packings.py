"""Packings side by side: spheres, bonds, and the directions of these (André et al. 2012, figs 5 and 6)."""

import math
from collections.abc import Sequence
from pathlib import Path

import numpy as np
from matplotlib import colormaps
from matplotlib.axes import Axes
from matplotlib.cm import ScalarMappable
from matplotlib.collections import PolyCollection
from matplotlib.colors import Normalize

from bondem._types import Floats
from bondem.report.cell_pictures import light_on
from bondem.report.spheres import View, render, tubes
from bondem.report.style import DIVERGING, SEQUENTIAL, sheet
from bondem.specimen.direction_sphere import direction_sphere
from bondem.specimen.fabric import fabric
from bondem.specimen.interior import region
from bondem.specimen.lattice import Lattice

_VIEW = View(azimuth=math.radians(28.0), elevation=math.radians(24.0))
_PIXELS = 660  # as wide as it is printed

# Bonds are drawn of a slab of this many mean radii, seen face on: more of them hide each other.
_SLAB = 3.5

# As the verdict of `fabric` has it [mean radii].
_CORE_DEPTH = 2.0


def draw_packings(path: Path, lattices: Sequence[Lattice], titles: Sequence[str]) -> None:
    """Figure 5: above, the spheres, coloured by radius; below, the bonds of a slice, coloured by direction.

    Args:
        path: PNG to write.
        lattices: packings.
        titles: over each.
    """
    ratios = [lattice.particles.radius / lattice.particles.mean_radius for lattice in lattices]
    reach = max(0.01, max(float(np.abs(ratio - 1.0).max()) for ratio in ratios))
    norm = Normalize(1.0 - reach, 1.0 + reach)
    with sheet(path, 8.2, 8.9, 2, len(lattices), squeeze=False) as (figure, axes):
        for k, (lattice, ratio) in enumerate(zip(lattices, ratios, strict=True)):
            particles = lattice.particles
            colour = colormaps[SEQUENTIAL](norm(ratio))[:, :3]
            spheres = render(particles.position, particles.radius, colour, view=_VIEW, width=_PIXELS)
            for ax, image in ((axes[0, k], spheres), (axes[1, k], _slice_of_bonds(lattice))):
                ax.imshow(image, interpolation="lanczos")
                ax.axis("off")
            axes[0, k].set_title(titles[k])
            axes[1, k].set_title("bonds of a slice, coloured by direction", fontweight="normal")
        bar = figure.colorbar(
            ScalarMappable(norm, SEQUENTIAL),
            ax=list(axes[0]),
            orientation="horizontal",
            shrink=0.35,
            aspect=30,
            pad=0.02,
        )
        bar.set_label("radius over mean radius,  R / R̄  [-]")
        bar.outline.set_visible(False)


def _slice_of_bonds(lattice: Lattice) -> Floats:
    particles = lattice.particles
    x = particles.position
    middle = 0.5 * (x[:, 1].min() + x[:, 1].max())
    near = np.abs(x[:, 1] - middle) < 0.5 * _SLAB * particles.mean_radius
    bonds = np.flatnonzero(near[lattice.pairs].all(axis=1))
    start = x[lattice.pairs[bonds, 0]]
    thin = 0.16 * particles.mean_radius
    beads, of = tubes(start, start + lattice.branch[bonds], thin)
    # A direction and its opposite are one: red along x, green along y, blue along z, and what lies between.
    direction = np.abs(lattice.branch[bonds]) / lattice.length[bonds, None]
    colour = 0.12 + 0.83 * direction / direction.max(axis=1, keepdims=True)
    return render(beads, np.full(len(beads), thin), colour[of], view=View(0.0, 0.0), width=_PIXELS)


def draw_histograms(path: Path, lattices: Sequence[Lattice], titles: Sequence[str]) -> None:
    """Figure 6: bonds on the 320 faces of the geode, each face raised to what it has over an isotropic fabric.

    Args:
        path: PNG to write.
        lattices: packings.
        titles: over each.
    """
    norm = Normalize(0.0, 2.0)
    with sheet(path, 8.2, 9.8, 2, len(lattices), squeeze=False) as (figure, axes):
        for column, lattice, title in zip(axes.T, lattices, titles, strict=True):
            quality = fabric(lattice)
            whole = f"e = {1e6 * quality.isotropy_error:.2f}·10⁻⁶,  rms excess {quality.rms_excess:.2f}"
            inside = f"rms excess {quality.core_rms_excess:.2f}"
            for ax, density, which, told in (
                (column[0], quality.face_density, "all bonds", whole),
                (column[1], _density_inside(lattice), "bonds away from the walls", inside),
            ):
                _draw_raised(ax, density, norm)
                ax.set(xticks=(), yticks=(), title=f"{title}, {which}", aspect="equal")
                ax.set_xlabel(f"{told}\nhighest face: {density.max():.2f} of isotropic")
                ax.spines[:].set_visible(False)
        bar = figure.colorbar(
            ScalarMappable(norm, DIVERGING),
            ax=list(axes.flat),
            orientation="horizontal",
            shrink=0.4,
            aspect=35,
            pad=0.02,
            extend="max",
        )
        bar.set_label("bonds over those of an isotropic fabric [-]")
        bar.outline.set_visible(False)


def _density_inside(lattice: Lattice) -> Floats:
    """Bond directions away from the walls on each face, over what an isotropic fabric would have, (320,)."""
    sphere, particles = direction_sphere(), lattice.particles
    far = region(particles).depth(particles.position) >= _CORE_DEPTH * particles.mean_radius
    chosen = far[lattice.pairs].all(axis=1)
    direction = lattice.branch[chosen] / lattice.length[chosen, None]
    one_way = np.bincount(sphere.face_of(direction), minlength=len(sphere.faces))
    expected = 2.0 * max(len(direction), 1) * sphere.solid_angle / (4.0 * np.pi)
    return (one_way + one_way[sphere.opposite]) / expected


def _draw_raised(ax: Axes, density: Floats, norm: Normalize) -> None:
    """Draw faces of the geode, moved out to `density`, with walls from there to the centre.

    Of two cones with one apex the one that points more towards the eye hides the other, and is drawn later.
    """
    sphere = direction_sphere()
    top = sphere.vertices[sphere.faces] * density[:, None, None]
    walls = [np.stack([0.0 * top[:, k], top[:, k], top[:, (k + 1) % 3]], axis=1) for k in range(3)]
    placed = np.concatenate([top, *walls]) @ _VIEW.axes.T
    normal = np.cross(placed[:, 1] - placed[:, 0], placed[:, 2] - placed[:, 0])
    # walls are lit on the side that is seen
    normal *= np.sign(normal[:, 2:]) / np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-300)
    colour = np.tile(colormaps[DIVERGING](norm(density))[:, :3], (4, 1)) * light_on(normal)[:, None]
    towards = sphere.vertices[sphere.faces].mean(axis=1) @ _VIEW.axes[2]
    order = np.argsort(np.concatenate([towards * (1.0 + 1e-6), *[towards] * 3]))
    shown = np.clip(colour[order], 0.0, 1.0)
    ax.add_collection(PolyCollection(list(placed[order, :, :2]), facecolors=shown, edgecolors=shown, linewidths=0.1))
    ax.autoscale_view()
