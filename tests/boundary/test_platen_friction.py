"""Platens with friction: what sticks, what slides, and how squat bodies are restrained between them."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import bondem as bd
from bondem.errors import InputError
from bondem.observables.cell_forces import CellForces
from tests.bits import EnoughError, assert_same_run
from tests.specimens import cells

E, NU = 30e9, 0.3
SPEED, RISE, DURATION = 0.05, 3e-5, 1.2e-4
ENDS = bd.Face("x_min"), bd.Face("x_max")
SQUAT = bd.Box((10e-3, 20e-3, 20e-3))


def pressed(friction: float | None, *, clamped: bool = False) -> bd.Model:
    """Squat block between platens; clamped ones hold it along all axes."""
    beside = {"vy": 0.0, "vz": 0.0} if clamped else {}
    drive = bd.Drive(ENDS[1], vx=bd.Ramp(0.0, -SPEED, RISE), friction=friction, **beside)
    fix = bd.Fix(ENDS[0], translation="xyz" if clamped else "x", rotation="", friction=friction)
    return bd.Model(cells(SQUAT, 150), bd.CellBond(E=E, nu=NU), 2500.0, [fix, drive])


def press(model: bd.Model, **options: Any) -> bd.ExplicitResult:
    gauges = {name: bd.Gauge(end, "force") for name, end in zip(("near", "far"), ENDS, strict=True)}
    return bd.solve_explicit(
        model, duration=DURATION, damping=bd.LocalDamping(0.3), every=20, gauges=gauges, **options
    )


def apparent_modulus(run: bd.ExplicitResult) -> float:
    """Mean stress of both platens over the strain of their approach, over E [-]."""
    force = 0.5 * (run.history["near"][-1, 0] - run.history["far"][-1, 0])
    strain = SPEED * (DURATION - 0.5 * RISE) / 10e-3
    return force / 4e-4 / strain / E


def test_platens_restrain_a_squat_block_between_smooth_and_clamped():
    """The free block has E; friction stiffens it with μ, up to the clamped one; its loss closes the energy."""
    smooth, clamped = (apparent_modulus(press(model)) for model in (pressed(None), pressed(None, clamped=True)))
    assert smooth == pytest.approx(1.0, abs=1e-3)
    runs = [press(pressed(mu)) for mu in (0.0, 0.05, 0.2, 10.0)]
    found = [apparent_modulus(run) for run in runs]
    assert found[0] == pytest.approx(smooth, abs=1e-3)
    assert found[-1] == pytest.approx(clamped, abs=1e-3)
    assert found == sorted(found)
    assert clamped > 1.08
    assert smooth + 0.1 * (clamped - smooth) < found[1] < found[2] < clamped
    lost = [run.history.energy["friction"][-1] / run.history.energy["work"][-1] for run in runs]
    assert lost[0] < 1e-12
    assert lost[-1] < 1e-12
    assert 0.005 < lost[1] < 0.05
    assert all(run.residual < 1e-6 for run in runs)


def test_shear_forces_stay_within_friction_times_pressure_at_all_times():
    mu, shares = 0.1, []
    model = pressed(mu)

    def look(state: bd.State, record: bd.History) -> None:
        force = CellForces.of(model, state).wall
        shear, pressure = np.linalg.norm(force[:, 1:], axis=1), np.abs(force[:, 0])
        shares.append(shear[pressure > 0.0] / pressure[pressure > 0.0])

    press(model, callback=look)
    largest = np.array([share.max(initial=0.0) for share in shares])
    assert largest.max() < mu * (1.0 + 1e-9)
    sliding = shares[-1] > mu * (1.0 - 1e-9)
    assert 0.2 < sliding.mean() < 1.0  # facets in the middle of a platen stick


def test_a_sliding_run_resumes_to_the_same_bits(tmp_path: Path):
    def stop(done: float) -> None:
        if done > 0.5:
            raise EnoughError

    model, place = pressed(0.05), tmp_path / "run.h5"
    whole = press(model)
    with pytest.raises(EnoughError):
        press(model, out=place, save_every=40, snapshot_every=40, progress=stop)
    assert 0 < bd.read_run(place).state.step < whole.steps
    assert_same_run(whole, bd.resume(place))


def test_platens_strengthen_squat_cylinders():
    """As rough platens do in the laboratory: a cylinder half as long as wide gains more than a fifth."""
    rock = bd.MohrCoulomb(
        tension=4e6, cohesion=14e6, friction_angle=0.61, fracture_energy=20.0, fracture_energy_shear=600.0
    )
    body = cells(bd.Cylinder(radius=10e-3, length=10e-3), 150)
    smooth, rough = (
        bd.labtests.uniaxial_compression(body, bd.CellBond(E=E, nu=0.2), rock, platen_friction=mu, traverses=30.0)
        for mu in (0.0, 0.3)
    )
    assert rough.peak > 1.2 * smooth.peak
    assert max(smooth.residual, rough.residual) < 1e-3


def test_friction_belongs_to_platens_of_cells():
    for wrong in ({"translation": "xy"}, {"translation": ""}, {"region": bd.Everything()}):
        with pytest.raises(InputError, match="friction is that of a platen"):
            bd.Fix(**({"region": ENDS[0], "translation": "x", "rotation": "", "friction": 0.3} | wrong))
    with pytest.raises(InputError, match=r"Drive: friction = -0\.1"):
        bd.Drive(ENDS[1], vx=1.0, friction=-0.1)
    platen = bd.Fix(ENDS[0], translation="x", rotation="", friction=0.1)
    law = bd.ParallelBond(E=1e9, nu=0.2, radius_ratio=0.5, kappa=1.0)
    with pytest.raises(InputError, match="press spheres by walls="):
        bd.Model(bd.connect(bd.Particles([(0.0, 0.0, 0.0), (1.0, 0.0, 0.0)], 0.5)), law, 1e3, [platen])
