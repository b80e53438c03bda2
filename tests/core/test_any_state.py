"""A state whose arrays were replaced by anything is run or refused by an error of the package, and nothing else."""

import warnings
from collections.abc import Iterator

import numpy as np
import pytest

import bondem as bd
from bondem._tables.columns import EventColumn
from bondem.errors import BondemError
from bondem.model.state import State

GRID = np.indices((4, 3, 3)).reshape(3, -1).T.astype(float)
SPHERES = bd.Particles(GRID, 0.5)
LATTICE, BODY = bd.connect(SPHERES, reach=1.1), bd.connect(SPHERES, method="laguerre")
TOUCH = {"contact": bd.LinearContact(E=1e7, friction=0.4), "walls": [bd.PlaneWall((0.0, 0.0, -0.5), (0.0, 0.0, 1.0))]}
BEAM = bd.EulerBernoulli(E=1e7, nu=0.2, radius_ratio=0.6)
MODELS = {
    "beams": bd.Model(
        LATTICE, BEAM, 1000.0, failure=bd.PeripheralStress(tension=1e4, shear=1e4),
        boundary=[bd.Fix(bd.Face("x_min"))],
        **TOUCH,
    ),
    "softening beams": bd.Model(
        LATTICE, BEAM, 1000.0, failure=bd.PeripheralStress(tension=1e5, shear=1e5, fracture_energy=1e4)
    ),
    "stored beams": bd.Model(
        LATTICE, bd.EulerBernoulli(E=1e7, nu=0.2, radius_ratio=0.6, formulation="incremental"), 1000.0
    ),
    "cells": bd.Model(
        BODY, bd.CellBond(E=1e7, nu=0.2), 1000.0,
        failure=bd.MohrCoulomb(tension=1e4, cohesion=2e4, friction_angle=0.6, fracture_energy=100.0), **TOUCH,
    ),
    "non-local": bd.Model(BODY, bd.NonLocal(E=1e7, nu=0.2), 1000.0, failure=bd.Rankine(tension=1e4), **TOUCH),
}  # fmt: skip
DT = 1e-4


def ran(model: bd.Model, state: State | None = None, steps: int = 2) -> State:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return bd.solve_explicit(model, duration=steps * DT, dt=DT, every=0, state=state).state


def faults(name: str, values: np.ndarray) -> Iterator[np.ndarray]:
    """Arrays of another shape, type or order in memory, and with numbers that cannot be."""
    rows = max(len(values), 1)
    yield np.zeros((rows - 1, *values.shape[1:]), values.dtype)
    yield np.ones((rows + 1, *values.shape[1:]), values.dtype)
    yield np.zeros((*values.shape[:-1], values.shape[-1] + 1), values.dtype)
    yield np.zeros((*values.shape[:-1], max(values.shape[-1] - 1, 0)), values.dtype)
    yield values.ravel()
    yield values[None]
    whole = np.clip(np.nan_to_num(values), -1e6, 1e6)
    yield from (whole.astype(kind) for kind in (np.float32, np.int32, object, bool))
    yield whole.astype(float if values.dtype.kind == "i" else np.int64)
    yield np.repeat(values, 2, axis=-1)[..., ::2]
    yield np.asfortranarray(values)
    fixed = values.copy()
    fixed.setflags(write=False)
    yield fixed
    if not values.size:
        return
    wrong = (-1, 10**9) if values.dtype.kind == "i" else (np.nan, np.inf, 1e300, -1.0, 1e9)
    thorough = name in State.GROWING or name in ("pose", "motion")
    columns = values.shape[-1] if values.ndim > 1 and thorough else 1
    for column in range(columns):
        for number in wrong:
            changed = values.copy()
            changed.reshape(len(changed), -1)[0, column] = number
            yield changed


@pytest.mark.validate
@pytest.mark.parametrize("kind", MODELS)
def test_anything_in_place_of_an_array_of_a_state_is_run_or_refused(kind):
    model = MODELS[kind]
    state = model.state()
    state.velocity = 5.0 * np.random.default_rng(0).standard_normal((len(SPHERES), 3))
    state = ran(model, state, steps=300)
    refused = []
    for name in State.ARRAYS:
        for wrong in faults(name, getattr(state, name)):
            changed = state.copy()
            setattr(changed, name, wrong)
            try:
                ran(model, changed)
            except BondemError as error:
                refused.append(str(error))
    assert len(refused) > 100
    assert not [message for message in refused if "\n" in message]


@pytest.mark.parametrize(
    ("name", "column", "number", "words"),
    [
        ("pose", 0, np.nan, "pose has values that are not finite"),
        ("motion", 4, np.inf, "motion has values that are not finite"),
        ("touching", 1, 36, "touching has numbers beyond 0 … 35"),
        ("touching", 0, -1, "touching has numbers beyond 0 … 35"),
        ("broken", 2, 75, "broken has numbers beyond 0 … 74"),
        ("broken", 2, 0.5, "broken has numbers beyond 0 … 74"),
    ],
)
def test_numbers_of_elements_and_bonds_that_are_not_there_are_refused(name, column, number, words):
    model = MODELS["beams"]
    state = ran(model)
    state.touching, state.stretch = np.array([[0, 35]]), np.zeros((1, 9))
    state.broken = np.zeros((1, EventColumn.COUNT))
    getattr(state, name)[0, column] = number
    with pytest.raises(BondemError, match=words):
        ran(model, state)
