"""The frame of every study of packings: rows stage by stage, then numbers, tables, figures and a page.

A study says what is to be made, what its rows mean and how to draw it; `run_packing_study` does the rest, and goes
on where it was when it is called again with the same folder.
"""

from abc import ABC, abstractmethod
from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path
from typing import Any, ClassVar

from bondem.report.packing_page import write_page
from bondem.study.packing_runs import complain, gather
from bondem.study.packing_tables import keep_results
from bondem.study.request import Request

Row = dict[str, Any]


class PackingStudy(ABC):
    """A study of packings.

    Attributes:
        name: of the command, of the template of its page, and in its results.
    """

    name: ClassVar[str]

    @property
    @abstractmethod
    def stages(self) -> tuple[tuple[str, Sequence[Request]], ...]:
        """Name and requests of each stage; later ones may need what earlier ones made."""

    @abstractmethod
    def results(self, rows: Sequence[Row]) -> dict[str, Any]:
        """What `results.json` says beside the rows of the last stage."""

    @abstractmethod
    def table(self, results: dict[str, Any]) -> str:
        """`table.md`."""

    @abstractmethod
    def draw(self, out: Path, rows: Sequence[Row], results: dict[str, Any]) -> None:
        """Figures, into the folder `figures` of `out`, from the rows without error; data files, into `out`."""


def run_packing_study(
    study: PackingStudy,
    out: str | Path,
    *,
    processes: int | None = None,
    progress: Callable[[str, float], None] | None = None,
) -> dict[str, Any]:
    """Make what is missing and leave `results.json`, tables, figures and `report.html` in a folder.

    Args:
        study: what to make.
        out: folder for the results, of an earlier run or new.
        processes: how many work at once; one a core unless given.
        progress: told the stage and the share of it that is done.

    Returns:
        What `results.json` holds.

    Raises:
        InputError: the folder cannot be written to.
        PackingError: a packing or a test of one failed; the results of all others are there.
        UnstableRunError: a run that packs became unstable; likewise.
    """
    out = Path(out)
    tell = progress or (lambda stage, share: None)
    failed: dict[Request, Row] = {}
    rows: list[Row] = []
    for stage, requests in study.stages:
        possible = [request for request in requests if request.needs not in failed]
        rows = gather(possible, out, processes=processes, progress=partial(tell, stage))
        failed |= {request: row for request, row in zip(possible, rows, strict=True) if row["error"]}
    good = [row for row in rows if not row["error"]]
    results = {"study": study.name, **study.results(rows), "failed": len(failed),
               "errors": [row["error"] for row in failed.values()], "rows": rows}  # fmt: skip
    results = keep_results(out, results, study.table(results))
    if good:
        tell("report", 0.0)
        study.draw(out, good, results)
        write_page(out, study.name, results)
    tell("report", 1.0)
    complain([*failed.values(), *good], out, what="packings" if len(study.stages) == 1 else "packings and tests")
    return results
