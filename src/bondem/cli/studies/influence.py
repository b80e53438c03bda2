"""`bondem study influence --out DIR`."""

from pathlib import Path

import click

from bondem.cli.studies.options import carry_out, of_study
from bondem.study.influence import Influence


@click.command("influence")
@of_study
@click.option("--count", type=click.IntRange(min=100), default=Influence.count, show_default=True,
              help="Elements of a packing.")  # fmt: skip
@click.option("--packings", type=click.IntRange(min=1), default=Influence.packings, show_default=True,
              help="Periodic cells.")
@click.option("--bars", type=click.IntRange(min=0), default=Influence.bars, show_default=True,
              help="Cylinders of 10 x 40 mm, the paper's specimen.")  # fmt: skip
def command(out: Path, processes: int | None, count: int, packings: int, bars: int) -> None:
    """E and ν over the parameters of bonds: figures 11, 13 and 14 of André et al. (2012)."""
    carry_out(Influence(count=count, packings=packings, bars=bars), out, processes)
