"""Git commit of the code that is running."""

import functools
import re
import subprocess
from pathlib import Path

from bondem import __version__

_ROOT = Path(__file__).resolve().parents[3]
_IN_VERSION = re.compile(r"\+g([0-9a-f]{7,})")


@functools.cache
def commit() -> str | None:
    """Return the short hash of the commit of bondem, or None if it is unknown.

    An installed package has the commit in its version. In a clone, whose code may change after the installation, Git
    is called once, and "-dirty" marks uncommitted changes.
    """
    if not (_ROOT / ".git").exists():
        found = _IN_VERSION.search(__version__)
        return found[1] if found else None
    asked = ["git", "-C", str(_ROOT), "describe", "--always", "--dirty", "--abbrev=10", "--exclude=*"]
    try:
        done = subprocess.run(asked, capture_output=True, text=True, timeout=10.0, check=True)
    except (OSError, subprocess.SubprocessError):
        return None
    return done.stdout.strip() or None
