"""`python -m validation NAME --out DIR`: carry out a study, or go on with one in the same folder."""

import importlib
import inspect
import sys
import warnings
from pathlib import Path
from types import ModuleType

import click

import bondem as bd
from bondem.cli import leave_with
from validation.frame.command import command_of, recording
from validation.frame.study import Study

#: All studies, by their modules.
NAMES = sorted(path.stem for path in (Path(__file__).parent / "studies").glob("[!_]*.py"))


def module_of(name: str) -> ModuleType:
    """The module of a study."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", bd.errors.UnitWarning)  # some shapes are metres long
        return importlib.import_module(f"validation.studies.{name}")


def study_of(name: str) -> type[Study] | None:
    """The study of a name if it makes rows over several processes, None if it writes one record."""
    module = module_of(name)
    own = (kind for kind in vars(module).values() if inspect.isclass(kind) and kind.__module__ == module.__name__)
    return next((kind for kind in own if issubclass(kind, Study)), None)


def command(name: str) -> click.Command:
    """The command of any study."""
    found = study_of(name)
    return command_of(found) if found else recording("validation", name, module_of(name))


class _Studies(click.Group):
    """The studies, each loaded when it is called."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        return NAMES

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        return command(cmd_name) if cmd_name in NAMES else None


@click.group("python -m validation", cls=_Studies, no_args_is_help=False, invoke_without_command=True,
             context_settings={"help_option_names": ["-h", "--help"]})  # fmt: skip
@click.pass_context
def validation(context: click.Context) -> None:
    """The papers' tests done again. A study goes on where it was stopped when started again with the same DIR."""
    if context.invoked_subcommand is None:
        click.echo(context.get_help())


def main() -> None:
    """Run the command line and leave with its exit status, as `bondem` does."""
    leave_with(validation)


if __name__ == "__main__":
    sys.exit(main())
