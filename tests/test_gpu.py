"""`device="gpu"`: what can be shown without a device, and, with one (pytest --gpu), that it agrees with the CPU."""

import dataclasses
import importlib
import json
import os
import re
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import bondem as bd
from bondem.errors import InputError
from bondem.model.state import State
from bondem.solve.explicit import integrate
from bondem.solve.plan import Plan
from bondem.solve.timestep import critical_step
from tests.device_runs import CASES, deviation

HERE = Path(__file__).parent
SIMULATOR = {"NUMBA_ENABLE_CUDASIM": "1", "NUMBA_DISABLE_JIT": "1"}


def only_slowly(case: str) -> Any:
    """A variant that scripts carry out where slow tests run."""
    return pytest.param(case, marks=pytest.mark.validate)


def run(script: str, *arguments: str, **environment: str) -> str:
    """What a script of this folder prints, in a process of its own."""
    done = subprocess.run(
        [sys.executable, HERE / script, *arguments], env=os.environ | environment, text=True, capture_output=True,
        timeout=300, check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr[-3000:]
    return done.stdout


@pytest.fixture(scope="module")
def compiled():
    """PTX of all kernels, and the bytes that each bond or element takes."""
    pytest.importorskip("numba_cuda", reason="needs numba-cuda: pip install -e '.[gpu]'")
    return json.loads(run("cuda_ptx.py"))


def test_memory_is_what_the_documents_say(compiled) -> None:
    """As in the modules `…_cuda` of `bondem.solve`, and decision 0010."""
    assert compiled["bytes"]["bonds"] == {"element": 212 + 4, "bond": 164}  # with body forces
    assert compiled["bytes"]["alike"] == {"element": 212, "bond": 124}
    assert compiled["bytes"]["breaking"] == {"element": 212 + 4 + 1, "bond": 164 + 128}
    assert compiled["bytes"]["cells"] == {"element": 212 + 8 + 24, "bond": 196, "held facet": 344}
    held = {"held facet": 344}
    assert compiled["bytes"]["breaking cells"] == {"element": 212 + 8 + 24 + 9, "bond": 196 + 129} | held
    yielding = {"element": 212 + 8 + 24 + 135 + 176, "bond": 196 + 667 + 24, "held facet": 344 + 24}
    assert compiled["bytes"]["yielding cells"] == yielding
    assert compiled["bytes"]["softening"] == {"element": 212 + 4 + 1, "bond": 164 + 128 + 108}
    assert compiled["bytes"]["cracking cells"] == {"element": 212 + 8 + 24 + 135, "bond": 196 + 667} | held


def test_all_kernels_compile_without_a_driver(compiled) -> None:
    ptx = compiled["ptx"]
    assert set(ptx) == {
        "bond_forces", "rotation_guard", "bond_sums",
        "swell", "stress_cells", "facet_loads", "turn_guard", "facet_sums",
        "judge_bonds", "move_or_wait", "break_bonds", "let_go", "released_sum",
        "mark_facets", "judge_facets", "hold_neighbours", "break_facets", "weigh_cells",
        "swell_again", "stress_again", "load_again",
        "stress_tensors", "heat_cells", "mark_cracks", "order_beginnings", "begin_cracks", "sum_moments",
        "begin_stresses", "end_stresses", "take_up_holds", "weigh_all_cracked", "link_cells", "measure_some",
        "relax_some", "wake_some", "wake_cells", "soften_some", "part_cracks", "calm_cracks", "change_cells",
        "load_cracks", "add_losses", "log_cracks", "crack_sums",
        "stretch_all", "stretch_holds", "yield_some", "follow_cells", "heat_sums",
        "cool_some", "mark_judged", "begin_judged",
        "soften_beams", "add_soft_losses", "log_soft", "press_some", "find_soft", "order_soft", "begin_soft",
        "soft_sums",
        "schedule_rows", "turn_moments", "pull_groups", "open_step", "move", "element_sums", "gauge_sums", "fold",
        "write_record",
    }  # fmt: skip
    for name, text in ptx.items():
        assert ".visible .entry" in text, name
        # numbers of single precision are stored for facets, never reckoned with
        singles = [line for line in text.splitlines() if ".f32" in line]
        stored = re.compile(r"\s*(ld\.global|cvt\.f64|\.reg )\.f32")
        assert all(map(stored.match, singles)), f"{name} leaves double precision"
        # the library's arc cosine begins Newton's steps with such a root
        exact = text.replace("rsqrt.approx.ftz.f64", "") if "trig_reduction" in text else text
        assert ".approx" not in exact, f"{name} divides or takes roots approximately"
        assert parameters(text) <= 4064, f"{name} takes more parameters than all drivers allow"
    for name in ("bond_forces", "swell", "facet_loads", "measure_some", "relax_some", "load_cracks", "yield_some",
                 "soften_beams"):  # fmt: skip
        assert "fma.rn.f64" in ptx[name]
        assert "call" not in ptx[name], f"{name}: scalar functions are not inlined"


def parameters(ptx: str) -> int:
    """Bytes that a launch is given."""
    head, size = ptx[ptx.index(".visible .entry") :], 0
    for bits in re.findall(r"\.param \.[a-z](\d+)", head[: head.index("{")]):
        each = int(bits) // 8
        size = -(-size // each) * each + each
    return size


def model_and_plan() -> tuple[bd.Model, Plan]:
    lattice = bd.Lattice(bd.Particles([[0.0, 0, 0], [1, 0, 0]], [0.5, 0.5]), [[0, 1]])
    law = bd.EulerBernoulli(E=1e7, nu=0.2, radius_ratio=0.6)
    return bd.Model(lattice, law, 1000.0), Plan(duration=0.0)


def test_another_device_is_refused() -> None:
    with pytest.raises(InputError, match="choose 'cpu' or 'gpu'"):
        bd.solve_explicit(model_and_plan()[0], duration=1e-6, device="tpu")


def test_every_option_is_known_to_the_device() -> None:
    """A new field of Model or Plan must be carried out on a device or refused by `bondem.solve.loop_on_gpu`."""
    assert {f.name for f in dataclasses.fields(bd.Model)} == {
        "lattice", "bond", "density", "boundary", "contact", "walls", "failure",
    }  # fmt: skip
    assert {f.name for f in dataclasses.fields(Plan)} == {
        "duration", "dt", "scheme", "damping", "gauges", "every", "save_every", "snapshot_every", "until", "safety",
        "imbalance",
    }  # fmt: skip


def test_without_the_package_it_says_what_to_install(monkeypatch) -> None:
    for module in ("bondem.solve.loop_on_gpu", "bondem._cuda"):
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
    loop_of = importlib.import_module("bondem.solve.loop_on_gpu").loop_on_gpu
    model, start, steps, dt, options = CASES[case]()
    plan = Plan(duration=steps * dt, dt=dt, **options)
    cpu, device = (integrate(model, plan, state=start(model), loop_of=loop) for loop in (None, loop_of))
    assert deviation(cpu, device) < 1e-10


@pytest.mark.gpu
@pytest.mark.parametrize("law", ["beams", "cells"])
def test_device_agrees_with_cpu_after_a_thousand_steps(monkeypatch, law: str) -> None:
    if (reason := absent()) is not None:
        pytest.skip(reason)
    loop_of = importlib.import_module("bondem.solve.loop_on_gpu").loop_on_gpu
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
