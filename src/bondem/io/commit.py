"""The commit of the code that is running, where it runs from a checkout."""

import functools
import subprocess
from pathlib import Path

_ROOT = Path(__file__).resolve().parents[3]


@functools.cache
def commit() -> str | None:
    """Short hash of the commit of bondem, "-dirty" after it where files have changed; None where it is installed.

    Git is asked once.
    """
    if not (_ROOT / ".git").exists():
        return None
    asked = ["git", "-C", str(_ROOT), "describe", "--always", "--dirty", "--abbrev=10", "--exclude=*"]
    try:
        done = subprocess.run(asked, capture_output=True, text=True, timeout=10.0, check=True)
    except (OSError, subprocess.SubprocessError):
        return None
    return done.stdout.strip() or None
