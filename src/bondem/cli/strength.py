"""`bondem strength --E … --nu … --ucs … --brazilian …`: strengths of cells for a material, in one command."""

import math
from dataclasses import replace
from pathlib import Path

import click

from bondem.cli.quantities import Quantity
from bondem.cli.terminal import on_threads, progress_bars
from bondem.study.strength_calibration import StrengthPlan, run_strength


@click.command("strength")
@click.option("--E", "E", type=Quantity("Pa"), required=True, help="Young's modulus [Pa], or \"40 GPa\".")
@click.option("--nu", type=Quantity("-"), required=True, help="Poisson's ratio [-].")
@click.option("--ucs", type=Quantity("Pa"), required=True, help="Uniaxial compressive strength asked for.")
@click.option("--brazilian", type=Quantity("Pa"), required=True, help="Brazilian strength asked for, 2 P / (π D t).")
@click.option("--ucs-within", type=Quantity("Pa", above=0.0), help="Tolerance; 4 % unless given.")
@click.option("--brazilian-within", type=Quantity("Pa", above=0.0), help="Tolerance; 7.5 % unless given.")
@click.option("--friction-angle", type=Quantity("rad"), default=StrengthPlan.friction_angle, show_default="35 deg",
              help="φ [rad], or \"35 deg\".")  # fmt: skip
@click.option("--fracture-energy", type=Quantity("J/m²"), default=StrengthPlan.fracture_energy, show_default=True,
              help="G_f [J/m²].")  # fmt: skip
@click.option("--diameter", type=Quantity("m", above=0.0), default=StrengthPlan.diameter, show_default=True,
              help="Of the cylinder [m].")  # fmt: skip
@click.option("--length", type=Quantity("m", above=0.0), default=StrengthPlan.length, show_default=True,
              help="Of the cylinder [m].")  # fmt: skip
@click.option("--count", type=click.IntRange(min=200), default=StrengthPlan.count, show_default=True,
              help="Cells each.")  # fmt: skip
@click.option("--packings", type=click.IntRange(min=1), default=StrengthPlan.packings, show_default=True,
              help="Packings, whose mean is calibrated.")  # fmt: skip
@click.option("--seed", type=click.IntRange(min=0), default=StrengthPlan.seed, show_default=True,
              help="Of the first packing.")  # fmt: skip
@click.option("--most", type=click.IntRange(min=1), default=StrengthPlan.most, show_default=True, help="Runs.")
@click.option("--out", metavar="DIR", type=click.Path(path_type=Path), help="Where runs are kept, to go on from.")
@click.option("--threads", type=click.IntRange(min=1), help="Number of threads; all cores unless given.")
def command(
    E: float, nu: float, ucs: float, brazilian: float, ucs_within: float | None, brazilian_within: float | None,
    friction_angle: float, fracture_energy: float, diameter: float, length: float, count: int, packings: int,
    seed: int, most: int, out: Path | None, threads: int | None,
) -> None:  # fmt: skip
    """Find tensile strength and cohesion of cells by compression and Brazilian tests, and say how sure that is."""
    plan = StrengthPlan(E=E, nu=nu, ucs=ucs, brazilian=brazilian, friction_angle=friction_angle,
                        fracture_energy=fracture_energy)  # fmt: skip
    plan = replace(plan, ucs_within=ucs_within, brazilian_within=brazilian_within, diameter=diameter, length=length,
                   count=count, packings=packings, seed=seed, most=most)  # fmt: skip
    with on_threads(threads), progress_bars():
        fit = run_strength(plan, out, progress=click.echo)
    click.echo(f"\n{fit}")
    found = fit.parameters  # says so where targets were not reached
    angle = math.degrees(friction_angle)
    click.echo(
        f"\n  bd.MohrCoulomb(tension={found['tension']:.4g}, cohesion={found['cohesion']:.4g},"
        f" friction_angle=math.radians({angle:g}), fracture_energy={fracture_energy:g})"
    )
