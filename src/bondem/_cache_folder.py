"""Folder of the cache of this user: packings, and passes compiled for a GPU."""

import os
import tempfile
from functools import cache
from pathlib import Path

from platformdirs import user_cache_path


@cache
def cache_folder() -> Path:
    """Return the folder bondem/ in BONDEM_CACHE_DIR or the user's caches, or a temporary one if that is read-only."""
    asked = os.environ.get("BONDEM_CACHE_DIR")
    try:
        folder = Path(asked, "bondem") if asked else user_cache_path("bondem", appauthor=False)
        if not asked and not folder.is_absolute():
            raise OSError("the user has no home")  # "~/.cache" of older versions of platformdirs
        folder.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryFile(dir=folder):
            return folder
    except (OSError, RuntimeError):  # the folder cannot be written to, or the user has no home
        return Path(tempfile.gettempdir()) / f"bondem-{os.getuid() if hasattr(os, 'getuid') else 'cache'}"
