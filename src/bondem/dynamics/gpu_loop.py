"""The loop of a run on a GPU."""

from bondem import _cuda
from bondem.dynamics.device_loop import DeviceLoop, device_has
from bondem.dynamics.plan import Loop, Plan
from bondem.errors import InputError
from bondem.model.model import Model
from bondem.model.state import State


def require_gpu(model: Model, plan: Plan) -> None:
    """Check that a model can run on a GPU, and that there is one.

    Raises:
        InputError: a feature runs on the CPU only, or there is no device.
        ImportError: a package is missing.
    """
    if not device_has(model):
        raise InputError(f"device='gpu' does not run {_special(model)}; use device='cpu'")
    reason = _cuda.lacks_gpu()
    if reason is not None:
        raise InputError(f"device='gpu': {reason}")


def loop_on_gpu(model: Model, plan: Plan, state: State, dt: float) -> Loop:
    """Make the loop of a run on the first GPU."""
    return DeviceLoop(model, plan, state, dt, _cuda.CudaDevice())


def _special(model: Model) -> str:
    """Return the features of a model that only some devices have."""
    table = model.softening
    features = {
        "cells that yield": table is not None and table.slip is not None,
        "material planes": table is not None and bool(table.plane.any()),
        "facets that crack under strains that change": table is not None and len(model.constraints.strain_part) > 0,
    }
    return ", ".join(name for name, there in features.items() if there) or f"{len(model.layout.i)} bonds"
