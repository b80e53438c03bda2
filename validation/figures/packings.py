"""Packings side by side: spheres, bonds, and the directions of these (André et al. 2012, figs 5 and 6)."""

import math
from collections.abc import Sequence
from pathlib import Path

import numpy as np
from matplotlib import colormaps
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize

from bondem._types import Floats, Ints
from bondem.report.spheres import View, render, tubes
from bondem.report.style import DIVERGING, SEQUENTIAL, sheet
from bondem.specimen.direction_sphere import direction_sphere
from bondem.specimen.fabric import fabric
from bondem.specimen.interior import region
from bondem.specimen.lattice import Lattice
from validation.figures.solids import render_triangles

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
                corner, face = _raised(density)
                colour = colormaps[DIVERGING](norm(density[face]))[:, :3]
                reach = 1.03 * float(np.abs(corner @ _VIEW.axes[:2].T).max())
                image = render_triangles(corner, colour, view=_VIEW, width=_PIXELS, reach=reach)
                ax.imshow(image, interpolation="lanczos")
                ax.set(xticks=(), yticks=(), title=f"{title}, {which}")
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


def _raised(density: Floats) -> tuple[Floats, Ints]:
    """Triangles of the faces of the geode, moved out to `density`, with the walls from there to the centre.

    Returns:
        Corners (k, 3, 3) and the face of each.
    """
    sphere = direction_sphere()
    top = sphere.vertices[sphere.faces] * density[:, None, None]
    centre = np.zeros_like(top[:, 0])
    walls = [np.stack([centre, top[:, k], top[:, (k + 1) % 3]], axis=1) for k in range(3)]
    return np.concatenate([top, *walls]), np.tile(np.arange(len(top)), 4)
