"""The command of a study, made from its fields: `python -m validation NAME --out DIR`."""

import inspect
import os
import re
import sys
from collections.abc import Callable
from dataclasses import MISSING, Field, fields
from pathlib import Path
from typing import Any

import click

from bondem.cli.terminal import progress_bars
from validation.frame.runner import run
from validation.frame.study import Study


def command_of(kind: type[Study]) -> click.Command:
    """A command with an option for each field that a text can give, explained as its docstring has it."""
    path = click.Path(path_type=Path)
    options: list[click.Parameter] = [
        click.Option(["--out"], required=True, metavar="DIR", type=path, help="Where results go."),
        click.Option(
            ["--processes"], type=click.IntRange(min=1), help="How many work at once; one a core unless given."
        ),
        click.Option(
            ["--threads"], type=click.IntRange(min=1, max=os.cpu_count()), default=1, show_default=True,
            help="Threads of each.",
        ),
        click.Option(["--address"], metavar="URL", help="Scheduler of a Dask cluster to work on instead."),
    ]  # fmt: skip
    told = explained(kind)
    for field in fields(kind):
        default = field.default
        if default is MISSING or not _of_text(default):
            continue
        options.append(click.Option(
            [f"--{field.name.replace('_', '-')}"], help=told[field.name], show_default=True,
            metavar=_metavar(default), default=",".join(map(str, default)) if isinstance(default, tuple) else default,
            type=str if isinstance(default, tuple) else type(default), callback=_read(field),
        ))  # fmt: skip

    def carry_out(out: Path, processes: int | None, threads: int, address: str | None, **options: Any) -> None:
        words = f"python -m validation {' '.join(sys.argv[1:])}"
        with progress_bars() as progress:
            run(
                kind(**options), out, processes=processes, thread_count=threads, address=address, command=words,
                progress=progress,
            )  # fmt: skip
        click.echo(f"\n{(out / 'table.md').read_text(encoding='utf-8')}")
        click.echo(f"{out / 'report.html'}\n{out / 'results.json'}")

    return click.Command(kind.name, params=options, callback=carry_out, help=(kind.__doc__ or "").splitlines()[0])


def explained(kind: type[Study]) -> dict[str, str]:
    """What the docstring of a study says of each of its fields."""
    _, _, listed = inspect.cleandoc(kind.__doc__ or "").partition("Attributes:\n")
    return {
        name: " ".join(text.split())
        for name, text in re.findall(r"^ {4}(\w+): (.*?)(?=^ {4}\w|\Z)", listed, flags=re.MULTILINE | re.DOTALL)
    }


def _of_text(default: object) -> bool:
    plain = default if isinstance(default, tuple) else (default,)
    return bool(plain) and all(isinstance(one, int | float | str) for one in plain)


def _metavar(default: object) -> str:
    if isinstance(default, tuple):
        return f"{type(default[0]).__name__},…".upper()
    return type(default).__name__.upper()


def _read(field: Field[Any]) -> Callable[..., Any]:
    def read(_context: click.Context, _parameter: click.Parameter, given: Any) -> Any:
        if not isinstance(field.default, tuple):
            return given
        kind = type(field.default[0])
        try:
            return tuple(kind(item.strip()) for item in given.split(","))
        except ValueError:
            raise click.BadParameter(f"'{given}': give them with commas between") from None

    return read
