"""The loop of a run on a GPU: by the core, or by numba-cuda for what the core does not have there yet."""

import importlib
from typing import Any

from bondem import _cuda
from bondem.errors import InputError
from bondem.model.model import Model
from bondem.model.state import State
from bondem.solve.loop_device import DeviceLoop, device_has
from bondem.solve.plan import Loop, Plan


def require_gpu(model: Model, plan: Plan) -> None:
    """Check that a model can run on a GPU, and that there is one.

    Raises:
        InputError: a feature runs on the CPU only, or there is no device.
        ImportError: a package is missing.
    """
    if not device_has(model):
        _older().require_runnable(model, plan)
    reason = _cuda.lacks_gpu()
    if reason is not None:
        raise InputError(f"device='gpu': {reason}")


def loop_on_gpu(model: Model, plan: Plan, state: State, dt: float) -> Loop:
    """Make the loop of a run: that of the core where each of its passes has a counterpart on a device."""
    if device_has(model):
        return DeviceLoop(model, plan, state, dt, _cuda.CudaDevice())
    return _older().GpuLoop(model, plan, state, dt)


def _older() -> Any:
    """The loop by numba-cuda, which is a package of its own."""
    return importlib.import_module("bondem.solve.loop_cuda")
