"""Access to pictures of run files, which need an optional extra."""

import importlib
from typing import Any

from bondem._extras import install
from bondem.errors import InputError

#: Objects to draw; "auto" selects cells if the file has them, otherwise elements, and cracks with both.
SHOWN = ("auto", "elements", "cells", "cracks", "bonds")


def pictures() -> Any:
    """Import the module that draws run files.

    Raises:
        InputError: the extra is not installed.
    """
    try:
        return importlib.import_module("bondem.report.scenes")
    except ImportError as error:
        raise InputError(f"pictures need pyvista ({error}); {install('view')}") from error
