"""`bondem study quasistatic --out DIR`."""

from pathlib import Path

import click

from bondem.cli.quantities import Quantity
from bondem.cli.studies.bar_options import carry_out_on_bar, of_bar
from bondem.study.calibrated_bar import BarRequest
from bondem.study.quasistatic import QuasiStatic, run_quasistatic


@click.command("quasistatic")
@of_bar(packings=QuasiStatic.bar.packings)
@click.option("--steps", type=click.IntRange(min=1000), default=QuasiStatic.steps, show_default=True,
              help="Steps of the run.")  # fmt: skip
@click.option("--ramp", type=Quantity("%", above=0.0, below=100.0),
              default=100.0 * QuasiStatic.ramp,
              show_default=True, help="Part of the steps in which the load grows, in percent.")  # fmt: skip
@click.option("--phi", type=Quantity("-", least=1.0), default=QuasiStatic.phi, show_default=True,
              help="Dissipation of the scheme of Tchamwa and Wielgosz.")  # fmt: skip
def command(out: Path, count: int, seed: int, steps: int, ramp: float, phi: float) -> None:
    """A slow tensile test by explicit dynamics: figures 10 and 12 of André et al. (2012)."""
    study = QuasiStatic(bar=BarRequest(count, seed), steps=steps, ramp=ramp / 100.0, phi=phi)
    carry_out_on_bar(run_quasistatic, study, out)
