"""`bondem study dispersion --out DIR` and `bondem study refinement --out DIR`."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import click

from bondem.cli.terminal import progress_bars
from bondem.packing import METHODS
from bondem.study.dispersion import SPREADS, Dispersion, run_dispersion
from bondem.study.packing_rows import TARGETS
from bondem.study.refinement import COUNTS, Refinement, run_refinement


def _numbers(kind: Callable[[str], Any], what: str) -> Callable[..., tuple[Any, ...]]:
    """Numbers with commas between."""

    def read(_context: click.Context, _parameter: click.Parameter, text: str) -> tuple[Any, ...]:
        try:
            return tuple(kind(item) for item in text.split(","))
        except ValueError:
            raise click.BadParameter(f"'{text}': give {what} with commas between") from None

    return read


def _shared(function: Callable[..., Any]) -> Callable[..., Any]:
    """Options of every study of packings."""
    out = click.Path(path_type=Path)
    function = click.option(
        "--processes", type=click.IntRange(min=1), help="Packings made at once; one a core unless given."
    )(function)
    return click.option("--out", required=True, metavar="DIR", type=out, help="Where results go.")(function)


@click.group("study", no_args_is_help=False, invoke_without_command=True)
@click.pass_context
def command(context: click.Context) -> None:
    """Studies of packings. Stopped at any moment, they go on where they were when started again with the same DIR."""
    if context.invoked_subcommand is None:
        click.echo(context.get_help())


@command.command("dispersion")
@_shared
@click.option("--count", type=click.IntRange(min=10), default=3000, show_default=True, help="Spheres of a packing.")
@click.option(
    "--kappa", "spreads", default=",".join(f"{100 * spread:.0f}" for spread in SPREADS), show_default=True,
    callback=_numbers(lambda item: float(item) / 100.0, "dispersions in percent"),
    help="Dispersions (R_max − R_min) / R̄ in percent.",
)  # fmt: skip
@click.option("--seeds", type=click.IntRange(min=1), default=1, show_default=True, help="Packings of each κ.")
@click.option("--method", type=click.Choice(METHODS), default="shear", show_default=True, help="How to pack.")
@click.option("--target", type=click.Choice(TARGETS), default="contacts", show_default=True,
              help="Where a packing ends: 6.2 contacts a sphere, or the onset of jamming.")  # fmt: skip
def dispersion(
    out: Path, processes: int | None, count: int, spreads: tuple[float, ...], seeds: int, method: str, target: str
) -> None:
    """Isotropy over the dispersion of the radii: figures 5 to 7 of André et al. (2012)."""
    study = Dispersion(count=count, spreads=spreads, seeds=seeds, method=method, target=target)
    with progress_bars() as progress:
        run_dispersion(study, out, processes=processes, progress=progress)
    _show(out)


@command.command("refinement")
@_shared
@click.option(
    "--counts", default=",".join(map(str, COUNTS)), show_default=True, callback=_numbers(int, "numbers of spheres"),
    help="Numbers of spheres.",
)  # fmt: skip
@click.option("--packings", type=click.IntRange(min=1), default=5, show_default=True, help="Packings of each size.")
@click.option("--periodic", type=click.IntRange(min=0), default=3, show_default=True,
              help="Packings without walls, to hold the limits against.")  # fmt: skip
@click.option("--kappa", type=click.FloatRange(0.0, 200.0, max_open=True), default=25.0, show_default=True,
              help="Dispersion of the radii in percent.")  # fmt: skip
@click.option("--method", type=click.Choice(METHODS), default="quench", show_default=True, help="How to pack.")
@click.option("--target", type=click.Choice((*TARGETS, "both")), default="both", show_default=True,
              help="Where a packing ends: the onset of jamming, 6.2 contacts a sphere, or one of each.")  # fmt: skip
def refinement(
    out: Path, processes: int | None, counts: tuple[int, ...], packings: int, periodic: int, kappa: float,
    method: str, target: str,
) -> None:  # fmt: skip
    """Density, contacts and isotropy over the number of spheres: figure 8 of André et al. (2012)."""
    study = Refinement(
        counts=counts, packings=packings, spread=round(kappa / 100.0, 6), method=method,
        targets=TARGETS if target == "both" else (target,), periodic=periodic,
    )  # fmt: skip
    with progress_bars() as progress:
        run_refinement(study, out, processes=processes, progress=progress)
    _show(out)


def _show(out: Path) -> None:
    """Print the means and where everything is."""
    click.echo(f"\n{(out / 'table.md').read_text(encoding='utf-8')}")
    click.echo(f"{out / 'report.html'}\n{out / 'results.json'}")
