"""Specimens of the tests: bodies of cells, spheres in rows, pairs and blocks, and crystals.

Each factory returns a `bd.Lattice`, which nobody can change, so that tests share what they ask for alike. Lengths are
in metres; bars and rows lie along x.
"""

import math
from collections.abc import Sequence
from functools import cache

import numpy as np

import bondem as bd

NO_BONDS = np.zeros((0, 2), dtype=int)
#: Four unequal spheres of about a metre in a crooked row, for files of particles.
FOUR_CENTRES = np.array([[0.0, 0.0, 0.0], [1.0, 0.1, 0.0], [2.0, 0.0, 0.25], [3.0, -1.0 / 3.0, 0.0]])
FOUR_RADII = np.array([0.5, 0.4, 0.5, 0.45])

# ---- bodies of cells and packings of spheres


@cache
def cells(shape: bd.Shape, count: int, *, seed: int = 1, spread: float | None = None) -> bd.Lattice:
    """Body of cells that fill a shape.

    Args:
        shape: shape to fill.
        count: number of cells.
        seed: seed of the packing.
        spread: spread of the radii of a dense random packing, whose Laguerre cells are taken; None for cells of about
            equal size.
    """
    method = "even" if spread is None else "quench"
    return bd.connect(bd.pack(shape, count=count, spread=spread, method=method, seed=seed), method="laguerre")


def bar(count: int, length: float = 16e-3, width: float | None = None, *, seed: int = 1) -> bd.Lattice:
    """Bar of cells of about equal size with a square section, half as wide as long unless a width is given."""
    width = 0.5 * length if width is None else width
    return cells(bd.Box((length, width, width)), count, seed=seed)


def cube(count: int, edge: float = 1.0, *, seed: int = 1) -> bd.Lattice:
    """Cube of cells of about equal size."""
    return cells(bd.Box((edge, edge, edge)), count, seed=seed)


def ball(count: int, radius: float, *, seed: int = 1) -> bd.Lattice:
    """Ball of cells of about equal size."""
    return cells(bd.Ball(radius), count, seed=seed)


@cache
def uneven_bar(count: int) -> bd.Lattice:
    """Bar of 16 x 8 x 8 mm of cells of unequal spheres: facets are not half-way between centres."""
    box = bd.Box((16e-3, 8e-3, 8e-3))
    even = bd.pack(box, count=count, method="even", seed=1)
    radius = even.radius * np.random.default_rng(2).uniform(0.7, 1.0, count)
    return bd.connect(bd.Particles(even.position, radius, shape=box), method="laguerre")


@cache
def spheres(
    shape: bd.Shape, count: int, *, seed: int = 1, spread: float = 0.25, reach: float | None = None
) -> bd.Lattice:
    """Dense random packing, bonded where spheres touch or are nearer than `reach` times the sum of their radii."""
    return bd.connect(bd.pack(shape, count=count, spread=spread, seed=seed), reach=reach)


# ---- cells on a grid


@cache
def cubes(shape: tuple[int, int, int], edge: float = 1.0, *, angle: float | None = None) -> bd.Lattice:
    """Box of cubic cells with a corner at the origin, turned about z by an angle [rad]."""
    centres = edge * (np.indices(shape).reshape(3, -1).T + 0.5)
    box = bd.Box((edge * shape[0], edge * shape[1], edge * shape[2]))
    if angle is not None:
        c, s = math.cos(angle), math.sin(angle)
        box, centres = box.rotated("z", angle), centres @ np.array([[c, s, 0.0], [-s, c, 0.0], [0.0, 0.0, 1.0]])
    return bd.connect(bd.Particles(centres, 0.5 * edge, shape=box), method="laguerre")


def two_cubes(edge: float = 1.0) -> bd.Lattice:
    """Two cubic cells side by side, which share one facet normal to x."""
    return cubes((2, 1, 1), edge)


@cache
def crooked_cells(
    shape: tuple[int, int, int], *, jitter: float = 0.2, spread: float = 0.2, seed: int = 0, periodic: bool = False,
    edge: float = 1.0,
) -> bd.Lattice:  # fmt: skip
    """Box or periodic cell of cells off a grid, but not in directions that are one cell thick.

    Args:
        shape: number of cells along x, y and z.
        jitter: largest distance from the grid along each axis, in edges [-].
        spread: spread of the radii about their mean [-].
        seed: seed of places and radii.
        periodic: whether the body has no walls.
        edge: distance of the grid's points [m].
    """
    grid = np.indices(shape).reshape(3, -1).T
    moved = np.random.default_rng(seed).uniform(-jitter, jitter, grid.shape) * (np.array(shape) > 1)
    radius = 0.3 * (1.0 + spread * np.random.default_rng(seed + 1).uniform(-1.0, 1.0, len(grid)))
    edges = (edge * shape[0], edge * shape[1], edge * shape[2])
    outline = bd.Cell(edges) if periodic else bd.Box(edges)
    return bd.connect(bd.Particles(edge * (grid + 0.5 + moved), edge * radius, shape=outline), method="laguerre")


# ---- spheres in rows and pairs


def two_spheres(distance: float = 1.0, radius: float | None = None, *, swapped: bool = False) -> bd.Lattice:
    """Two bonded spheres along x, the first at the origin; they touch unless a radius is given.

    Args:
        distance: distance of the centres [m].
        radius: radius of both [m]; half the distance by default.
        swapped: whether the bond is from the second sphere to the first.
    """
    position = np.array([[0.0, 0.0, 0.0], [distance, 0.0, 0.0]])
    particles = bd.Particles(position, 0.5 * distance if radius is None else radius)
    return bd.Lattice(particles, [[1, 0]] if swapped else [[0, 1]])


@cache
def row(count: int, spacing: float = 1e-3, radius: float | None = None) -> bd.Lattice:
    """Equal spheres along x from the origin, each bonded to the next, which it touches unless a radius is given."""
    position = np.zeros((count, 3))
    position[:, 0] = spacing * np.arange(count)
    particles = bd.Particles(position, 0.5 * spacing if radius is None else radius)
    return bd.Lattice(particles, [(k, k + 1) for k in range(count - 1)])


@cache
def rod(count: int) -> bd.Lattice:
    """Touching spheres of unequal radii about 0.5 m along x, each bonded to the next."""
    radius = 0.5 * (1.0 + 0.2 * np.cos(np.arange(count)))
    position = np.zeros((count, 3))
    position[1:, 0] = np.cumsum(radius[1:] + radius[:-1])
    return bd.Lattice(bd.Particles(position, radius), [(k, k + 1) for k in range(count - 1)])


@cache
def chain(count: int, *, radius: float = 0.5e-3) -> bd.Lattice:
    """Touching equal spheres along x that fill a cylinder of their own radius, as a bar of closed forms."""
    position = np.zeros((count, 3))
    position[:, 0] = radius * (1.0 + 2.0 * np.arange(count))
    shape = bd.Cylinder(radius=radius, length=2.0 * radius * count)
    return bd.Lattice(bd.Particles(position, radius, shape=shape), [(k, k + 1) for k in range(count - 1)])


# ---- spheres on a grid


@cache
def grid(
    shape: tuple[int, int, int], spacing: float = 1e-3, *, walled: bool = False, periodic: bool = False
) -> bd.Lattice:
    """Equal spheres on a cubic grid, bonded to those that they touch.

    Args:
        shape: number of spheres along x, y and z.
        spacing: distance of neighbours [m].
        walled: whether the particles have the box that they touch for a shape; without it the first centre is the
            origin.
        periodic: whether they have that box without walls.
    """
    place = np.indices(shape).reshape(3, -1).T + (0.5 if walled or periodic else 0.0)
    edges = (spacing * shape[0], spacing * shape[1], spacing * shape[2])
    outline = bd.Cell(edges) if periodic else bd.Box(edges) if walled else None
    return bd.connect(bd.Particles(spacing * place, 0.5 * spacing, shape=outline), tolerance=1e-9)


@cache
def crooked_block(
    shape: tuple[int, int, int], *, edge: float = 1.0, jitter: float = 0.1,
    radius: float | tuple[float, float] = (0.3, 0.4), reach: float = 2.0, seed: int = 1, walled: bool = False,
) -> bd.Lattice:  # fmt: skip
    """Block of spheres off a cubic grid, bonded to their neighbours.

    Args:
        shape: number of spheres along x, y and z.
        edge: distance of the points of the grid [m].
        jitter: largest distance from them along each axis, over `edge` [-].
        radius: radius, or the least and largest of random ones, over `edge` [-].
        reach: distance of bonded centres over the sum of their radii, at most [-].
        seed: seed of places and radii.
        walled: whether the particles have the box of the grid for a shape, with a corner at the origin.
    """
    rng = np.random.default_rng(seed)
    place = np.indices(shape).reshape(3, -1).T + (0.5 if walled else 0.0)
    size = rng.uniform(*radius, len(place)) if isinstance(radius, tuple) else np.full(len(place), radius)
    box = bd.Box((edge * shape[0], edge * shape[1], edge * shape[2])) if walled else None
    position = edge * (place + rng.uniform(-jitter, jitter, place.shape))
    return bd.connect(bd.Particles(position, edge * size, shape=box), reach=reach)


@cache
def crystal(count: int = 8, *, periodic: bool = True) -> bd.Particles:
    """Face-centred cubic crystal of touching spheres, of `count` unit cells of 1 m along each axis."""
    base = np.array([[0.0, 0.0, 0.0], [0.5, 0.5, 0.0], [0.5, 0.0, 0.5], [0.0, 0.5, 0.5]])
    corner = np.indices((count,) * 3).reshape(3, -1).T
    centre = (corner[:, None] + base).reshape(-1, 3)
    return bd.Particles(centre, 0.25 * math.sqrt(2.0), period=[count] * 3 if periodic else None)


def loose(position: Sequence | np.ndarray, radius: float | Sequence | np.ndarray = 1.0, **options) -> bd.Lattice:
    """Spheres without bonds."""
    return bd.Lattice(bd.Particles(position, radius, **options), NO_BONDS)
