"""Run files of older schemas: two that older versions of bondem wrote, and a run that goes on from one.

The files of `tests/io/data` hold, in every array of the state that does not grow, 0, 1/64, 2/64 … in its order, and
three records whose column c is s + c/64.
"""

import gzip
import json
from pathlib import Path

import h5py
import numpy as np
import pytest

import bondem as bd
from bondem._tables.columns import HistoryColumn as Column
from bondem.dynamics.explicit import integrate
from bondem.errors import RunFileError
from bondem.io.codec import decode, encode
from bondem.io.digest import fixed
from bondem.io.older_bodies import with_corrected_normals
from bondem.io.runfile import SCHEMA, RunFile, _digest_of_rest, _digest_of_state
from tests.bits import EnoughError, assert_same_bits
from tests.models import cantilever, grains
from tests.specimens import crooked_cells, row

DATA = Path(__file__).parent / "data"
# What a schema did not have: arrays of the state, columns of the records.
_SOFT = ("cracks", "plastic", "held_slip", "facet_force", "softened", "grips")
MISSING = {
    2: (("stress", "broken", "released", *_SOFT), (Column.EXTRA_WORK, Column.RELEASED, Column.PLASTIC)),
    3: (("broken", "released", *_SOFT), (Column.RELEASED, Column.PLASTIC)),
}


def file_of(schema: int, tmp_path: Path) -> Path:
    place = tmp_path / f"schema_{schema}.h5"
    place.write_bytes(gzip.decompress((DATA / f"run_schema_{schema}.h5.gz").read_bytes()))
    return place


def cut_at(step: int) -> type[RunFile]:
    """A writer of run files that ends a run at a step."""
    class Cut(RunFile):
        def checkpoint(self, state, history):
            super().checkpoint(state, history)
            if state.step == step:
                raise EnoughError

    return Cut


@pytest.mark.parametrize("schema", MISSING)
def test_what_an_older_bondem_wrote_is_read(schema: int, tmp_path: Path) -> None:
    read = bd.read_run(file_of(schema, tmp_path))
    missing, columns = MISSING[schema]
    missing, columns = (*missing, "crushed"), (*columns, Column.CRUSHING)
    assert (read.state.step, read.state.time, read.state.stale) == (7, 7e-8, False)
    fresh = bd.State(read.model)
    for name in bd.State.ARRAYS:
        found = getattr(read.state, name)
        if name in missing or name in bd.State.GROWING:
            np.testing.assert_array_equal(found, getattr(fresh, name), err_msg=name)
        elif name == "walls":  # they did not turn
            np.testing.assert_array_equal(found[:, :14].ravel(), np.arange(14 * len(found)) / 64.0)
            np.testing.assert_array_equal(found[:, 14:], fresh.walls[:, 14:])
        else:
            np.testing.assert_array_equal(found.ravel(), np.arange(found.size) / 64.0, err_msg=name)
    # what was not measured then is 0, and what was is where it belongs
    assert read.history.gauges == ("end",)
    assert read.history.records.shape == (3, Column.COUNT + 3)
    then = [c for c in range(Column.COUNT + 3) if c not in columns]
    np.testing.assert_array_equal(read.history.records[:, columns], 0.0)
    np.testing.assert_array_equal(read.history.records[:, then], np.arange(3)[:, None] + np.arange(len(then)) / 64.0)
    assert read.model.failure is None
    assert read.plan.damping == bd.LocalDamping(0.05)


def test_the_models_of_older_files_come_back(tmp_path: Path) -> None:
    beams, body = (bd.read_run(file_of(schema, tmp_path)).model for schema in MISSING)
    assert beams.bond == bd.EulerBernoulli(E=70e9, nu=0.3, radius_ratio=0.5)
    assert beams.contact == bd.LinearContact(E=70e9, friction=0.3)
    assert len(beams.walls) == 1
    assert [type(one) for one in beams.boundary] == [bd.Fix, bd.Load, bd.Drive]
    assert beams.lattice.pairs.tolist() == [[0, 1], [1, 2], [2, 3]]
    assert body.bond == bd.NonLocal(E=40e9, nu=0.2)
    assert body.lattice.cells.volume.sum() == pytest.approx(16e-9, rel=1e-9)


def without_turns(path: Path) -> None:
    """Take the orientation and the turn of walls from a run file: schemas before 11 did not have them."""
    kept = bd.read_run(path)
    kept.state.walls = kept.state.walls[:, :14]
    with h5py.File(path, "a") as file:
        del file["state/walls"]
        file["state/walls"] = kept.state.walls
        file["state"].attrs["digest"] = fixed(_digest_of_state(kept.state, kept.history, 10))
        file.attrs["schema"] = 10
        file.attrs["digest"] = fixed(_digest_of_rest(file))


def without_additions_of_10(path: Path, schema: int) -> None:
    """Take the steps of onset, crushing and faces in contact from a run file: schemas before 10 did not have them."""
    kept = bd.read_run(path)
    without_turns(path)
    kept.state.walls = kept.state.walls[:, :14]
    history = bd.History(np.delete(kept.history.records, Column.CRUSHING, axis=1), kept.history.gauges)
    late = {"broken": 1, "cracks": 1, "softened": 1, "stretch": 3}
    for name, columns in late.items():
        setattr(kept.state, name, getattr(kept.state, name)[:, :-columns])
    assert not len(kept.state.cracks)
    kept.state.cracks = np.zeros((0, 13))
    with h5py.File(path, "a") as file:
        for name in late:
            del file[f"state/{name}"]
            file[f"state/{name}"] = getattr(kept.state, name)
        del file["state/crushed"], file["history/records"]
        file["history/records"] = history.records
        file["state"].attrs["digest"] = fixed(_digest_of_state(kept.state, history, schema))


def aged(path: Path, schema: int) -> None:
    """Make a run file of today one of an older schema: without what that one did not have."""
    without_additions_of_10(path, schema)
    arrays, columns = MISSING.get(schema, (("grips",), ()))
    with h5py.File(path, "a") as file:
        file.attrs["schema"] = schema
        for name in arrays:
            del file[f"state/{name}"]
        records = np.delete(file["history/records"][()], columns, axis=1)
        del file["history/records"]
        file["history/records"] = records
        model = json.loads(file["model"][()])
        del file["model"], model["failure"]
        file["model"] = json.dumps(model)


@pytest.mark.parametrize("schema", [*MISSING, 6])
def test_a_run_goes_on_from_an_older_file_to_the_bit(schema: int, tmp_path: Path) -> None:
    law = bd.EulerBernoulli(E=70e9, nu=0.3, radius_ratio=0.5)
    model = cantilever(row(5), law, 2500.0, ramp=1e-6, force=(0.0, -0.5, 0.1))
    options = {"every": 7, "save_every": 50, "gauges": {"end": bd.Gauge(bd.Index([4]), "displacement")}}
    dt = bd.solve_explicit(model, duration=0.0, **options).dt
    whole = bd.solve_explicit(model, duration=200 * dt, out=tmp_path / "whole.h5", **options)

    place, plan = tmp_path / "cut.h5", bd.read_run(tmp_path / "whole.h5").plan
    with pytest.raises(EnoughError), cut_at(100)(place, model, plan) as sink:
        integrate(model, plan, sink=sink)
    aged(place, schema)
    resumed = bd.resume(place)
    assert_same_bits(whole, resumed)
    np.testing.assert_array_equal(whole.history.records, resumed.history.records)
    with h5py.File(place) as file:  # what it leaves is of today
        assert file.attrs["schema"] == SCHEMA
        assert "state/broken" in file


def test_walls_of_a_file_of_schema_10_go_on_to_the_bit(tmp_path: Path) -> None:
    """They are at their orientation in the reference, and stay there."""
    walls = [bd.PlaneWall((0, 0, -1.0), (0, 0, 1), motion=bd.Driven(vz=1.0)),
             bd.SphereWall(0.5, (0, 0, 1.6), motion=bd.Free(3e3, velocity=(0.0, 0.0, -2.0)))]  # fmt: skip
    model = grains([[0, 0, 0]], law=bd.LinearContact(E=1e7, friction=0.3), walls=walls)
    options = {"every": 7, "save_every": 50, "gauges": {"v": bd.WallGauge(1, "velocity")}}
    dt = bd.solve_explicit(model, duration=0.0, **options).dt
    whole = bd.solve_explicit(model, duration=200 * dt, out=tmp_path / "whole.h5", **options)
    place, plan = tmp_path / "cut.h5", bd.read_run(tmp_path / "whole.h5").plan
    with pytest.raises(EnoughError), cut_at(100)(place, model, plan) as sink:
        integrate(model, plan, sink=sink)
    without_turns(place)
    assert bd.read_run(place).state.velocity.any()
    assert_same_bits(whole, bd.resume(place))


def test_a_body_without_shares_goes_on_with_those_it_began_with(tmp_path: Path) -> None:
    """Schema 8: shares A w M⁻¹n, along the normal alone at smooth platens; the resumed file stores them."""
    ends = [bd.Fix(bd.Face("x_min"), translation="x", rotation=""), bd.Drive(bd.Face("x_max"), vx=0.01)]
    body = with_corrected_normals(crooked_cells((4, 3, 3)), ends)
    model = bd.Model(body, bd.CellBond(E=1e9, nu=0.4), 2500.0, boundary=ends)
    options = {"every": 10, "save_every": 10}
    dt = bd.solve_explicit(model, duration=0.0, **options).dt
    whole = bd.solve_explicit(model, duration=40 * dt, out=tmp_path / "whole.h5", **options)
    place, plan = tmp_path / "old.h5", bd.read_run(tmp_path / "whole.h5").plan
    with pytest.raises(EnoughError), cut_at(20)(place, model, plan) as sink:
        integrate(model, plan, sink=sink)
    without_additions_of_10(place, 8)
    with h5py.File(place, "a") as file:
        file.attrs["schema"] = 8
        for name in ("facets/share_i", "facets/share_j", "cells/free/share", "cells/remainder"):
            del file[name]
        file.attrs["digest"] = fixed(_digest_of_rest(file))
    read = bd.read_run(place)
    np.testing.assert_allclose(read.model.lattice.facets.share_i, body.facets.share_i, rtol=1e-12, atol=1e-18)
    np.testing.assert_allclose(read.model.lattice.cells.free.share, body.cells.free.share, rtol=1e-12, atol=1e-18)
    resumed = bd.resume(place)
    np.testing.assert_allclose(resumed.state.displacement, whole.state.displacement, rtol=1e-9, atol=1e-15)
    with h5py.File(place) as file:
        assert file.attrs["schema"] == SCHEMA
        np.testing.assert_array_equal(file["facets/share_i"], read.model.lattice.facets.share_i)
    assert bd.read_run(place).state.step == 40


@pytest.mark.parametrize(("schema", "missing"), [(3, "state/stress"), (4, "state/broken"), (2, "state/loss")])
def test_an_array_that_its_schema_has_must_be_there(schema: int, missing: str, tmp_path: Path) -> None:
    place = file_of(3, tmp_path)
    with h5py.File(place, "a") as file:
        file.attrs["schema"] = schema
        if missing in file:
            del file[missing]
    with pytest.raises(RunFileError, match=r"is damaged .*; start the run again"):
        bd.read_run(place)


def test_a_file_before_contacts_is_refused_in_a_line(tmp_path: Path) -> None:
    place = file_of(2, tmp_path)
    with h5py.File(place, "a") as file:
        file.attrs["schema"] = 1
    with pytest.raises(RunFileError, match="older bondem without contacts; start the run") as refused:
        bd.read_run(place)
    assert str(place) in str(refused.value)
    assert "\n" not in str(refused.value)


def test_a_law_of_a_later_version_is_refused_by_name(tmp_path: Path) -> None:
    place = file_of(3, tmp_path)
    with h5py.File(place, "a") as file:
        model = json.loads(file["model"][()])
        model["bond"]["type"] = "LaterLaw"
        del file["model"]
        file["model"] = json.dumps(model)
    with pytest.raises(RunFileError, match="unknown type 'LaterLaw'; read the file with the bondem version"):
        bd.read_run(place)


def test_platens_of_older_files_are_not_damped():
    """Servo walls were not, so that their runs continue to the same bits."""
    kept = encode(bd.Servo(1e3, speed=1.0))
    assert decode(kept).damping == bd.Servo(1e3, speed=1.0).damping > 0.0
    del kept["damping"]
    assert decode(kept) == bd.Servo(1e3, speed=1.0, damping=0.0)
