"""The command of a study, made from its fields or arguments: `python -m validation NAME`."""

import inspect
import os
import re
import sys
import types
from collections.abc import Callable
from dataclasses import MISSING, fields
from pathlib import Path
from typing import Annotated, Any, Literal, Union, get_args, get_origin, get_type_hints

import click

from bondem.cli.terminal import progress_bars
from validation.frame.record import RESULTS, Record, command_line
from validation.frame.runner import run
from validation.frame.study import Study, of_text

_FILE = click.Path(path_type=Path)


def command_of(kind: type[Study]) -> click.Command:
    """A command with an option for each field that a text can give, explained as its docstring has it."""
    options: list[click.Parameter] = [
        click.Option(["--out"], required=True, metavar="DIR", type=_FILE, help="Where results go."),
        click.Option(
            ["--processes"], type=click.IntRange(min=1), help="How many work at once; one a core unless given."
        ),
        click.Option(
            ["--threads"], type=click.IntRange(min=1, max=os.cpu_count()), default=1, show_default=True,
            help="Threads of each.",
        ),
    ]  # fmt: skip
    told = explained(kind)
    for field in fields(kind):
        default = field.default
        if default is MISSING or not of_text(default):
            continue
        of = type(default[0]) if isinstance(default, tuple) else type(default)
        options.append(_option(field.name, tuple[of, ...] if isinstance(default, tuple) else of, default,
                               told[field.name]))  # fmt: skip

    def carry_out(out: Path, processes: int | None, threads: int, **options: Any) -> None:
        words = f"python -m validation {' '.join(sys.argv[1:])}"
        with progress_bars() as progress:
            run(kind(**options), out, processes=processes, thread_count=threads, command=words, progress=progress)
        click.echo(f"\n{(out / 'table.md').read_text(encoding='utf-8')}")
        click.echo(out / "results.json")

    return click.Command(kind.name, params=options, callback=carry_out, help=(kind.__doc__ or "").splitlines()[0])


def recording(package: str, name: str, module: types.ModuleType) -> click.Command:
    """A command of a module that measures into a record, that draws from one, or both.

    Its function `measure(record, *, …)` gets the record and has an argument for each option; a tuple of texts takes
    those of its default only, or those of its annotation. Its function `draw(record, folder)` draws what the record
    has.

    Args:
        package: of the command, `python -m PACKAGE NAME`; or a script, `python SCRIPT`.
        name: of the command, and of the record unless `--out` is given.
        module: with `measure`, `draw` or both.
    """
    usual, options, told = RESULTS / f"{name}.json", [], explained(getattr(module, "measure", None))
    if hasattr(module, "measure"):
        hints = get_type_hints(module.measure, include_extras=True)
        arguments = list(inspect.signature(module.measure).parameters.values())[1:]
        options += [_option(one.name, hints[one.name], one.default, told.get(one.name, ""), choose=True)
                    for one in arguments]  # fmt: skip
        text = "Record to write, or to continue."
        options.append(click.Option(["--out"], type=_FILE, metavar="FILE", default=usual, help=text))
    if hasattr(module, "draw"):
        text = "Draw there what the record has, without measuring." if options else "Draw there."
        options.append(click.Option(["--figures"], type=_FILE, metavar="DIR", help=text, required=not options))

    def carry_out(out: Path = usual, figures: Path | None = None, **given: Any) -> None:
        called = [package] if package.endswith(".py") else ["-m", package]
        record = Record(out, command_line(["python", *called, *sys.argv[1:]]))
        if figures is None:
            module.measure(record, **given)
            click.echo(record.path)
            return
        figures.mkdir(parents=True, exist_ok=True)
        module.draw(record, figures)
        click.echo(figures)

    words = (module.__doc__ or "").strip()
    short = words.splitlines()[0]
    return click.Command(name, params=options, callback=carry_out, help=f"\b\n{words}", short_help=short)


def explained(of: object) -> dict[str, str]:
    """What a docstring says of each field of a class, or argument of a function."""
    text = inspect.cleandoc(of.__doc__ or "")
    _, *listed = re.split(r"^(?:Attributes|Args):\n", text, maxsplit=1, flags=re.MULTILINE)
    found = re.findall(r"^ {4}(\w+): (.*?)(?=^ {4}\w|^$|\Z)", "".join(listed), re.MULTILINE | re.DOTALL)
    return {name: " ".join(words.split()) for name, words in found}


def _option(name: str, kind: Any, default: Any, text: str, *, choose: bool = False) -> click.Option:
    """An option for a field or an argument: a flag, one value, or several with commas between."""
    flag = f"--{name.replace('_', '-')}"
    choices: tuple[str, ...] = ()
    if get_origin(kind) is Annotated:
        kind, choices = get_args(kind)
    if kind is bool:
        return click.Option([flag], is_flag=True, help=text)
    several = get_origin(kind) is tuple
    of = get_args(kind)[0] if several else kind
    if get_origin(of) in (Union, types.UnionType):
        of = next(one for one in get_args(of) if one is not types.NoneType)
    if get_origin(of) is Literal:
        choices = get_args(of)
    elif several and of is str and choose and not choices:
        choices = default
    of = str if choices else of
    shown = ",".join(map(str, default)) if several else default
    return click.Option(
        [flag], help=text, show_default=True, default=shown, metavar=f"{of.__name__},…".upper() if several else None,
        type=str if several else click.Choice(choices) if choices else _FILE if of is Path else of,
        callback=_read(of, choices) if several else None,
    )  # fmt: skip


def _read(kind: Callable[[str], Any], choices: tuple[str, ...]) -> Callable[..., Any]:
    def read(_context: click.Context, _parameter: click.Parameter, given: str) -> Any:
        try:
            found = tuple(kind(item.strip()) for item in given.split(",") if item.strip())
        except ValueError:
            raise click.BadParameter(f"'{given}': give them with commas between") from None
        if choices and (other := [one for one in found if one not in choices]):
            raise click.BadParameter(f"'{other[0]}': choose from {', '.join(choices)}")
        return found

    return read
