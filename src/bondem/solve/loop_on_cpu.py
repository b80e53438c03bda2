"""The loop of a run on the CPU: by the core, or by Numba for what the core does not have yet."""

from bondem.model.model import Model
from bondem.model.state import State
from bondem.solve.loop_core import CoreLoop, core_has
from bondem.solve.loop_cpu import CpuLoop
from bondem.solve.plan import Loop, Plan


def loop_on_cpu(model: Model, plan: Plan, state: State, dt: float) -> Loop:
    """Make the loop of a run: that of the core where it has all passes of the model."""
    kind = CoreLoop if core_has(model) else CpuLoop
    return kind(model, plan, state, dt)
