"""`python -m validation NAME --out DIR`: carry out a study, or go on with one in the same folder."""

import importlib
import inspect
import sys

import click

from bondem.cli import leave_with
from validation.frame.command import command_of, recording
from validation.frame.study import Study

#: Studies whose rows are made over several processes, into a folder.
STUDIES = (
    "abacus", "assembly", "beam_bonds", "branching", "celigueta", "coverage", "crack_paths", "dispersion", "fracture",
    "granite", "influence", "kalthoff", "protocol", "quasistatic", "refinement", "ring", "section", "size_effect",
    "spall", "surface", "toughness", "vibration", "wave", "weibull",
)  # fmt: skip
#: Those that write one record.
RECORDS = (
)  # fmt: skip


def study_of(name: str) -> type[Study]:
    """The study of a name that makes rows over several processes."""
    module = importlib.import_module(f"validation.studies.{name}")
    (found,) = (
        kind for kind in vars(module).values()
        if inspect.isclass(kind) and issubclass(kind, Study) and kind.__module__ == module.__name__
    )  # fmt: skip
    return found


def command(name: str) -> click.Command:
    """The command of any study."""
    if name in STUDIES:
        return command_of(study_of(name))
    return recording("validation", name, importlib.import_module(f"validation.studies.{name}"))


class _Studies(click.Group):
    """The studies, each loaded when it is called."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        return sorted((*STUDIES, *RECORDS))

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        return command(cmd_name) if cmd_name in (*STUDIES, *RECORDS) else None


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
