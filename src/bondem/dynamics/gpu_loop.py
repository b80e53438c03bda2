"""Loop of a run on a GPU, which supports every model that the CPU runs (`bondem.dynamics.on_device`)."""

from bondem import _cuda
from bondem.dynamics.device_loop import DeviceLoop
from bondem.dynamics.plan import Loop, Plan
from bondem.errors import InputError
from bondem.model.model import Model
from bondem.model.state import State

# Bounds of the numbers of bonds, and of facets that may crack: indices of bonds and of halves of cracks have 32 bits.
_MOST_BONDS, _MOST_FACETS = 2**31, 2**30 - 1


def require_gpu(model: Model) -> None:
    """Check that a GPU is available and can index the bonds of a model.

    Raises:
        InputError: The model has too many bonds, or no device or driver was found.
    """
    count, most = len(model.layout.i), _MOST_BONDS if model.softening is None else _MOST_FACETS
    if count >= most:
        raise InputError(f"device='gpu' runs fewer than {most} bonds, not {count}; use device='cpu'")
    reason = _cuda.lacks_gpu()
    if reason is not None:
        raise InputError(f"device='gpu': {reason}")


def loop_on_gpu(model: Model, plan: Plan, state: State, dt: float) -> Loop:
    """Make the loop of a run on the first GPU."""
    return DeviceLoop(model, plan, state, dt, _cuda.CudaDevice())
