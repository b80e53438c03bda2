"""Compile every kernel that a run launches to PTX without a driver: python tests/cuda_ptx.py prints them as JSON.

Beside them stands what the arrays of a bond and of an element take on a device.

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

import bondem as bd
import cuda_facets
import cuda_soft_beams
import cuda_yielding
import device_cases
from bondem.solve import beam_softening_cuda, breakage_cuda, cracks_cuda, forces_cuda, loop_cuda
from bondem.solve.plan import Plan

CAPABILITY = (9, 0)
RANKINE = bd.Rankine(tension=2e5, fracture_energy=1e4, friction=0.5)


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

    uploaded: list[np.ndarray] = []

    def kept(array: np.ndarray) -> np.ndarray:
        uploaded.append(np.array(array, order="C").view(OnHost))
        return uploaded[-1]

    for module in (loop_cuda, forces_cuda, breakage_cuda, cracks_cuda, beam_softening_cuda):
        module.launch = compiled
        module.upload = kept
        module.zeros = lambda *shape: kept(np.zeros(shape))
    loop_cuda.download = lambda array, target: None
    loop_cuda.recorded = lambda work: lambda: work(0)
    loop_cuda.missing = lambda: None
    sizes: dict[str, dict[str, float]] = {}
    for name, model, gauges in (
        ("bonds", device_cases.bar(), device_cases.GAUGES), ("alike", device_cases.cell(), device_cases.INNER_GAUGES),
        ("breaking", device_cases.breaking_bar(device_cases.CRITERIA["peripheral"]), device_cases.GAUGES),
        ("cells", device_cases.held_bar(), device_cases.CELL_GAUGES),
        ("breaking cells", cuda_facets.held_bar(), device_cases.CELL_GAUGES),
        ("softening", cuda_soft_beams.softening_bar(cuda_soft_beams.CRITERIA["peripheral"]), device_cases.GAUGES),
        (
            "yielding cells", cuda_facets.breaking(device_cases.held_bar(), cuda_yielding.CONE),
            device_cases.CELL_GAUGES,
        ),
        ("cracking cells", cuda_facets.breaking(device_cases.held_bar(), RANKINE), device_cases.CELL_GAUGES),
    ):  # fmt: skip
        uploaded.clear()
        loop_cuda.GpuLoop(model, Plan(duration=1.0), device_cases.moving(model), 1e-3)
        n, m = len(model.mass), len(model.lattice.pairs)
        sizes[name] = {
            "element": bytes_of_each(uploaded, n, n + 1),
            "bond": bytes_of_each(uploaded, m) + 2 * bytes_of_each(uploaded, 2 * m),  # cracks have two halves
        }
        if model.cells is not None:
            sizes[name]["held facet"] = bytes_of_each(uploaded, len(model.cells.grips.cell))
        plan = Plan(duration=1.0, gauges=gauges, damping=bd.LocalDamping(0.1), every=3)
        loop = loop_cuda.GpuLoop(model, plan, device_cases.moving(model), 1e-3)
        loop.look()
        loop.look()  # now the acceleration is known
        loop.run(10)
    print(json.dumps({"ptx": ptx, "bytes": sizes}))


def bytes_of_each(arrays: list[np.ndarray], *counts: int) -> float:
    """Of all arrays with as many entries along an axis as one of these counts."""
    shared = [(array.nbytes, set(counts) & set(array.shape)) for array in arrays]
    return sum(size / found.pop() for size, found in shared if found)


if __name__ == "__main__":
    main()
