"""`bondem resume RUN.h5`."""

from pathlib import Path

import click

from bondem.cli import UNSTABLE
from bondem.cli.terminal import on_threads, progress_bars
from bondem.run import resume


@click.command("resume")
@click.argument("run_file", metavar="RUN.h5", type=click.Path(path_type=Path))
@click.option("--threads", "count", type=click.IntRange(min=1), help="Number of threads; all cores unless given.")
@click.pass_context
def command(context: click.Context, run_file: Path, count: int | None) -> None:
    """Go on from the last checkpoint of a run, exactly as if it had never stopped."""
    with on_threads(count), progress_bars() as progress:
        result = resume(run_file, progress=lambda share: progress("run", share))
    click.echo(f"{result.status.value} at t = {result.state.time:.6g} s, step {result.steps}: {result.message}")
    if result.status.failed:
        context.exit(UNSTABLE)
