"""Pipeline of `bondem campaign`: distribute the specimens, collect their rows and report failures."""

import json
import time
from collections.abc import Callable, Iterable, Iterator, Mapping
from pathlib import Path
from typing import Any

import bondem
from bondem._checks import instance, place
from bondem._progress import reported
from bondem.campaign.cluster import connected, submitted
from bondem.campaign.sweep import Campaign, CampaignSpecimen
from bondem.campaign.table import require_tables, write_tables
from bondem.campaign.work import SPECIMENS, carry_out, clear, finished
from bondem.io.atomic import make_folder, write_text
from bondem.io.folder import only_writer

# Least time between two updates of the table [s].
_EVERY = 5.0

#: Function of the name of a stage and its completed share.
Report = Callable[[str, float], None]


def run_campaign(
    campaign: Campaign, out: str | Path, *, workers: int | None = None, address: str | None = None,
    progress: Report | None = None, dashboard: Callable[[str], None] | None = None,
) -> dict[str, Any]:  # fmt: skip
    """Run a campaign; specimens already finished in the folder are not run again.

    Each specimen has a folder `specimens/NAME/` with the results of `bondem run`, as soon as they are complete.
    `table.parquet` and `table.csv` are updated as specimens finish. `results.json` lists the failed specimens with
    their input and the reason.

    Args:
        campaign: the campaign.
        out: folder for the results, on a file system that all workers share.
        workers: number of processes of a local cluster; None for the SLURM jobs of the campaign, else one per core.
        address: scheduler address of an existing cluster.
        progress: callback, called with the name of the stage and its completed share [-].
        dashboard: callback, called with the address of the cluster's status page.

    Returns:
        Contents of `results.json`, such as the number "finished", the rows of "failed" specimens, and "seconds".

    Raises:
        InputError: the folder cannot be written, another process writes to it, or no scheduler is at the address.
        MissingDependencyError: Dask, pandas or pyarrow is not installed.
    """
    instance("run_campaign", "campaign", campaign, Campaign, "a campaign from bd.read_campaign")
    folder = place("out", out)
    require_tables()
    with only_writer(folder, "output folder"), reported(progress) as report:
        return _carry_out(campaign, folder, workers, address, report, dashboard)


def _carry_out(
    campaign: Campaign, out: Path, workers: int | None, address: str | None, report: Report,
    dashboard: Callable[[str], None] | None,
) -> dict[str, Any]:  # fmt: skip
    start = time.perf_counter()
    make_folder(out / SPECIMENS)
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
                report("specimens", len(rows) / len(campaign.specimens))
                if time.perf_counter() - shown > _EVERY:
                    write_tables(_good(campaign, rows), campaign.keys, out)
                    shown = time.perf_counter()
    report("specimens", 1.0)
    clear(out)
    good = _good(campaign, rows)
    write_tables(good, campaign.keys, out)
    results = {
        "campaign": campaign.name, "varied": list(campaign.keys), "specimens": len(campaign.specimens),
        "finished": len(good), "before": before, "seconds": round(time.perf_counter() - start, 3),
        "failed": [rows[one.name] for one in campaign.specimens if "error" in rows[one.name]],
        "version": bondem.__version__,
    }  # fmt: skip
    write_text(out / "results.json", json.dumps(results, indent=1, allow_nan=False, default=str) + "\n")
    return results


def _arriving(client: Any, missing: Iterable[CampaignSpecimen], out: Path) -> Iterator[dict[str, Any]]:
    """Yield a row per specimen in the order of completion; that of a failed specimen has "error" with the reason."""
    for job, one in submitted(client, carry_out, missing, out):
        if job.status == "finished":
            yield job.result()
        else:
            error = job.exception()
            reason = f"{type(error).__name__}: {' '.join(str(error).split())}"
            yield {"name": one.name, "varied": dict(one.varied), "error": reason}


def _good(campaign: Campaign, rows: Mapping[str, dict[str, Any]]) -> list[dict[str, Any]]:
    """Select the rows without an error, in the order of the campaign."""
    found = (rows.get(one.name) for one in campaign.specimens)
    return [row for row in found if row is not None and "error" not in row]
