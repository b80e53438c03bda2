"""Snapshots in a run file: what VTK's own reader finds in it while it grows, after a resume, and of every kind."""

import math
import os
import resource
import signal
import sys
import threading
from pathlib import Path

import h5py
import numpy as np
import pytest

import bondem as bd
from bondem.dynamics.explicit import integrate
from bondem.errors import RunFileError
from bondem.fracture.growing_cracks import GrowingCracks
from bondem.io.runfile import RunFile
from tests.bits import EnoughError, assert_same_bits
from tests.specimens import bar, spheres


def torn(lattice: bd.Lattice, law: bd.CellBond | bd.EulerBernoulli, tension: float = 2e6) -> bd.Model:
    """Pulled apart along x, fast, with contact between the pieces."""
    ends = [bd.Fix(bd.Face("x_min")), bd.Drive(bd.Face("x_max"), vx=1.0)]
    failure = bd.MohrCoulomb(tension=tension, cohesion=3.0 * tension, friction_angle=0.6)
    return bd.Model(
        lattice, law, density=2500.0, failure=failure, boundary=ends, contact=bd.LinearContact(E=30e9, friction=0.3)
    )


def cells() -> bd.Model:
    return torn(bar(120, 4e-3), bd.CellBond(E=30e9, nu=0.2))


def beams() -> bd.Model:
    return torn(spheres(bd.Box((4e-3, 2e-3, 2e-3)), 150), bd.EulerBernoulli(E=100e9, nu=0.2, radius_ratio=0.6))


def shown(path: Path, step: int) -> tuple[list[float], dict]:
    """Times of a file and the pieces of one step, by VTK's reader."""
    reader = pytest.importorskip("vtkmodules.vtkIOHDF").vtkHDFReader()
    pyvista = pytest.importorskip("pyvista")
    reader.SetFileName(str(path))
    reader.UpdateInformation()
    reader.SetStep(step)
    reader.Update()
    found = reader.GetOutputDataObject(0)
    key = reader.GetExecutive().TIME_STEPS()
    times = list(reader.GetOutputInformation(0).Get(key) or ())
    assembly = found.GetDataAssembly()
    pieces = {}
    for node in assembly.GetChildNodes(assembly.GetRootNode()):
        (index,) = assembly.GetDataSetIndices(node) or (None,)
        part = found.GetPartitionedDataSet(index)
        pieces[assembly.GetNodeName(node)] = pyvista.wrap(part.GetPartition(0))
    return times, pieces


@pytest.mark.parametrize("make", [cells, beams])
def test_vtk_reads_what_the_run_had(tmp_path: Path, make) -> None:
    model, states = make(), []
    dt = bd.solve_explicit(model, duration=0.0).dt

    def keep(state: bd.State, record: bd.History) -> None:
        states.append(state.copy())

    run = bd.solve_explicit(
        model, duration=600 * dt, every=200, snapshot_every=200, out=tmp_path / "run.h5", callback=keep
    )
    assert len(run.events) > 20
    states = [model.state(), *states[-3:]]
    for k, state in enumerate(states):
        times, found = shown(tmp_path / "run.h5", k)
        np.testing.assert_allclose(times, [one.time for one in states], rtol=1e-12, atol=1e-18)
        elements = found["elements"]
        single = {"rtol": 1e-6, "atol": 1e-6 * np.abs(state.displacement).max() + 1e-12}
        np.testing.assert_allclose(elements["displacement"], state.displacement, **single)
        np.testing.assert_allclose(elements.points, state.position, rtol=1e-6, atol=1e-9)
        np.testing.assert_allclose(elements["radius"], model.lattice.particles.radius, rtol=1e-6)
        np.testing.assert_allclose(elements["orientation"], state.orientation, atol=1e-6)
        gone = np.flatnonzero(state.bond_integrity < 1.0)
        assert sorted(set(found["cracks"]["facet"])) == gone.tolist()
        if not model.interaction.on_facets:
            bonds = found["bonds"]
            assert bonds.n_lines == len(model.lattice.pairs)
            np.testing.assert_allclose(bonds["integrity"], state.bond_integrity)
            length = np.linalg.norm(np.diff(state.position[model.lattice.pairs], axis=1)[:, 0], axis=1)
            force = state.bond_integrity * model.stiffness.kn * (length - model.lattice.length)
            rounding = 1e-14 * (model.stiffness.kn * length).max()
            np.testing.assert_allclose(
                bonds["normal_force"], force, rtol=1e-5, atol=1e-5 * np.abs(force).max() + rounding
            )
            found = bd.bond_forces(model, state)
            for name in ("shear", "bending", "twisting"):
                (shown_as,) = (key for key in bonds.cell_data if key.startswith(name))
                np.testing.assert_allclose(bonds[shown_as], getattr(found, name), rtol=1e-6)
        else:
            own = found["cells"]
            stress = bd.cell_stress(model, state)
            assert own.n_cells == len(model.lattice.particles)
            assert own.volume == pytest.approx(16e-9, rel=1e-5)
            np.testing.assert_array_equal(own["velocity"], elements["velocity"])
            with h5py.File(tmp_path / "run.h5") as file:  # stored once
                assert file["VTKHDF/cells/CellData/stress"] == file["VTKHDF/elements/PointData/stress"]
            np.testing.assert_allclose(
                own["stress"], stress[:, [0, 1, 2, 0, 1, 0], [0, 1, 2, 1, 2, 2]], rtol=1e-5,
                atol=1e-6 * np.abs(stress).max() + 1e-9,
            )  # fmt: skip


@pytest.mark.parametrize(("snapshot_every", "killed", "kept"), [
    (150, 450, 400), pytest.param(200, 400, 200, marks=pytest.mark.validate),
    pytest.param(200, 0, 0, marks=pytest.mark.validate),
])  # fmt: skip
def test_a_run_that_goes_on_has_the_same_snapshots(
    tmp_path: Path, snapshot_every: int, killed: int, kept: int
) -> None:
    """Killed after a snapshot that the last checkpoint does not know, also between both of one step."""
    model = cells()
    dt = bd.solve_explicit(model, duration=0.0).dt
    options = {"every": 50, "save_every": 200, "snapshot_every": snapshot_every}
    whole = bd.solve_explicit(model, duration=900 * dt, out=tmp_path / "whole.h5", **options)

    class Cut(RunFile):
        def snapshot(self, state: bd.State) -> None:
            super().snapshot(state)
            if state.step == killed:
                raise EnoughError

    place, plan = tmp_path / "cut.h5", bd.read_run(tmp_path / "whole.h5").plan
    with pytest.raises(EnoughError), Cut(place, model, plan, cracks=GrowingCracks(model.lattice)) as sink:
        integrate(model, plan, sink=sink)
    assert bd.read_run(place).state.step == kept
    assert_same_bits(whole, bd.resume(place))
    with h5py.File(tmp_path / "whole.h5") as one, h5py.File(place) as other:
        names = []
        one["VTKHDF"].visit(names.append)
        for name in names:
            if isinstance(one["VTKHDF"][name], h5py.Dataset):
                np.testing.assert_array_equal(one["VTKHDF"][name], other["VTKHDF"][name], err_msg=name)
        assert one["VTKHDF/elements/Steps"].attrs["NSteps"] == 1 + math.ceil(900 / snapshot_every)


def test_a_full_disk_leaves_the_checkpoint_before(tmp_path: Path, monkeypatch) -> None:
    monkeypatch.setattr(sys, "dont_write_bytecode", True)  # Python would keep cut bytecode of what is imported
    model = cells()
    dt = bd.solve_explicit(model, duration=0.0).dt
    place = tmp_path / "run.h5"
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    with RunFile(place, model, read_plan(model, dt, tmp_path)) as sink:
        sink.checkpoint(model.state(), bd.History.empty(()))
        before = place.read_bytes()
        resource.setrlimit(resource.RLIMIT_FSIZE, (len(before) + 4096, hard))
        try:
            with pytest.raises(RunFileError, match="could not be written"):
                sink.snapshot(model.state())
        finally:
            resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))
    assert place.read_bytes() == before
    assert bd.read_run(place).state.step == 0
    assert [path.name for path in tmp_path.iterdir() if path.name.startswith(".")] == []


def read_plan(model: bd.Model, dt: float, folder: Path):
    bd.solve_explicit(model, duration=10 * dt, out=folder / "plan.h5")
    return bd.read_run(folder / "plan.h5").plan


def test_only_one_may_write_a_file(tmp_path: Path) -> None:
    model = cells()
    dt = bd.solve_explicit(model, duration=0.0).dt
    plan, place = read_plan(model, dt, tmp_path), tmp_path / "run.h5"
    with RunFile(place, model, plan) as sink:
        with pytest.raises(RunFileError, match="written by another process"):
            RunFile(place, model, plan)
        sink.checkpoint(model.state(), bd.History.empty(()))
        before = place.read_bytes()
        for attempt in (lambda: RunFile(place, model, plan), lambda: bd.resume(place)):
            with pytest.raises(RunFileError, match="written by another process"):
                attempt()
        assert place.read_bytes() == before
        assert bd.read_run(place).state.step == 0
    RunFile(place, model, plan).close()


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_a_signal_stops_a_run_after_a_checkpoint(tmp_path: Path, number: signal.Signals) -> None:
    model = cells()
    dt = bd.solve_explicit(model, duration=0.0).dt
    before = signal.getsignal(number)
    whole = bd.solve_explicit(model, duration=3000 * dt, every=500)
    sent = []

    def send(share: float) -> None:
        if share > 0.3 and not sent:
            sent.append(share)
            os.kill(os.getpid(), number)

    with pytest.raises(KeyboardInterrupt if number == signal.SIGINT else SystemExit) as stopped:
        bd.solve_explicit(
            model, duration=3000 * dt, every=500, out=tmp_path / "run.h5", progress=send, save_every=1000
        )
    assert signal.getsignal(number) is before
    assert "bd.resume" in str(stopped.value) or stopped.value.code == 143
    kept = bd.read_run(tmp_path / "run.h5").state.step
    assert 0 < kept < 3000
    assert_same_bits(whole, bd.resume(tmp_path / "run.h5"))


def test_a_run_in_a_thread_takes_no_signals(tmp_path: Path) -> None:
    model, found = cells(), []
    dt = bd.solve_explicit(model, duration=0.0).dt
    work = threading.Thread(
        target=lambda: found.append(bd.solve_explicit(model, duration=20 * dt, out=tmp_path / "run.h5"))
    )
    work.start()
    work.join()
    assert found[0].steps == 20


@pytest.mark.parametrize("changed", ["label", "names"])
def test_bodies_of_a_scene_are_in_the_digest(tmp_path: Path, changed: str) -> None:
    one = bd.connect(bd.pack(bd.Box((2e-3,) * 3), count=30, method="even", seed=1), method="laguerre")
    scene = bd.join(one, one.moved((0.0, 0.0, 2.1e-3)), names=("lower", "upper"))
    place, contact = tmp_path / "run.h5", bd.LinearContact(E=70e9)
    model = bd.Model(scene, bd.CellBond(E=70e9, nu=0.2), 2500.0, contact=contact)
    bd.solve_explicit(model, duration=1e-7, out=place)
    assert bd.read_run(place).model.lattice.names == ("lower", "upper")
    with h5py.File(place, "a") as file:
        if changed == "label":
            file["bodies/label"][0] = 1
        else:
            file["bodies"].attrs["names"] = '["lower", "uppar"]'
    with pytest.raises(RunFileError, match="damaged"):
        bd.read_run(place)


def test_a_flipped_bit_is_never_taken_for_the_run(tmp_path: Path) -> None:
    """Whatever bit of the file is flipped: it is refused, or reads the same."""
    model = cells()
    dt = bd.solve_explicit(model, duration=0.0).dt
    place, harmed = tmp_path / "run.h5", tmp_path / "harmed.h5"
    bd.solve_explicit(model, duration=400 * dt, every=100, snapshot_every=200, out=place)
    whole, data = bd.read_run(place), place.read_bytes()
    random, refused = np.random.default_rng(1), 0
    used = np.flatnonzero(np.frombuffer(data, dtype=np.uint8))  # chunks are padded with zeros
    for _ in range(60):
        bit = 8 * int(random.choice(used)) + int(random.integers(8))
        changed = bytearray(data)
        changed[bit // 8] ^= 1 << bit % 8
        harmed.write_bytes(changed)
        try:
            found = bd.read_run(harmed)
        except RunFileError:
            refused += 1
            continue
        for name in bd.State.ARRAYS:
            np.testing.assert_array_equal(getattr(found.state, name), getattr(whole.state, name), err_msg=name)
        np.testing.assert_array_equal(found.history.records, whole.history.records)
        np.testing.assert_array_equal(found.model.mass, whole.model.mass)
    assert refused > 10
