"""Addresses of arrays, and of Python functions of users that the core calls as C functions.

The core calls a function of stresses once per step, on the thread that called the core, and only if there are
stresses to evaluate (`core/passes/damage/stress_criteria.hpp`).
"""

import ctypes
from collections.abc import Callable
from typing import Any

import numpy as np

__all__ = ["StressCallback", "address_of"]

_NOTHING = ctypes.c_char * 0

_KIND = ctypes.CFUNCTYPE(
    None, ctypes.c_int64, ctypes.POINTER(ctypes.c_double), ctypes.POINTER(ctypes.c_double),
    ctypes.POINTER(ctypes.c_double),
)  # fmt: skip


class StressCallback:
    """Python function of stresses as a C function.

    The function is called with stresses (k, 3, 3) [Pa] and with each parameter, and returns k indices. After an error
    in the function all indices are 0, without further calls, until `check` raises the error.

    Args:
        function: function of stresses and of the parameters.
        count: number of parameters.

    Attributes:
        address: address of the C function; valid as long as this object lives.
    """

    def __init__(self, function: Callable[..., Any], count: int) -> None:
        self._function, self._count = function, count
        self._error: BaseException | None = None
        self._callback = _KIND(self._call)
        self.address = int(ctypes.cast(self._callback, ctypes.c_void_p).value or 0)

    def _call(self, count: int, stress: Any, parameter: Any, index: Any) -> None:
        found = np.ctypeslib.as_array(index, (count,))
        found[:] = 0.0
        if self._error is not None:
            return
        try:
            given = np.ctypeslib.as_array(parameter, (self._count,)).tolist() if self._count else []
            with np.errstate(all="ignore"):
                found[:] = self._function(np.ctypeslib.as_array(stress, (count, 3, 3)).copy(), *given)
        except BaseException as error:  # nothing may pass through the core, not even an interruption
            self._error = error

    def check(self) -> None:
        """Raise the error that the function has raised since the last check."""
        error, self._error = self._error, None
        if error is not None:
            raise error


def address_of(array: Any) -> int:  # NumPy does not declare the buffer protocol for Python 3.11
    """Return the address of the numbers of a contiguous array, in a third of the time of `array.ctypes.data`."""
    return ctypes.addressof(_NOTHING.from_buffer(array)) if array.flags.writeable else array.ctypes.data
