"""`bondem study assembly --out DIR`."""

from pathlib import Path

import click

from bondem.cli.studies.options import carry_out, numbers, of_study
from bondem.study.assembly import COUNTS, Assembly
from bondem.study.packing_rows import TARGETS


@click.command("assembly")
@of_study
@click.option(
    "--counts", default=",".join(map(str, COUNTS)), show_default=True, callback=numbers(int, "numbers of elements"),
    help="Numbers of elements.",
)  # fmt: skip
@click.option("--packings", type=click.IntRange(min=2), default=Assembly.packings, show_default=True,
              help="Bars of each size.")  # fmt: skip
@click.option("--cells", type=click.IntRange(min=0), default=Assembly.cells, show_default=True,
              help="Periodic cells, to hold the limits against.")  # fmt: skip
@click.option("--target", type=click.Choice((*TARGETS, "both")), default="contacts", show_default=True,
              help="Where a packing ends: 6.2 contacts an element, the onset of jamming, or each.")  # fmt: skip
def command(
    out: Path, processes: int | None, counts: tuple[int, ...], packings: int, cells: int, target: str
) -> None:
    """E and ν over the number of elements: figures 17 and 18 of André et al. (2012)."""
    # 6.2 contacts first, as in the paper
    targets = tuple(reversed(TARGETS)) if target == "both" else (target,)
    carry_out(Assembly(counts=counts, packings=packings, cells=cells, targets=targets), out, processes)
