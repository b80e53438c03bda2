"""`bondem study surface --out DIR`."""

from pathlib import Path

import click

from bondem.cli.studies.options import carry_out, numbers, of_study
from bondem.study.surface_study import SurfaceStudy


@click.command("surface")
@of_study
@click.option(
    "--counts", default=",".join(map(str, SurfaceStudy.counts)), show_default=True,
    callback=numbers(int, "numbers of elements"), help="Elements of a body with 6.2 contacts a sphere.",
)  # fmt: skip
@click.option("--seeds", type=click.IntRange(min=1), default=SurfaceStudy.seeds, show_default=True,
              help="Packings of each.")  # fmt: skip
@click.option("--other-count", type=click.IntRange(min=300), default=SurfaceStudy.other_count, show_default=True,
              help="Elements of bodies packed to jamming, or cut from a larger packing.")  # fmt: skip
@click.option("--cell-count", type=click.IntRange(min=300), default=SurfaceStudy.cell_count, show_default=True,
              help="Elements of a periodic cell.")  # fmt: skip
def command(
    out: Path, processes: int | None, counts: tuple[int, ...], seeds: int, other_count: int, cell_count: int
) -> None:
    """How E and ν of a body differ from those of the bulk, and how well that is predicted from its lattice."""
    study = SurfaceStudy(counts=counts, seeds=seeds, other_count=other_count, cell_count=cell_count)
    carry_out(study, out, processes)
