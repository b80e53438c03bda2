"""`bondem view RUN.h5`: show a run file in a window."""

from pathlib import Path
from typing import Any

import click

from bondem.cli.pictures import SHOWN, pictures


@click.command("view", context_settings={"show_default": True})
@click.argument("run_file", metavar="RUN.h5", type=click.Path(path_type=Path))
@click.option("--field", help="Field that colours elements: one of the file, 's1' or 'fragment'.  [displacement]")
@click.option("--show", type=click.Choice(SHOWN), default="auto", help="Objects to draw.")
@click.option("--snapshot", type=int, default=-1, help="Index of the snapshot; -1 is the last.")
@click.option("--warp", type=click.FloatRange(min=0.0), default=1.0, help="Magnification of displacements.")
@click.option("--camera", default="iso", metavar="VIEW",
              help="Direction of view: iso, x, -x, y, -y, z, -z, or AZIMUTH,ELEVATION in degrees.")  # fmt: skip
def command(run_file: Path, **options: Any) -> None:
    """Open a run file in a window with rotation and a slider for snapshots.

    A display and the optional extra are required: pip install -e ".[view]" in a clone. Without a display the exit
    status is 2.
    """
    pictures().view_run(run_file, **options)
