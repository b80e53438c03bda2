"""Definition of a case, and the specimens, laws and conditions from which cases are composed."""

import importlib
from dataclasses import dataclass, field

import numpy as np

import bondem as bd
from bondem.model.state import State

# Edges of the irregular grids, by size: too few bonds for threads; several domains; several blocks of 4000 elements.
GRIDS = {60: (5, 4, 3), 500: (12, 7, 6), 3000: (20, 15, 10), 9000: (30, 20, 15)}
E, NU, RATIO = 1e7, 0.2, 0.6
ALIKE = bd.EulerBernoulli(E=E, nu=NU, radius_ratio=RATIO)
SHORT = bd.Timoshenko(E=E, nu=NU, radius_ratio=RATIO)
CONTACT = bd.LinearContact(E=E, friction=0.4, damping=0.1)
# Steps between two checks of the rotations of bonds, in which spinning elements turn a whole number of times.
ROUND = 100


def set_threads(count: int) -> None:
    """Set the number of threads, in old revisions that of Numba."""
    if hasattr(bd, "set_threads"):
        bd.set_threads(count)
    else:
        importlib.import_module("numba").set_num_threads(count)


@dataclass(frozen=True, kw_only=True)
class Case:
    """A run whose bits are compared; arrays are in the user's order.

    Attributes:
        model: model of the run.
        velocity: initial velocities [m/s], (n, 3).
        turn: initial rotation per step [rad], (n, 3).
        integrity: initial integrity of the bonds, (m,), or None for intact ones.
        strain: size of the stress-free strains in the initial state [-].
        options: scheme, damping and further gauges of `solve_explicit`.
        then: model of the second of two consecutive runs, or None for the same.
        share: time step over the critical one [-].
        rounds: True if the run may be interrupted after whole rounds of `ROUND` steps only, because the rotations of
            bonds are out of range in between.
    """

    model: bd.Model
    velocity: np.ndarray | None = None
    turn: np.ndarray | None = None
    integrity: np.ndarray | None = None
    strain: float = 0.0
    options: dict = field(default_factory=dict)
    then: bd.Model | None = None
    share: float = 0.8
    rounds: bool = False

    def start(self, dt: float) -> State:
        """Return the initial state for a time step [s]."""
        state = State(self.model)
        spin = None if self.turn is None else self.turn / dt
        state.set_motion(velocity=self.velocity, angular_velocity=spin)
        if self.integrity is not None:
            state.integrity[:] = self.integrity[self.model.layout.bond_order]
        if self.strain:
            state.set_eigenstrain(self.strain * np.linspace(-1.0, 1.0, len(self.model.lattice.pairs)))
        return state


def crooked(size: int, *, period: bool = False, radius: tuple[float, float] = (0.3, 0.4), reach: float = 1.62):
    """Return a bonded irregular grid in one connected piece, with about 2.9 bonds per element."""
    edges = GRIDS[size]
    rng = np.random.default_rng(size)
    grid = np.indices(edges).reshape(3, -1).T.astype(float)
    position = grid + rng.uniform(-0.1, 0.1, grid.shape) + 0.5
    radii = rng.uniform(*radius, len(grid))
    if not period:
        return bd.connect(bd.Particles(position, radii), reach=reach)
    cell = np.array(edges, dtype=float)
    return bd.connect(bd.Particles(position % cell, radii, cell, bd.Cell(size=tuple(cell.tolist()))), reach=reach)


def density(size: int) -> np.ndarray:
    return np.random.default_rng(size + 1).uniform(900.0, 1100.0, int(np.prod(GRIDS[size])))


def random_motion(lattice: bd.Lattice, *, speed: float = 0.5, turn: float = 2e-3) -> dict[str, np.ndarray]:
    rng = np.random.default_rng(7)
    shape = (len(lattice.particles), 3)
    return {"velocity": rng.uniform(-speed, speed, shape), "turn": rng.uniform(-turn, turn, shape)}


def bonded(lattice: bd.Lattice, *, bond=ALIKE, boundary=(), **options) -> Case:
    """Bonds in random motion; laws, conditions and integrity may be functions of the lattice."""
    size = min(GRIDS, key=lambda count: abs(count - len(lattice.particles)))
    rho = options.pop("density", None)
    bond, boundary = (given(lattice) if callable(given) else given for given in (bond, boundary))
    if "integrity" in options:
        options["integrity"] = options["integrity"](lattice)
    model = bd.Model(lattice, bond, density=density(size) if rho is None else rho, boundary=boundary)
    return Case(model=model, **(random_motion(lattice) | options))


def weakened(lattice: bd.Lattice) -> np.ndarray:
    """Bonds of which some are broken or weak."""
    return np.random.default_rng(3).uniform(-0.2, 1.3, len(lattice.pairs)).clip(0.0, 1.0)


def patches(lattice: bd.Lattice) -> dict:
    """Return bond laws of three materials by region: one for each half, and one for bonds between them."""
    half = 0.5 * float(lattice.particles.position[:, 0].max())
    left = bd.Within(bd.Box(size=(half, 1e3, 1e3)))
    right = bd.Everything() - left
    soft = bd.Timoshenko(E=0.4 * E, nu=0.3, radius_ratio=0.5, radius_rule="pair_min")
    return {left: SHORT, right: soft, (left, right): bd.ParallelBond(E=0.7 * E, nu=0.1, radius_ratio=0.55)}


def rows(lattice: bd.Lattice) -> list:
    """Return conditions that fix, drive and load elements, in some or all components, by all kinds of schedules."""
    n = len(lattice.particles)
    middle, other = n // 2, n // 3
    wave = bd.Table((0.0, 0.05, 0.05, 0.2), (0.0, 1.0, 0.5, -1.0))
    return [
        bd.Fix(bd.Face("x_min", depth=0.5) - bd.Index([middle, other])),
        bd.Fix(bd.Face("y_max", depth=0.5) - bd.Face("x_min", depth=0.5) - bd.Index([middle, other]),
               translation="y", rotation="z"),
        bd.Drive(bd.Index([middle]), vy=bd.Ramp(0.0, 0.4, 0.05), rx=bd.Ramp(0.0, 0.1, 0.03), z=wave_of(0.01)),
        bd.Drive(bd.Index([other]), x=bd.Ramp(0.0, 0.02, 0.1), wz=bd.Constant(0.3)),
        bd.Load(bd.Face("x_max", depth=0.5), force=(3e4, -1e4, 2e4), schedule=bd.Ramp(0.0, 1.0, 0.02)),
        bd.Load(bd.Face("x_max", depth=0.5), moment=(1e3, 2e3, -3e3), schedule=wave),
    ]  # fmt: skip


def wave_of(size: float) -> bd.Table:
    return bd.Table((0.0, 0.02, 0.08, 0.3), (0.0, size, -size, 0.0))
