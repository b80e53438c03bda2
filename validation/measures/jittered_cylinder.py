"""A cylinder of spheres on a jittered grid, made without packing."""

import numpy as np
from scipy.spatial import cKDTree

import bondem as bd


def cylinder(count: int, coordination: float = 6.2) -> bd.Lattice:
    """About `count` elements on a jittered grid: no packing, so that only solvers are timed."""
    shape = bd.Cylinder(radius=5e-3, length=40e-3)
    a = (np.pi * shape.radius**2 * shape.length / count) ** (1.0 / 3.0)
    along, across = np.arange(a / 2, shape.length, a), np.arange(-shape.radius, shape.radius + a, a)
    grid = np.stack(np.meshgrid(along, across, across, indexing="ij"), axis=-1).reshape(-1, 3)
    grid = grid[np.hypot(grid[:, 1], grid[:, 2]) < shape.radius - 0.3 * a]
    grid = grid + np.random.default_rng(0).uniform(-0.18, 0.18, grid.shape) * a
    tree, low, high = cKDTree(grid), 1.0, 3.0
    for _ in range(20):
        reach = 0.5 * (low + high)
        z = 2.0 * (tree.count_neighbors(tree, 0.7 * a * reach) - len(grid)) / 2.0 / len(grid)
        low, high = (reach, high) if z < coordination else (low, reach)
    return bd.connect(bd.Particles(grid, 0.35 * a, shape=shape), reach=high)
