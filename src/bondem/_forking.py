"""Threaded loops in processes forked after bondem has used threads, such as workers of `multiprocessing.Pool`.

The threads of GNU OpenMP do not survive a fork. Numba therefore ends a forked process by SIGTERM at its first
threaded loop, a pool starts another process in its place, which ends likewise, and the pool never returns. A loop on
one thread needs none of the lost threads: forked processes are limited to one, and Numba accepts them as new ones.
"""

import ctypes
import os
import sys
from typing import Any


def _in_child() -> None:
    layer: Any = sys.modules.get("numba.np.ufunc.omppool")
    if layer is None:  # no loop was threaded before the fork, or by a layer that survives it
        return
    numba: Any = sys.modules["numba"]
    # stores the number of this process, which Numba compares with that of the parent before each threaded loop
    ctypes.CFUNCTYPE(None, ctypes.c_int)(layer.launch_threads)(1)
    set_num_threads = numba.set_num_threads
    set_num_threads(1)
    # a larger number, of a study or a run, would use threads that do not exist
    numba.set_num_threads = lambda _: set_num_threads(1)


def allow_forks() -> None:
    """Enable threaded loops, on one thread, in processes that are forked from this one."""
    if hasattr(os, "register_at_fork"):
        os.register_at_fork(after_in_child=_in_child)
