"""`bondem watch RUN.h5`: follow a run."""

import os
import time
from pathlib import Path

import click
from rich.console import Console
from rich.live import Live

from bondem._progress import span
from bondem.cli.info import table_of
from bondem.errors import RunFileError
from bondem.io.run_contents import RunContents, read_contents


@click.command("watch")
@click.argument("run_file", metavar="RUN.h5", type=click.Path(path_type=Path))
@click.option("--interval", type=click.FloatRange(0.05, 86400.0), default=1.0, show_default=True, metavar="SECONDS",
              help="Time between two readings of the file.")  # fmt: skip
@click.option("--patience", type=click.FloatRange(min=0.0), default=60.0, show_default=True, metavar="SECONDS",
              help="Time limit for the file to appear.")  # fmt: skip
def command(run_file: Path, interval: float, patience: float) -> None:
    """Show the progress of a run at each checkpoint until the run ends.

    On a terminal the display is updated in place; in a pipe each checkpoint gives one line.
    """
    console = Console(highlight=False, markup=False)
    found, began = None, time.monotonic()
    while found is None:
        try:
            found = read_contents(run_file)
        except RunFileError:
            if os.path.lexists(run_file) or time.monotonic() - began >= patience:
                raise
            time.sleep(interval)
    if not console.is_terminal:
        _follow(run_file, found, interval)
        return
    with Live(table_of(found), console=console, auto_refresh=False) as live:
        while found.written:
            time.sleep(interval)
            found = read_contents(run_file)
            live.update(table_of(found), refresh=True)


def _follow(run_file: Path, found: RunContents, interval: float) -> None:
    shown = -1
    while True:
        if found.step != shown:
            shown = found.step
            left = "" if found.left is None else f", {span(found.left)} left"
            rate = "" if found.rate is None else f", {found.rate:.4g} steps/s{left}"
            click.echo(f"step {found.step} of {found.steps}, t = {found.time:.6g} s, {found.broken} broken{rate}")
        if not found.written:
            return
        time.sleep(interval)
        found = read_contents(run_file)
