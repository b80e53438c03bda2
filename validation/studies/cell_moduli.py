"""E and ν of bodies of cells against those put in, and how far tractions and stresses scatter.

Nothing is calibrated. Packings of spheres (κ = 25 %, seeds 1 to 5) are cut into cells: a periodic cell, and a free
bar 4 × 1 × 1 pulled between smooth platens. In the bar the stress is uniform, σ = F / S along x: the root mean square
of t - σ n over the facets of the middle half, over σ, and the scatter of the mean stress of its cells tell what a
failure criterion would see.
"""

from functools import partial
from typing import Any

import numpy as np

import bondem as bd
from bondem.observables.cell_forces import CellForces
from validation.frame.record import Record

NU = (-0.3, 0.0, 0.1, 0.2, 0.3, 0.4, 0.45, 0.49)
PULL = 1e-3


def bar_test(body: bd.Lattice, nu: float, law: bd.CellBond | None = None) -> dict[str, float]:
    """E and ν of a bar between smooth platens, for E = 1, and the scatter of its tractions and stresses.

    `law` takes the place of the plain law, with the same E and ν.
    """
    shape = body.particles.envelope
    length, section = shape.extent, shape.section()
    middle = int(np.linalg.norm(body.centre - shape.bounds[1] / 2.0, axis=1).argmin())
    held = [
        bd.Fix(bd.Face("x_min"), translation="x", rotation=""), bd.Drive(bd.Face("x_max"), x=PULL * length),
        bd.Fix(bd.Index([middle]), translation="yz", rotation="x"),
    ]  # fmt: skip
    model = bd.Model(body, law or bd.CellBond(E=1.0, nu=nu), 1.0, boundary=held)
    static = bd.solve_static(model)
    stress = static.reaction[body.centre[:, 0] > 0.5 * length, 0].sum() / section
    inside = np.abs(body.particles.position[:, 0] - 0.5 * length) < 0.25 * length
    design = np.column_stack([body.particles.position[inside], np.ones(inside.sum())])
    fit = np.linalg.lstsq(design, static.displacement[inside], rcond=None)[0]
    assert body.facets is not None
    area, both = body.facets.area[:, None], inside[body.pairs].all(axis=1)
    off = CellForces.of(model, static).force / area - stress * body.facets.normal[:, :1] * [1.0, 0.0, 0.0]
    traction = np.sqrt((area * off**2)[both].sum() / area[both].sum()) / stress
    return {
        "E": stress / PULL, "nu": float(-0.5 * (fit[1, 1] + fit[2, 2]) / fit[0, 0]), "traction": float(traction),
        "stress": float(bd.cell_stress(model, static)[inside, 0, 0].std() / stress),
    }  # fmt: skip


def measure(record: Record, *, count: int = 2000, seeds: tuple[int, ...] = (1, 2, 3, 4, 5)) -> None:
    """Measure both bodies of each packing."""
    record.keep(count=count)
    for seed in seeds:
        torus, bar = (
            bd.connect(bd.pack(shape, count=count, spread=0.25, seed=seed), method="laguerre")
            for shape in (bd.Cell((1.0, 1.0, 1.0)), bd.Box((4.0, 1.0, 1.0)))
        )
        for nu in NU:
            record.add(partial(moduli, torus, bar, nu), "rows", seed=seed, nu=nu)


def moduli(torus: bd.Lattice, bar: bd.Lattice, nu: float) -> dict[str, Any]:
    """Moduli of the periodic cell, and what a pulled bar has."""
    bulk = bd.bulk_moduli(torus, bd.CellBond(E=1.0, nu=nu))
    return {"bulk": {"E": bulk.E, "nu": bulk.nu}, "bar": bar_test(bar, nu)}
