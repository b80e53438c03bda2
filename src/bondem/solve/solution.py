"""What every solver gives back beside its solution."""

from dataclasses import dataclass
from enum import Enum


class Status(Enum):
    """How a solution ended. What has not converged is no solution: it raises `ConvergenceError`."""

    COMPLETED = "completed"
    STOPPED = "stopped by an event"
    UNSTABLE = "unstable"
    IMBALANCED = "stopped by its energy balance"

    @property
    def failed(self) -> bool:
        """Whether the end of the run is no result: it became unstable, or its energy balance was lost."""
        return self in (Status.UNSTABLE, Status.IMBALANCED)


@dataclass(frozen=True, eq=False, kw_only=True)
class Solution:
    """What all solutions say of themselves; each adds what was asked for.

    Attributes:
        status: how it ended.
        iterations: steps of the method: time steps, Newton's, of conjugate gradients; 1 for an elimination.
        residual: what is left of the equations, as a share of their terms [-]; each solution says of which.
    """

    status: Status = Status.COMPLETED
    iterations: int
    residual: float
