"""Libraries of the optional extras: loaded where they are used, so that bondem does without them."""

import importlib
from typing import Any

from bondem.errors import MissingDependencyError


def needed(module: str, extra: str) -> Any:
    """A library of an extra.

    Args:
        module: its name.
        extra: that of the extra that brings it.

    Raises:
        MissingDependencyError: it is not installed.
    """
    try:
        return importlib.import_module(module)
    except ImportError as error:
        raise MissingDependencyError(f'this needs more ({error}): pip install "bondem[{extra}]"') from error
