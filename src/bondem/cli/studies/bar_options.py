"""What the commands of the dynamic studies share: where results go, and which packings of the cylinder."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import click

from bondem.cli.studies.options import show
from bondem.cli.terminal import progress_bars
from bondem.study.calibrated_bar import BarRequest

Command = Callable[..., Any]


def of_bar(packings: int) -> Callable[[Command], Command]:
    """--out DIR, --count, --seed and, unless one packing is all that is looked at, --packings."""

    def options(function: Command) -> Command:
        if packings > 1:
            function = click.option(
                "--packings", type=click.IntRange(min=1), default=packings, show_default=True,
                help="Packings of the cylinder, seeds in sequence.",
            )(function)  # fmt: skip
        function = click.option(
            "--seed", type=click.IntRange(min=0), default=BarRequest.seed, show_default=True,
            help="Of the first packing, on which the bonds are calibrated.",
        )(function)  # fmt: skip
        function = click.option(
            "--count", type=click.IntRange(min=500), default=BarRequest.count, show_default=True,
            help="Spheres of a packing."
        )(function)
        out = click.Path(path_type=Path)
        return click.option("--out", required=True, metavar="DIR", type=out, help="Where results go.")(function)

    return options


def carry_out_on_bar(run: Callable[..., Any], study: object, out: Path) -> None:
    """Run a study, then print its tables and where everything is."""
    with progress_bars() as progress:
        run(study, out, progress=progress)
    show(out)
