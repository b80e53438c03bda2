"""Shear compaction (André et al. 2012, §4.1): spheres on a grid, compressed while walls shear them back and forth.

The compaction is a run of the explicit solver with contacts. One wall is under pressure (the pressure wall). Two
opposite walls move sinusoidally (the shear walls), or the mantle of a cylinder expands and contracts. The other walls
only repel. The paper describes the procedure without numbers: pressure, stiffness and rates here are those of slow
flow of nearly rigid grains.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from bondem._checks import shown
from bondem._threads import threads
from bondem._types import Floats
from bondem.boundary.gauges import WallGauge
from bondem.boundary.schedules import Table
from bondem.boundary.wall_motions import Driven, Servo
from bondem.boundary.walls import CylinderWall, PlaneWall, Wall
from bondem.dynamics.explicit import integrate
from bondem.dynamics.history import History
from bondem.dynamics.plan import Plan, Status
from bondem.dynamics.schemes import VelocityVerlet
from bondem.dynamics.timestep import critical_step
from bondem.errors import InputError, PackingError
from bondem.geometry.elementary_shapes import Box, Cylinder, Shape
from bondem.interactions.contact.contact_law import LinearContact
from bondem.model.model import Model
from bondem.model.state import State
from bondem.packing.soft_spheres import SoftSpheres
from bondem.packing.targets import Target
from bondem.specimen.lattice import Lattice
from bondem.specimen.particles import Particles

# Pressure and density are the units, because only their ratios to stiffness and rate matter. Grains of this modulus
# overlap by a thousandth; a larger modulus would only cost time.
_PRESSURE, _DENSITY, _MODULUS, _DASHPOT = 1.0, 1.0, 1000.0, 0.1

# Inertial number γ' d √(ρ/p) of the fastest shear: below 0.01 or so flow is quasi-static.
_INERTIAL = 0.01

# Amplitude of the shear strain, total number of cycles, and number of the last cycles, after the radii were fitted.
_STRAIN, _CYCLES, _FITTING = 0.1, 24, 2

# Initial volume fraction, from which the radii follow, clearance on the grid over the largest diameter, and disorder
# of the grid over the largest radius: spheres on straight lines would stay there.
_FRACTION, _CLEARANCE, _DISORDER = 0.64, 0.01, 0.005

# Largest speed of the pressure wall, over √(p/ρ) and over the speed that the shear requires.
_SPEED, _AHEAD = 0.3, 3.0

# Number of relaxation steps that a whole compaction counts as in `on_step`; some thousand are usual.
_REPORTS = 2000


@dataclass(frozen=True, eq=False)
class Compaction:
    """Result of a shear compaction.

    Attributes:
        position: centres [m], (n, 3).
        radius: radii [m], (n,).
        length: final extent up to the pressure wall along x [m].
        history: gauges "pressure wall" (displacement), "pressure" (force), "shear wall" (displacement of the wall at
            y_max, or growth of the mantle) and "shear" (force on that wall, or growth); energies [J], whose balance
            restarts with the second run, after the radii were fitted. Density [kg/m³] and pressure [Pa] are 1.
        steps: number of time steps.
    """

    position: Floats
    radius: Floats
    length: float
    history: History
    steps: int


def sheared(
    shape: Shape, relative_radius: Floats, target: Target, random: np.random.Generator, on_step: Callable[[int], None]
) -> SoftSpheres:
    """Compact spheres of relative radii (n,) under shear to fill the shape; the target has no effect here.

    Raises:
        InputError: The shape is neither Box nor Cylinder, or the spheres are too large for it.
        PackingError: The run became unstable.
    """
    packed = compact(shape, relative_radius, random, on_share=lambda share: on_step(round(share * _REPORTS)))
    position = packed.position.copy()
    position[:, 0] *= shape.bounds[1][0] / packed.length
    spheres = SoftSpheres(shape, position, packed.radius)
    spheres.steps, spheres.on_step = _REPORTS, on_step
    return spheres


def compact(
    shape: Shape, relative_radius: Floats, random: np.random.Generator, *, cycles: int = _CYCLES,
    on_share: Callable[[float], None] = lambda share: None,
) -> Compaction:  # fmt: skip
    """Compact spheres under shear, in two runs: the second after fitting the radii to the length of the shape.

    Args:
        shape: a Box or a Cylinder; the wall at x_max carries the pressure.
        relative_radius: radii up to a common factor, (n,).
        random: random generator for the disorder of the grid.
        cycles: number of shear cycles, including those of the fit.
        on_share: function called with the completed share of the time, 0 … 1.

    Raises:
        InputError: The shape is neither Box nor Cylinder, or the spheres are too large for it.
        PackingError: The run became unstable.
    """
    if not isinstance(shape, Box | Cylinder):
        raise InputError(
            f"method='shear' fills Box and Cylinder, not {shown(shape)}; use another method, or carve a Box"
        )
    solid = 4.0 / 3.0 * math.pi * float((relative_radius**3).sum())
    radius = relative_radius * (_FRACTION * shape.volume / solid) ** (1.0 / 3.0)
    position, top = _grid(shape, radius, random)
    length = float(shape.bounds[1][0])
    first = max(cycles - _FITTING, 1)
    report = _shares(on_share, first, _FITTING)

    press = _Press(shape, float(radius.mean()))
    done = press.run(position, radius, top, first, lambda share: report(0, share))
    # radii that fill the shape at the density reached; the second run compacts them to its length
    radius = radius * (length / done.length) ** (1.0 / 3.0)
    again = press.run(done.position, radius, done.length, _FITTING, lambda share: report(1, share))
    records = again.history.records.copy()
    records[:, 0] += done.history.time[-1]
    return replace(again, history=done.history.extended(records), steps=done.steps + again.steps)


def _shares(on_share: Callable[[float], None], first: int, second: int) -> Callable[[int, float], None]:
    whole = first + second
    return lambda stage, share: on_share((share * first if stage == 0 else first + share * second) / whole)


def _grid(shape: Box | Cylinder, radius: Floats, random: np.random.Generator) -> tuple[Floats, float]:
    """Return centres on a grid with small random shifts [m], (n, 3), and its length from the wall at x = 0 on [m]."""
    n, largest = len(radius), float(radius.max())
    edge = 2.0 * largest * (1.0 + _CLEARANCE)
    lower, upper = shape.bounds
    counts = np.floor((upper - lower)[1:] / edge).astype(int)
    if (counts < 1).any():
        raise InputError(f"{n} spheres are too large for {shown(shape)}; ask for more spheres or a wider shape")
    pitch = (upper - lower)[1:] / counts
    y, z = ((np.arange(count) + 0.5) * p for count, p in zip(counts, pitch, strict=True))
    layer = np.stack(np.meshgrid(lower[1] + y, lower[2] + z, indexing="ij"), axis=-1).reshape(-1, 2)
    if isinstance(shape, Cylinder):
        layer = layer[np.hypot(*layer.T) <= shape.radius - 0.5 * edge]
    layers = -(-n // len(layer))
    position = np.empty((layers * len(layer), 3))
    position[:, 0] = np.repeat((np.arange(layers) + 0.5) * edge, len(layer))
    position[:, 1:] = np.tile(layer, (layers, 1))
    full = (layers - 1) * len(layer)
    last = full + random.permutation(len(layer))[: n - full]
    chosen = np.concatenate([np.arange(full), np.sort(last)])
    return position[chosen] + _DISORDER * largest * random.uniform(-1.0, 1.0, (n, 3)), layers * edge


class _Press:
    """Walls, contact law and rates of compactions in one shape."""

    def __init__(self, shape: Box | Cylinder, mean_radius: float) -> None:
        self._shape = shape
        self._law = LinearContact(E=_MODULUS * _PRESSURE, damping=_DASHPOT, stress_free=False)
        # fastest shear rate 2 π · strain / period
        rate = _INERTIAL / (2.0 * mean_radius) * math.sqrt(_PRESSURE / _DENSITY)
        self._period = 2.0 * math.pi * _STRAIN / rate
        self._speed = max(_SPEED * math.sqrt(_PRESSURE / _DENSITY), _AHEAD * rate * float(shape.bounds[1][0]))
        self._area = shape.volume / float(shape.bounds[1][0])

    def run(
        self, position: Floats, radius: Floats, top: float, cycles: int, on_share: Callable[[float], None]
    ) -> Compaction:
        """Compress and shear spheres, then stop the shear for a period; the pressure wall starts at `top` [m]."""
        lattice = Lattice(Particles(position, radius), np.zeros((0, 2), dtype=np.int64))
        duration = top / self._speed + (cycles + 1) * self._period
        walls = self._walls(top, top / self._speed, cycles)
        model = Model(lattice, None, density=_DENSITY, contact=self._law, walls=walls)
        shearing = "growth" if isinstance(self._shape, Cylinder) else "displacement"
        # collisions are no result, so that the step need not resolve them and the energy balance is not checked
        dt = 0.9 * critical_step(model, VelocityVerlet())
        plan = Plan(duration=duration, dt=dt, imbalance=None, gauges={
            "pressure wall": WallGauge(1, "displacement"),
            "pressure": WallGauge(1, "force"),
            "shear wall": WallGauge(2, shearing),
            "shear": WallGauge(2, "growth" if shearing == "growth" else "force"),
        }, every=200)  # fmt: skip
        state = State(model)
        with threads(1 if len(radius) < 3000 else None):
            done = integrate(model, plan, state=state, progress=on_share)
        if done.status is not Status.COMPLETED:
            raise PackingError(f"shear compaction of {len(radius)} spheres in {shown(self._shape)} {done.message}")
        length = top + float(done.state.wall_displacement[1, 0])
        return Compaction(done.state.position, radius, length, done.history, done.steps)

    def _walls(self, top: float, begin: float, cycles: int) -> list[Wall]:
        """Return the wall at x_min, the pressure wall, the shear walls, and the walls that only repel."""
        shape = self._shape
        lower, upper = shape.bounds
        pressing = Servo(_PRESSURE * self._area, speed=self._speed, damping=0.0)
        ends: list[Wall] = [
            PlaneWall((0.0, 0.0, 0.0), (1.0, 0.0, 0.0)),
            PlaneWall((top, 0.0, 0.0), (-1.0, 0.0, 0.0), motion=pressing),
        ]
        if isinstance(shape, Cylinder):
            # radial strain: half the axial strain, with the opposite sign
            mantle = Driven(growth=self._swing(-0.5 * _STRAIN * shape.radius, begin, cycles))
            return [*ends, CylinderWall(shape.radius, motion=mantle)]
        half = 0.5 * _STRAIN * float(upper[1] - lower[1])
        return [
            *ends,
            PlaneWall((0.0, upper[1], 0.0), (0, -1, 0), motion=Driven(y=self._swing(-half, begin, cycles))),
            PlaneWall((0.0, lower[1], 0.0), (0, 1, 0), motion=Driven(y=self._swing(half, begin, cycles))),
            PlaneWall((0.0, 0.0, lower[2]), (0, 0, 1)),
            PlaneWall((0.0, 0.0, upper[2]), (0, 0, -1)),
        ]

    def _swing(self, amplitude: float, begin: float, cycles: int) -> Table:
        """Return the schedule `amplitude` [m] · sin over whole cycles from `begin` [s] on, and 0 afterwards."""
        phase = np.linspace(0.0, cycles, 32 * cycles + 1)
        times = np.concatenate([[0.0], begin + self._period * phase])
        swing = np.concatenate([[0.0], amplitude * np.sin(2.0 * np.pi * phase)])
        return Table(tuple(times.tolist()), tuple(swing.tolist()))
