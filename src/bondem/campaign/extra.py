"""Libraries that only campaigns need: loaded where they are used, so that bondem does without them."""

import importlib
from typing import Any

from bondem.errors import MissingDependencyError


def needed(module: str) -> Any:
    """A library of the extra "campaign".

    Raises:
        MissingDependencyError: it is not installed.
    """
    try:
        return importlib.import_module(module)
    except ImportError as error:
        raise MissingDependencyError(f'campaigns need more ({error}): pip install "bondem[campaign]"') from error
