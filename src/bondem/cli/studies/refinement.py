"""`bondem study refinement --out DIR`."""

from pathlib import Path

import click

from bondem.cli.quantities import Quantity
from bondem.cli.studies.options import carry_out, numbers, of_study
from bondem.packing import METHODS
from bondem.study.packing_rows import TARGETS
from bondem.study.refinement import COUNTS, Refinement


@click.command("refinement")
@of_study
@click.option(
    "--counts", default=",".join(map(str, COUNTS)), show_default=True, callback=numbers(int, "numbers of spheres"),
    help="Numbers of spheres.",
)  # fmt: skip
@click.option("--packings", type=click.IntRange(min=1), default=Refinement.packings, show_default=True,
              help="Packings of each size.")  # fmt: skip
@click.option("--periodic", type=click.IntRange(min=0), default=Refinement.periodic, show_default=True,
              help="Packings without walls, to hold the limits against.")  # fmt: skip
@click.option("--kappa", type=Quantity("%", least=0.0, below=200.0), default=100.0 * Refinement.spread,
              show_default=True,
              help="Dispersion of the radii in percent.")  # fmt: skip
@click.option("--method", type=click.Choice(METHODS), default=Refinement.method, show_default=True,
              help="How to pack.")  # fmt: skip
@click.option("--target", type=click.Choice((*TARGETS, "both")), default="both", show_default=True,
              help="Where a packing ends: the onset of jamming, 6.2 contacts a sphere, or one of each.")  # fmt: skip
def command(
    out: Path, processes: int | None, counts: tuple[int, ...], packings: int, periodic: int, kappa: float,
    method: str, target: str,
) -> None:  # fmt: skip
    """Density, contacts and isotropy over the number of spheres: figure 8 of André et al. (2012)."""
    study = Refinement(
        counts=counts, packings=packings, spread=round(kappa / 100.0, 6), method=method,
        targets=TARGETS if target == "both" else (target,), periodic=periodic,
    )  # fmt: skip
    carry_out(study, out, processes)
