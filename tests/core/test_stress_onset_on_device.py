"""Facets that begin to crack by a function of the stress: passes of a device against those of the CPU."""

import copy
import ctypes
from typing import Any

import numpy as np
import pytest

import bondem as bd
from bondem._core_steps import Composer
from bondem._device import DeviceTables, Host, HostCall, passes_of
from bondem.dynamics.core_loop import CoreLoop
from bondem.dynamics.explicit import integrate
from bondem.dynamics.on_device.counterparts import launches_of
from bondem.dynamics.on_device.stress_onset_counterparts import COUNTERPARTS
from bondem.dynamics.on_device.translation import Translation
from bondem.dynamics.plan import Plan
from bondem.dynamics.timestep import critical_step
from bondem.interactions.step_part import Passes, composed
from bondem.model.state import State
from tests.core.test_cells import LAW, body
from tests.device_runs import deviation
from tests.device_sides import on_device

DT = 1e-6
# Elements and bonds of a portion, as in `core/steps.hpp`.
PORTIONS = {"judge_cells": 1024, "find_stress_candidates": 2048}
#: Passes of a device, of which each criterion has some.
ONSET = {
    "judge_cell_by_mean_stress", "judge_cell_by_cone", "judge_cell_by_size", "clear_candidates",
    "find_stress_candidate", "index_candidate_by_mean_stress", "index_candidate_by_cone", "mark_failing_facet",
    "find_strength_along",
}  # fmt: skip
OF_EACH = {
    "mean stress": {"judge_cell_by_mean_stress", "index_candidate_by_mean_stress"},
    "cone": {"judge_cell_by_cone", "index_candidate_by_cone"},
    "function": {"judge_cell_by_size"},
}


def mean_over_strength(stress: np.ndarray, tension: float) -> Any:
    return (stress[..., 0, 0] + stress[..., 1, 1] + stress[..., 2, 2]) / (3.0 * tension)


CRITERIA: dict[str, Any] = {
    "mean stress": bd.Hydrostatic(tension=1e6, scatter=bd.Weibull(modulus=6.0, volume=1e-3, seed=2)),
    "cone": bd.DruckerPrager(tension=2e6, compression=8e6),
    "function": bd.StressCriterion(mean_over_strength, tension=4e5),
}


def onset_of(loop: CoreLoop) -> Passes:
    """Return the passes in which facets begin to crack, at random stresses; some cells and facets are cracked."""
    passes = [one for one in composed(loop._parts, "prepare") if one.name in COUNTERPARTS]
    (stresses, *_, cracks), (_, facets, kept, *_, onset) = (one.tables for one in passes[:2])
    rng, n = np.random.default_rng(3), len(stresses.tensor)
    m = int(np.count_nonzero(facets.k))
    stresses.tensor[:, :6] = rng.normal(0.0, 1e6, (n, 6)) * np.linspace(0.0, 1.0, n)[:, None]
    stresses.tensor[:, 6] = rng.uniform(0.0, 1e11, n)
    stresses.tensor[:, 7] = np.sqrt((stresses.tensor[:, :6] ** 2 * [1, 1, 1, 2, 2, 2]).sum(axis=1))
    kept.force[:, :m] = rng.normal(0.0, 1e6, (3, m)) * onset.area[:m]
    cracks.cracked[rng.random(n) < 0.1] = 1
    cracks.listed[:m][rng.random(m) < 0.1] = 1
    return passes


def carry_out(passes: Passes, n: int, m: int) -> None:
    """Carry out passes of the CPU, portion by portion, within a step."""
    clock = np.zeros(9)
    clock[1] = DT
    kind = ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_void_p)
    composer = Composer()
    for one, entry in zip(passes, composer(passes), strict=True):
        count = n if one.name.startswith("judge") else m
        size = next((size for name, size in PORTIONS.items() if one.name.startswith(name)), count)
        for block, first in enumerate(range(0, count, size)):
            last = min(first + size, count)
            turn = np.array([clock.ctypes.data, first, last, last, 0, 0, block, 0, 0], dtype=np.int64)
            kind(int(entry[0]))(turn.ctypes.data, entry[2:].ctypes.data)


def carry_out_on_device(loop: CoreLoop, passes: Passes) -> tuple[set[str], int]:
    """Carry out the counterparts of passes, and copy back what they find; return their names and calls of the CPU."""
    model = loop.state.model
    shared = loop._tables
    run = Translation(model.layout, shared.blocks, shared.ledger, 0, np.zeros(0, dtype=np.uint8), further=False)
    run.span.clock.view(float)[1] = DT
    launches, tables = launches_of(passes, run), DeviceTables(Host())
    tables.work_space(*run.work_spaces)
    for enqueue in tables.prepared(launches):
        enqueue(None)
    tables.fetch_written()
    return set(passes_of(launches)), sum(isinstance(one, HostCall) for one, *_ in launches)


@pytest.mark.parametrize("name", CRITERIA)
def test_facets_that_begin_to_crack_are_those_of_the_cpu(name: str) -> None:
    model = bd.Model(body(450), LAW, density=2500.0, failure=CRITERIA[name])
    loop = CoreLoop(model, Plan(duration=DT, dt=DT, every=0), State(model), DT)
    passes = onset_of(loop)
    ours = copy.deepcopy(passes)
    launched, calls = carry_out_on_device(loop, ours)
    carry_out(passes, len(model.layout.order), len(model.layout.i))
    assert calls == (2 if name == "function" else 0)
    assert launched == ONSET - set().union(*(names for other, names in OF_EACH.items() if other != name))
    cracks, onset = (one.tables[-1] for one in passes[:2])
    found, found_onset = (one.tables[-1] for one in ours[:2])
    assert 0 < (cracks.judged > 0).sum() < len(cracks.judged)
    assert 50 < cracks.marked.sum() < 0.9 * len(cracks.marked)
    for field in ("judged", "marked", "found"):
        np.testing.assert_array_equal(getattr(found, field), getattr(cracks, field), err_msg=field)
    np.testing.assert_array_equal(found_onset.along, onset.along)
    assert len(np.unique(onset.along)) > 50


@pytest.mark.parametrize("name", CRITERIA)
def test_a_body_that_is_torn_cracks_as_on_the_cpu(name: str) -> None:
    boundary = [bd.Fix(bd.Face("x_min")), bd.Drive(bd.Face("x_max"), vx=2.0)]
    model = bd.Model(body(120), LAW, density=2500.0, failure=CRITERIA[name], boundary=boundary)
    dt = 0.9 * critical_step(model, bd.VelocityVerlet())
    plan = Plan(duration=110 * dt, dt=dt, every=20)
    cpu, device = (integrate(model, plan, loop_of=loop) for loop in (CoreLoop, on_device))
    assert 100 < len(cpu.state.cracks) == len(device.state.cracks)
    assert len(cpu.state.broken) > 20
    assert deviation(cpu, device) < 1e-12
