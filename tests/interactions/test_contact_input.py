"""What contacts and walls refuse, and how."""

from pathlib import Path

import h5py
import numpy as np
import pytest

import bondem as bd
from bondem.errors import InputError, RunFileError
from tests.models import grains, moving


@pytest.mark.parametrize(
    ("make", "words"),
    [
        (lambda: bd.LinearContact(E=0.0), "E = 0.0"),
        (lambda: bd.LinearContact(E=1.0, friction=-0.1), "friction"),
        (lambda: bd.LinearContact(E=1.0, damping=1.0), "damping"),
        (lambda: bd.LinearContact(E=1.0, kappa=0.0), "kappa"),
        (lambda: bd.HertzMindlin(E=0.0, nu=0.2), "E = 0.0"),
        (lambda: bd.HertzMindlin(E=1.0, nu=0.5), "nu = 0.5"),
        (lambda: bd.HertzMindlin(E=1.0, nu=0.2, restitution=0.0), "restitution = 0.0"),
        (lambda: bd.HertzMindlin(E=1.0, nu=0.2, restitution=1.1), "restitution = 1.1"),
        (lambda: bd.HertzMindlin(E=1.0, nu=0.2, overlap=1.0), "overlap = 1.0"),
        (lambda: bd.HertzMindlin(E=1.0, nu=0.2, friction=-0.1), "friction"),
        (lambda: bd.PlaneWall((0, 0, 0), (0, 0, 0)), "normal"),
        (lambda: bd.PlaneWall((0, 0), (0, 0, 1)), "point"),
        (lambda: bd.PlaneWall((0, 0, 0), (0, 0, 1), motion=bd.Driven(growth=1.0)), "radius"),
        (lambda: bd.PlaneWall((0, 0, 0), (0, 0, 1), outer=1.0, inner=1.0), "outer"),
        (lambda: bd.PlaneWall((0, 0, 0), (0, 0, 1), inner=-1.0), "inner"),
        (lambda: bd.CylinderWall(-1.0), "radius"),
        (lambda: bd.CylinderWall(1.0, friction=-1.0), "friction"),
        (lambda: bd.Servo(-1.0, speed=1.0), "force"),
        (lambda: bd.Servo(1.0, speed=0.0), "speed"),
        (lambda: bd.Servo(1.0, speed=1.0, mass=0.0), "mass"),
        (lambda: bd.Driven(), "name"),
        (lambda: bd.Driven(u=1.0), "'u'"),
        (lambda: bd.Driven(x=1.0, vx=1.0), "once"),
        (lambda: bd.WallGauge(0, "speed"), "'speed'"),
        (lambda: grains([[0, 0, 0]], law=None, walls=[bd.PlaneWall((0, 0, -1), (0, 0, 1))]), "contact="),
        (lambda: grains([[0, 0, 0]], law=bd.LinearContact(E=1.0), walls=[3]), "walls = 3; give bd.PlaneWall"),
        (lambda: grains([[0, 0, 0]], law=3), "contact = "),
        (lambda: bd.Model(bd.Lattice(bd.Particles(2.0 * np.eye(3), 1.0), [[0, 1], [1, 2]]), None, 1.0), "bond = "),
    ],
)
def test_bad_input_is_refused(make, words: str) -> None:
    with pytest.raises(InputError, match=words):
        make()


def test_walls_and_gauges_that_do_not_fit() -> None:
    model = grains([[0, 0, 2.0]], law=bd.LinearContact(E=1e7), walls=[bd.PlaneWall((0, 0, 0), (0, 0, 1))])
    with pytest.raises(InputError, match="wall = 1 does not exist"):
        bd.solve_explicit(model, duration=1e-3, gauges={"wall": bd.WallGauge(1, "force")})
    with pytest.raises(InputError, match="walls"):
        bd.solve_static(model)


def test_a_state_of_numbers_that_are_none_is_refused() -> None:
    model = grains([[0, 0, 0], [3, 0, 0]], law=bd.LinearContact(E=1e7))
    state = moving(model, [[0, 0, 0], [1.0, 0, 0]])
    state.motion[0, 0] = np.nan
    with pytest.raises(InputError, match="motion has values that are not finite"):
        bd.solve_explicit(model, duration=1.0, dt=1e-3, every=10, state=state)


def test_run_files_of_before_contacts_are_refused(tmp_path: Path) -> None:
    model = grains([[0, 0, 0]], law=bd.LinearContact(E=1e7))
    bd.solve_explicit(model, duration=1e-3, dt=1e-4, out=tmp_path / "run.h5")
    with h5py.File(tmp_path / "run.h5", "a") as file:
        file.attrs["schema"] = 1
    with pytest.raises(RunFileError, match="older"):
        bd.read_run(tmp_path / "run.h5")
