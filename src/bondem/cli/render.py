"""`bondem render RUN.h5`: draw a run file."""

from pathlib import Path
from typing import Any

import click

from bondem.cli.pictures import SHOWN, pictures


@click.command("render", context_settings={"show_default": True})
@click.argument("run_file", metavar="RUN.h5", type=click.Path(path_type=Path))
@click.option("--out", type=click.Path(path_type=Path),
              help="Output file: PNG, or MP4 or GIF of all snapshots.  [RUN.png]")  # fmt: skip
@click.option("--field", help="Field that colours elements: one of the file, 's1' or 'fragment'.  [displacement]")
@click.option("--show", type=click.Choice(SHOWN), default="auto", help="Objects to draw.")
@click.option("--snapshot", type=int, default=-1, help="Index of the snapshot; -1 is the last.")
@click.option("--section", type=click.Choice(("x", "y", "z")),
              help="Remove the half in front of the middle plane normal to this axis.")  # fmt: skip
@click.option("--warp", type=click.FloatRange(min=0.0), default=1.0, help="Magnification of displacements.")
@click.option("--camera", default="iso", metavar="VIEW",
              help="Direction of view: iso, x, -x, y, -y, z, -z, or AZIMUTH,ELEVATION in degrees.")  # fmt: skip
@click.option("--walls/--no-walls", default=True, help="Draw the walls of the model.")
@click.option("--axes/--no-axes", default=True, help="Draw coordinate axes with units.")
@click.option("--size", type=click.IntRange(min=64, max=8192), nargs=2, default=(1200, 800),
              metavar="WIDTH HEIGHT", help="Size of the picture [pixels].")  # fmt: skip
def command(run_file: Path, out: Path | None, **options: Any) -> None:
    """Draw the elements or cells and the cracks of a run file, coloured by a field, as a picture or film.

    The optional extra is required: pip install -e ".[view]" in a clone.
    """
    click.echo(f"{pictures().render_run(run_file, out or run_file.with_suffix('.png'), **options)}")
