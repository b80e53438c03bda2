"""Compile every kernel that a run launches to PTX without a driver: python tests/cuda_ptx.py prints one JSON object.

Arrays stay on the host, and a launch compiles its kernel for the types of its arguments. Scalar functions are
compiled for "the current device", which must be replaced: by a private name of numba-cuda, one reason for which its
version is pinned.
"""

import json
from types import SimpleNamespace
from typing import Any

import numba
import numba.cuda
import numpy as np
from numba.cuda import dispatcher

import cuda_cases
from bondem.solve import forces_cuda, loop_cuda
from bondem.solve.plan import Plan

CAPABILITY = (9, 0)


class OnHost(np.ndarray):
    """An array that takes itself for one on a device."""

    def copy_to_host(self) -> np.ndarray:
        return np.asarray(self)

    def copy_to_device(self, other: np.ndarray) -> None:
        self[...] = other


def plain(argument: Any) -> Any:
    """An argument, or a table of them, with arrays that numba knows."""
    if isinstance(argument, tuple):
        return type(argument)(*map(plain, argument))
    return np.asarray(argument) if isinstance(argument, OnHost) else argument


def main() -> None:
    dispatcher.get_current_device = lambda: SimpleNamespace(compute_capability=CAPABILITY)
    ptx: dict[str, str] = {}

    def compiled(kernel: Any, count: int, *arguments: Any, stream: Any = 0) -> None:
        name = kernel.py_func.__name__
        if count > 0 and name not in ptx:
            signature = numba.types.void(*map(numba.typeof, map(plain, arguments)))
            ptx[name] = numba.cuda.compile_ptx(kernel.py_func, signature, cc=CAPABILITY)[0]

    for module in (loop_cuda, forces_cuda):
        module.launch = compiled
        module.upload = lambda array: np.array(array, order="C").view(OnHost)
        module.zeros = lambda *shape: np.zeros(shape).view(OnHost)
    loop_cuda.download = lambda array, target: None
    loop_cuda.recorded = lambda work: lambda: work(0)
    loop_cuda.missing = lambda: None
    for model, gauges in (
        (cuda_cases.bar(), cuda_cases.GAUGES), (cuda_cases.cell(), cuda_cases.GAUGES),
        (cuda_cases.held_bar(), cuda_cases.CELL_GAUGES),
    ):  # fmt: skip
        plan = Plan(duration=1.0, gauges=gauges, damping=cuda_cases.bd.LocalDamping(0.1), every=3)
        loop = loop_cuda.GpuLoop(model, plan, cuda_cases.moving(model), 1e-3)
        loop.look()
        loop.run(10)
    print(json.dumps(ptx))


if __name__ == "__main__":
    main()
