"""`bondem view RUN.h5`: show a run file in a window."""

from pathlib import Path

import click

from bondem.cli.pictures import SHOWN, pictures


@click.command("view")
@click.argument("run_file", metavar="RUN.h5", type=click.Path(path_type=Path))
@click.option("--field", help="Field that colours elements: a field of the file, or 'fragment'.  [displacement]")
@click.option("--show", type=click.Choice(SHOWN), default="auto", show_default=True, help="Objects to draw.")
@click.option("--snapshot", type=int, default=-1, show_default=True, help="Index of the snapshot; -1 is the last.")
@click.option("--warp", type=click.FloatRange(min=0.0), default=1.0, show_default=True,
              help="Magnification of displacements.")  # fmt: skip
@click.option("--camera", default="iso", show_default=True, metavar="VIEW",
              help="Direction of view: iso, x, -x, y, -y, z, -z, or AZIMUTH,ELEVATION in degrees.")  # fmt: skip
def command(run_file: Path, field: str | None, show: str, snapshot: int, warp: float, camera: str) -> None:
    """Open a run file in a window with rotation and a slider for snapshots.

    A display and the optional extra are required: pip install -e ".[view]" in a clone. Without a display the exit
    status is 2.
    """
    pictures().view_run(run_file, field=field, show=show, snapshot=snapshot, warp=warp, camera=camera)
