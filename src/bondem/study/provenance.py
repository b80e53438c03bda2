"""Origin of results: version, commit, machine, threads, command and date."""

import platform
import shlex
import sys
from datetime import datetime
from pathlib import Path
from typing import Any

from bondem import __version__
from bondem._threads import current_threads, most_threads
from bondem.io.commit import commit


def provenance() -> dict[str, Any]:
    """Describe the present process: version, commit, command, date, machine, Python and threads of the solvers."""
    return {
        "version": __version__,
        "commit": commit(),
        "command": _command(),
        "date": datetime.now().astimezone().isoformat(timespec="seconds"),
        "machine": f"{platform.system()} {platform.machine()}, {_processor()}, {most_threads()} threads available",
        "python": platform.python_version(),
        "threads": current_threads(),
    }


def _command() -> str | None:
    """Return the command line of `bondem`; None for a call from Python."""
    called = Path(sys.argv[0] if sys.argv else "")
    named = called.stem == "bondem" or called.parts[-2:] == ("bondem", "__main__.py")
    return shlex.join(["bondem", *sys.argv[1:]]) if named else None


def _processor() -> str:
    """Return the name of the processor."""
    try:
        lines = Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines()
    except OSError:
        lines = []
    named = [line.partition(":")[2].strip() for line in lines if line.startswith("model name")]
    return named[0] if named else platform.processor() or "unknown processor"
