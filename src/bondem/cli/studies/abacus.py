"""`bondem study abacus --out DIR`."""

from pathlib import Path

import click

from bondem.cli.studies.options import carry_out, of_study
from bondem.study.abacus import SWEEPS, Abacus


@click.command("abacus")
@of_study
@click.option("--count", type=click.IntRange(min=100), default=Abacus.count, show_default=True,
              help="Elements of a packing.")  # fmt: skip
@click.option("--packings", type=click.IntRange(min=1), default=Abacus.packings, show_default=True,
              help="Periodic cells.")
@click.option("--bars", type=click.IntRange(min=0), default=Abacus.bars, show_default=True,
              help="Cylinders of 10 x 40 mm, the paper's specimen.")  # fmt: skip
@click.option("--law", "laws", type=click.Choice(tuple(SWEEPS)), multiple=True,
              help="Which laws; all unless given.")  # fmt: skip
def command(
    out: Path, processes: int | None, count: int, packings: int, bars: int, laws: tuple[str, ...]
) -> None:
    """Calibration curves of every law: figures 15 and 16 of André et al. (2012), as data to use again."""
    study = Abacus(count=count, packings=packings, bars=bars, laws=laws or tuple(SWEEPS))
    carry_out(study, out, processes)
