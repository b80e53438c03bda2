"""Summary of a run file, without reading all of it."""

import json
import os
from contextlib import suppress
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import numpy as np

from bondem._checks import place, require_file
from bondem._lock import claim
from bondem.dynamics.history import History
from bondem.errors import RunFileError
from bondem.io.digest import text_of
from bondem.io.hdf5 import damage
from bondem.io.journal import JournaledFile, journal_of
from bondem.io.run_identity import IDENTITY
from bondem.io.runfile import KIND, head_of, reading_run


@dataclass(frozen=True)
class RunContents:
    """Summary of a run file.

    Attributes:
        path: path of the file.
        size: size of the file [bytes].
        elements, bonds: numbers of elements and of bonds; facets of a body count as bonds.
        cells: True if the elements are cells.
        step, steps: number of steps at the last checkpoint, and of the whole run.
        time, duration: time at the last checkpoint and at the end of the run [s].
        dt: time step [s].
        seconds: wall time of the run until the last checkpoint [s].
        records: number of records of the history.
        snapshots: number of snapshots for ParaView.
        broken: number of broken bonds.
        imbalance: largest error of the energy balance over its largest term [-]; None if unknown.
        written: True if a process is writing the file.
        provenance: versions, machine and start time.
        schema: schema number of the file.
    """

    path: str
    size: int
    elements: int
    bonds: int
    cells: bool
    step: int
    steps: int
    time: float
    duration: float
    dt: float
    seconds: float
    records: int
    snapshots: int
    broken: int
    imbalance: float | None
    written: bool
    provenance: dict[str, str]
    schema: int

    @property
    def rate(self) -> float | None:
        """Steps per second of wall time; None if unknown."""
        return self.step / self.seconds if self.seconds > 0.0 and self.step else None

    @property
    def left(self) -> float | None:
        """Remaining wall time at the current rate [s]; None if unknown."""
        return None if self.rate is None else (self.steps - self.step) / self.rate

    def as_json(self) -> str:
        """Return the summary as JSON text."""
        return json.dumps(asdict(self) | {"rate": self.rate, "left": self.left}, indent=2)


def read_contents(path: str | Path) -> RunContents:
    """Read the summary of a run file, also while it is written.

    If a process was killed during a commit, the commit is completed first, so that VTK can read the file.

    Args:
        path: path of the file.

    Raises:
        RunFileError: no such file, not a run file, or damaged.
        InputError: `path` is neither text nor a path.
    """
    path = place("read_contents: path", path)
    require_file(path, "run file", RunFileError)
    written = _written(path)
    if not written and os.path.exists(journal_of(path)):
        with suppress(RunFileError):  # without permission to write, readers apply the journal in memory
            JournaledFile(path).close()
    with reading_run(path) as file:
        head = head_of(file, path)
        with damage(path, KIND):
            return _contents(path, file, head, written)


def _contents(path: Path, file: Any, head: Any, written: bool) -> RunContents:
    plan, group = json.loads(file["plan"][()]), file.get("state")
    gauges = json.loads(file["history"].attrs["gauges"]) if "history" in file else []
    history = History(np.asarray(file["history/records"][()]), tuple(gauges)) if "history" in file else None
    dt, duration = float(plan["dt"]), float(plan["duration"])
    stands = group.attrs if group is not None else {}
    steps = file.get("VTKHDF/elements/Steps")
    stored = json.loads(file["provenance"][()]) if "provenance" in file else {"bondem": str(head["bondem_version"])}
    missed = None if history is None or not len(history) else history.imbalance
    return RunContents(
        path=str(path), size=path.stat().st_size, elements=len(file["elements/radius"]),
        bonds=len(file["bonds/pairs"]), cells="cells" in file, step=int(stands.get("step", 0)),
        steps=round(duration / dt), time=float(stands.get("time", 0.0)), duration=duration, dt=dt,
        seconds=float(stands.get("seconds", 0.0)), records=0 if history is None else len(history),
        snapshots=0 if steps is None else int(steps.attrs["NSteps"]),
        broken=len(file["state/broken"]) if group is not None and "broken" in group else 0,
        imbalance=None if missed is None or not np.isfinite(missed) else missed, written=written,
        provenance={str(key): str(value) for key, value in stored.items()}, schema=int(head["schema"]),
    )  # fmt: skip


def _written(path: Path) -> bool:
    try:
        with open(path, "r+b") as file:
            return not claim(file.fileno())
    except OSError:  # without permission to write, no process here writes the file
        return not os.access(path, os.R_OK)


def identity_in(path: Path) -> str | None:
    """Return the identity stored in a run file (`identity_of`); None for other files and older run files."""
    try:
        with reading_run(path) as file:
            found = dict(file.attrs).get(IDENTITY)
    except RunFileError:
        return None
    return None if found is None else text_of(found)
