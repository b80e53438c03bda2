"""Common part of the results of explicit, static and modal solutions."""

from dataclasses import dataclass
from enum import Enum


class Status(Enum):
    """Outcome of a solution. A solver that does not converge has no outcome: it raises `ConvergenceError`."""

    COMPLETED = "completed"
    STOPPED = "stopped by an event"
    UNSTABLE = "unstable"
    IMBALANCED = "stopped by its energy balance"

    @property
    def failed(self) -> bool:
        """True if the run gives no result, because it became unstable or lost its energy balance."""
        return self in (Status.UNSTABLE, Status.IMBALANCED)


@dataclass(frozen=True, eq=False, kw_only=True)
class Solution:
    """Common part of the results of `solve_explicit`, `solve_static` and `solve_modes`.

    Attributes:
        status: outcome of the solution.
        iterations: number of time steps, or of iterations of the solver; 1 for elimination.
        residual: residual of the equations, relative to their terms [-]; each type of solution defines it.
    """

    status: Status = Status.COMPLETED
    iterations: int
    residual: float
