"""Branches on None that are decided while a function is compiled, whether the argument is None or not.

Numba decides `if table is None` while it compiles where the argument is None. Where it is not, it compiles both
branches, which for the step of a body of cells would be that of bonds as well, and leaves the choice to LLVM.
"""

from typing import Any

from numba.core import types
from numba.core.analysis import dead_branch_prune
from numba.core.compiler import CompilerBase, DefaultPassBuilder
from numba.core.compiler_machinery import FunctionPass, register_pass
from numba.core.untyped_passes import DeadBranchPrune

__all__ = ["Pruned"]

# Types that may stand for None, or that numba knows the value of.
_OPEN = types.NoneType, types.Omitted, types.Optional, types.Literal


class _Present:
    """Stands for the type of an argument that is no None: numba asks what it knows of a value for `literal_type`."""

    def __init__(self, of: Any) -> None:
        self.literal_type = of


@register_pass(mutates_CFG=True, analysis_only=False)
class _PrunePresent(FunctionPass):
    _name = "prune_present"

    def __init__(self) -> None:  # numba's own, which does not name itself
        FunctionPass.__init__(self)

    def run_pass(self, state: Any) -> Any:
        dead_branch_prune(state.func_ir, [t if isinstance(t, _OPEN) else _Present(t) for t in state.args])
        return True


class Pruned(CompilerBase):
    """Numba's compiler with the pass above."""

    def define_pipelines(self) -> list[Any]:
        """The passes of one function."""
        passes = DefaultPassBuilder.define_nopython_pipeline(self.state)
        passes.add_pass_after(_PrunePresent, DeadBranchPrune)
        passes.finalize()
        return [passes]
