"""Loops that only other loops call: kept as what they are linked from, without machine code of their own.

Numba makes machine code of every compiled function, and once more of all that is linked into what calls it. Of a loop
that Python never calls the first is for nothing.
"""

from typing import Any

import llvmlite.binding as llvm
from numba.core.codegen import JITCodeLibrary

from bondem._pruning import Pruned

__all__ = ["InlinedOnly", "LinkedOnly"]

# What numba sets when it loads a function, by this prefix of its name.
_ENVIRONMENT = "_ZN08NumbaEnv"


class _Linked(JITCodeLibrary):
    """A library whose functions others take in; what is compiled of it is its environment alone."""

    _final_module: Any
    _codegen: Any

    def _finalize_final_module(self) -> None:
        if self._shared_module is None:  # not one that comes from the cache
            self._finalize_dynamic_globals()
            self._verify_declare_only_symbols()
            self._finalized = True  # as far as others are concerned, who link this
            self._get_module_for_linking()
            self._finalized = False
            self._final_module = self._environment()
        super()._finalize_final_module()

    def _environment(self) -> Any:
        """A module of the environments."""
        kept = [str(one) for one in self._final_module.global_variables if one.name.startswith(_ENVIRONMENT)]
        text = "\n".join([str(self._codegen._create_empty_module(self.name)), *kept])
        module = llvm.parse_assembly(text)
        module.name = self._final_module.name
        return module


class _Inlined(_Linked):
    """The same of functions that vanish in what calls them, which optimises all of it."""

    def _optimize_final_module(self) -> None:
        """Nothing."""


class LinkedOnly(Pruned):
    """The compiler of such loops."""

    _library: type[JITCodeLibrary] = _Linked

    def define_pipelines(self) -> list[Any]:
        """The passes of one function."""
        state: Any = self.state
        library = state.targetctx.codegen().create_library(state.func_id.func_qualname)
        library.__class__ = self._library
        library.enable_object_caching()
        state.library = library
        return super().define_pipelines()


class InlinedOnly(LinkedOnly):
    """The compiler of functions that are always inlined."""

    _library = _Inlined
