"""What the commands of studies share: where results go, how many processes, lists of numbers."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import click

from bondem.cli.terminal import progress_bars
from bondem.study.frame import PackingStudy, run_packing_study


def numbers(kind: Callable[[str], Any], what: str) -> Callable[..., tuple[Any, ...]]:
    """Callback of an option: numbers with commas between."""

    def read(_context: click.Context, _parameter: click.Parameter, text: str) -> tuple[Any, ...]:
        try:
            return tuple(kind(item) for item in text.split(","))
        except ValueError:
            raise click.BadParameter(f"'{text}': give {what} with commas between") from None

    return read


def of_study(function: Callable[..., Any]) -> Callable[..., Any]:
    """--out DIR and --processes, which every study has."""
    out = click.Path(path_type=Path)
    function = click.option(
        "--processes", type=click.IntRange(min=1), help="How many work at once; one a core unless given."
    )(function)
    return click.option("--out", required=True, metavar="DIR", type=out, help="Where results go.")(function)


def carry_out(study: PackingStudy, out: Path, processes: int | None) -> None:
    """Run a study, then print its tables and where everything is."""
    with progress_bars() as progress:
        run_packing_study(study, out, processes=processes, progress=progress)
    show(out)


def show(out: Path) -> None:
    """Print the tables of a study and where everything is."""
    click.echo(f"\n{(out / 'table.md').read_text(encoding='utf-8')}")
    click.echo(f"{out / 'report.html'}\n{out / 'results.json'}")
