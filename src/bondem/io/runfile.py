"""The run file: output and restart in one HDF5 file.

    /                attributes format, schema, bondem_version, identity, digest; texts plan, model, provenance (JSON)
    /elements        position (n, 3) [m], radius (n,) [m], density [kg/m³]; period (3,) [m] of a periodic cell
    /bonds           pairs (m, 2)
    /facets, /cells  of a body of cells, see `bondem.io.bodies`
    /bodies          label (n,) of the bodies of a scene, their names and shapes (JSON)
    /state           the arrays of `State` in internal order; attributes step, time [s], stale, seconds, digest
    /history         records (s, 15 + 3 g) with g gauges; attribute gauges
    /VTKHDF          snapshots for ParaView, if the run stores any, see `bondem.io.snapshots`

Derived data (order, stiffnesses) are not stored but computed again by the same code. The file grows by commits of
`bondem.io.journal`: after a kill at any moment the previous checkpoint and snapshots are valid. Digests cover all
data for a restart: a file with a changed bit is rejected.
"""

import json
import os
import platform
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path
from types import TracebackType
from typing import Any, Self

import h5py
import numpy as np

from bondem import __version__
from bondem._checks import instance, place, require_file
from bondem._tables.columns import HistoryColumn
from bondem.damage.criteria.criterion import Criterion
from bondem.dynamics.history import History
from bondem.dynamics.plan import Plan
from bondem.errors import InputError, RunFileError
from bondem.io.atomic import require_writable
from bondem.io.bodies import complete_body, read_bonds, read_elements, write_bonds, write_elements
from bondem.io.codec import decode, encode
from bondem.io.digest import agree, arrays_of, digest_of, fixed, text_of
from bondem.io.exporting import refuse_suffix
from bondem.io.hdf5 import FORMAT as HDF5
from bondem.io.hdf5 import Kind, array_at, damage, reading, refuse_newer, write_head
from bondem.io.journal import JournaledFile, committed
from bondem.io.older_bodies import with_corrected_normals
from bondem.io.older_states import brought_up, shape_in
from bondem.io.run_identity import IDENTITY, text_of_model
from bondem.io.snapshots import Outlined, Snapshots
from bondem.model.model import Model
from bondem.model.state import State
from bondem.observables.breakage import BrokenBonds

FORMAT = "bondem run"
SCHEMA = 13
# Oldest schema that is read, first one with digests, first one with shares. New contents by schema: 2 contacts, walls
# and friction; 3 stresses, non-local work and cells; 4 failure criteria and events; 5 softening facets and yielding
# cells; 6 softening beams; 7 digests, snapshots and provenance; 8 grips that continue from an earlier stage, and
# cracks compared with the strength of their facet; 9 shares of facets; 10 steps of initiation, crushing, and the
# held slip of yielding cells; 11 rotating walls and rolling resistance; 12 a digest of bodies as well.
_OLDEST, _DIGESTED, _SHARED, _BODIES = 2, 7, 9, 12
# First schema that has an array of the state.
_SINCE = {
    "stress": 3, "broken": 4, "released": 4, "cracks": 5, "plastic": 5, "facet_force": 5, "softened": 6, "grips": 8,
    "crushed": 10, "held_slip": 10, "rolled": 11, "wall_rolled": 11,
}  # fmt: skip
KIND = Kind("a run file of bondem", "give a file of a run", "start the run again", RunFileError)
# First schema that has a column of the records.
_COLUMN_SINCE = {
    HistoryColumn.EXTRA_WORK: 3, HistoryColumn.RELEASED: 4, HistoryColumn.PLASTIC: 5, HistoryColumn.CRUSHING: 10,
}  # fmt: skip
# Parts of the file that do not change during a run.
_STATIC = ("plan", "model", "provenance", "elements", "bonds", "facets", "cells")
_CHUNK = 1 << 20


@dataclass(frozen=True, eq=False)
class Checkpoint:
    """Data of a run for a restart.

    Attributes:
        model: model of the run.
        plan: options of the run.
        state: state at the checkpoint.
        history: records so far.
        seconds: wall time so far [s].
        schema: schema number of the file.
    """

    model: Model
    plan: Plan
    state: State
    history: History
    seconds: float = 0.0
    schema: int = SCHEMA

    @property
    def events(self) -> BrokenBonds:
        """Broken bonds or facets in the order of breakage."""
        return BrokenBonds.of(self.state)


class RunFile:
    """Writer of the checkpoints and snapshots of a run to its file.

    Args:
        path: the file; an existing run file is replaced at the first checkpoint or snapshot.
        model: model of the run.
        plan: options of the run with the resolved time step, so that a restart does not compute it again.
        cracks: function of crack outlines for snapshots; None for snapshots without cracks.
        goes_on: checkpoint in the file at `path` from which the run is resumed, or None.
        identity: digest of the run from `bondem.io.run_identity`, for a new file.

    Raises:
        InputError: the file cannot be written, or exists and is no run file.
        RunFileError: the model contains an object that cannot be stored, or another process writes the file.
    """

    def __init__(
        self, path: str | Path, model: Model, plan: Plan, *, cracks: Callable[[State], Outlined] | None = None,
        goes_on: Checkpoint | None = None, identity: str = "",
    ) -> None:  # fmt: skip
        self.path = place("out", path)
        refuse_suffix("out", self.path)
        require_writable(self.path, "run file")
        self._model, self._plan, self._identity = model, plan, identity
        self._cracks = cracks if model.fails else None
        self._before = goes_on.seconds if goes_on is not None else 0.0
        self._start = time.perf_counter()
        self._texts = {
            "plan": json.dumps(encode(plan)),
            "model": text_of_model(model),
            "provenance": json.dumps({
                "bondem": __version__, "numpy": np.__version__, "h5py": h5py.__version__,
                "python": platform.python_version(), "machine": f"{platform.system()} {platform.machine()}",
                "started": datetime.now(UTC).isoformat(timespec="seconds"),
            }),
        }  # fmt: skip
        self._snapshots: Snapshots | None = None
        self._replaced: JournaledFile | None = None
        again = goes_on is not None and goes_on.schema >= _DIGESTED
        if not again and os.path.exists(self.path):
            _refuse_others(self.path)
            self._replaced = JournaledFile(self.path)  # locks the file that the first checkpoint replaces
        self._raw = JournaledFile(self.path, new=not again)
        self._file: h5py.File | None = None
        if again:
            assert goes_on is not None
            self._file = h5py.File(self._raw, "r+", libver=HDF5)
            if goes_on.schema < SCHEMA:  # its next checkpoint has the current schema
                self._file.attrs["schema"] = SCHEMA
                complete_body(self._file, model.lattice)
                self._file.attrs["digest"] = fixed(_digest_of_rest(self._file))
            if "VTKHDF" in self._file:
                self._snapshots = Snapshots.of(self._file, model, self._cracks)
                self._snapshots.cut(goes_on.state.time)

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()

    def close(self) -> None:
        """Release the file; uncommitted data are discarded."""
        if self._file is not None:
            self._raw.roll_back()
            self._file.close()
        self._file = None
        self._raw.close()
        if self._replaced is not None:
            self._replaced.close()

    def checkpoint(self, state: State, history: History) -> None:
        """Write all data for a restart from this state.

        Raises:
            RunFileError: the disk is full, or another failure to write; the previous checkpoint remains valid.
        """
        file = self._new_file()
        stored = file.require_group("state")
        for name in state.arrays:
            _put(stored, name, getattr(state, name))
        file.require_group("history")
        _put(file["history"], "records", history.records)
        _attributes(file["history"])["gauges"] = fixed(json.dumps(history.gauges))
        seconds = self._before + time.perf_counter() - self._start
        stored.attrs.update(step=state.step, time=state.time, stale=state.stale, seconds=seconds)
        stored.attrs["digest"] = fixed(_digest_of_state(state, history))
        self._commit()

    def snapshot(self, state: State) -> None:
        """Append and commit a snapshot of a state for ParaView; errors as for `checkpoint`."""
        file = self._new_file()
        if self._snapshots is None:
            self._snapshots = Snapshots.begin(file, self._model, self._cracks)
        self._snapshots.take(self._model, state)
        self._commit()

    def _commit(self) -> None:
        assert self._file is not None
        self._file.flush()
        self._raw.commit()
        if self._replaced is not None:
            self._replaced.close()
            self._replaced = None

    def _new_file(self) -> h5py.File:
        if self._file is not None:
            return self._file
        self._file = file = h5py.File(self._raw, "w", libver=HDF5)
        write_head(file, FORMAT, SCHEMA, self._texts)
        if self._identity:
            file.attrs[IDENTITY] = fixed(self._identity)
        write_elements(file, self._model.lattice.particles)
        file["elements/density"] = np.asarray(self._model.density, dtype=float)
        write_bonds(file, self._model.lattice)
        file.attrs["digest"] = fixed(_digest_of_rest(file))
        return file


def _put(group: Any, name: str, values: np.ndarray) -> None:
    """Write an array to a group. An array of the same name is resized and overwritten, or else replaced."""
    data = group.get(name)
    if data is None or data.shape[1:] != values.shape[1:] or data.maxshape[:1] != (None,):
        if data is not None:
            del group[name]
        if values[:1].nbytes == 0 and values.shape[1:].count(0):
            group[name] = values
            return
        row = max(values.dtype.itemsize * int(np.prod(values.shape[1:])), 1)
        chunk = (max(min(len(values), _CHUNK // row), 1), *values.shape[1:])
        data = group.create_dataset(
            name, shape=values.shape, maxshape=(None, *values.shape[1:]), chunks=chunk, dtype=values.dtype
        )
    if len(data) != len(values):
        data.resize(len(values), axis=0)
    if len(values):
        data[...] = values


def _digest_of_state(state: State, history: History, schema: int = SCHEMA) -> str:
    arrays = [(name, getattr(state, name)) for name in state.arrays if _SINCE.get(name, 0) <= schema]
    stands = json.dumps([state.step, state.time, bool(state.stale), list(history.gauges)])
    return digest_of([*arrays, ("records", history.records), ("stands", stands)])


def _digest_of_rest(file: h5py.File) -> str:
    schema = int(_attributes(file)["schema"])
    parts = (*_STATIC, "bodies") if schema >= _BODIES else _STATIC
    stored = {name: file[name] for name in parts if name in file}
    bodies = stored["bodies"].attrs if "bodies" in stored else {}
    head = json.dumps([text_of(file.attrs["format"]), schema, *(text_of(bodies[name]) for name in sorted(bodies))])
    return digest_of([*arrays_of(stored), ("head", head)])


def read_run(path: str | Path, *, failure: Criterion | None = None) -> Checkpoint:
    """Read the last checkpoint of a run file.

    Args:
        path: path of the file.
        failure: criterion of the run if it is a `bd.StressCriterion`, whose function cannot be stored; else None.

    Raises:
        RunFileError: The file does not exist, is no run file, is damaged, has a newer or too old format, or belongs
            to another criterion.
        InputError: `path` is no path, or `failure` is no criterion.
    """
    if failure is not None:
        instance("read_run", "failure", failure, Criterion, "the criterion of the run, or None")
    path = place("path", path)
    with reading_run(path) as file:
        head = head_of(file, path)
        refuse_newer(path, head["schema"], head["bondem_version"], SCHEMA, KIND)
        if head["schema"] < _OLDEST:
            raise RunFileError(f"'{path}' was written by an older bondem without contacts; start the run again")
        with damage(path, KIND, RunFileError):
            if head["schema"] >= _DIGESTED and not agree(_digest_of_rest(file), head["digest"]):
                raise ValueError("its digest does not match")
            return _checkpoint(file, int(head["schema"]), failure)


@contextmanager
def reading_run(path: Path) -> Iterator[h5py.File]:
    """Yield the last commit of a run file, open for reading, also while the file is written or after a kill.

    Raises:
        RunFileError: The file does not exist, is not HDF5, or is damaged.
    """
    require_file(path, "run file", RunFileError)
    with reading(path, KIND, committed(path)) as file:
        yield file


def head_of(file: h5py.File, path: Path) -> dict[str, Any]:
    """Read the attributes of a run file by name, such as schema and version of bondem.

    Raises:
        RunFileError: another kind of file, or a damaged one.
    """
    with damage(path, KIND):
        head = dict(_attributes(file))
        known = text_of(head.get("format")) == FORMAT
        if known:
            head["schema"], head["bondem_version"] = int(head["schema"]), text_of(head["bondem_version"])
    if not known:
        raise RunFileError(f"'{path}' is not {KIND.name}; {KIND.given}")
    return head


def _refuse_others(path: Path) -> None:
    """Raise InputError for a file that is neither a run file nor empty, so that no run replaces it."""
    try:
        if path.stat().st_size:
            with reading_run(path) as file:
                head_of(file, path)
    except RunFileError:
        raise InputError(
            f"out = '{path}': the file exists and is no run file, or a damaged one. Give another name, or delete it."
        ) from None


def ends_at(path: Path, state: State) -> bool:
    """Return True if there is a run file whose last checkpoint has the time and the pose of a state."""
    try:
        with reading_run(path) as file:
            same = float(_attributes(file["state"])["time"]) == state.time > 0.0
            return same and np.array_equal(array_at(file, "state/pose"), state.pose)
    except (RunFileError, KeyError):
        return False


def _attributes(item: Any) -> Any:
    return item.attrs


def _json(file: h5py.File, name: str) -> Any:
    return json.loads(array_at(file, name).item())


def _checkpoint(file: h5py.File, schema: int, failure: Criterion | None) -> Checkpoint:
    text = _json(file, "model")
    if failure is not None and encode(failure) != text.pop("failure", None):
        raise RunFileError(
            "failure= is not the criterion of the run; give the criterion with its parameters, or None"
        )
    made_of = {key: decode(value) for key, value in text.items()}
    density = array_at(file, "elements/density")
    lattice = read_bonds(file, read_elements(file, made_of["shape"]))
    if schema < _SHARED:
        lattice = with_corrected_normals(lattice, made_of["boundary"])
    model = Model(
        lattice, **{name: made_of[name] for name in ("bond", "boundary", "contact", "walls")},
        density=float(density) if density.ndim == 0 else density, failure=failure or made_of.get("failure"),
        mass_matrix=made_of.get("mass_matrix", "lumped"),
    )  # fmt: skip
    state = State(model)
    for name in state.arrays:
        if schema < _SINCE.get(name, 0):
            continue
        values = np.ascontiguousarray(array_at(file, f"state/{name}"))
        wanted = shape_in(schema, name, getattr(state, name).shape)
        if (name not in State.GROWING and values.shape != wanted) or values.shape[1:] != wanted[1:]:
            raise ValueError(f"state/{name} has shape {values.shape}")
        setattr(state, name, values)
    stored = _attributes(file["state"])
    state.step, state.time, state.stale = int(stored["step"]), float(stored["time"]), bool(stored["stale"])
    history = History(array_at(file, "history/records"), tuple(json.loads(_attributes(file["history"])["gauges"])))
    if schema >= _DIGESTED and not agree(_digest_of_state(state, history, schema), stored["digest"]):
        raise ValueError("the digest of its state does not match")
    records = history.records
    for column, since in _COLUMN_SINCE.items():
        if schema < since:
            records = np.insert(records, column, 0.0, axis=1)
    history = History(records, history.gauges)
    brought_up(model, state, schema)
    return Checkpoint(
        model, decode(_json(file, "plan")), state, history, float(stored.get("seconds", 0.0)), schema
    )
