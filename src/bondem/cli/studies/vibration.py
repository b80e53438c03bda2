"""`bondem study vibration --out DIR`."""

from pathlib import Path

import click

from bondem.cli.quantities import Quantity
from bondem.cli.studies.bar_options import carry_out_on_bar, of_bar
from bondem.study.calibrated_bar import BarRequest
from bondem.study.vibration import Vibration, run_vibration


@click.command("vibration")
@of_bar(packings=Vibration.bar.packings)
@click.option("--steps", type=click.IntRange(min=1000), default=Vibration.steps, show_default=True,
              help="Steps of the run.")  # fmt: skip
@click.option("--ramp", type=Quantity("%", above=0.0, below=100.0),
              default=100.0 * Vibration.ramp,
              show_default=True, help="Part of the steps in which the loads grow, in percent.")  # fmt: skip
def command(out: Path, count: int, seed: int, packings: int, steps: int, ramp: float) -> None:
    """Energies of a free vibration, and the specimen's inertia: figure 19 and eq (19) of André et al. (2012)."""
    study = Vibration(bar=BarRequest(count, seed, packings), steps=steps, ramp=ramp / 100.0)
    carry_out_on_bar(run_vibration, study, out)
