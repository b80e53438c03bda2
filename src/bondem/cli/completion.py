"""`bondem completion bash|zsh|fish`: shell completion."""

import click
from click.shell_completion import get_completion_class

from bondem.cli import bondem

_SHELLS = ("bash", "zsh", "fish")


@click.command("completion")
@click.argument("shell", type=click.Choice(_SHELLS))
def command(shell: str) -> None:
    """Print the script that completes commands and options in a shell.

    For bash: echo 'eval "$(bondem completion bash)"' >> ~/.bashrc
    """
    found = get_completion_class(shell)
    assert found is not None
    click.echo(found(bondem, {}, "bondem", "_BONDEM_COMPLETE").source())
