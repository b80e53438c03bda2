"""Loading of the libraries of optional extras at their first use; bondem works without them."""

import importlib
from typing import Any

from bondem.errors import MissingDependencyError


def install(extra: str) -> str:
    """Return the command that installs an optional extra, for a message.

    bondem is on no package index, so that its name alone installs nothing, or the package of a stranger.

    Args:
        extra: name of the extra in `pyproject.toml`.
    """
    return f'in a clone of bondem, run pip install -e ".[{extra}]"'


def needed(module: str, extra: str) -> Any:
    """Import a library of an optional extra.

    Args:
        module: name of the module.
        extra: name of the extra that installs it.

    Raises:
        MissingDependencyError: the library is not installed.
    """
    try:
        return importlib.import_module(module)
    except ImportError as error:
        raise MissingDependencyError(f"a library is missing ({error}); {install(extra)}") from error
