"""CUDA device, for which NVRTC compiles passes of the core with one thread per element, bond or facet.

This module is loaded for `device="gpu"` only; no other module imports NVIDIA's `cuda.core`. Each pass is a separate
program, compiled when a run first needs it. Compiled passes are stored in the folder `kernels` of bondem's cache, by
sources, compiler and architecture.
"""

import hashlib
import io
import os
import re
import tempfile
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import cuda.bindings.nvrtc as cuda_nvrtc
import cuda.core as cuda_core
import numpy as np

from bondem._cache_folder import cache_folder
from bondem._core_build import SOURCES, core_sources
from bondem._device import Enqueue, in_sequence
from bondem._passes import Kernel

__all__ = ["CudaDevice", "Registers", "compiled_passes", "lacks_gpu"]

# their attributes depend on the version of CUDA, so that type checkers do not know them
core: Any = cuda_core
nvrtc: Any = cuda_nvrtc
# Threads of a block.
_BLOCK = 128
# Number of tables among the arguments of a kernel, which follow the number of indices and the address of a flag.
_TABLES = 8


def lacks_gpu() -> str | None:
    """Return a sentence on a missing requirement of runs on a GPU, or None if all are met."""
    try:
        if core.Device.get_all_devices():
            return None
    except Exception:  # no driver, or one that is too old: the kind of the error depends on the version
        pass
    return "no CUDA device or driver was found: install an NVIDIA driver for CUDA 12 or newer, or use device='cpu'"


# ---- compiling


@dataclass(frozen=True)
class Registers:
    """Registers and memory of a thread of a kernel, as the compiler reports them.

    Attributes:
        registers: number of registers.
        spilled: number of bytes that a thread writes and reads because registers are lacking.
        stack: number of bytes on the stack.
    """

    registers: int
    spilled: int
    stack: int


def compiled_passes(
    architecture: str, name: str | None = None, *, fused: bool = True
) -> tuple[bytes, dict[str, Registers]]:
    """Compile passes with one thread per index; no device is needed.

    Args:
        architecture: architecture of the device, such as "sm_90".
        name: name of a pass; None for all passes.
        fused: True to let the compiler fuse products and sums.

    Returns:
        The compiled passes, and the registers of a thread of each.
    """
    source, log = SOURCES / "gpu" / "kernels.cu", io.StringIO()
    options = core.ProgramOptions(
        name=str(source), arch=architecture, std="c++17", device_as_default_execution_space=True,
        include_path=[str(source.parent)], define_macro=None if name is None else [("BONDEM_ONLY", name)],
        ptxas_options=["-v"], fma=fused,
    )  # fmt: skip
    compiled = core.Program(source.read_text(), "c++", options).compile("cubin", logs=log)
    return bytes(compiled.code), _registers(log.getvalue())


def _registers(log: str) -> dict[str, Registers]:
    """Read the report of the compiler on each kernel."""
    found = {}
    for part in log.split("Compiling entry function '")[1:]:
        kernel = part.partition("'")[0]
        spilled = re.search(r"(\d+) bytes stack frame, (\d+) bytes spill stores, (\d+) bytes spill loads", part)
        used = re.search(r"Used (\d+) registers", part)
        if spilled is not None and used is not None:
            found[kernel] = Registers(int(used[1]), int(spilled[2]) + int(spilled[3]), int(spilled[1]))
    return found


@cache
def _cached() -> Path:
    """Return the folder of the passes compiled from these sources by this compiler."""
    digest = hashlib.sha256(str(nvrtc.nvrtcVersion()).encode())
    for path in core_sources("*.cpp", "*.hpp", "*.cu"):
        digest.update(path.read_bytes())
    return cache_folder() / "kernels" / digest.hexdigest()[:16]


def _cubin(name: str, architecture: str) -> bytes:
    """Return a compiled pass, from the cache if it is stored there.

    If BONDEM_CUDA_FMA is "off", products and sums are not fused, as on a CPU that cannot do so (BONDEM_ISA=v2).
    """
    fused = os.environ.get("BONDEM_CUDA_FMA") != "off"
    place = _cached() / f"{architecture}.{name}{'' if fused else '.unfused'}.cubin"
    try:
        return place.read_bytes()
    except OSError:
        made, _ = compiled_passes(architecture, name, fused=fused)
    try:
        place.parent.mkdir(parents=True, exist_ok=True)
        with tempfile.NamedTemporaryFile(dir=place.parent, delete=False) as aside:
            aside.write(made)
        os.replace(aside.name, place)
    except OSError:  # a folder that cannot be written to: it is compiled again next time
        pass
    return made


# ---- the device


class CudaDevice:
    """First CUDA device, with its own stream; see `bondem._device.Device`."""

    def __init__(self) -> None:
        self._device = core.Device()
        self._device.set_current()
        self._stream = self._device.create_stream()
        self._architecture = f"sm_{self._device.arch}"
        self._kernels: dict[str, Any] = {}

    @property
    def name(self) -> str:
        """Name of the device."""
        return str(self._device.name)

    def allocate(self, size: int) -> tuple[int, object]:
        """Allocate `size` bytes of zeros; return their address and the object that owns them."""
        memory = self._device.allocate(max(size, 8), stream=self._stream)
        memory.fill(0, stream=self._stream)
        return int(memory.handle), memory

    def send(self, array: np.ndarray, to: int) -> None:
        """Copy a contiguous array to an address of the device."""
        self._copy(array.ctypes.data, to, array.nbytes)

    def fetch(self, source: int, array: np.ndarray) -> None:
        """Copy from an address of the device into a contiguous array, after all launches so far."""
        self._copy(source, array.ctypes.data, array.nbytes)

    def _copy(self, source: int, to: int, size: int) -> None:
        """Copy between the memories of host and device, after all work of the stream."""
        if size:
            there, here = (core.Buffer.from_handle(address, size) for address in (to, source))
            there.copy_from(here, stream=self._stream)
            self._stream.sync()

    def prepared(self, one: Kernel, count: int, tables: Sequence[int], halted: int) -> Enqueue:
        """Return a function that launches a pass over 0 … count - 1; arguments are those of `Device.prepared`."""
        self.compile([one.name])
        kernel, device_stream = self._kernels[one.name], self._stream
        config = core.LaunchConfig(grid=-(-count // _BLOCK), block=_BLOCK)
        arguments = [np.int64(count), np.uint64(halted), *(np.uint64(table) for table in tables)]
        arguments += [np.uint64(0)] * (_TABLES - len(tables))

        def enqueue(stream: Any) -> None:
            core.launch(device_stream if stream is None else stream, config, kernel, *arguments)

        return enqueue

    def compile(self, names: Sequence[str]) -> None:
        """Compile passes by name on several threads, or read them from the cache."""
        lacking = [name for name in dict.fromkeys(names) if name not in self._kernels]
        with ThreadPoolExecutor() as pool:
            made_each = pool.map(lambda name: _cubin(name, self._architecture), lacking)
            for name, made in zip(lacking, made_each, strict=True):
                self._kernels[name] = core.ObjectCode.from_cubin(made, name=name).get_kernel(name)

    def recorded(self, work: Sequence[Enqueue]) -> Callable[[], None]:
        """Return a function that runs launches as a CUDA graph, or singly if BONDEM_CUDA_GRAPHS is "off"."""
        if os.environ.get("BONDEM_CUDA_GRAPHS") == "off":
            return in_sequence(work)
        builder = self._device.create_graph_builder()
        builder.begin_building()
        for enqueue in work:
            enqueue(builder)
        graph = builder.end_building().complete()
        return lambda: graph.launch(self._stream)
