"""What compiled code calls of its own accord: functions of a user by their address, and choices without a branch."""

import functools
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numba
import numba.core.config
from llvmlite import ir
from numba.core import types
from numba.extending import intrinsic
from numba.np.numpy_support import carray
from numba.np.unsafe.ndarray import to_fixed_tuple

__all__ = ["Callback", "callback", "called", "picked"]

# set by numba at import, so that type checkers do not know its attributes
config: Any = numba.core.config


@dataclass(frozen=True, eq=False)
class Callback:
    """A function compiled by itself, which loops call by its address: none of them is compiled for it.

    Attributes:
        address: of a C function of two pointers, to nine numbers and to the parameters, that returns a number.
        function: the same for Python, of a matrix (3, 3) and each parameter.
        kept: what must live as long as the address is used.
    """

    address: int
    function: Callable[..., Any]
    kept: Any


@functools.cache  # for good: addresses stand in the tables of models
def callback(function: Callable[..., Any], count: int) -> Callback:
    """Compile a function of a matrix (3, 3) and of `count` numbers, which returns a number.

    Raises:
        Exception: of any kind, where it cannot be compiled.
    """
    if config.DISABLE_JIT:  # in the simulator of a device, which calls no address
        return Callback(address=1, function=getattr(function, "py_func", function), kept=None)
    inner: Any = numba.njit(error_model="numpy")(getattr(function, "py_func", function))
    spread: Any = to_fixed_tuple
    if count:

        def outer(matrix: Any, given: Any) -> Any:
            return inner(carray(matrix, (3, 3)), *spread(carray(given, (count,)), count))
    else:

        def outer(matrix: Any, given: Any) -> Any:
            return inner(carray(matrix, (3, 3)))

    pointer = types.CPointer(types.float64)
    made: Any = numba.cfunc(types.float64(pointer, pointer), error_model="numpy")(outer)
    return Callback(address=int(made.address), function=inner, kept=made)


def _called(_: Any, address: Any, matrix: Any, given: Any) -> Any:
    """In compiled code: what the function at an address (`Callback`) gives for two contiguous arrays of numbers."""

    def build(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        pointer = ir.DoubleType().as_pointer()
        kind = ir.FunctionType(ir.DoubleType(), [pointer, pointer])
        data = [
            context.make_array(of)(context, builder, value).data
            for of, value in zip(signature.args[1:], arguments[1:], strict=True)
        ]
        return builder.call(builder.inttoptr(arguments[0], kind.as_pointer()), data)

    return types.float64(types.int64, matrix, given), build


called: Any = intrinsic(_called)


def _picked(_: Any, value: Any, one: Any, other: Any) -> Any:
    """In compiled code: `one` where a number, or each of many in one register, is above zero, else `other`.

    Both are computed, so that a function without branches is compiled for one number and for many.
    """
    kinds = value, one, other
    many = next((kind for kind in kinds if kind != types.float64), types.float64)

    def build(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        kind = next((a.type for a in arguments if isinstance(a.type, ir.VectorType)), ir.DoubleType())
        found = [a if a.type == kind else _spread(builder, a, kind) for a in arguments]
        return builder.select(builder.fcmp_ordered(">", found[0], ir.Constant(kind, None)), found[1], found[2])

    return many(*kinds), build


def _spread(builder: Any, value: Any, kind: Any) -> Any:
    """One number in each place of a vector."""
    index, size = ir.IntType(32), kind.count
    first = builder.insert_element(ir.Constant(kind, ir.Undefined), value, ir.Constant(index, 0))
    return builder.shuffle_vector(first, first, ir.Constant(ir.VectorType(index, size), [0] * size))


picked: Any = intrinsic(_picked)
