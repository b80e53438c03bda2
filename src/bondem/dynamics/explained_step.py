"""Explanation of one step of an explicit run: its passes, with the purpose of each."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from bondem._checks import instance
from bondem._core import step_pass
from bondem._passes import steps
from bondem._tables.columns import HistoryColumn
from bondem._tables.step_tables import HistoryRows
from bondem.boundary.gauges import AnyGauge
from bondem.dynamics.damping import AnyDamping
from bondem.dynamics.parts.parts_of_model import parts_in_one_block
from bondem.dynamics.plan import Plan
from bondem.dynamics.restart import begin
from bondem.interactions.step_part import STAGES, composed
from bondem.model.model import Model
from bondem.model.state import State

__all__ = ["ExplainedPass", "ExplainedStep", "explain_step"]

# Description of the row of the history that all parts write after the last stage.
_RECORD = {"record": "a row of the history, every `every` steps"}


class ExplainedPass(NamedTuple):
    """Description of one pass of a step."""

    stage: str  #: stage of the step that it belongs to
    name: str  #: name in the core
    over: str  #: items that the pass runs over
    purpose: str  #: purpose of the pass, as a sentence


@dataclass(frozen=True)
class ExplainedStep:
    """The passes of one step of an explicit run; `print` shows them by stage.

    Attributes:
        passes: stage, name, range and purpose of each, in the order of the step.
    """

    passes: tuple[ExplainedPass, ...]

    def __str__(self) -> str:
        lines = []
        for stage, words in {**STAGES, **_RECORD}.items():
            of_stage = [one for one in self.passes if one.stage == stage]
            lines += [f"{stage}: {words}"] if of_stage else []
            lines += [f"    {one.name} ({one.over})\n        {one.purpose}" for one in of_stage]
        return "\n".join(lines)


def explain_step(
    model: Model, *, damping: AnyDamping | tuple[AnyDamping, ...] | None = None,
    gauges: Mapping[str, AnyGauge] | None = None, state: State | None = None,
) -> ExplainedStep:  # fmt: skip
    """Return the passes that the core calls in one step of `solve_explicit`, with the purpose of each.

    The step is composed from a state as in a run, and none of its passes is called. The step of a model
    without contact, for example, has no pass of contact.

    Args:
        model: model of the run.
        damping: damping of the run, as for `solve_explicit`; none by default.
        gauges: gauges of the run, as for `solve_explicit`; none by default.
        state: state that the run would begin from; at rest by default. It is not changed.

    Raises:
        InputError: A value is invalid, or the state belongs to another model.
    """
    instance("explain_step", "model", model, Model, "bd.Model(...)")
    if state is not None:
        instance("explain_step", "state", state, State, "the state of a run, or model.state()")
    plan = Plan(duration=0.0, damping=damping, gauges={} if gauges is None else gauges)
    # the length of a step is a number in tables of contacts and cracks, and selects no pass
    _, parts = parts_in_one_block(model, plan, begin(model, state), 0.0)
    row = HistoryRows(np.zeros((1, HistoryColumn.COUNT + 3 * len(plan.gauges))))
    names = [(stage, one.name) for stage in STAGES for one in composed(parts, stage)]
    names += [("record", one.name) for part in parts for one in part.record(row)]
    return ExplainedStep(
        tuple(ExplainedPass(stage, name, steps.KINDS[step_pass(name)[0][1]], _purpose(name)) for stage, name in names)
    )


def _purpose(name: str) -> str:
    """Return the sentence on the purpose of a pass."""
    return " ".join((getattr(steps, name).__doc__ or "").partition("\n\n")[0].split())
