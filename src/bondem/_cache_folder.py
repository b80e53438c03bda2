"""The folder of the cache of this user: packings, and passes compiled for a GPU."""

import os
import tempfile
from functools import cache
from pathlib import Path


@cache
def cache_folder() -> Path:
    """Return the folder: bondem/ in BONDEM_CACHE_DIR, XDG_CACHE_HOME or ~/.cache, else one for temporary files."""
    asked = os.environ.get("BONDEM_CACHE_DIR") or os.environ.get("XDG_CACHE_HOME")
    try:
        root = Path(asked) if asked else Path.home() / ".cache"
        (root / "bondem").mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryFile(dir=root / "bondem"):
            return root / "bondem"
    except (OSError, RuntimeError):  # the folder cannot be written to, or the user has no home
        return Path(tempfile.gettempdir()) / f"bondem-{os.getuid() if hasattr(os, 'getuid') else 'cache'}"
