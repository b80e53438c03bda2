"""The pipeline behind `bondem campaign`: hand out the specimens, gather their rows, tell which failed."""

import json
import time
from collections.abc import Callable, Iterable, Iterator, Mapping
from pathlib import Path
from typing import Any

import bondem
from bondem._checks import instance, place
from bondem.campaign.cluster import connected, submitted
from bondem.campaign.sweep import Campaign, CampaignSpecimen
from bondem.campaign.table import require_tables, write_tables
from bondem.campaign.work import SPECIMENS, carry_out, clear, finished
from bondem.io.atomic import write_text
from bondem.io.folder import only_writer

# The table is written again when so much time has passed and something has come [s].
_EVERY = 5.0

#: Told the share that is done, and a word on what is going on.
Told = Callable[[str, float], None]


def run_campaign(
    campaign: Campaign,
    out: str | Path,
    *,
    workers: int | None = None,
    address: str | None = None,
    progress: Told | None = None,
    dashboard: Callable[[str], None] | None = None,
) -> dict[str, Any]:
    """Carry out a campaign; what is finished in the folder is not done again.

    It leaves `specimens/NAME/` with what `bondem run` leaves of each, named when all is in it; `table.parquet` and
    `table.csv`, written again as specimens arrive; and `results.json`, with the specimens that failed, their input
    and the reason.

    Args:
        campaign: what to do.
        out: folder for the results, on a file system that all workers share.
        workers: processes of a local cluster; one a core unless given.
        address: of the scheduler of a cluster that is there.
        progress: told the share that is done.
        dashboard: told the address of the cluster's own page.

    Returns:
        What `results.json` holds: "finished", "failed" with a row each, "seconds".

    Raises:
        InputError: the folder cannot be written, another process writes to it, or no scheduler is at the address.
        MissingDependencyError: Dask or pandas is not installed.
    """
    instance("run_campaign", "campaign", campaign, Campaign, "what bd.read_campaign returns")
    folder = place("out", out)
    require_tables()
    with only_writer(folder, "output folder"):
        return _carry_out(campaign, folder, workers, address, progress or (lambda *_: None), dashboard)


def _carry_out(
    campaign: Campaign, out: Path, workers: int | None, address: str | None, tell: Told,
    dashboard: Callable[[str], None] | None,
) -> dict[str, Any]:  # fmt: skip
    begun = time.perf_counter()
    (out / SPECIMENS).mkdir(parents=True, exist_ok=True)
    clear(out)
    rows = {one.name: row for one in campaign.specimens if (row := finished(one, out)) is not None}
    before, missing = len(rows), [one for one in campaign.specimens if one.name not in rows]
    shown = time.perf_counter()
    if missing:
        slurm = None if address is not None or workers is not None else campaign.slurm
        with connected(workers=workers, address=address, slurm=slurm, shared=out) as client:
            if dashboard is not None and client.dashboard_link:
                dashboard(client.dashboard_link)
            for row in _arriving(client, missing, out.resolve()):
                rows[row["name"]] = row
                tell("specimens", len(rows) / len(campaign.specimens))
                if time.perf_counter() - shown > _EVERY:
                    write_tables(_good(campaign, rows), campaign.keys, out)
                    shown = time.perf_counter()
    tell("specimens", 1.0)
    clear(out)
    good = _good(campaign, rows)
    write_tables(good, campaign.keys, out)
    results = {
        "campaign": campaign.name, "varied": list(campaign.keys), "specimens": len(campaign.specimens),
        "finished": len(good), "before": before, "seconds": round(time.perf_counter() - begun, 3),
        "failed": [rows[one.name] for one in campaign.specimens if "error" in rows[one.name]],
        "version": bondem.__version__,
    }  # fmt: skip
    write_text(out / "results.json", json.dumps(results, indent=1, allow_nan=False, default=str) + "\n")
    return results


def _arriving(client: Any, missing: Iterable[CampaignSpecimen], out: Path) -> Iterator[dict[str, Any]]:
    """Rows as they come; a specimen over which worker after worker died has its row, too."""
    for job, one in submitted(client, carry_out, missing, out):
        if job.status == "finished":
            yield job.result()
        else:
            error = job.exception()
            reason = f"{type(error).__name__}: {' '.join(str(error).split())}"
            yield {"name": one.name, "varied": dict(one.varied), "error": reason}


def _good(campaign: Campaign, rows: Mapping[str, dict[str, Any]]) -> list[dict[str, Any]]:
    """Rows without an error, in the order of the campaign."""
    found = (rows.get(one.name) for one in campaign.specimens)
    return [row for row in found if row is not None and "error" not in row]
