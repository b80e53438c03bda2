"""Carry out a study: rows over several processes, each kept as soon as it is there, and only what is missing.

Processes are spawned, since OpenMP does not survive a fork, and work on one thread each unless told otherwise: many
packings at once use cores better than threads within one do.
"""

import multiprocessing
import os
import signal
import threading
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Future, ProcessPoolExecutor, as_completed
from concurrent.futures.process import BrokenProcessPool
from contextlib import suppress
from functools import partial
from multiprocessing.connection import wait
from pathlib import Path
from typing import Any

from bondem._threads import threads
from bondem.errors import BondemError, InputError
from bondem.io.atomic import require_folder
from validation.frame.failures import complain
from validation.frame.request import Request, kept_row, made_row
from validation.frame.sources import code_hash, commit
from validation.frame.study import Row, Study
from validation.frame.tables import keep_results


def run(
    study: Study,
    out: str | Path,
    *,
    processes: int | None = None,
    thread_count: int = 1,
    command: str = "",
    progress: Callable[[str, float], None] | None = None,
) -> dict[str, Any]:
    """Make what is missing and leave `results.json`, tables and figures in a folder.

    Args:
        study: what to make.
        out: folder for the results, of an earlier run or new.
        processes: how many work at once; one a core unless given.
        thread_count: threads of each.
        command: that the results are to name.
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
    stages, number = study.stages(out), 0
    with suppress(StopIteration):
        stage, requests = next(stages)
        while True:
            number += 1
            possible = [request for request in requests if request.needs not in failed]
            told = partial(tell, stage)
            rows = gather(possible, out, processes=processes, thread_count=thread_count, progress=told)
            failed |= {request: row for request, row in zip(possible, rows, strict=True) if row["error"]}
            stage, requests = stages.send(rows)
    good = [row for row in rows if not row["error"]]
    results = {"study": study.name, "command": command, "commit": commit(), "code": code_hash(type(study).__module__),
               **study.options, **study.results(out, rows), "failed": len(failed),
               "errors": [row["error"] for row in failed.values()], "rows": rows}  # fmt: skip
    results = keep_results(out, results)
    if good:
        tell("figures", 0.0)
        study.draw(out, good, results)
    tell("figures", 1.0)
    complain([*failed.values(), *good], out, what="packings" if number == 1 else "packings and tests")
    return results


def gather(
    requests: Sequence[Request],
    folder: Path,
    *,
    processes: int | None = None,
    thread_count: int = 1,
    progress: Callable[[float], None] | None = None,
) -> list[dict[str, Any]]:
    """The rows of all requests, in their order; those not in the folder yet are made now, largest first.

    Args:
        requests: what is asked for, of one kind.
        folder: where rows and packings are kept; made if it is not there.
        processes: how many work at once; one a core unless given.
        thread_count: threads of each; rows are the same to the bit.
        progress: told the share of the work that is done, 0 … 1.

    Returns:
        A row a request; one with an `error` where it failed.

    Raises:
        InputError: the folder cannot be written to, or fewer than one process.
    """
    if processes is not None and processes < 1:
        raise InputError(f"processes = {processes}; give at least 1")
    require_folder(folder, "output folder")
    for part in ("rows", "packings"):
        (folder / part).mkdir(parents=True, exist_ok=True)
    rows = {request: kept_row(request, folder) for request in requests}
    missing = sorted((request for request, row in rows.items() if row is None), key=lambda one: -one.weight)
    done, whole = 0.0, sum(request.weight for request in missing)
    workers = min(processes or os.cpu_count() or 1, max(len(missing), 1))
    for request, row in _made(missing, folder, workers, thread_count):
        rows[request] = row
        done += request.weight
        if progress is not None:
            progress(done / whole)
    return [row for request in requests if (row := rows[request]) is not None]


def _made(
    missing: Sequence[Request], folder: Path, processes: int, thread_count: int
) -> Iterator[tuple[Request, dict[str, Any]]]:
    """Each request and its row, as they come."""
    if not missing:
        return
    pool = ProcessPoolExecutor(processes, multiprocessing.get_context("spawn"), initializer=_settle)
    try:
        jobs: dict[Future[dict[str, Any]], Request] = {
            pool.submit(_on_threads, request, folder, thread_count): request for request in missing
        }
        for job in as_completed(jobs):
            yield jobs[job], _outcome(job, jobs[job])
    except BaseException:
        # Interrupted: what is being made now is lost, and waiting for it would be a surprise.
        for child in multiprocessing.active_children():
            child.terminate()
        pool.shutdown(wait=False, cancel_futures=True)
        raise
    pool.shutdown()


def _outcome(job: Any, request: Request) -> dict[str, Any]:
    # A death by signal or for want of memory is no property of the request: its row is not kept, so that the next
    # run tries again.
    try:
        return job.result()
    except BrokenProcessPool:
        reason = "a process was killed, perhaps for want of memory; run it again, with fewer --processes"
    except MemoryError:
        reason = "there is not enough memory; run it again, with fewer --processes"
    except BondemError as error:
        reason = str(error)
    return request.asked | {"error": reason, "unstable": False, "seconds": None}


def _on_threads(request: Request, folder: Path, count: int) -> dict[str, Any]:
    with threads(count):
        return made_row(request, folder)


def _settle() -> None:
    """What a process does before it works."""
    # Times are those of packing; rows and packings are kept by the study itself.
    os.environ["BONDEM_PACKING_CACHE"] = "off"
    # ^C reaches all processes of a terminal; the parent ends its children.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    parent = multiprocessing.parent_process()
    assert parent is not None

    def follow() -> None:
        wait([parent.sentinel])
        os._exit(1)

    # A parent killed outright would leave children waiting for work for ever.
    threading.Thread(target=follow, daemon=True).start()
