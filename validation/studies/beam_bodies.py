"""Bodies of calibrated beam bonds against three-dimensional elasticity, in the shapes that cells are held against.

Euler–Bernoulli bonds are calibrated once for each of five materials, in periodic cells without any wall, and fill the
seven shapes of `cell_bodies.py`: as calibrated, and with E_μ and r̃ changed for the whole body by bondem's
surface correction (`fit.law_for`). The continua are those of the cells, and so are the quantities: E and ν of bars,
six free frequencies, and what loads on the clamped body do. Spheres are held and loaded at their centres, which lie R̄
inside of the faces: what a load does is compared with the continuum between these planes, in the beams' favour (with
faces held, several per cent of the length would be missing).
"""

from functools import cache, partial
from itertools import product
from typing import Any

import numpy as np

import bondem as bd
from validation.frame.record import Record
from validation.measures.bodies import MODES, bodies, free_modes, mesh
from validation.measures.matching import matched
from validation.studies.any_specimen import DEPTH, MATERIALS, SPREAD, cells, deflections

#: Spheres of each calibrating cell, and how many cells.
CELL, CELLS = 10_000, 2
WAYS = ("calibrated", "corrected")


@cache
def fit(material: str) -> Any:
    """The bonds of a material."""
    return bd.calibrate(cells(CELL, CELLS), bd.materials.get(material), law=bd.EulerBernoulli)


@cache
def body(name: str, count: int, seed: int) -> bd.Lattice:
    return bd.connect(bd.pack(bodies()[name].shape, count=count, spread=SPREAD, seed=seed))


@cache
def clamped(name: str, nu: float, inside: float) -> dict[str, float]:
    """What each unit load does where it acts, for E = 1, between planes `inside` [m] of the faces."""
    return bodies()[name].moved(_between(name, inside), nu, inside)


@cache
def _between(name: str, inside: float) -> Any:
    return mesh(name).between(inside, "x_min", bodies()[name].loaded)


def case(material: str, name: str, count: int, seed: int) -> dict[str, Any]:
    """One body: every quantity over that of the continuum, less one; of ν the difference."""
    lattice, found = body(name, count, seed), fit(material)
    target = found.material
    laws = (found.law, found.law_for(lattice))
    size = (bodies()[name].shape.volume / count) ** (1.0 / 3.0)
    return {
        "material": material, "shape": name, "nu": target.nu, "count": count, "seed": seed,
        "thickness": bodies()[name].thickness / size,
    } | {way: errors(lattice, law, found, name) for way, law in zip(WAYS, laws, strict=True)}  # fmt: skip


def errors(lattice: bd.Lattice, law: Any, found: Any, name: str) -> dict[str, float]:
    """Of one law in one body."""
    target, moving = found.material, lattice.connected
    rows: dict[str, float] = {}
    if bodies()[name].bar:
        bar = bd.labtests.static_tension(lattice, law, depth=DEPTH)
        rows |= {"E": bar.E / target.E - 1.0, "nu": bar.nu - target.nu}
    theory = free_modes(name, target.nu)
    modes = bd.solve_modes(bd.Model(lattice, law, found.density_for(lattice)), count=MODES + 3)
    expected = mesh(name).sampler(lattice.particles.position[moving])(theory.shape)
    groups = matched(modes, lattice.particles.volume[moving], theory, expected, moving)
    speed = np.sqrt(target.E / target.rho)
    each = [one.measured / (speed * one.reference) - 1.0 for one in groups for _ in one.modes]
    rows |= {f"f{k}": error for k, error in enumerate(each[:6], start=1)}
    exact = clamped(name, target.nu, lattice.particles.mean_radius)
    pushed = deflections(lattice, law, bodies()[name].loaded, bodies()[name].loads)
    return rows | {load: moved * target.E / exact[load] - 1.0 for load, moved in pushed.items()}


def measure(
    record: Record, *, shapes: tuple[str, ...] = tuple(bodies()), materials: tuple[str, ...] = tuple(MATERIALS),
    count: int = 10_000, seed: int = 1,
) -> None:  # fmt: skip
    """Measure each material in each shape."""
    record.keep(cell=CELL, cells=CELLS)
    for name, material in product(shapes, materials):
        record.add(partial(case, material, name, count, seed), material=material, shape=name, count=count, seed=seed)
