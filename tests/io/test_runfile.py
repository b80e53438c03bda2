"""Run files: exact restart, whole files only, and refusal of what is not understood."""

import json
import os

import h5py
import numpy as np
import pytest

import bondem as bd
from bondem.dynamics.explicit import integrate
from bondem.errors import InputError, RunFileError
from bondem.io.codec import decode, encode
from bondem.io.runfile import RunFile
from tests.models import loaded_row, torn_row
from tests.specimens import grid


def cantilever(**law):
    """Twelve spheres in a row, held on the left, pulled down on the right by a ramp."""
    return loaded_row((0.0, -0.5, 0.1), ramp=1e-4, **law)


def block():
    """A loaded block of unequal spheres, jittered off a cubic lattice, with an oblique bond net."""
    random = np.random.default_rng(3)
    grid = np.stack(np.meshgrid(*[np.arange(8)] * 3, indexing="ij"), axis=-1).reshape(-1, 3)
    position = 1e-3 * (grid + 0.5) + 5e-5 * random.standard_normal(grid.shape)
    particles = bd.Particles(position, 0.45e-3 * random.uniform(0.85, 1.1, len(grid)))
    lattice = bd.connect(particles, reach=1.7)
    return bd.Model(
        lattice,
        bond=bd.Timoshenko(E=50e9, nu=0.2, radius_ratio=0.6),
        density=2000.0,
        boundary=[
            bd.Fix(bd.Face("x_min", depth=0.6)),
            bd.Load(bd.Face("x_max", depth=0.6), force=(80.0, 20.0, 0.0), moment=(0.01, 0.0, 0.0),
                    schedule=bd.Ramp(0.0, 1.0, 1e-5)),
            bd.Drive(bd.Index([350]), vy=0.05, rz=bd.Ramp(0.0, 1e-4, 1e-5)),
        ],
    )  # fmt: skip


class KilledError(Exception):
    pass


class Killed(RunFile):
    """What a kill between steps 300 and 400 leaves behind is the checkpoint of step 300."""

    def checkpoint(self, state, history):
        super().checkpoint(state, history)
        if state.step == 300:
            raise KilledError


SCHEMES = [bd.VelocityVerlet(), bd.TchamwaWielgosz(phi=1.1)]


@pytest.mark.parametrize("make", [cantilever, block, lambda: cantilever(formulation="incremental")])
@pytest.mark.parametrize("scheme", SCHEMES, ids=["verlet", "tchamwa"])
def test_resume_is_exact_to_the_bit(tmp_path, make, scheme):
    model = make()
    end = len(model.lattice.particles) - 1
    options = {
        "scheme": scheme,
        "damping": bd.LocalDamping(0.05),
        "gauges": {"end": bd.Gauge(bd.Index([end]), "displacement")},
        "every": 7,
        "save_every": 150,
    }
    dt = bd.solve_explicit(model, duration=0.0, **options).dt
    whole = bd.solve_explicit(model, duration=400 * dt, out=tmp_path / "whole.h5", **options)

    plan = bd.read_run(tmp_path / "whole.h5").plan
    with pytest.raises(KilledError), Killed(tmp_path / "killed.h5", model, plan) as sink:
        integrate(model, plan, sink=sink)
    assert bd.read_run(tmp_path / "killed.h5").state.step == 300

    resumed = bd.resume(tmp_path / "killed.h5")
    assert resumed.status is bd.Status.COMPLETED
    assert resumed.steps == whole.steps == 400
    assert resumed.dt == whole.dt
    for name in bd.State.ARRAYS:
        np.testing.assert_array_equal(getattr(resumed.state, name), getattr(whole.state, name), err_msg=name)
    assert resumed.state.time == whole.state.time
    np.testing.assert_array_equal(resumed.history.records, whole.history.records)
    assert np.abs(whole.history["end"][-1]).max() > 0.0
    # the file the resumed run leaves is again one to go on from
    np.testing.assert_array_equal(bd.read_run(tmp_path / "killed.h5").state.pose, whole.state.pose)


def test_a_run_file_has_the_failures_of_its_run(tmp_path):
    run = bd.solve_explicit(torn_row(), duration=2e-4, every=20, imbalance=None, out=tmp_path / "torn.h5")
    read = bd.read_run(tmp_path / "torn.h5").events
    assert len(run.events) > 0
    np.testing.assert_array_equal(read.bond, run.events.bond)
    np.testing.assert_array_equal(read.time, run.events.time)


def test_a_finished_run_resumes_to_itself(tmp_path):
    done = bd.solve_explicit(cantilever(), duration=1e-5, out=tmp_path / "run.h5")
    again = bd.resume(tmp_path / "run.h5")
    assert again.status is bd.Status.COMPLETED
    np.testing.assert_array_equal(again.state.pose, done.state.pose)


def test_a_complete_run_goes_on_in_another_file(tmp_path):
    first, second = tmp_path / "run.h5", tmp_path / "more.h5"
    model = cantilever()
    done = bd.solve_explicit(model, duration=1e-5, out=first, resume=True)
    with pytest.raises(InputError, match=r"holds this run with duration = 1e-05 s; .*state=bd.read_run"):
        bd.solve_explicit(model, duration=2e-5, out=first, resume=True)
    with pytest.raises(InputError, match="does not hold this run"):
        bd.solve_explicit(model, duration=2e-5, every=7, out=first, resume=True)
    before = bd.read_run(first)
    for state in (before.state, done.state):
        with pytest.raises(InputError, match="holds the run that led to state=, and would be lost"):
            bd.solve_explicit(before.model, state=state, duration=1e-5, out=first)
    more = bd.solve_explicit(before.model, state=before.state, duration=1e-5, out=second)
    assert more.state.time == pytest.approx(2e-5, rel=1e-2)
    assert bd.read_run(first).state.time == done.state.time
    bd.solve_explicit(model, duration=1e-5, out=first)  # the run itself may be repeated


def test_a_stopped_run_stays_stopped(tmp_path):
    model = cantilever()
    stop = bd.AtRest(speed=1e3, after=1e-6)
    done = bd.solve_explicit(model, duration=1e-4, every=10, until=(stop,), out=tmp_path / "run.h5")
    again = bd.resume(tmp_path / "run.h5")
    assert done.status is again.status is bd.Status.STOPPED
    assert again.steps == done.steps


def test_every_type_of_a_plan_and_a_model_comes_back(tmp_path):
    face = (bd.Face("x_max", depth=0.1) | bd.Within(bd.Ball(1e-3))) & bd.Everything() - bd.Index([3, 4])
    plan = bd.Plan(
        duration=1e-3, dt=1.1e-8, scheme=bd.TchamwaWielgosz(phi=1.05), damping=bd.LocalDamping(0.1),
        gauges={"face": bd.Gauge(face, "force", "sum")}, every=3, save_every=5,
        until=(bd.AtRest(speed=1e-9, after=1e-4),), safety=0.5,
    )  # fmt: skip
    values = [
        plan,
        bd.Drive(face, x=bd.Table((0.0, 1.0), (0.0, 2.0)), vz=bd.Ramp(0, 1, 2), ry=0.1, wz=3.0),
        bd.Fix(face, translation="xy", rotation=""),
        bd.Load(face, force=(1.0, 2.0, 3.0), moment=(0.1, 0.2, 0.3), schedule=bd.Constant(2.0)),
        {bd.Everything(): bd.ParallelBond(E=1e9, nu=0.2, radius=1e-4, kappa=2.0),
         (face, bd.Face("side")): bd.Obermayr(E=1e9, nu=0.2, radius_ratio=0.5, alpha_s=0.8)},
        (bd.Cylinder(1.0, 2.0), bd.Box((1, 2, 3)), bd.Cell((1, 2, 3)), None, True, 0.1, "text"),
        bd.ContactBond(E=1e9, nu=0.2, radius_ratio=0.5, radius_rule="pair_min", formulation="incremental"),
    ]  # fmt: skip
    for value in values:
        assert decode(json.loads(json.dumps(encode(value)))) == value


def test_periodic_lattice_and_density_by_element_come_back(tmp_path):
    lattice = grid((6, 6, 6), 1.0, periodic=True)
    model = bd.Model(lattice, bd.EulerBernoulli(E=1e6, nu=0.2, radius_ratio=0.5), density=np.linspace(1, 2, 216))
    sink = RunFile(tmp_path / "run.h5", model, bd.Plan(duration=1.0, dt=1e-3))
    sink.checkpoint(model.state(), bd.History.empty(()))
    back = bd.read_run(tmp_path / "run.h5").model
    np.testing.assert_array_equal(back.mass, model.mass)
    np.testing.assert_array_equal(back.lattice.branch, lattice.branch)
    assert back.lattice.particles.shape == bd.Cell((6.0, 6.0, 6.0))


def test_unknown_types_and_keys_are_refused():
    with pytest.raises(RunFileError, match="unknown type 'Warp'"):
        decode({"type": "Warp", "factor": 9})
    with pytest.raises(RunFileError, match="colour"):
        decode({"type": "Face", "name": "x_min", "colour": "red"})
    with pytest.raises(RunFileError, match=r"cannot be written|is a folder"):
        encode(object())


def test_a_failing_write_keeps_the_old_file(tmp_path, monkeypatch):
    model = cantilever()
    path = tmp_path / "run.h5"
    sink = RunFile(path, model, bd.Plan(duration=1.0, dt=1e-7))
    sink.checkpoint(model.state(), bd.History.empty(()))
    before = path.read_bytes()

    def full(*_args):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(os, "fsync", full)
    with pytest.raises(RunFileError, match="No space left"):
        sink.checkpoint(model.state(), bd.History.empty(()))
    assert path.read_bytes() == before
    assert list(tmp_path.iterdir()) == [path]


def test_what_is_not_a_run_file_is_refused(tmp_path):
    with pytest.raises(RunFileError, match="there is no run file"):
        bd.read_run(tmp_path / "none.h5")
    (tmp_path / "text.h5").write_text("hello")
    with pytest.raises(RunFileError, match="not a run file"):
        bd.read_run(tmp_path / "text.h5")
    with h5py.File(tmp_path / "other.h5", "w") as file:
        file["x"] = 1
    with pytest.raises(RunFileError, match="not a run file"):
        bd.read_run(tmp_path / "other.h5")


def test_newer_and_damaged_files_are_refused(tmp_path):
    model = cantilever()
    for name in ("newer", "damaged"):
        sink = RunFile(tmp_path / f"{name}.h5", model, bd.Plan(duration=1.0, dt=1e-7))
        sink.checkpoint(model.state(), bd.History.empty(()))
    with h5py.File(tmp_path / "newer.h5", "a") as file:
        file.attrs["schema"] = 999
        file.attrs["bondem_version"] = "99.0"
    with pytest.raises(RunFileError, match=r"written by bondem 99\.0"):
        bd.read_run(tmp_path / "newer.h5")
    with h5py.File(tmp_path / "damaged.h5", "a") as file:
        del file["state/pose"]
    with pytest.raises(RunFileError, match="damaged"):
        bd.read_run(tmp_path / "damaged.h5")


def test_the_place_is_checked_before_the_run(tmp_path):
    (tmp_path / "file").write_text("")
    for place in (tmp_path / "missing" / "run.h5", tmp_path / "file" / "run.h5", tmp_path):
        with pytest.raises(InputError, match=r"cannot be written|is a folder"):
            bd.solve_explicit(cantilever(), duration=1e-6, out=place)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["file"]


def test_nothing_is_written_without_out(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    bd.solve_explicit(cantilever(), duration=1e-6)
    assert not list(tmp_path.iterdir())


def test_vtkhdf_opens_in_vtk(tmp_path):
    pyvista = pytest.importorskip("pyvista")
    model = cantilever()
    run = bd.solve_explicit(model, duration=1e-5)
    bd.write_vtkhdf(tmp_path / "bar.vtkhdf", model.lattice, state=run.state, elements={"n": np.arange(12)})
    mesh = pyvista.read(tmp_path / "bar.vtkhdf")
    assert mesh.n_points == 12
    assert mesh.n_lines == 11
    np.testing.assert_allclose(mesh["displacement"], run.state.displacement)
    np.testing.assert_allclose(mesh.points, run.state.position)
    np.testing.assert_allclose(mesh.cell_data["integrity"], 1.0)
    with pytest.raises(InputError, match="field 'n' has 3 values"):
        bd.write_vtkhdf(tmp_path / "bad.vtkhdf", model.lattice, elements={"n": np.arange(3)})
