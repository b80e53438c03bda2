"""`device="gpu"`: what can be shown without a device, and, with one (pytest --gpu), that it agrees with the CPU."""

import dataclasses
import importlib
import sys

import numpy as np
import pytest

import bondem as bd
from bondem.dynamics.explicit import integrate
from bondem.dynamics.plan import Plan
from bondem.dynamics.timestep import critical_step
from bondem.errors import InputError
from bondem.model.state import State
from tests import device_cracks, device_runs, device_yielding
from tests.device_runs import deviation

CASES = device_runs.CASES | device_cracks.CASES | device_yielding.CASES


def model_and_plan() -> tuple[bd.Model, Plan]:
    lattice = bd.Lattice(bd.Particles([[0.0, 0, 0], [1, 0, 0]], [0.5, 0.5]), [[0, 1]])
    law = bd.EulerBernoulli(E=1e7, nu=0.2, radius_ratio=0.6)
    return bd.Model(lattice, law, 1000.0), Plan(duration=0.0)


def test_another_device_is_refused() -> None:
    with pytest.raises(InputError, match="choose 'cpu' or 'gpu'"):
        bd.solve_explicit(model_and_plan()[0], duration=1e-6, device="tpu")


def test_every_option_is_known_to_the_device() -> None:
    """A new field of Model or Plan must be carried out on a device or refused by `bondem.dynamics.gpu_loop`."""
    assert {f.name for f in dataclasses.fields(bd.Model)} == {
        "lattice", "bond", "density", "boundary", "contact", "walls", "failure", "mass_matrix",
    }  # fmt: skip
    assert {f.name for f in dataclasses.fields(Plan)} == {
        "duration", "dt", "scheme", "damping", "gauges", "every", "save_every", "snapshot_every", "until", "safety",
        "imbalance",
    }  # fmt: skip


def test_without_the_package_it_says_what_to_install(monkeypatch) -> None:
    for module in ("bondem.dynamics.gpu_loop", "bondem._cuda"):
        monkeypatch.delitem(sys.modules, module, raising=False)
    monkeypatch.delattr(bd, "_cuda", raising=False)
    monkeypatch.setitem(sys.modules, "cuda.core", None)
    with pytest.raises(InputError, match=r"pip install -e \"\.\[gpu\]\""):
        bd.solve_explicit(model_and_plan()[0], duration=1e-6, device="gpu")


def absent() -> str | None:
    """Why there is no device here, or None."""
    try:
        return importlib.import_module("bondem._cuda").lacks_gpu()
    except ImportError as error:
        return f"needs cuda-core ({error}): pip install -e '.[gpu]'"


def test_without_a_device_it_says_so() -> None:
    pytest.importorskip("cuda.core", reason="needs cuda-core: pip install -e '.[gpu]'")
    if absent() is None:
        pytest.skip("there is a CUDA device here")
    with pytest.raises(InputError, match="no CUDA device or driver was found"):
        bd.solve_explicit(model_and_plan()[0], duration=1e-6, device="gpu")


def cylinder(law: str, count: int = 5_000) -> bd.Model:
    """Held at one end, pulled and bent at the other, of beams or cells.

    The load is large, because positions are rounded: CPUs with and without fused multiply-adds differ by 2.3e-11 of
    the largest angular velocity after a thousand steps under it, under a pull of 1 kN by 3.6e-9 and 2.1e-8.
    """
    particles = bd.pack(bd.Cylinder(radius=5e-3, length=2e-2), count=count, spread=0.25, seed=1)
    lattice, bond = bd.connect(particles), bd.EulerBernoulli(E=265e9, nu=0.3, radius_ratio=0.71)
    if law == "cells":
        lattice, bond = bd.connect(particles, method="laguerre"), bd.CellBond(E=72e9, nu=0.17)
    return bd.Model(lattice, bond, 2500.0, boundary=[
        bd.Fix(bd.Face("x_min")), bd.Load(bd.Face("x_max"), force=(1e5, 1e5, 0), schedule=bd.Ramp(0.0, 1.0, 1e-6)),
    ])  # fmt: skip


@pytest.mark.gpu
@pytest.mark.parametrize("case", CASES)
def test_small_runs_on_a_device_agree_with_the_cpu(case: str) -> None:
    if (reason := absent()) is not None:
        pytest.skip(reason)
    loop_of = importlib.import_module("bondem.dynamics.gpu_loop").loop_on_gpu
    model, start, steps, dt, options = CASES[case]()
    plan = Plan(duration=steps * dt, dt=dt, **options)
    cpu, device = (integrate(model, plan, state=start(model), loop_of=loop) for loop in (None, loop_of))
    assert deviation(cpu, device) < 1e-10


@pytest.mark.gpu
@pytest.mark.parametrize("law", ["beams", "cells"])
def test_device_agrees_with_cpu_after_a_thousand_steps(monkeypatch, law: str) -> None:
    if (reason := absent()) is not None:
        pytest.skip(reason)
    loop_of = importlib.import_module("bondem.dynamics.gpu_loop").loop_on_gpu
    model = cylinder(law)
    dt = 0.9 * critical_step(model, bd.VelocityVerlet())
    plan = Plan(duration=1000 * dt, dt=dt, every=100, gauges={"end": bd.Gauge(bd.Face("x_max"), "displacement")})

    def result(loop):
        return integrate(model, plan, state=State(model), loop_of=loop)

    cpu, first, second = result(None), result(loop_of), result(loop_of)
    monkeypatch.setenv("BONDEM_CUDA_GRAPHS", "off")
    plain = result(loop_of)
    for name in ("displacement", "velocity", "angular_velocity"):
        expected, found = getattr(cpu.state, name), getattr(first.state, name)
        assert np.abs(found - expected).max() <= 1e-10 * np.abs(expected).max()
        np.testing.assert_array_equal(found, getattr(second.state, name))
        np.testing.assert_array_equal(found, getattr(plain.state, name))
    np.testing.assert_allclose(first.history["end"], cpu.history["end"], rtol=0.0,
                               atol=1e-10 * np.abs(cpu.history["end"]).max())  # fmt: skip
