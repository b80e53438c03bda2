"""`bondem campaign STUDY.toml --out DIR`: run a study for many seeds and values."""

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

#: Exit status after failed specimens.
FAILED = 1
# Number of failed specimens that are listed.
_SHOWN = 5


@click.command("campaign")
@click.argument("study_file", metavar="STUDY.toml", type=click.Path(path_type=Path))
@click.option("--out", required=True, metavar="DIR", type=click.Path(path_type=Path), help="Folder for results.")
@click.option("--workers", type=click.IntRange(min=1),
              help="Number of worker processes on this machine; one per core by default.")  # fmt: skip
@click.option("--address", metavar="URL",
              help='Scheduler address of an existing Dask cluster, such as "tcp://host:8786".')  # fmt: skip
@click.option("--log", metavar="FILE", type=click.Path(path_type=Path),
              help="Log file for progress, written in addition to the terminal.")  # fmt: skip
def command(study_file: Path, out: Path, workers: int | None, address: str | None, log: Path | None) -> int:
    """Run a study for all seeds and values of its table [campaign], in parallel.

    Called again with the same DIR, the command runs only unfinished specimens. Workers that die are replaced, and
    their specimens run again. The exit status is 1 if specimens failed; results.json lists their input and reason.
    """
    if workers is not None and address is not None:
        raise InputError(
            "--workers and --address: both are given; give --workers for processes of this machine, or --address"
        )
    campaign = read_campaign(study_file)
    with progress_bars(log) as progress:
        results = run_campaign(
            campaign, out, workers=workers, address=address, progress=progress, dashboard=_show_address
        )
    _show(results, out)
    return FAILED if results["failed"] else 0


def _show_address(link: str) -> None:
    console = Console(highlight=False, stderr=True)
    if console.is_terminal:
        console.print(f"dashboard: {link}", markup=False)


def _show(results: Mapping[str, Any], out: Path) -> None:
    console = Console(highlight=False, soft_wrap=True)
    before = f", {results['before']} of them earlier" if results["before"] else ""
    done = f"{results['finished']} of {results['specimens']} specimens finished{before}"
    console.print(f"[bold]{escape(results['campaign'])}[/bold]: {done}, in {span(results['seconds'])}")
    for row in results["failed"][:_SHOWN]:
        values = ", ".join(f"{key} = {value}" for key, value in row["varied"].items())
        console.print(f"  failed: {values}: {row['error']}", markup=False)
    if len(results["failed"]) > _SHOWN:
        console.print(f"  and {len(results['failed']) - _SHOWN} more")
    console.print(f"  {out / 'table.parquet'}\n  {out / 'table.csv'}\n  {out / 'results.json'}", markup=False)
