"""The compiler boundary for CUDA devices: loaded only where `device="gpu"` is asked for.

A CUDA loop is a plain function with one thread an index; the scalar `@device` functions it calls are those of the
CPU. It is compiled in double precision when first launched, without the disk cache, in which Numba would not notice
an edit of the functions it calls. With NUMBA_ENABLE_CUDASIM=1 and NUMBA_DISABLE_JIT=1, set before anything is
imported, everything runs in plain Python instead (slowly), for tests without a device.
"""

import os
from collections.abc import Callable
from typing import Any

import cuda.core as cuda_core
import numba.core.config
import numba.core.types
import numba.cuda
import numba_cuda  # noqa: F401  not the older twin that Numba brings along
import numpy as np

__all__ = ["Array", "cuda", "cuda_kernel", "download", "launch", "missing", "recorded", "refused", "upload",
           "zeros"]  # fmt: skip

# their attributes are set at import, so that type checkers do not know them
config: Any = numba.core.config
cuda: Any = numba.cuda
core: Any = cuda_core
Array = Any  # on the device

SIMULATED = bool(config.ENABLE_CUDASIM)
# a few rows of a boundary are a small grid, and are meant to be
config.CUDA_LOW_OCCUPANCY_WARNINGS = 0
# Threads of a block; the simulator starts a thread of the system for each.
_BLOCK = 32 if SIMULATED else 128


def missing() -> str | None:
    """What a run on a device lacks here, as a sentence for people; None where nothing."""
    if SIMULATED:
        plain = bool(config.DISABLE_JIT)
        return None if plain else "the simulator of CUDA runs plain Python only: set NUMBA_DISABLE_JIT=1 too"
    if cuda.is_available():
        return None
    return "no CUDA device or driver was found: install an NVIDIA driver for CUDA 12 or newer, or use device='cpu'"


def cuda_kernel(function: Callable[..., None]) -> Any:
    """Compile a function that every thread of a device runs once; `cuda.grid(1)` is the thread's number."""
    return cuda.jit(function)


def refused(function: Callable[..., Any], count: int) -> str | None:
    """Why a function of a matrix (3, 3) and of `count` numbers does not compile for a device; None where it does."""
    if SIMULATED:
        return None
    number: Any = numba.core.types.float64
    signature = number(number[:, ::1], *[number] * count)
    try:  # for the oldest devices that CUDA 12 and 13 know: one need not be there
        cuda.compile_ptx(getattr(function, "py_func", function), signature, device=True, cc=(7, 5))
    except Exception as error:
        return (str(error) or type(error).__name__).splitlines()[0]
    return None


def launch(kernel: Any, count: int, *arguments: Any, stream: Any = 0) -> None:
    """Enqueue a kernel with at least `count` threads; none of nothing."""
    if count > 0:
        kernel[-(-count // _BLOCK), _BLOCK, stream](*arguments)


def upload(array: np.ndarray) -> Array:
    """A copy on the device; an empty array gets one unused entry along its empty axes."""
    full = array if array.size else np.zeros([max(1, length) for length in array.shape], array.dtype)
    return cuda.to_device(np.require(full, requirements=["C", "W"]))


def zeros(*shape: int, like: type = float) -> Array:
    """Zeros on the device, allocated there only; an axis of no entries gets an unused one."""
    array = cuda.device_array(tuple(max(1, length) for length in shape), np.dtype(like))
    flat = array.reshape(array.size)
    launch(_clear, array.size, flat)
    return array


def download(array: Array, target: np.ndarray) -> None:
    """Wait for the device, and copy an array back into one of the same shape; nothing into an empty one."""
    if target.size:
        target[...] = array.copy_to_host()


def recorded(work: Callable[[Any], None]) -> Callable[[], None]:
    """What `work(stream)` launches, as one CUDA graph that is launched as a whole, in order with all else.

    Its kernels must have run before, so that nothing is left to compile.
    """
    if SIMULATED or os.environ.get("BONDEM_CUDA_GRAPHS") == "off":
        return lambda: work(0)
    device = core.Device(cuda.get_current_device().id)
    device.set_current()
    builder = device.create_graph_builder()
    builder.begin_building()
    work(builder)
    graph = builder.end_building().complete()
    default = core.Stream.from_handle(0)
    return lambda: graph.launch(default)


def _clear_entry(flat: Any) -> None:
    k = cuda.grid(1)
    if k < flat.size:
        flat[k] = 0


_clear = cuda_kernel(_clear_entry)
