"""An error in place of a hang in processes forked after bondem has used threads.

GNU OpenMP does not survive a fork: in the child, Numba ends the process by SIGTERM at the first threaded loop, a pool
of processes starts another one in its place, which ends likewise, and so on for ever.
"""

import os
import signal
import sys
import threading
from types import FrameType

from bondem.errors import ForkError


def _refuse(number: int, frame: FrameType | None) -> None:
    """Raise within bondem, whose loop has just been refused; elsewhere end the process as the signal asks for."""
    while frame is not None:
        if str(frame.f_globals.get("__name__", "")).startswith("bondem."):
            raise ForkError(
                "this process was forked after bondem had used threads, and cannot use them; start workers with"
                " multiprocessing.get_context('spawn') or 'forkserver', or before bondem is first used"
            )
        frame = frame.f_back
    signal.signal(number, signal.SIG_DFL)
    os.kill(os.getpid(), number)


def _in_child() -> None:
    compiled = sys.modules.get("bondem._compile")
    used = compiled is not None and "threads" in getattr(compiled, "_used", ())
    main = threading.current_thread() is threading.main_thread()
    if used and main and signal.getsignal(signal.SIGTERM) is signal.SIG_DFL:
        signal.signal(signal.SIGTERM, _refuse)


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_in_child)
