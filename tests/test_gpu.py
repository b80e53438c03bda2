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
from bondem.kernels.tables import FIXED_COLUMNS, TRANSLATION, WORK
from bondem.model.state import State
from bondem.solve.explicit import integrate
from bondem.solve.plan import Plan
from bondem.solve.timestep import critical_step
from tests.cuda_cases import CUBE_DT, CUBE_STEPS, NUS
from tests.recording import Record

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
def outcomes(tmp_path_factory):
    """The small runs on the CPU and in the simulator."""
    pytest.importorskip("numba_cuda", reason="needs numba-cuda: pip install -e '.[gpu]'")
    folder = tmp_path_factory.mktemp("cuda")
    bodies = str(folder / "bodies")
    run("cuda_cases.py", "cpu", str(folder / "cpu.npz"), bodies)
    run("cuda_cases.py", "gpu", str(folder / "gpu.npz"), bodies, **SIMULATOR)
    with np.load(folder / "cpu.npz") as cpu, np.load(folder / "gpu.npz") as gpu:
        return dict(cpu), dict(gpu)


BEAMS = "bar", "paused", "dissipative", "cell"
CELLS = "free cells", "held cells", "paused cells", "resumed cells", "pressed cells", "periodic cells"
FIELDS = "pose", "stress", "motion", "acceleration", "loss", "work", "reaction"


@pytest.mark.parametrize("case", BEAMS + CELLS)
def test_simulated_device_agrees_with_cpu_to_rounding(outcomes, case: str, record: Record) -> None:
    cpu, gpu = outcomes
    missed = []
    assert cpu[f"{case}/end"].tolist() == gpu[f"{case}/end"].tolist()
    for field in FIELDS:
        expected, found = cpu[f"{case}/{field}"], gpu[f"{case}/{field}"]
        scale = np.abs(expected).max(initial=0.0)
        if field == "work" and case in CELLS:  # that of walls is booked with the rows of their cells
            expected, found = expected.sum(), found.sum()
        np.testing.assert_allclose(found, expected, rtol=0.0, atol=1e-12 * scale, err_msg=field)
        missed.append(np.abs(found - expected).max(initial=0.0) / (scale or 1.0))
    records = cpu[f"{case}/records"]
    assert (len(records) > 2) is not case.startswith("paused")
    scale = np.abs(records).max(axis=0, initial=0.0)
    scale[1:11] = scale[1:11].max()  # energies come and go: their sum is what rounding is measured by
    apart = (gpu[f"{case}/records"] - records) / np.where(scale, scale, 1.0)
    np.testing.assert_allclose(apart, 0.0, rtol=0.0, atol=1e-12)
    missed.append(np.abs(apart).max(initial=0.0))
    if case in CELLS:
        record("simulated cells", *missed)
    else:
        record("simulated device", *missed)


def test_cells_do_all_that_a_device_knows(outcomes) -> None:
    """Walls, loads, tractions, damping and dilatation count in these runs, so that leaving one out would be seen."""
    cpu, _ = outcomes
    for case in CELLS:
        assert np.abs(cpu[f"{case}/stress"]).max() > 1e3
    for case in ("held cells", "pressed cells"):
        records, work = cpu[f"{case}/records"], cpu[f"{case}/work"]
        assert abs(records[-1, WORK]) > 0.1 * records[-1, TRANSLATION:WORK].sum()
        assert abs(work[-1]) > 0.01 * np.abs(work).max()  # of walls and tractions
        assert (np.abs(records[-1, FIXED_COLUMNS:]) > 0.0).all()
    assert cpu["held cells/loss"].any()
    for case in ("pressed cells", "bar"):
        rows, n = len(cpu[f"{case}/reaction"]), len(cpu[f"{case}/pose"])
        assert np.abs(cpu[f"{case}/work"][rows : rows + n]).max() > 1.0  # of body forces


@pytest.mark.parametrize("walls", [False, True], ids=["free", "between walls"])
@pytest.mark.parametrize("nu", NUS)
def test_two_cubes_move_as_one_oscillator(outcomes, nu: float, walls: bool) -> None:
    """Free: U = ½ 2G δ² + 2 · ½ λ' (δ/2)², λ' of five free facets; between walls, of four: U = ½ (4G + λ') u² each.

    With ω² from it and cos φ = 1 - ω² dt²/2, velocity Verlet gives u = v dt sin(n φ) / sin φ exactly.
    """
    E, rho, v = 1e7, 1000.0, 1.0
    G, lame = E / (2.0 * (1.0 + nu)), E * nu / ((1.0 + nu) * (1.0 - 2.0 * nu))
    # c = Σ A d / V over the free facets, each with A = 1 m² and d = ½ m
    relaxed = lame / (1.0 + (4 if walls else 5) * 0.5 * lame / (2.0 * G))
    square = (4.0 * G + relaxed if walls else 2.0 * (2.0 * G + 0.5 * relaxed)) / rho
    phi = np.arccos(1.0 - 0.5 * square * CUBE_DT**2)
    moved = v * CUBE_DT * np.sin(CUBE_STEPS * phi) / np.sin(phi)
    _, gpu = outcomes
    found = gpu[f"cubes {nu} {walls}/pose"][:, 0] - [0.5, 1.5]
    expected = [moved, moved] if walls else [-moved, moved]
    # of a displacement of 7 mm a position of 1 m keeps 14 digits
    np.testing.assert_allclose(found, expected, rtol=1e-12)


@pytest.mark.parametrize(
    ("whole", "parted"), [("bar", "paused"), ("held cells", "paused cells"), ("held cells", "resumed cells")]
)
def test_pausing_changes_no_bit_on_the_device(outcomes, whole: str, parted: str) -> None:
    _, gpu = outcomes
    for field in FIELDS:
        np.testing.assert_array_equal(gpu[f"{whole}/{field}"], gpu[f"{parted}/{field}"])


@pytest.mark.parametrize("case", ["wild", "wild cells"])
def test_a_wild_run_ends_as_on_the_cpu(outcomes, case: str) -> None:
    for outcome in outcomes:
        assert outcome[f"{case}/end"][0] == "UNSTABLE"
    cpu, gpu = outcomes
    assert cpu[f"{case}/end"][1] == gpu[f"{case}/end"][1]
    np.testing.assert_array_equal(cpu[f"{case}/pose"], gpu[f"{case}/pose"])  # the start is kept


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


def model_and_plan(**options) -> tuple[bd.Model, Plan]:
    lattice = bd.Lattice(bd.Particles([[0.0, 0, 0], [1, 0, 0]], [0.5, 0.5]), [[0, 1]])
    law = bd.EulerBernoulli(E=1e7, nu=0.2, radius_ratio=0.6, formulation=options.pop("formulation", "total"))
    return bd.Model(lattice, law, 1000.0, **options), Plan(duration=0.0)


def test_what_the_device_cannot_do_is_refused() -> None:
    pytest.importorskip("numba_cuda", reason="needs numba-cuda: pip install -e '.[gpu]'")
    heat = bd.Eigenstrain(1e-3, schedule=bd.Ramp(0.0, 1.0, 1e-3))
    open_end = bd.Absorbing(bd.Face("x_max"), density=1000.0, E=1e7, nu=0.2)
    for options, what in (
        ({"contact": bd.LinearContact(E=1e7)}, "contacts and walls"),
        ({"formulation": "incremental"}, "the incremental formulation"),
        ({"boundary": heat}, "strains that change"),
    ):
        with pytest.raises(InputError, match=rf"cannot run {what}.* yet; use device='cpu'"):
            bd.solve_explicit(model_and_plan(**options)[0], duration=1e-6, device="gpu")
    pair = bd.Particles([[0.4, 0.5, 0.5], [1.5, 0.5, 0.5]], 0.3, shape=bd.Box((2, 1, 1)))
    body = bd.connect(pair, method="laguerre")
    for bond, options, what in (
        (bd.CellBond(E=1e7, nu=0.2), {"boundary": open_end}, "absorbing faces"),
        (bd.CellBond(E=1e7, nu=0.2), {"boundary": heat}, "strains that change"),
        (
            bd.CellBond(E=1e7, nu=0.2), {"boundary": bd.Pressure(bd.Face("x_max"), 1.0, follows=True)},
            "pressures that follow",
        ),
        (bd.NonLocal(E=1e7, nu=0.2), {}, "the non-local law"),
    ):
        with pytest.raises(InputError, match=rf"cannot run {what}.* yet; use device='cpu'"):
            bd.solve_explicit(bd.Model(body, bond, 1000.0, **options), duration=1e-6, device="gpu")
    with pytest.raises(InputError, match="choose 'cpu' or 'gpu'"):
        bd.solve_explicit(model_and_plan()[0], duration=1e-6, device="tpu")


def test_every_option_is_known_to_the_device() -> None:
    """A new field of Model or Plan must be carried out on a device or refused by `bondem.solve.loop_cuda.check`."""
    assert {f.name for f in dataclasses.fields(bd.Model)} == {
        "lattice", "bond", "density", "boundary", "contact", "walls", "failure",
    }  # fmt: skip
    assert {f.name for f in dataclasses.fields(Plan)} == {
        "duration", "dt", "scheme", "damping", "gauges", "every", "save_every", "snapshot_every", "until", "safety",
        "imbalance",
    }  # fmt: skip


@pytest.mark.filterwarnings("ignore:Couldn't get spec for numba_cuda")  # Numba's redirector, where it is installed
def test_without_the_package_it_says_what_to_install(monkeypatch) -> None:
    monkeypatch.delitem(sys.modules, "bondem.solve.loop_cuda", raising=False)
    monkeypatch.delitem(sys.modules, "bondem._compile_cuda", raising=False)
    monkeypatch.setitem(sys.modules, "numba_cuda", None)
    with pytest.raises(InputError, match=r"pip install -e \"\.\[gpu\]\""):
        bd.solve_explicit(model_and_plan()[0], duration=1e-6, device="gpu")


def absent() -> str | None:
    """Why there is no device here, or None."""
    try:
        return importlib.import_module("bondem._compile_cuda").missing()
    except ImportError as error:
        return f"needs numba-cuda ({error}): pip install -e '.[gpu]'"


def test_without_a_device_it_says_so() -> None:
    pytest.importorskip("numba_cuda", reason="needs numba-cuda: pip install -e '.[gpu]'")
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
@pytest.mark.parametrize("law", ["beams", "cells"])
def test_device_agrees_with_cpu_after_a_thousand_steps(monkeypatch, law: str) -> None:
    if (reason := absent()) is not None:
        pytest.skip(reason)
    loop_of = importlib.import_module("bondem.solve.loop_cuda").GpuLoop
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
