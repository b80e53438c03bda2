"""`bondem study coverage --out DIR`."""

from pathlib import Path

import click

from bondem.cli.studies.options import of_study, show
from bondem.cli.terminal import progress_bars
from bondem.study.coverage import Coverage, run_coverage


@click.command("coverage")
@of_study
@click.option("--count", type=click.IntRange(min=500), default=Coverage.count, show_default=True,
              help="Elements each.")  # fmt: skip
@click.option("--calibrating", type=click.IntRange(min=2), default=Coverage.calibrating, show_default=True,
              help="To calibrate on.")  # fmt: skip
@click.option("--unseen", type=click.IntRange(min=1), default=Coverage.held_out, show_default=True,
              help="Packings that test.")  # fmt: skip
@click.option("--shape", type=click.Choice(("cylinder", "cell")), default=Coverage.shape, show_default=True,
              help="The paper's cylinder of 10 x 40 mm, or a periodic cell.")  # fmt: skip
def command(out: Path, processes: int | None, count: int, calibrating: int, unseen: int, shape: str) -> None:
    """Whether the intervals of a calibration hold unseen packings as often as they say."""
    study = Coverage(count=count, calibrating=calibrating, held_out=unseen, shape=shape)
    with progress_bars() as progress:
        run_coverage(study, out, processes=processes, progress=progress)
    show(out)
