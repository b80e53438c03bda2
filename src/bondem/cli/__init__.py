"""Command line of bondem, the command `bondem`.

The exit status is 0 for success, 2 for bad input or another error, and 3 for a run that became unstable or lost its
energy balance. The status is 1 if the reader of a pipe has ended or specimens of a campaign failed, and 130 for an
interrupt. An error gives one line on stderr. Subcommands are imported when called, so that `bondem --help` is fast.
"""

import contextlib
import importlib
import sys
import warnings
from typing import NoReturn

import click

from bondem import __version__
from bondem.cli.streams import accept_all_characters, flush
from bondem.errors import BondemError, UnstableRunError

# First line of the help of each command, so that `bondem --help` imports no module of a command.
_COMMANDS = {
    "calibrate": "Calibrate bonds to E, ν and ρ of a material, and with --ucs and --tension to its strengths.",
    "campaign": "Run a study for all seeds and values of its table [campaign], in parallel.",
    "check": "Check a study and print what it will compute, without running it.",
    "completion": "Print the script that completes commands and options in a shell.",
    "export": "Write the last checkpoint of a run file, or a packing with its bonds, for another program.",
    "info": "Print the contents of a run file: progress, broken bonds, energy balance and origin.",
    "new": "Write a commented study file as a template.",
    "render": "Draw the elements or cells and the cracks of a run file, coloured by a field, as a picture or film.",
    "resume": "Resume a run from its last checkpoint; the result is bit-identical to an uninterrupted run.",
    "run": "Run a study: pack, check, connect, calibrate, test and report.",
    "schema": "Print the JSON schema of study files, for editors that complete and check TOML.",
    "strength": "Calibrate the tensile strength and cohesion of cells to compression and Brazilian tests.",
    "view": "Open a run file in a window with rotation and a slider for snapshots.",
    "watch": "Show the progress of a run at each checkpoint until the run ends.",
}

OK, UNREAD, BAD_INPUT, UNSTABLE, INTERRUPTED = 0, 1, 2, 3, 130


class _Commands(click.Group):
    """Group of commands, each in a module of its name under `bondem.cli`."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        return list(_COMMANDS)

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        if cmd_name not in _COMMANDS:
            return None
        return importlib.import_module(f"bondem.cli.{cmd_name}").command

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        with formatter.section("Commands"):
            formatter.write_dl(list(_COMMANDS.items()))


@click.group(
    cls=_Commands, no_args_is_help=False, invoke_without_command=True,
    context_settings={"help_option_names": ["-h", "--help"]},
)  # fmt: skip
@click.version_option(__version__, prog_name="bondem")
@click.pass_context
def bondem(context: click.Context) -> None:
    """Pack, bond, calibrate and break real materials with the discrete element method."""
    if context.invoked_subcommand is None:
        click.echo(context.get_help())


def main() -> None:
    """Run the command line and end the process with its exit status."""
    leave_with(bondem)


def leave_with(command: click.Command) -> NoReturn:
    """Run a command and end the process with its exit status; print each warning and error as one line."""
    accept_all_characters()
    with warnings.catch_warnings():
        warnings.showwarning = _warn
        status = _status(command)
    with contextlib.suppress(OSError):  # without an output the status remains
        flush(sys.stderr)
    sys.exit(status)


def _status(command: click.Command) -> int:
    try:
        try:
            return command.main(standalone_mode=False) or OK
        except click.exceptions.Exit as stop:
            return stop.exit_code
        finally:
            flush(sys.stdout)
    except BrokenPipeError:  # the reader of the pipe, such as `head`, has ended
        return UNREAD
    except OSError as error:
        where = f"'{error.filename}': " if error.filename else ""
        return _complain(f"{where}{error.strerror or error}; make room or choose another place", BAD_INPUT)
    except (click.Abort, KeyboardInterrupt) as stop:
        return _complain(_interrupt_text(stop), INTERRUPTED)
    except SystemError as error:
        # an interrupt during compiled code becomes a SystemError
        if _by_interrupt(error):
            return _complain("interrupted", INTERRUPTED)
        raise
    except click.ClickException as error:
        return _complain(f"{error.format_message()} See '{command.name} --help'.", BAD_INPUT)
    except UnstableRunError as error:
        return _complain(str(error), UNSTABLE)
    except BondemError as error:
        return _complain(str(error), BAD_INPUT)


def _by_interrupt(error: BaseException | None) -> bool:
    while error is not None and not isinstance(error, KeyboardInterrupt):
        error = error.__cause__ or error.__context__
    return error is not None


def _interrupt_text(stop: BaseException) -> str:
    """Return the message of an interrupt, which may state how to resume the run."""
    cause = stop.__cause__ or stop.__context__
    return str(stop) or (str(cause) if isinstance(cause, KeyboardInterrupt) else "") or "interrupted"


def _warn(message: Warning | str, category: type[Warning], *_: object, **__: object) -> None:
    _say(f"warning: {message}")


def _complain(message: str, status: int) -> int:
    _say(message)
    return status


def _say(message: str) -> None:
    with contextlib.suppress(OSError):  # stderr may be closed
        click.echo(f"bondem: {' '.join(message.split())}", err=True)
