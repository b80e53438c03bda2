"""Summary of a run file, without reading all of it."""

import json
import os
from contextlib import suppress
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import numpy as np

from bondem._checks import place
from bondem._lock import claim
from bondem.dynamics.history import History
from bondem.errors import RunFileError
from bondem.io.journal import JournaledFile, journal_of
from bondem.io.runfile import head_of, reading


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
        imbalance: largest error of the energy balance over its largest term [-]; None without records.
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
        """Summary as JSON text."""
        return json.dumps(asdict(self) | {"rate": self.rate, "left": self.left}, indent=2)


def read_contents(path: str | Path) -> RunContents:
    """Read the summary of a run file, also while it is written.

    If a process was killed during a commit, the commit is completed first, so that VTK can read the file.

    Args:
        path: path of the file.

    Raises:
        RunFileError: no such file, not a run file, or damaged.
    """
    path = place("read_contents: path", path)
    if not path.is_file():
        raise RunFileError(f"path = '{path}': there is no run file; check the path")
    written = _written(path)
    if not written and journal_of(path).exists():
        with suppress(RunFileError):  # where nobody may write, the journal is read beside the file
            JournaledFile(path).close()
    with reading(path) as file:
        head = head_of(file, path)
        try:
            return _contents(path, file, head, written)
        except Exception as error:  # damage shows in more ways than a list could hold
            told = " ".join(str(error).split())
            raise RunFileError(f"'{path}' is damaged ({told}); start the run again") from error


def _contents(path: Path, file: Any, head: Any, written: bool) -> RunContents:
    plan, kept = json.loads(file["plan"][()]), file.get("state")
    gauges = json.loads(file["history"].attrs["gauges"]) if "history" in file else []
    history = History(np.asarray(file["history/records"][()]), tuple(gauges)) if "history" in file else None
    dt, duration = float(plan["dt"]), float(plan["duration"])
    stands = kept.attrs if kept is not None else {}
    steps = file.get("VTKHDF/elements/Steps")
    told = json.loads(file["provenance"][()]) if "provenance" in file else {"bondem": str(head["bondem_version"])}
    missed = None if history is None or not len(history) else history.imbalance
    return RunContents(
        path=str(path), size=path.stat().st_size, elements=len(file["elements/radius"]),
        bonds=len(file["bonds/pairs"]), cells="cells" in file, step=int(stands.get("step", 0)),
        steps=round(duration / dt), time=float(stands.get("time", 0.0)), duration=duration, dt=dt,
        seconds=float(stands.get("seconds", 0.0)), records=0 if history is None else len(history),
        snapshots=0 if steps is None else int(steps.attrs["NSteps"]),
        broken=len(file["state/broken"]) if kept is not None and "broken" in kept else 0,
        imbalance=None if missed is None or not np.isfinite(missed) else missed, written=written,
        provenance={str(key): str(value) for key, value in told.items()}, schema=int(head["schema"]),
    )  # fmt: skip


def _written(path: Path) -> bool:
    try:
        with open(path, "r+b") as file:
            return not claim(file.fileno())
    except OSError:  # what nobody here may write, nobody here writes
        return not os.access(path, os.R_OK)
