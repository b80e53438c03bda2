"""Parts of a time step: the passes for one subject, such as contact, sorted by the stages of the step.

A pass is a function of the compiled core. A step runs the stages in order; each stage runs the passes of all parts
for it, in the order of the parts. A model has no part for a subject that it lacks.
"""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field

from bondem._passes import StepEntry
from bondem._tables.step_tables import HistoryRows

#: Passes with their tables, in the order in which the core calls them.
Passes = list[StepEntry]

#: Stages of forces and motion, in the order of a step, and what each does.
FORCES = {
    "contacts": "forces of contacts and walls",
    "prepare": "quantities of elements that bonds need",
    "stress": "stresses of elements, from all that the passes before have added",
    "constrain": "walls and conditions that depend on these stresses",
    "loads": "forces of bonds; marks bonds near to failure",
    "judge": "finds which marked bonds fail",
    "gather": "sums of the elements that domains share",
    "add": "further forces on elements",
    "correct": "forces that depend on the sums of all others",
    "keep": "sums of the elements that a failure delays",
    "move": "closes the step of elements, and opens the next one",
    "settle": "works and losses of the motion",
    "apply": "failure of bonds, after the motion",
    "hand_over": "contact where bonds have failed",
}
#: Stages of elements that a failure has delayed.
RESUME = {
    "resume": "elements that a failure has delayed find their acceleration",
    "reopening": "elements that a failure has delayed open the next step",
}
#: All stages of parts, in the order of a step.
STAGES = {
    "begin": "once, as a run begins",
    "opening": "elements open a step after a pause for a record or a guard",
    "travel": "walls move; lists of contacts may be out of date",
    "present": "boundary conditions at the present time",
    **FORCES,
    **RESUME,
    "guard": "whether the run is sound, every 100 steps",
}


def _nothing(_: HistoryRows) -> Passes:
    return []


def _keep_nothing() -> None:
    pass


@dataclass(frozen=True, eq=False)
class Part:
    """Passes of one subject, such as contact, in a time step.

    Attributes:
        stages: passes by stage, a name in `STAGES`; other names raise ValueError.
        record: function that returns the passes that write a row of the history.
        keep: function to call after each call of the core, which writes data of the passes into the state.
        renewed: function that returns the part with a new list of contacts, or None if a centre is not finite; None
            for a part without such a list.
        kinetic: passes that correct the kinetic energies of elements, before these are written or examined.
    """

    stages: Mapping[str, Passes]
    record: Callable[[HistoryRows], Passes] = field(default=_nothing)
    keep: Callable[[], None] = field(default=_keep_nothing)
    renewed: "Callable[[], Part | None] | None" = None
    kinetic: Passes = field(default_factory=list)

    def __post_init__(self) -> None:
        unknown = set(self.stages) - set(STAGES)
        if unknown:
            raise ValueError(f"stages {sorted(unknown)} do not exist")


def composed(parts: Iterable[Part], *stages: str) -> Passes:
    """Return the passes of given stages one after the other, each in the order of the parts."""
    parts = list(parts)
    return [one for stage in stages for part in parts for one in part.stages.get(stage, [])]
