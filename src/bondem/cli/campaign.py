"""`bondem campaign STUDY.toml --out DIR`."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import click
from rich.console import Console
from rich.markup import escape

from bondem._progress import span
from bondem.campaign.coordinator import run_campaign
from bondem.campaign.sweep import read_campaign
from bondem.cli.terminal import progress_bars
from bondem.errors import InputError

#: Exit status where specimens failed.
FAILED = 1
# So many of them are shown.
_SHOWN = 5


@click.command("campaign")
@click.argument("study_file", metavar="STUDY.toml", type=click.Path(path_type=Path))
@click.option("--out", required=True, metavar="DIR", type=click.Path(path_type=Path), help="Where results go.")
@click.option("--workers", type=click.IntRange(min=1), help="Processes of this machine; one a core unless given.")
@click.option("--address", metavar="URL", help='Scheduler of a Dask cluster that is there, such as "tcp://host:8786".')
@click.option("--log", metavar="FILE", type=click.Path(path_type=Path), help="Where progress is written to, too.")
def command(study_file: Path, out: Path, workers: int | None, address: str | None, log: Path | None) -> int:
    """Do a study for all seeds and values that its table [campaign] names, several at once.

    Run again with the same DIR, it does what is not finished there. Workers that die are replaced and their
    specimens done again. Exit status 1 when specimens failed: results.json has their input and the reason.
    """
    if workers is not None and address is not None:
        raise InputError("give --workers, for processes of this machine, or --address, not both")
    campaign = read_campaign(study_file)
    with progress_bars(log) as progress:
        results = run_campaign(
            campaign, out, workers=workers, address=address, progress=progress, dashboard=_tell_address
        )
    _show(results, out)
    return FAILED if results["failed"] else 0


def _tell_address(link: str) -> None:
    console = Console(highlight=False, stderr=True)
    if console.is_terminal:
        console.print(f"dashboard: {link}", markup=False)


def _show(results: Mapping[str, Any], out: Path) -> None:
    console = Console(highlight=False, soft_wrap=True)
    before = f", {results['before']} of them earlier" if results["before"] else ""
    done = f"{results['finished']} of {results['specimens']} specimens finished{before}"
    console.print(f"[bold]{escape(results['campaign'])}[/bold]: {done}, in {span(results['seconds'])}")
    for row in results["failed"][:_SHOWN]:
        told = ", ".join(f"{key} = {value}" for key, value in row["varied"].items())
        console.print(f"  failed: {told}: {row['error']}", markup=False)
    if len(results["failed"]) > _SHOWN:
        console.print(f"  and {len(results['failed']) - _SHOWN} more")
    console.print(f"  {out / 'table.parquet'}\n  {out / 'table.csv'}\n  {out / 'results.json'}", markup=False)
