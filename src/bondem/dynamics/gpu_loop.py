"""The loop of a run on a GPU. A device carries out whatever the CPU does (`bondem.dynamics.on_device`)."""

from bondem import _cuda
from bondem.dynamics.device_loop import DeviceLoop
from bondem.dynamics.plan import Loop, Plan
from bondem.errors import InputError
from bondem.model.model import Model
from bondem.model.state import State

# Bonds from which on their numbers, and those of the halves of cracks, need more than 32 bits.
_MOST_BONDS, _MOST_FACETS = 2**31, 2**30 - 1


def require_gpu(model: Model) -> None:
    """Check that a model fits the tables of a GPU, and that there is one.

    Raises:
        InputError: a model of too many bonds, or there is no device.
        ImportError: a package is missing.
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
