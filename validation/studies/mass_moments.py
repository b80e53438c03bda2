"""First frequencies of cylinders whose elements have one density, eq (19), or the body's mass, centre and inertia."""

from typing import Any

import numpy as np

import bondem as bd
from bondem.calibration.density import balanced_density, element_density
from bondem.geometry.moments import moments
from validation.frame.record import Record

RHO = 2201.0
SHAPE = bd.Cylinder(radius=5e-3, length=40e-3)
LAW = bd.EulerBernoulli(E=265e9, nu=0.3, radius_ratio=0.71)
KINDS = ("tension", "bending", "torsion")


def inertia_error(lattice: bd.Lattice, density: Any) -> list[float]:
    """Error of the moments of inertia about the axis, and across it, through the centre of the elements [-]."""
    model, on = bd.Model(lattice, LAW, density=density), lattice.connected
    m, x = model.mass[on], lattice.particles.position[on]
    x = x - m @ x / m.sum()
    own = model.inertia[on].sum()
    square = m @ x**2
    found = np.array([square[1] + square[2], square[0] + 0.5 * (square[1] + square[2])]) + own
    wanted = RHO * np.diag(moments(SHAPE).inertia)[:2]
    return (found / wanted - 1.0).tolist()


def examine(count: int, seed: int) -> dict[str, Any]:
    """One packing: errors of the first frequencies against theory, with one density and with balanced ones."""
    lattice = bd.connect(bd.pack(SHAPE, count=count, spread=0.25, seed=seed))
    tension = bd.labtests.static_tension(lattice, LAW)
    row: dict[str, Any] = {"seed": seed, "count": count}
    own = {"E": tension.E, "nu": tension.nu, "rho": RHO, "gyration": tension.gyration}
    for name, density in (("one", element_density([lattice], RHO)), ("balanced", balanced_density(lattice, RHO))):
        modes = bd.labtests.natural_frequencies(lattice, LAW, density=density)
        tests = [
            getattr(bd.labtests, f"dynamic_{kind}")(lattice, LAW, density=density, modes=modes, **own)
            for kind in KINDS
        ]
        row[name] = {
            "frequency": [test.measured for test in tests],
            "error": [test.error if test.error_timoshenko is None else test.error_timoshenko for test in tests],
            "error_refined": [test.error_refined for test in tests],
            "inertia_error": inertia_error(lattice, density),
        }
    return row


def summary(rows: list[dict[str, Any]]) -> dict[str, Any]:
    """Mean and standard deviation of every error over the packings."""
    found: dict[str, Any] = {}
    for name in ("one", "balanced"):
        for key in ("error", "error_refined", "inertia_error"):
            values = np.array([row[name][key] for row in rows])
            std = values.std(axis=0, ddof=1).tolist() if len(rows) > 1 else [None] * values.shape[1]
            found.setdefault(name, {})[key] = {"mean": values.mean(axis=0).tolist(), "std": std}
    return found


def measure(record: Record, *, count: int = 10_000, packings: int = 4) -> None:
    """Measure cylinders of several packings."""
    rows = [examine(count, seed) for seed in range(1, packings + 1)]
    record.keep(kinds=KINDS, summary=summary(rows), rows=rows)
