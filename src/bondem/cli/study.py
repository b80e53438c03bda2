"""`bondem study NAME --out DIR`: the group; each study is in a file of its name under `bondem.cli.studies`."""

import importlib

import click

_STUDIES = (
    "abacus", "assembly", "coverage", "dispersion", "influence", "quasistatic", "refinement", "section",
    "surface", "vibration", "wave",
)  # fmt: skip


class _Studies(click.Group):
    """The studies, each loaded when it is called."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        return list(_STUDIES)

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        if cmd_name not in _STUDIES:
            return None
        return importlib.import_module(f"bondem.cli.studies.{cmd_name}").command


@click.group("study", cls=_Studies, no_args_is_help=False, invoke_without_command=True)
@click.pass_context
def command(context: click.Context) -> None:
    """Studies. Those of many packings go on where they were stopped when started again with the same DIR."""
    if context.invoked_subcommand is None:
        click.echo(context.get_help())
