"""`bondem study dispersion --out DIR`."""

from pathlib import Path

import click

from bondem.cli.studies.options import carry_out, numbers, of_study
from bondem.packing import METHODS
from bondem.study.dispersion import SPREADS, Dispersion
from bondem.study.packing_rows import TARGETS


@click.command("dispersion")
@of_study
@click.option("--count", type=click.IntRange(min=10), default=Dispersion.count, show_default=True,
              help="Spheres of a packing.")  # fmt: skip
@click.option(
    "--kappa", "spreads", default=",".join(f"{100 * spread:.0f}" for spread in SPREADS), show_default=True,
    callback=numbers(lambda item: float(item) / 100.0, "dispersions in percent"),
    help="Dispersions (R_max − R_min) / R̄ in percent.",
)  # fmt: skip
@click.option("--seeds", type=click.IntRange(min=1), default=Dispersion.seeds, show_default=True,
              help="Packings of each κ.")  # fmt: skip
@click.option("--method", type=click.Choice(METHODS), default=Dispersion.method, show_default=True,
              help="How to pack.")  # fmt: skip
@click.option("--target", type=click.Choice(TARGETS), default=Dispersion.target, show_default=True,
              help="Where a packing ends: 6.2 contacts a sphere, or the onset of jamming.")  # fmt: skip
def command(
    out: Path, processes: int | None, count: int, spreads: tuple[float, ...], seeds: int, method: str, target: str
) -> None:
    """Isotropy over the dispersion of the radii: figures 5 to 7 of André et al. (2012)."""
    study = Dispersion(count=count, spreads=spreads, seeds=seeds, method=method, target=target)
    carry_out(study, out, processes)
