"""What machine code is made of compiled functions, and whose copies of other functions it calls.

Numba makes machine code of every compiled function, and once more of all that is linked into what calls it. Of a loop
that Python never calls the first is for nothing: it is kept as what others are linked from.

The copies that are linked into a function stay visible to others, and the first copy of a name that a process loads
serves all that call this name. A copy that was optimised once more can differ by the last bit of a sum, and which one
is first hangs on what was compiled, what came from the cache and in which order: each function calls its own here.
"""

from typing import Any

import llvmlite.binding as llvm
from numba.core.codegen import JITCodeLibrary

from bondem._pruning import Pruned

__all__ = ["InlinedOnly", "LaunchingOnly", "LinkedOnly", "OwnCopies"]

# What numba sets when it loads a function, by this prefix of its name.
_ENVIRONMENT = "_ZN08NumbaEnv"
# How copies are visible: of functions, and of what threads are handed.
_SHARED = llvm.Linkage.linkonce_odr, llvm.Linkage.weak_odr


class _Own(JITCodeLibrary):
    """A library that calls its own copies of what is linked into it."""

    _final_module: Any
    _codegen: Any

    def _finalize_final_module(self) -> None:
        if self._shared_module is None:  # not one that comes from the cache
            self._finalized = True  # as far as others are concerned, who link this
            self._get_module_for_linking()
            self._finalized = False
            self._keep_to_itself()
        super()._finalize_final_module()

    def _keep_to_itself(self) -> None:
        """Nobody else sees the copies; others link the module that was made for that."""
        if self._shared_module is self._final_module:
            self._final_module = self._final_module.clone()
        for function in self._final_module.functions:
            if not function.is_declaration and function.linkage in _SHARED:
                function.linkage = "internal"


class _Linked(_Own):
    """A library whose functions others take in; what is compiled of it is its environment alone."""

    def _keep_to_itself(self) -> None:
        self._finalize_dynamic_globals()
        self._verify_declare_only_symbols()
        self._final_module = self._environment()

    def _environment(self) -> Any:
        """A module of the environments."""
        kept = [str(one) for one in self._final_module.global_variables if one.name.startswith(_ENVIRONMENT)]
        text = "\n".join([str(self._codegen._create_empty_module(self.name)), *kept])
        module = llvm.parse_assembly(text)
        module.name = self._final_module.name
        return module


class _Launching(_Linked):
    """The same of a loop on threads: its work is in functions of their own, and what calls it optimises the rest.

    Numba takes the arrays of all tables apart for the threads, which a function pass takes seconds over.
    """

    def _optimize_functions(self, ll_module: Any) -> None:
        ll_module.data_layout = self._codegen._data_layout


class _Inlined(_Linked):
    """The same of functions that vanish in what calls them, which optimises all of it."""

    def _optimize_final_module(self) -> None:
        """Nothing."""


class OwnCopies(Pruned):
    """The compiler of functions that Python calls."""

    _library: type[JITCodeLibrary] = _Own

    def define_pipelines(self) -> list[Any]:
        """The passes of one function."""
        state: Any = self.state
        library = state.targetctx.codegen().create_library(state.func_id.func_qualname)
        library.__class__ = self._library
        library.enable_object_caching()
        state["library"] = library
        return super().define_pipelines()


class LinkedOnly(OwnCopies):
    """The compiler of loops that only other loops call."""

    _library = _Linked


class LaunchingOnly(OwnCopies):
    """The compiler of loops on threads that only other loops call."""

    _library = _Launching


class InlinedOnly(OwnCopies):
    """The compiler of functions that are always inlined."""

    _library = _Inlined
