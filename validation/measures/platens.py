"""One concrete cylinder between smooth platens, of any bond law: compressed, pulled, or split across a diameter.

Platens hold the elements at the ends of the cylinder along x, or two strips of its side along y, and leave all other
motions free: no friction, and the same support for spheres, cells and the non-local law. What is broken touches by
`bd.LinearContact`, but for cells with a fracture energy, whose closed cracks bear pressure by themselves. Density
2400 kg/m³, local damping 0.3, platens so slow that sound runs TRAVERSES times along the load until the expected peak.
"""

import math
import time
from dataclasses import dataclass
from typing import Any

import numpy as np

import bondem as bd

E, NU, RHO = 40e9, 0.2, 2400.0
RADIUS, LENGTH = 50e-3, 200e-3
SOUND = math.sqrt(E / RHO)
#: How often sound runs along the load until the stress that is expected.
TRAVERSES = 60.0
#: Stress that sets the speed [Pa]: 2 P / (π D t) of the Brazilian test.
EXPECTED = {"ucs": 55e6, "tension": 4e6, "brazilian": 4e6}
#: A test that bears less than this share of it is done again.
SOON = 0.5
#: Motion at the expected stress over that stress and D / E, of the Brazilian test: between strips, as of cells.
CLOSING = 4.0
#: A test ends at this share of its peak, or at so many times the expected motion. A cylinder that has split bears on
#: between its strips, so that its test ends sooner.
FALLEN, REACH = {"ucs": 0.7, "tension": 0.5, "brazilian": 0.8}, 2.5
#: Damping of elements, and dashpots of contacts over the critical one; none where cells touch, whose smallest facets
#: would bring the time step down to 6e-11 s.
DAMPING, DASHPOT = 0.3, 0.1


@dataclass(frozen=True, eq=False)
class Tested:
    """One test.

    Attributes:
        peak: largest stress [Pa]: P / S, or 2 P / (π D t).
        E: slope of the curve between a tenth and half of the peak [Pa]; none of the Brazilian test.
        curve: strain and stress, (k, 2).
        asymmetry: largest difference of the forces on both platens up to the peak, over the peak [-].
        broken: bonds or facets until the end, and up to the peak.
        run: the explicit run.
        seconds: of it.
    """

    peak: float
    E: float
    curve: np.ndarray
    asymmetry: float
    broken: tuple[int, int]
    run: bd.ExplicitResult
    seconds: float


def spheres(count: int, seed: int) -> bd.Lattice:
    """A packing of spheres that touch, for beams."""
    return bd.connect(bd.pack(bd.Cylinder(radius=RADIUS, length=LENGTH), count=count, seed=seed))


def cells(count: int, seed: int) -> bd.Lattice:
    """The cylinder cut into cells."""
    particles = bd.pack(bd.Cylinder(radius=RADIUS, length=LENGTH), count=count, method="even", seed=seed)
    return bd.connect(particles, method="laguerre")


def strips(lattice: bd.Lattice) -> tuple[bd.Region, bd.Region, float]:
    """Two strips of the side at +y and -y, as wide as `bd.labtests.brazilian` has them, and half their angle."""
    edge = (math.pi * RADIUS**2 * LENGTH / len(lattice.particles)) ** (1.0 / 3.0)
    angle = max(math.radians(5.0), math.asin(0.75 * edge / RADIUS))
    y, z = lattice.centre[:, 1], lattice.centre[:, 2]
    side = bd.Face("side", depth=0.1)
    up, down = (side & bd.Index(np.flatnonzero(np.abs(np.arctan2(z, sign * y)) < angle)) for sign in (1.0, -1.0))
    return up, down, angle


def model_of(
    kind: str, lattice: bd.Lattice, law: Any, failure: bd.Criterion | None, friction: float, speed: float,
    begin: float,
) -> tuple[bd.Model, dict[str, bd.Gauge]]:  # fmt: skip
    """The specimen between its platens, and the gauges of both."""
    density = RHO
    if lattice.cells is None:
        density = RHO * math.pi * RADIUS**2 * LENGTH / float(lattice.particles.volume.sum())
    if kind == "brazilian":
        far, near, _ = strips(lattice)
        half = bd.Ramp(0.0, 0.5 * speed, begin), bd.Ramp(0.0, -0.5 * speed, begin)
        boundary = [bd.Drive(far, vy=half[0]), bd.Drive(near, vy=half[1])]
    else:
        near, far = bd.Face("x_min", depth=0.1), bd.Face("x_max", depth=0.1)
        boundary = [bd.Fix(near, translation="x", rotation=""), bd.Drive(far, vx=bd.Ramp(0.0, speed, begin))]
    softens = failure is not None and failure.softening is not None and isinstance(law, bd.CellBond)
    contact = None
    if failure is not None and not softens:
        dashpot = 0.0 if isinstance(law, bd.CellBond) else DASHPOT
        contact = bd.LinearContact(E=E, friction=friction, kappa=2.0 * (1.0 + NU), damping=dashpot)
    model = bd.Model(lattice, law, density, failure=failure, contact=contact, boundary=boundary)
    return model, {"near": bd.Gauge(near, "force"), "far": bd.Gauge(far, "force")}


def broken_by(kind: str, lattice: bd.Lattice, law: Any, failure: bd.Criterion, *, friction: float) -> Tested:
    """One test to failure; again, and slower by as much, where less than half of the expected stress is borne."""
    found = _loaded(kind, lattice, law, failure, friction, EXPECTED[kind])
    if found.peak < SOON * EXPECTED[kind]:
        found = _loaded(kind, lattice, law, failure, friction, found.peak)
    return found


def _loaded(
    kind: str, lattice: bd.Lattice, law: Any, failure: bd.Criterion, friction: float, expected: float
) -> Tested:
    axis, size = (1, 2.0 * RADIUS) if kind == "brazilian" else (0, LENGTH)
    section = math.pi * RADIUS * (LENGTH if kind == "brazilian" else RADIUS)
    sign = 1.0 if kind == "tension" else -1.0
    way = expected / E * size * (CLOSING if kind == "brazilian" else 1.0)
    rise = TRAVERSES * size / SOUND
    speed, begin = sign * way / rise, 0.2 * rise
    model, gauges = model_of(kind, lattice, law, failure, friction, speed, begin)

    def stress(history: bd.History) -> np.ndarray:
        return sign * 0.5 * (history["far"][:, axis] - history["near"][:, axis]) / section

    along = 0.5 * sign * np.eye(3)[axis]
    falls = bd.LoadDrop({"far": tuple(along), "near": tuple(-along)}, FALLEN[kind], 0.02 * expected * section)
    clock = time.perf_counter()
    run = bd.solve_explicit(
        model, duration=REACH * rise + 0.5 * begin, every=40, gauges=gauges, until=falls,
        damping=bd.LocalDamping(DAMPING),
    )  # fmt: skip
    seconds = time.perf_counter() - clock
    history = run.history
    t, found = history.time, stress(history)
    strain = np.where(t < begin, 0.5 * t**2 / begin, t - 0.5 * begin) * abs(speed) / size
    peak = int(np.argmax(found))
    straight = np.flatnonzero((found > 0.1 * found[peak]) & (found < 0.5 * found[peak]) & (np.arange(len(t)) < peak))
    both = np.abs(history["far"][:, axis] + history["near"][:, axis])[: peak + 1] / section
    broken = len(run.events), int((run.events.time <= t[peak]).sum())
    slope = float(np.polyfit(strain[straight], found[straight], 1)[0]) if len(straight) > 2 else math.nan
    return Tested(
        peak=float(found[peak]), E=slope, curve=np.column_stack([strain, found]), broken=broken,
        asymmetry=float(both.max() / found[peak]), run=run, seconds=seconds,
    )  # fmt: skip
