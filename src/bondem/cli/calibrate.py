"""`bondem calibrate`: calibrate the bonds of a material."""

import math
from dataclasses import replace
from pathlib import Path
from typing import Any

import click
from rich.markup import escape
from rich.table import Table

from bondem.cli.quantities import Quantity
from bondem.cli.terminal import TABLE, on_threads, progress_bars, wide_console
from bondem.errors import InputError
from bondem.interactions.beams.bond_law import BondLaw
from bondem.interactions.law_catalogue import CALIBRATED, LAWS, named
from bondem.report.numbers import percent, with_unit
from bondem.specimen import materials
from bondem.specimen.material import Material
from bondem.study.calibration_step import SHAPES, CalibrationPlan, run_calibration

# Bond laws by their names on the command line, such as euler-bernoulli.
_LAWS: dict[str, type[BondLaw]] = {law.title.lower().replace("–", "-"): law for law in CALIBRATED.values()}


@click.command("calibrate", context_settings={"show_default": True})
@click.option("--material", metavar="NAME",
              help="Material of the library, such as granite; --E, --nu and --rho override its values.")  # fmt: skip
@click.option("--E", "E", type=Quantity("Pa"), help="Young's modulus [Pa], or with its unit: \"72.5 GPa\".")
@click.option("--nu", type=Quantity("-"), help="Poisson's ratio [-].")
@click.option("--rho", type=Quantity("kg/m³"), help="Density [kg/m³], or with its unit: \"2.2 g/cm^3\".")
@click.option("--law", type=click.Choice(tuple(_LAWS)), help="Bond law; the recommended one by default.")
@click.option("--count", type=click.IntRange(min=200), default=CalibrationPlan.count,
              help="Number of elements per packing.")  # fmt: skip
@click.option("--packings", type=click.IntRange(min=1), default=CalibrationPlan.packings, help="Number of packings.")
@click.option("--shape", type=click.Choice(tuple(SHAPES)), default=CalibrationPlan.shape,
              help="Periodic cell (bulk, no surfaces) or the cylinder of André et al. (2012).")  # fmt: skip
@click.option("--spread", type=Quantity("-", least=0.0, below=2.0), default=CalibrationPlan.spread,
              help="Full range of the radii over their mean, κ [-].")  # fmt: skip
@click.option("--nu-mu", type=Quantity("-"), default=CalibrationPlan.nu_mu, help="Poisson's ratio of the bonds [-].")
@click.option("--ucs", type=Quantity("Pa", above=0.0),
              help="Uniaxial compressive strength [Pa], with --tension and --shape cylinder.")  # fmt: skip
@click.option("--tension", type=Quantity("Pa", above=0.0), help="Strength in direct tension [Pa].")
@click.option("--friction-angle", type=Quantity("rad"), default=CalibrationPlan.friction_angle, show_default="35 deg",
              help="Friction angle of the bonds [rad], or \"35 deg\".")  # fmt: skip
@click.option("--seed", type=click.IntRange(min=0), default=CalibrationPlan.seed, help="Seed of the first packing.")
@click.option("--out", metavar="DIR", type=click.Path(path_type=Path),
              help="Folder for calibration.json and its figure.")  # fmt: skip
@click.option("--threads", type=click.IntRange(min=1), help="Number of threads; all cores by default.")
def command(
    material: str | None, E: float | None, nu: float | None, rho: float | None, law: str | None, out: Path | None,
    threads: int | None, **given: Any,
) -> None:  # fmt: skip
    """Calibrate bonds to E, ν and ρ of a material, and with --ucs and --tension to its strengths.

    The result states the scatter over the packings and the confidence intervals.
    """
    plan = CalibrationPlan(material=_material(material, E, nu, rho), law=_LAWS[law] if law else None, **given)
    with on_threads(threads), progress_bars() as progress:
        fit, found = run_calibration(plan, out, progress=progress)
    _show(found)
    if fit.strength is not None:
        click.echo(f"\n  strengths: {fit.strength}")
        failure = fit.failure  # raises an error for targets that were not reached
        click.echo(
            f"\n  bd.MohrCoulomb(tension={failure.tension:.4g}, cohesion={failure.cohesion:.4g},"
            f" friction_angle=math.radians({math.degrees(plan.friction_angle):g}))"
        )
    if out is not None:
        click.echo(f"\n  {out / 'calibration.json'}\n  {out / 'calibration.png'}")


def _material(name: str | None, E: float | None, nu: float | None, rho: float | None) -> Material:
    given: dict[str, Any] = {"E": E, "nu": nu, "rho": rho}
    if name is not None:
        return replace(materials.get(name), **{key: value for key, value in given.items() if value is not None})
    missing = [f"--{key}" for key, value in given.items() if value is None]
    if missing:
        raise InputError(f"{' and '.join(missing)} missing; give --E, --nu and --rho, or --material NAME")
    return Material("the material", **given)


def _show(found: dict[str, Any]) -> None:
    console = wide_console()
    micro, specimen, timing = found["micro"], found["specimen"], found["timing"]
    symbol = LAWS[found["law"]].free.symbol
    target = found["material"]
    console.print(
        f"\n[bold]{named(found['law'])} bonds[/bold] for {escape(target['name'])}"
        f" (E = {with_unit(target['E'], 'Pa')}, ν = {target['nu']:g}, ρ = {with_unit(target['rho'], 'kg/m³')})"
    )
    if found["reason"]:
        console.print(f"  recommended: {found['reason']}")
    radius = "" if found["parameter"] == "radius_ratio" else f", r̃ = {micro['r_mu_ratio']:g}"
    console.print(
        f"\n  E_μ = {with_unit(micro['E_mu'], 'Pa')}, {symbol} = {micro[found['parameter']]:.4f}{radius},"
        f" ν_μ = {micro['nu_mu']:g}, ρ_μ = {with_unit(micro['rho_mu'], 'kg/m³')}\n"
    )
    table = Table(header_style="bold", **TABLE)
    for name in ("", "achieved", "scatter", "mean of all packings, 95 %", "one new packing, 95 %"):
        table.add_column(name, justify="right" if name else "left", no_wrap=True)
    rows = (("E", "  E", "Pa"), ("nu", "  ν", "-"), ("E_mu", "  E_μ", "Pa"), ("value", f"  {symbol}", "-"))
    for key, label, unit in rows:
        one = found["quantities"][key]
        scatter = "–" if one["std"] is None else percent(one["std"] / one["mean"])
        table.add_row(label, with_unit(one["mean"], unit), scatter, _interval(one["confidence_95"], unit),
                      _interval(one["prediction_95"], unit))  # fmt: skip
    console.print(table)
    place = "periodic cell" if specimen["shape"] == "cell" else specimen["shape"]
    needed = found["packings_for_1_percent"]
    more = "" if needed["E"] is None else (
        f"\n  for a mean within 1 % at 95 %: {needed['E']} packings for E, {needed['nu']} for ν"
    )  # fmt: skip
    console.print(
        f"\n  {specimen['packings']} × {specimen['elements']} elements, {place}, z ="
        f" {', '.join(f'{z:.2f}' for z in specimen['coordination_number'])}{more}\n"
        f"  packed in {timing['pack_s']:.1f} s, calibrated in {timing['calibrate_s']:.1f} s"
    )


def _interval(interval: tuple[float, float] | None, unit: str) -> str:
    return "–" if interval is None else " … ".join(with_unit(value, unit) for value in interval)
