"""The run file: output and restart in one HDF5 file.

    /                attributes format, schema, bondem_version; texts plan and model (JSON)
    /elements        position (n, 3) [m], radius (n,) [m], period (3,) [m] where there is one, density
    /bonds           pairs (m, 2)
    /facets, /cells  of a body, see `bondem.io.bodies`
    /state           the arrays of `State` in the kernels' order; attributes step, time [s], stale
    /history         records (s, 14 + 3 g); attribute gauges

What is derived (order, stiffnesses) is not kept but made again, by the same code. The file is
written aside and moved into place, so that a kill leaves the checkpoint before.
"""

import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import h5py
import numpy as np

from bondem import __version__
from bondem._checks import instance, place
from bondem.errors import RunFileError
from bondem.io.atomic import replacing, require_writable
from bondem.io.bodies import read_bonds, write_bonds
from bondem.io.codec import decode, encode
from bondem.kernels.tables import FRACTURE, NON_LOCAL, PLASTIC
from bondem.laws.failure.criterion import Criterion
from bondem.model.model import Model
from bondem.model.state import State
from bondem.solve.history import History
from bondem.solve.plan import Plan
from bondem.specimen.particles import Particles, filled

FORMAT = "bondem run"
SCHEMA = 6
# From here on they hold contacts, walls and friction; from 3 on stresses, non-local work and bodies of cells; from 4
# on criteria of failure and what broke; from 5 on cracks that soften and cells that yield; from 6 on soft beams.
_OLDEST = 2
# Schema from which on an array of the state is there.
_SINCE = {"stress": 3, "broken": 4, "released": 4, "cracks": 5, "plastic": 5, "facet_force": 5, "softened": 6}


@dataclass(frozen=True, eq=False)
class Checkpoint:
    """All that is needed to go on.

    Attributes:
        model: what is run.
        plan: how.
        state: where it stands.
        history: the records so far.
    """

    model: Model
    plan: Plan
    state: State
    history: History


class RunFile:
    """Keeps the last checkpoint of a run in a file (a `Sink`).

    Args:
        path: the file; one that is there is replaced at the first checkpoint.
        model: what is run.
        plan: how, with its time step resolved, so that going on does not depend on finding it again.

    Raises:
        InputError: the file cannot be written.
        RunFileError: the model holds something that a run file cannot.
    """

    def __init__(self, path: str | Path, model: Model, plan: Plan) -> None:
        self.path = place("out", path)
        require_writable(self.path, "run file")
        self._model = model
        self._texts = {
            "plan": json.dumps(encode(plan)),
            "model": json.dumps({
                "bond": encode(model.bond),
                "boundary": encode(tuple(model.boundary)),
                "contact": encode(model.contact),
                "walls": encode(tuple(model.walls)),
                "failure": encode(model.failure),
                "shape": encode(model.lattice.particles.shape),
            }),
        }  # fmt: skip

    def checkpoint(self, state: State, history: History) -> None:
        """Write all that is needed to go on from here."""
        particles = self._model.lattice.particles
        with replacing(self.path) as aside, h5py.File(aside, "w") as file:
            file.attrs["format"] = FORMAT
            file.attrs["schema"] = SCHEMA
            file.attrs["bondem_version"] = __version__
            for name, text in self._texts.items():
                file.create_dataset(name, data=text)
            elements = file.create_group("elements")
            elements["position"] = particles.position
            elements["radius"] = particles.radius
            elements["density"] = np.asarray(self._model.density, dtype=float)
            if particles.period is not None:
                elements["period"] = particles.period
            write_bonds(file, self._model.lattice)
            kept = file.create_group("state")
            for name in State.ARRAYS:
                kept[name] = getattr(state, name)
            kept.attrs.update(step=state.step, time=state.time, stale=state.stale)
            file["history/records"] = history.records
            file["history"].attrs["gauges"] = json.dumps(history.gauges)


def read_run(path: str | Path, *, failure: Criterion | None = None) -> Checkpoint:
    """Read a run file.

    Args:
        path: of the file.
        failure: the criterion of the run, where that is a `bd.StressCriterion`: no file holds its function.

    Raises:
        RunFileError: no such file, not a run file, damaged, of a newer bondem, or of another criterion.
    """
    if failure is not None:
        instance("read_run", "failure", failure, Criterion, "the criterion of the run, or None")
    path = place("path", path)
    if not path.is_file():
        raise RunFileError(f"there is no run file '{path}'; check the path")
    try:
        file = h5py.File(path, "r")
    except OSError:
        raise RunFileError(f"'{path}' is not a run file of bondem; give the file a run wrote") from None
    with file:
        head = _attributes(file)
        if head.get("format") != FORMAT:
            raise RunFileError(f"'{path}' is not a run file of bondem; give the file a run wrote")
        if head["schema"] > SCHEMA:
            raise RunFileError(
                f"'{path}' was written by bondem {head['bondem_version']}, which is newer than this"
                f" {__version__}; update bondem to read it"
            )
        if head["schema"] < _OLDEST:
            raise RunFileError(
                f"'{path}' was written by an older bondem, before there were contacts; start the run again"
            )
        try:
            return _checkpoint(file, head["schema"], failure)
        except (KeyError, ValueError, OSError) as error:
            raise RunFileError(f"'{path}' is damaged ({error}); start the run again") from error


def _array(file: h5py.File, name: str) -> np.ndarray:
    item = file[name]
    assert isinstance(item, h5py.Dataset)
    return np.asarray(item[()])


def _attributes(item: Any) -> Any:
    return item.attrs


def _json(file: h5py.File, name: str) -> Any:
    return json.loads(_array(file, name).item())


def _checkpoint(file: h5py.File, schema: int, failure: Criterion | None) -> Checkpoint:
    text = _json(file, "model")
    if failure is not None and encode(failure) != text.pop("failure", None):
        raise RunFileError("failure= is not the criterion of the run; give that, with its parameters, or None")
    made_of = {key: decode(value) for key, value in text.items()}
    period = _array(file, "elements/period") if "elements/period" in file else None
    particles = filled(
        Particles(_array(file, "elements/position"), _array(file, "elements/radius"), period), made_of["shape"]
    )
    density = _array(file, "elements/density")
    model = Model(
        read_bonds(file, particles),
        bond=made_of["bond"],
        density=float(density) if density.ndim == 0 else density,
        boundary=made_of["boundary"],
        contact=made_of["contact"],
        walls=made_of["walls"],
        failure=failure or made_of.get("failure"),
    )
    state = State(model)
    for name in State.ARRAYS:
        if schema < _SINCE.get(name, 0):
            continue
        values = np.ascontiguousarray(_array(file, f"state/{name}"))
        wanted = getattr(state, name).shape
        if (name not in State.GROWING and values.shape != wanted) or values.shape[1:] != wanted[1:]:
            raise ValueError(f"state/{name} has shape {values.shape}")
        setattr(state, name, values)
    kept = _attributes(file["state"])
    state.step, state.time, state.stale = int(kept["step"]), float(kept["time"]), bool(kept["stale"])
    records = _array(file, "history/records")
    if schema < 3:
        records = np.insert(records, NON_LOCAL, 0.0, axis=1)
    if schema < 4:
        records = np.insert(records, FRACTURE, 0.0, axis=1)
    if schema < 5:
        records = np.insert(records, PLASTIC, 0.0, axis=1)
    history = History(records, tuple(json.loads(_attributes(file["history"])["gauges"])))
    return Checkpoint(model, decode(_json(file, "plan")), state, history)
