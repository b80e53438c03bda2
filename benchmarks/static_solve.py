"""Time of the static, modal and non-linear solvers on a jittered cylinder of length 8 radii, z = 6.2.

python benchmarks/static_solve.py [elements ...]
"""

import sys
import time
from collections.abc import Callable

import numpy as np
from scipy.spatial import cKDTree

import bondem as bd
from bondem.solve.linear import Iteration, System

LAW = bd.EulerBernoulli(E=265e9, nu=0.3, radius_ratio=0.5)
DEPTH = 1.0


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


def clock(name: str, task: Callable[[], object]) -> None:
    """Best of three, by the wall and by all processors: the two differ on a busy machine."""
    best = []
    for _ in range(3):
        wall, cpu = time.perf_counter(), time.process_time()
        task()
        best.append((time.perf_counter() - wall, time.process_time() - cpu))
    print(f"  {name:28s} {min(b[0] for b in best):8.2f} s wall {min(b[1] for b in best):8.2f} s cpu")


def main(counts: list[int]) -> None:
    for count in counts:
        lattice = cylinder(count)
        clamp = bd.Fix(bd.Face("x_min", depth=DEPTH))
        pull = bd.Load(bd.Face("x_max", depth=DEPTH), force=(1e3, 0.0, 0.0))
        model = bd.Model(lattice, LAW, density=2700.0, boundary=[clamp, pull])
        free = model.with_boundary([pull, bd.Load(bd.Face("x_min", depth=DEPTH), force=(-1e3, 0.0, 0.0))])
        near = bd.solve_static(model)
        similar = bd.Model(
            lattice, bd.EulerBernoulli(E=265e9, nu=0.3, radius_ratio=0.52), 1000.0, boundary=[clamp, pull]
        )
        print(f"{len(lattice.particles)} elements, {len(lattice.pairs)} bonds")
        clock("static, clamped", lambda m=model: bd.solve_static(m))
        clock("static, free", lambda m=free: bd.solve_static(m))
        clock("static, warm start", lambda m=similar, g=near: bd.solve_static(m, guess=g))
        clock("  of it matrix", lambda m=model: System.of(m))
        system = System.of(model)
        clock("  of it preconditioner", lambda s=system: Iteration(s))
        if len(lattice.particles) < 50_000:
            clock("eight modes", lambda m=model: bd.solve_modes(m))
            clock("relaxed to 1e-6", lambda m=model: bd.solve_relaxed(m))
            clock("static, non-linear", lambda m=model: bd.solve_static(m, nonlinear=True))


if __name__ == "__main__":
    main([int(argument) for argument in sys.argv[1:]] or [10_000, 100_000])
