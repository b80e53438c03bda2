"""`bondem study wave --out DIR`."""

from pathlib import Path

import click

from bondem.cli.quantities import Quantity
from bondem.cli.studies.bar_options import carry_out_on_bar, of_bar
from bondem.study.calibrated_bar import BarRequest
from bondem.study.wave import WaveStudy, run_wave


@click.command("wave")
@of_bar(packings=WaveStudy.bar.packings)
@click.option("--velocity", type=Quantity("m/s", above=0.0), default=WaveStudy.velocity, show_default=True,
              help="Of the struck face [m/s].")  # fmt: skip
def command(out: Path, count: int, seed: int, packings: int, velocity: float) -> None:
    """A wave after a strike, and its celerity: figures 20 and 21 of André et al. (2012)."""
    carry_out_on_bar(run_wave, WaveStudy(bar=BarRequest(count, seed, packings), velocity=velocity), out)
