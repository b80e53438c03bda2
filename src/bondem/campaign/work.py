"""Run of one specimen of a campaign, in a temporary folder that is renamed once the results are complete."""

import contextlib
import json
import os
import shutil
import socket
import time
import uuid
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from bondem._progress import quiet
from bondem._threads import threads
from bondem.campaign.sweep import CampaignSpecimen, flat
from bondem.errors import BondemError
from bondem.io.atomic import write_text
from bondem.study.pipeline import run_study
from bondem.study.programme_run import read_json
from bondem.study.study_file import parse_study

#: Folder of the specimens within that of a campaign, and file with the row of a finished specimen.
SPECIMENS, RECORD = "specimens", "specimen.json"
# Ending of the folder of an unfinished specimen, whose name starts with a dot and contains the worker.
_UNFINISHED = ".unfinished"


def carry_out(specimen: CampaignSpecimen, out: Path) -> dict[str, Any]:
    """Run one specimen on one thread, unless it is finished.

    Args:
        specimen: the specimen.
        out: folder of the campaign, on a file system that all workers share.

    Returns:
        Row of the specimen: "name", "varied" and "values"; "error" with the reason instead of values if it failed.
    """
    final = out / SPECIMENS / specimen.name
    row: dict[str, Any] = {"name": specimen.name, "varied": dict(specimen.varied)}
    known = finished(specimen, out)
    if known is not None:  # finished by a worker that the scheduler had lost
        return known
    own = final.parent / f".{specimen.name}.{socket.gethostname()}-{os.getpid()}-{uuid.uuid4().hex[:8]}{_UNFINISHED}"
    start = time.perf_counter()
    try:
        with threads(1), quiet():
            results = run_study(parse_study(specimen.document, folder=specimen.folder), own)
    except BondemError as error:
        shutil.rmtree(own, ignore_errors=True)
        return row | {"error": " ".join(str(error).split())}
    worker = f"{socket.gethostname()}:{os.getpid()}"
    row["values"] = {**scalars(results), "seconds": round(time.perf_counter() - start, 3)}
    write_text(own / RECORD, json.dumps(row | {"inputs": specimen.inputs, "worker": worker}, indent=1) + "\n")
    try:
        own.rename(final)
    except OSError:
        if finished(specimen, out) is None:
            raise
        shutil.rmtree(own, ignore_errors=True)  # another worker was faster
    return row


def finished(specimen: CampaignSpecimen, out: Path) -> dict[str, Any] | None:
    """Return the row of a specimen that is finished in `out` with equal study and code, or None."""
    record = read_json(out / SPECIMENS / specimen.name / RECORD)
    if record is None or record.get("inputs") != specimen.inputs:
        return None
    return {key: record[key] for key in ("name", "varied", "values")}


def clear(out: Path) -> None:
    """Remove the folders and locks of unfinished specimens that remain from workers that died."""
    for left in (out / SPECIMENS).glob(f".*{_UNFINISHED}*"):
        with contextlib.suppress(OSError):
            shutil.rmtree(left) if left.is_dir() else left.unlink()


def scalars(results: Mapping[str, Any]) -> dict[str, Any]:
    """Collect the numbers and texts of results by dotted names, without lists such as that of the packings."""
    return {name: value for name, value in flat(results) if not isinstance(value, list)}
