"""Passes that Python calls, of `core/steps.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import Call
from bondem._tables.step_tables import Ledger, StepBlocks, StepPasses, StepScheme, StepSpan


def take_steps(
    step_passes: StepPasses, step_blocks: StepBlocks, step_scheme: StepScheme, step_span: StepSpan, ledger: Ledger
) -> Call:
    """Takes the steps of a span, or records the present state without a step; returns how the call has ended."""
    return Call("take_steps", (step_passes, step_blocks, step_scheme, step_span, ledger))
