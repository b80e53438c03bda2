"""The way to pictures of run files, which need an optional extra."""

import importlib
from typing import Any

from bondem._extras import install
from bondem.errors import InputError

#: What can be drawn; "auto" is cells where there are any, else elements, and cracks with them.
SHOWN = ("auto", "elements", "cells", "cracks", "bonds")


def seeing() -> Any:
    """The module that draws.

    Raises:
        InputError: the extra is not installed.
    """
    try:
        return importlib.import_module("bondem.report.scenes")
    except ImportError as error:
        raise InputError(f"pictures need pyvista ({error}); {install('view')}") from error
