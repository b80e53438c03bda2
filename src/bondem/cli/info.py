"""`bondem info RUN.h5`: contents of a run file."""

from pathlib import Path

import click
from rich.console import Console
from rich.table import Table

from bondem._progress import span
from bondem.io.run_contents import RunContents, read_contents


@click.command("info")
@click.argument("run_file", metavar="RUN.h5", type=click.Path(path_type=Path))
@click.option("--json", "as_json", is_flag=True, help="Print the complete contents as JSON.")
def command(run_file: Path, as_json: bool) -> None:
    """Print the contents of a run file: progress, broken bonds, energy balance and origin."""
    found = read_contents(run_file)
    if as_json:
        click.echo(found.as_json())
        return
    Console(highlight=False, markup=False).print(table_of(found))


def table_of(found: RunContents) -> Table:
    """Create a table with the contents of a run file, as names and texts."""
    table = Table(box=None, show_header=False, padding=(0, 2, 0, 0))
    for name, words in _lines(found):
        table.add_row(name, words)
    return table


def _lines(found: RunContents) -> list[tuple[str, str]]:
    """Summarise a run file as pairs of a name and a text."""
    done = found.step / found.steps if found.steps else 1.0
    stands = "being written" if found.written else "finished" if done >= 1.0 else "not finished"
    lines = [
        ("file", f"{found.path}, {found.size / 1e6:.3g} MB, schema {found.schema}, {stands}"),
        ("model", f"{found.elements} {'cells' if found.cells else 'spheres'},"
                  f" {found.bonds} {'facets' if found.cells else 'bonds'}"),
        ("step", f"{found.step} of {found.steps} ({100.0 * done:.1f} %), dt = {found.dt:.4g} s"),
        ("time", f"{found.time:.6g} of {found.duration:.6g} s"),
        ("wall time", _pace(found)),
        ("broken", f"{found.broken} {'facets' if found.cells else 'bonds'}"),
        ("energy", "no records" if found.imbalance is None else
                   f"{found.records} records, error of the energy balance {found.imbalance:.2g} of its largest term"),
        ("snapshots", f"{found.snapshots}; ParaView opens the file" if found.snapshots else "none"),
        ("made by", ", ".join(f"{key} {value}" for key, value in found.provenance.items())),
    ]  # fmt: skip
    if not found.written and done < 1.0:
        lines.append(("resume with", f"bondem resume {found.path}"))
    return lines


def _pace(found: RunContents) -> str:
    if found.rate is None:
        return "unknown"
    rest = "" if not found.left else f", {span(found.left)} left"
    return f"{span(found.seconds)}, {found.rate:.4g} steps/s{rest}"
