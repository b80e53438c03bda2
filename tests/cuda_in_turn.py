"""The simulator of CUDA devices, with the threads of a block one after another.

It starts a thread of the system for each by itself, most of which find that there is nothing to do, and that is most
of its time. In turn they do the same as long as none waits for another: there is no barrier in the kernels of bondem,
and one would fail here, because the thread that runs them all has no `syncthreads`.
"""

import importlib
import threading
from typing import Any

import numpy as np


def _in_turn(block: Any, place: tuple[int, ...], *arguments: Any) -> None:
    """Run all threads of a block: what replaces `BlockManager.run`."""
    simulated = importlib.import_module("numba.cuda.simulator.kernel")
    here: Any = threading.current_thread()
    here.blockIdx = simulated.Dim3(*place)
    for index in np.ndindex(*block._block_dim):
        here.threadIdx = simulated.Dim3(*index)
        block._f(*arguments)


def simulate_in_turn() -> None:
    """Make the simulator of this process do so; it must have been chosen."""
    importlib.import_module("numba_cuda")
    importlib.import_module("numba.cuda.simulator.kernel").BlockManager.run = _in_turn
