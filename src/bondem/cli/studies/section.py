"""`bondem study section --out DIR`."""

from pathlib import Path

import click

from bondem.cli.studies.bar_options import carry_out_on_bar, of_bar
from bondem.study.calibrated_bar import BarRequest
from bondem.study.effective_section import SectionStudy, run_section


@click.command("section")
@of_bar(packings=SectionStudy.bar.packings)
def command(out: Path, count: int, seed: int, packings: int) -> None:
    """The section that forces fill, and bending with it: figure 22 of André et al. (2012)."""
    carry_out_on_bar(run_section, SectionStudy(bar=BarRequest(count, seed, packings)), out)
