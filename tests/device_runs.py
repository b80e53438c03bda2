"""Runs with all that devices know, and how far two of them are apart."""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np

import bondem as bd
from bondem.dynamics.plan import ExplicitResult
from bondem.model.state import State
from tests import lagged_runs, softening_cases
from tests.core import contact_cases
from tests.device_cases import (
    CELL_GAUGES,
    CRITERIA,
    GAUGES,
    Case,
    bar,
    body,
    breaking_bar,
    breaking_cell,
    cell,
    free_body,
    held_bar,
    moving,
    pressed_bar,
    sheet,
)

DAMPED = bd.LocalDamping(0.1)


def strained(model: bd.Model, size: float) -> State:
    state = moving(model)
    state.set_eigenstrain(size * np.random.default_rng(3).standard_normal(len(model.lattice.pairs)))
    return state


def held_beams() -> bd.Model:
    """The bar, held at one end and free of anything else."""
    law = bd.Timoshenko(E=1e7, nu=0.2, radius=0.2)
    return bd.Model(bar().lattice, law, 1000.0, boundary=[bd.Fix(bd.Face("x_min", depth=0.5))])


def brittle_beams() -> bd.Model:
    """These beams, which break."""
    model, failure = held_beams(), bd.PeripheralStress(tension=5e4, shear=5e4)
    return bd.Model(model.lattice, model.bond, 1000.0, boundary=model.boundary, failure=failure)


def warming_beams() -> bd.Model:
    """The bar, which grows by two strains that change, and which is held at both ends."""
    ends = bd.Face("x_min", depth=0.5), bd.Face("x_max", depth=0.5)
    heat = [
        bd.Eigenstrain(5e-3, schedule=bd.Ramp(0.0, 1.0, 0.05)),
        bd.Eigenstrain(-8e-3, bd.Index(range(20)), schedule=bd.Ramp(0.0, 1.0, 0.2)),
    ]
    law = bd.Timoshenko(E=1e7, nu=0.2, radius_ratio=0.6)
    return bd.Model(bar().lattice, law, 1000.0, boundary=[*(bd.Fix(face) for face in ends), *heat])


def warming_cells() -> bd.Model:
    """A bar of cells between walls, which grows by two strains that change."""
    heat = [
        bd.Eigenstrain(2e-3, schedule=bd.Ramp(0.0, 1.0, 0.05)),
        bd.Eigenstrain(-3e-3, bd.Index(range(12)), schedule=bd.Ramp(0.0, 1.0, 0.2)),
    ]
    held = [bd.Fix(bd.Face("x_min")), bd.Fix(bd.Face("x_max"), "x", "")]
    return bd.Model(body(4, 3, 3), bd.CellBond(E=1e7, nu=0.2), density=1000.0, boundary=[*held, *heat])


def absorbing_bar() -> bd.Model:
    """A bar of cells with an absorbing end, a moment on a region, and a pressure that follows its face."""
    return bd.Model(body(4, 3, 3), bd.CellBond(E=1e7, nu=0.2), density=1000.0, boundary=[
        bd.Absorbing(bd.Face("x_max"), density=1000.0, E=1e7, nu=0.2),
        bd.Load(bd.Face("x_min"), moment=(1e4, 0.0, 2e4), schedule=bd.Ramp(0.0, 1.0, 0.02)),
        bd.Pressure(bd.Face("y_max"), 1e5, schedule=bd.Ramp(0.0, 1.0, 0.01), follows=True),
    ])  # fmt: skip


def cells_on_rough_platens() -> bd.Model:
    """Cells that are squeezed between platens, on which some stick and others slide."""
    ends = [
        bd.Fix(bd.Face("x_min"), "x", "", friction=0.1),
        bd.Drive(bd.Face("x_max"), vx=bd.Ramp(0.0, -2.0, 0.02), friction=0.3),
    ]
    return bd.Model(body(4, 3, 3), bd.CellBond(E=1e7, nu=0.3), density=1000.0, boundary=ends)


def breaking_cells(model: bd.Model, tension: float, **options: Any) -> bd.Model:
    """A body of cells, whose facets break."""
    scatter = bd.Weibull(modulus=6.0, volume=0.3, seed=2)
    failure = bd.MohrCoulomb(tension=tension, cohesion=2.0 * tension, friction_angle=0.5, scatter=scatter)
    return bd.Model(model.lattice, model.bond, model.density, boundary=model.boundary, failure=failure, **options)


# Cells touch as spheres where their facets break, and press on two walls.
TOUCHING: dict[str, Any] = {
    "contact": bd.LinearContact(E=1e7, friction=0.4, damping=0.1),
    "walls": [
        bd.PlaneWall((0, 0, 0), (0, 0, 1)), bd.PlaneWall((0, 3.0, 0), (0, -1, 0), motion=bd.Driven(vy=-3.0)),
    ],
}  # fmt: skip


CASES: dict[str, Callable[[], Case]] = {
    "bar": lambda: (bar(), moving, 320, 2e-3, {"damping": DAMPED, "gauges": GAUGES, "every": 6}),
    "dissipative": lambda: (
        bar(), moving, 240, 2e-3, {"scheme": bd.TchamwaWielgosz(1.2), "gauges": GAUGES, "every": 5}
    ),
    "dashpots": lambda: (bar(), moving, 240, 1e-3, {"damping": bd.BondDamping(eta=0.1), "every": 7}),
    "dragged": lambda: (bar(), moving, 240, 2e-3, {"damping": bd.MassDamping(alpha=5.0), "every": 0}),
    "held": lambda: (held_beams(), moving, 240, 2e-3, {}),
    "dragged and free": lambda: (cell(), moving, 150, 2e-3, {"damping": bd.MassDamping(alpha=5.0), "every": 9}),
    "periodic": lambda: (cell(), lambda model: strained(model, 1e-3), 240, 2e-3, {"every": 6}),
    "free cells": lambda: (free_body()[0], lambda _: free_body()[1], 150, 1e-3, {"every": 3}),
    "held cells": lambda: (
        held_bar(), moving, 240, 1e-3, {"damping": DAMPED, "gauges": CELL_GAUGES, "every": 6}
    ),
    "pressed cells": lambda: (
        pressed_bar(), moving, 240, 8e-4, {"scheme": bd.TchamwaWielgosz(1.2), "gauges": CELL_GAUGES, "every": 5}
    ),
    "cells with corrected mass": lambda: (
        replace(held_bar(), mass_matrix="dispersion-corrected"), moving, 120, 1e-3, {"damping": DAMPED, "every": 3}
    ),
    "cells on rough platens": lambda: (
        cells_on_rough_platens(), moving, 120, 1e-3, {"gauges": CELL_GAUGES, "every": 5}
    ),
    "layer of cells": lambda: (sheet(), moving, 150, 1e-3, {"damping": DAMPED, "every": 3}),
    "periodic cells": lambda: (
        bd.Model(body(3, 3, 3, periodic=True), bd.CellBond(E=1e7, nu=0.2), density=1000.0),
        lambda model: strained(model, 1e-2), 150, 1e-3, {"damping": DAMPED, "every": 3},
    ),
    **{
        name: lambda criterion=criterion: (
            breaking_bar(criterion), moving, 60, 2e-3, {"damping": DAMPED, "gauges": GAUGES, "every": 5}
        )
        for name, criterion in CRITERIA.items()
    },
    "dissipative and brittle": lambda: (
        breaking_bar(CRITERIA["peripheral"]), moving, 60, 2e-3, {"every": 5, "scheme": bd.TchamwaWielgosz(1.2)}
    ),
    "alike and brittle": lambda: (
        breaking_cell(), lambda model: moving(model, speed=1.2), 60, 2e-3, {"every": 5}
    ),
    "dashpots and brittle": lambda: (
        breaking_bar(CRITERIA["peripheral"]), moving, 60, 1e-3, {"every": 0, "damping": bd.BondDamping(eta=0.1)}
    ),
    "held and brittle": lambda: (brittle_beams(), moving, 60, 2e-3, {}),
    "brittle cells": lambda: (
        breaking_cells(held_bar(), 1.5e5), moving, 60, 1e-3, {"damping": DAMPED, "gauges": CELL_GAUGES, "every": 5}
    ),
    "free brittle cells": lambda: (
        breaking_cells(bd.Model(body(3, 3, 3, periodic=True), bd.CellBond(E=1e7, nu=0.2), density=1000.0), 1.5e5),
        lambda model: moving(model, 3.0), 100, 1e-3, {"every": 9},
    ),
    "pressed brittle cells": lambda: (
        breaking_cells(pressed_bar(), 6e4), lambda model: moving(model, 2.0), 120, 8e-4,
        {"scheme": bd.TchamwaWielgosz(1.2), "gauges": CELL_GAUGES, "every": 5},
    ),
    "warming brittle cells": lambda: (breaking_cells(warming_cells(), 3e4), moving, 100, 1e-3, {"every": 10}),
    "cells break and touch": lambda: (
        breaking_cells(held_bar(), 2e5, **TOUCHING), lambda model: moving(model, 2.0), 120, 5e-4,
        {"damping": bd.BondDamping(eta=0.05), "gauges": CELL_GAUGES, "every": 7},
    ),
    "warming": lambda: (warming_beams(), moving, 150, 2e-3, {"every": 10}),
    "warming cells": lambda: (warming_cells(), moving, 100, 1e-3, {"every": 10}),
    "absorbing cells": lambda: (absorbing_bar(), moving, 150, 1e-3, {"gauges": CELL_GAUGES, "every": 10}),
}  # fmt: skip


def _touching(case: str) -> Callable[[], Case]:
    """A case of contacts and walls, with gauges of all walls."""

    def make() -> Case:
        found, damping = contact_cases.CASES[case]
        model, _ = found()
        plan = contact_cases.plan_of(model, 1)
        assert plan.dt is not None
        options: dict[str, Any] = {"damping": damping, "gauges": plan.gauges, "every": 20}
        return model, lambda _: found()[1], contact_cases.STEPS, plan.dt, options

    return make


CASES |= {case: _touching(case) for case in contact_cases.CASES}
CASES |= softening_cases.CASES | lagged_runs.CASES


def deviation(expected: ExplicitResult, found: ExplicitResult) -> float:
    """Return the largest difference of two runs, over the largest value of each array; inf if they end otherwise.

    Energies are compared with the largest of a record, as they come and go, and works by their sum: on a device the
    work of walls and tractions belongs to the rows of their cells.
    """
    if (expected.status, expected.message) != (found.status, found.message):
        return np.inf
    one, other = expected.state, found.state
    pairs = [(getattr(one, name), getattr(other, name)) for name in _FIELDS]
    work = max(np.abs(one.work).max(initial=0.0), 1e-300)
    pairs.append((np.array([work, one.work.sum()]), np.array([work, other.work.sum()])))
    records = [result.history.records for result in (expected, found)]
    pairs += [(records[0][:, 1:11], records[1][:, 1:11])]
    pairs += [(records[0][:, c], records[1][:, c]) for c in (0, *range(11, records[0].shape[1]))]
    if any(a.shape != b.shape for a, b in pairs):
        return np.inf
    return max(float(np.abs(b - a).max(initial=0.0) / (np.abs(a).max(initial=0.0) or 1.0)) for a, b in pairs)


_FIELDS = (
    "stretch", "wall_stretch", "walls", "pose", "motion", "acceleration", "loss", "reaction", "integrity", "broken",
    "softened", "released", "history", "stress",
)  # fmt: skip
