"""`bondem resume RUN.h5`: resume an interrupted run."""

from pathlib import Path

import click

from bondem.cli import UNSTABLE
from bondem.cli.terminal import on_threads, progress_bars
from bondem.run import resume


@click.command("resume")
@click.argument("run_file", metavar="RUN.h5", type=click.Path(path_type=Path))
@click.option("--threads", "count", type=click.IntRange(min=1), help="Number of threads; all cores by default.")
@click.pass_context
def command(context: click.Context, run_file: Path, count: int | None) -> None:
    """Resume a run from its last checkpoint; the result is bit-identical to an uninterrupted run."""
    with on_threads(count), progress_bars() as progress:
        result = resume(run_file, progress=lambda share: progress("run", share))
    click.echo(f"{result.status.value} at t = {result.state.time:.6g} s, step {result.steps}: {result.message}")
    if result.status.failed:
        context.exit(UNSTABLE)
