"""`bondem strength`: calibrate strengths of cells for a material."""

import math
from pathlib import Path
from typing import Any

import click

from bondem.cli.quantities import Quantity
from bondem.cli.terminal import on_threads, progress_bars
from bondem.study.strength_calibration import StrengthPlan, run_strength


@click.command("strength", context_settings={"show_default": True})
@click.option("--E", "E", type=Quantity("Pa"), required=True, help="Young's modulus [Pa], or \"40 GPa\".")
@click.option("--nu", type=Quantity("-"), required=True, help="Poisson's ratio [-].")
@click.option("--ucs", type=Quantity("Pa"), required=True, help="Target uniaxial compressive strength [Pa].")
@click.option("--brazilian", type=Quantity("Pa"), required=True, help="Target Brazilian strength 2 P / (π D t) [Pa].")
@click.option("--ucs-within", type=Quantity("Pa", above=0.0), help="Tolerance of --ucs [Pa]; 4 % by default.")
@click.option("--brazilian-within", type=Quantity("Pa", above=0.0),
              help="Tolerance of --brazilian [Pa]; 7.5 % by default.")  # fmt: skip
@click.option("--friction-angle", type=Quantity("rad"), default=StrengthPlan.friction_angle, show_default="35 deg",
              help="Friction angle φ [rad], or \"35 deg\".")  # fmt: skip
@click.option("--fracture-energy", type=Quantity("J/m²"), default=StrengthPlan.fracture_energy,
              help="Fracture energy G_f [J/m²].")  # fmt: skip
@click.option("--diameter", type=Quantity("m", above=0.0), default=StrengthPlan.diameter,
              help="Diameter of the cylinder [m].")  # fmt: skip
@click.option("--length", type=Quantity("m", above=0.0), default=StrengthPlan.length,
              help="Length of the cylinder [m].")  # fmt: skip
@click.option("--count", type=click.IntRange(min=200), default=StrengthPlan.count,
              help="Number of cells per packing.")  # fmt: skip
@click.option("--packings", type=click.IntRange(min=1), default=StrengthPlan.packings,
              help="Number of packings, whose mean strength is calibrated.")  # fmt: skip
@click.option("--seed", type=click.IntRange(min=0), default=StrengthPlan.seed, help="Seed of the first packing.")
@click.option("--most", type=click.IntRange(min=1), default=StrengthPlan.most, help="Largest number of runs.")
@click.option("--out", metavar="DIR", type=click.Path(path_type=Path),
              help="Folder for finished runs, which a later call reuses.")  # fmt: skip
@click.option("--threads", type=click.IntRange(min=1), help="Number of threads; all cores by default.")
def command(out: Path | None, threads: int | None, **given: Any) -> None:
    """Calibrate the tensile strength and cohesion of cells to compression and Brazilian tests.

    The result states the uncertainty of the parameters.
    """
    plan = StrengthPlan(**given)
    with on_threads(threads), progress_bars():
        fit = run_strength(plan, out, progress=click.echo)
    click.echo(f"\n{fit}")
    found = fit.parameters  # raises an error for targets that were not reached
    angle = math.degrees(plan.friction_angle)
    click.echo(
        f"\n  bd.MohrCoulomb(tension={found['tension']:.4g}, cohesion={found['cohesion']:.4g},"
        f" friction_angle=math.radians({angle:g}), fracture_energy={plan.fracture_energy:g})"
    )
