"""Several numbers in one register: what a loop takes where it says so, instead of hoping that it is vectorised.

`Lanes` is a number to Numba. It knows + - * /, min, max and negation, among themselves and with floats, square root,
absolute value and rounding, each as one or two packed instructions of LLVM, so that a scalar `@device` function
compiles for it unchanged, and gives in each lane the bits it gives for one number.

How they come from memory and go back is in `bondem.kernels.lane_memory`.

WIDTH is what fits the registers of this CPU (`bondem._compile.LANES`): no result depends on it.
"""

import math
import operator
from collections.abc import Callable
from typing import Any

import numpy as np
from llvmlite import ir
from numba.core import cgutils, types
from numba.core.typing import templates
from numba.core.typing.templates import AbstractTemplate, signature
from numba.extending import intrinsic, lower_builtin, models, register_model

from bondem._compile import LANES as WIDTH
from bondem._compile import device

__all__ = [
    "WIDTH", "LanesType", "all_below", "dot", "fused", "instruction", "lane", "lanes", "put_lane",
    "reached", "shuffled", "sign", "vector", "where_positive", "zero_of",
]  # fmt: skip

# type checkers know numba's decorators for something else
instruction: Any = intrinsic
infer_global: Any = templates.infer_global
_DOUBLE, _INDEX = ir.DoubleType(), ir.IntType(32)
vector = ir.VectorType(_DOUBLE, WIDTH)


class LanesType(types.Type):
    """Numba's type of WIDTH numbers."""

    def __init__(self) -> None:
        super().__init__(name=f"Lanes{WIDTH}")


lanes = LanesType()
place = types.UniTuple(types.uint64, WIDTH)


@register_model(LanesType)
class _LanesModel(models.PrimitiveModel):
    def __init__(self, manager: Any, kind: Any) -> None:
        super().__init__(manager, kind, vector)


def shuffled(builder: Any, a: Any, b: Any, order: list[int]) -> Any:
    """Numbers of two vectors in another order, those of the second counted after those of the first."""
    return builder.shuffle_vector(a, b, ir.Constant(ir.VectorType(_INDEX, len(order)), order))


def _splat(builder: Any, value: Any) -> Any:
    if isinstance(value.type, ir.VectorType):
        return value
    one = builder.insert_element(ir.Constant(vector, ir.Undefined), value, ir.Constant(_INDEX, 0))
    return shuffled(builder, one, one, [0] * WIDTH)


def _teach_operator(function: Any, instruction: Callable[[Any, Any, Any], Any]) -> None:
    @infer_global(function)
    class Template(AbstractTemplate):
        def generic(self, args: tuple, kws: dict) -> Any:
            if len(args) != 2 or lanes not in args:
                return None
            return signature(lanes, *(arg if arg is lanes else types.float64 for arg in args))

    def lower(context: Any, builder: Any, sig: Any, args: tuple) -> Any:
        return instruction(builder, *(_splat(builder, arg) for arg in args))

    for pair in ((lanes, lanes), (lanes, types.float64), (types.float64, lanes)):
        lower_builtin(function, *pair)(lower)


def _teach_function(function: Any, lower: Callable[[Any, Any], Any]) -> None:
    @infer_global(function)
    class Template(AbstractTemplate):
        def generic(self, args: tuple, kws: dict) -> Any:
            return signature(lanes, lanes) if args == (lanes,) else None

    lower_builtin(function, lanes)(lambda context, builder, sig, args: lower(builder, args[0]))


def _instruction(name: str) -> Callable[[Any, Any], Any]:
    kind = ir.FunctionType(vector, [vector])

    def lower(builder: Any, value: Any) -> Any:
        function = cgutils.get_or_insert_function(builder.module, kind, f"{name}.v{WIDTH}f64")
        return builder.call(function, [value])

    return lower


def _better(order: str) -> Callable[[Any, Any, Any], Any]:
    """The second where it stands in this order to the first, else the first, as Python has it."""
    return lambda builder, a, b: builder.select(builder.fcmp_ordered(order, b, a), b, a)


def _word(name: str) -> Callable[[Any, Any, Any], Any]:
    return lambda builder, a, b: getattr(builder, name)(a, b)


for _name, _instruction_name in (("add", "fadd"), ("sub", "fsub"), ("mul", "fmul"), ("truediv", "fdiv")):
    _teach_operator(getattr(operator, _name), _word(_instruction_name))
    _teach_operator(getattr(operator, f"i{_name}"), _word(_instruction_name))
_teach_operator(min, _better("<"))
_teach_operator(max, _better(">"))
_teach_function(operator.neg, lambda builder, value: builder.fneg(value))
_teach_function(math.sqrt, _instruction("llvm.sqrt"))
_teach_function(math.fabs, _instruction("llvm.fabs"))
_teach_function(np.rint, _instruction("llvm.rint"))


def _constant(value: float) -> Any:
    return ir.Constant(vector, [value] * WIDTH)


@instruction
def sign(typingctx, value):
    """-1, 0 or 1 as a number, or each of many, is below, at or above zero; 0 for one that is none."""
    if value not in (lanes, types.float64):
        return None

    def generate(context, builder, sig, args):
        zero, one = ir.Constant(args[0].type, None), context.get_constant(types.float64, 1.0)
        minus = context.get_constant(types.float64, -1.0)
        if sig.args[0] is lanes:
            zero, one, minus = _constant(0.0), _constant(1.0), _constant(-1.0)
        below = builder.select(builder.fcmp_ordered("<", args[0], zero), minus, zero)
        return builder.select(builder.fcmp_ordered(">", args[0], zero), one, below)

    return value(value), generate


@instruction
def where_positive(typingctx, value, above, else_):
    """One number where another is above zero, else a third; or the same in every lane."""
    if not (value in (lanes, types.float64) and value == above == else_):
        return None

    def generate(context, builder, sig, args):
        zero = ir.Constant(args[0].type, [0.0] * WIDTH if sig.args[0] is lanes else 0.0)
        return builder.select(builder.fcmp_ordered(">", args[0], zero), args[1], args[2])

    return value(value, above, else_), generate


@instruction
def fused(typingctx, a, b, c):
    """a b + c with one rounding, of numbers or of many: where the bits must not depend on which product is fused."""
    if not (a is b is c or a == b == c):
        return None

    def generate(context, builder, sig, args):
        one = args[0].type
        name = f"llvm.fma.v{WIDTH}f64" if sig.args[0] is lanes else "llvm.fma.f64"
        function = cgutils.get_or_insert_function(builder.module, ir.FunctionType(one, [one] * 3), name)
        return builder.call(function, args)

    return c(a, b, c), generate


@instruction
def all_below(typingctx, value, limit):
    """Whether a number, or all of many, are below another."""

    def generate(context, builder, sig, args):
        if sig.args[0] is not lanes:
            return builder.fcmp_ordered("<", *args)
        bits = ir.IntType(WIDTH)
        below = builder.bitcast(builder.fcmp_ordered("<", args[0], _splat(builder, args[1])), bits)
        return builder.icmp_unsigned("==", below, ir.Constant(bits, 2**WIDTH - 1))

    return types.boolean(value, types.float64), generate


@instruction
def reached(typingctx, value, limit):
    """Which of many reach the limits of each, as bits, the first the lowest."""
    if not (value is lanes and limit is lanes):
        return None

    def generate(context, builder, sig, args):
        bits = builder.bitcast(builder.fcmp_ordered(">=", *args), ir.IntType(WIDTH))
        return builder.zext(bits, ir.IntType(64))

    return types.int64(value, limit), generate


@instruction
def lane(typingctx, value, n):
    """One of many, or the number itself."""

    def generate(context, builder, sig, args):
        return builder.extract_element(*args) if sig.args[0] is lanes else args[0]

    return types.float64(value, types.int64), generate


@instruction
def put_lane(typingctx, value, n, one):
    """Many, one of them replaced; or the other number."""

    def generate(context, builder, sig, args):
        return builder.insert_element(args[0], args[2], args[1]) if sig.args[0] is lanes else args[2]

    return value(value, types.int64, types.float64), generate


@instruction
def zero_of(typingctx, value):
    """Zero, of the kind of a number: one, or one in every lane."""
    if value not in (lanes, types.float64):
        return None

    def generate(context, builder, sig, args):
        return ir.Constant(args[0].type, [0.0] * WIDTH if sig.args[0] is lanes else 0.0)

    return value(value), generate


@device
def dot(a, b):
    """Scalar product of two triples, with the products fused that a compiler fuses in scalar code."""
    return fused(a[2], b[2], fused(a[0], b[0], a[1] * b[1]))
