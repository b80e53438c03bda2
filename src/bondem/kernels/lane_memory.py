"""Lanes from memory, and back: one element or bond, or WIDTH of them, by the same words.

Where an element is, is told by an unsigned number for one, or by a tuple of WIDTH of them. `row`, `put_row`, `entry`
and `put_entry` take either, so that the motion of an element is written once and compiled for one and for many. Rows
have eight numbers, one cache line; many rows are read whole and transposed, which is quicker than to gather numbers.
"""

from typing import Any

from llvmlite import ir
from numba.core import cgutils, types

from bondem._compile import device
from bondem.kernels.lanes import WIDTH, instruction, lanes, shuffled, vector, zero_of

__all__ = [
    "add_loads", "add_numbers", "add_rows", "clear_row", "entry", "number_in", "places", "places_below",
    "places_from", "places_in", "prefetch", "put_entry", "put_row", "put_side", "row", "side", "widened",
]  # fmt: skip

_COLUMNS = 8
_DOUBLE, _LONG, _INDEX = ir.DoubleType(), ir.IntType(64), ir.IntType(32)
_HALF = ir.VectorType(_DOUBLE, 4)
place = types.UniTuple(types.uint64, WIDTH)


def _address(context: Any, builder: Any, kind: Any, array: Any, offset: Any, target: Any = _DOUBLE) -> Any:
    data = context.make_array(kind)(context, builder, array).data
    return builder.bitcast(builder.gep(data, [offset]), target.as_pointer())


def _places(builder: Any, value: Any) -> list[Any]:
    """Element numbers, one or many."""
    if isinstance(value.type, ir.IntType):
        return [value]
    return [builder.extract_value(value, n) for n in range(WIDTH)]


def _long(value: int) -> Any:
    return ir.Constant(_LONG, value)


def _transposed4(builder: Any, rows: list[Any]) -> list[Any]:
    a, b, c, d = rows
    low, high = shuffled(builder, a, b, [0, 4, 2, 6]), shuffled(builder, a, b, [1, 5, 3, 7])
    low2, high2 = shuffled(builder, c, d, [0, 4, 2, 6]), shuffled(builder, c, d, [1, 5, 3, 7])
    return [
        shuffled(builder, low, low2, [0, 1, 4, 5]), shuffled(builder, high, high2, [0, 1, 4, 5]),
        shuffled(builder, low, low2, [2, 3, 6, 7]), shuffled(builder, high, high2, [2, 3, 6, 7]),
    ]  # fmt: skip


def _transposed8(builder: Any, rows: list[Any]) -> list[Any]:
    """Three rounds of exchanges: of neighbours, of pairs, of halves."""
    for reach in (1, 2, 4):
        swapped = list(rows)
        for n in range(8):
            if n & reach:
                continue
            a, b = rows[n], rows[n + reach]
            low = [c if not c & reach else 8 + c - reach for c in range(8)]
            swapped[n] = shuffled(builder, a, b, low)
            swapped[n + reach] = shuffled(builder, a, b, [c + reach if not c & reach else 8 + c for c in range(8)])
        rows = swapped
    return rows


def _is_table(kind: Any) -> bool:
    return isinstance(kind, types.Array) and kind.dtype == types.float64 and kind.layout == "C"


@instruction
def places(typingctx, column, k):
    """Elements k … k + WIDTH of a column of uint32."""

    def generate(context, builder, sig, args):
        data = context.make_array(sig.args[0])(context, builder, args[0]).data
        loads = [builder.load(builder.gep(data, [builder.add(args[1], _long(n))])) for n in range(WIDTH)]
        return context.make_tuple(builder, sig.return_type, [builder.zext(load, _LONG) for load in loads])

    return place(column, types.uint64), generate


@instruction
def places_below(typingctx, column, k, end):
    """As `places`, the last before `end` again where there are no more."""

    def generate(context, builder, sig, args):
        data = context.make_array(sig.args[0])(context, builder, args[0]).data
        last = builder.sub(args[2], _long(1))
        found = []
        for n in range(WIDTH):
            wanted = builder.add(args[1], _long(n))
            there = builder.select(builder.icmp_unsigned("<", wanted, last), wanted, last)
            found.append(builder.zext(builder.load(builder.gep(data, [there])), _LONG))
        return context.make_tuple(builder, sig.return_type, found)

    return place(column, types.uint64, types.uint64), generate


@instruction
def places_from(typingctx, k, end):
    """k, k + 1 … as places, the last before `end` again where there are no more."""

    def generate(context, builder, sig, args):
        last, found = builder.sub(args[1], _long(1)), []
        for n in range(WIDTH):
            wanted = builder.add(args[0], _long(n))
            found.append(builder.select(builder.icmp_unsigned("<", wanted, last), wanted, last))
        return context.make_tuple(builder, sig.return_type, found)

    return place(types.uint64, types.uint64), generate


@instruction
def places_in(typingctx, column, p):
    """Number p of a column of uint32, or those of many, to be used as a place."""
    if not (isinstance(column, types.Array) and column.dtype == types.uint32 and column.layout == "C"):
        return None

    def generate(context, builder, sig, args):
        data = context.make_array(sig.args[0])(context, builder, args[0]).data
        found = [builder.zext(builder.load(builder.gep(data, [n])), _LONG) for n in _places(builder, args[1])]
        return found[0] if sig.args[1] == types.uint64 else context.make_tuple(builder, sig.return_type, found)

    return p(column, p), generate


@instruction
def row(typingctx, table, p):
    """The eight numbers of a row of a table (n, 8), or the eight columns of many rows."""
    if not (_is_table(table) and p in (types.uint64, place)):
        return None

    def generate(context, builder, sig, args):
        starts = [builder.mul(n, _long(_COLUMNS)) for n in _places(builder, args[1])]

        def load(start: Any, first: int, kind: Any) -> Any:
            pointer = _address(context, builder, sig.args[0], args[0], builder.add(start, _long(first)), kind)
            return builder.load(pointer, align=8)

        if sig.args[1] == types.uint64:
            found = [load(starts[0], c, _DOUBLE) for c in range(_COLUMNS)]
        elif WIDTH == 8:
            found = _transposed8(builder, [load(start, 0, vector) for start in starts])
        else:
            halves = [[load(start, first, _HALF) for start in starts] for first in (0, 4)]
            found = [column for half in halves for column in _transposed4(builder, half)]
        return context.make_tuple(builder, sig.return_type, found)

    one = types.float64 if p == types.uint64 else lanes
    return types.UniTuple(one, _COLUMNS)(table, p), generate


@instruction
def put_row(typingctx, table, p, values):
    """Write the eight numbers of a row, or of many rows."""

    def generate(context, builder, sig, args):
        starts = [builder.mul(n, _long(_COLUMNS)) for n in _places(builder, args[1])]
        columns = [builder.extract_value(args[2], c) for c in range(_COLUMNS)]

        def store(start: Any, first: int, value: Any) -> None:
            offset = builder.add(start, _long(first))
            pointer = _address(context, builder, sig.args[0], args[0], offset, value.type)
            builder.store(value, pointer, align=8)

        if sig.args[1] == types.uint64:
            for c, value in enumerate(columns):
                store(starts[0], c, value)
        elif WIDTH == 8:
            for start, value in zip(starts, _transposed8(builder, columns), strict=True):
                store(start, 0, value)
        else:
            for first in (0, 4):
                rows = _transposed4(builder, columns[first : first + 4])
                for start, value in zip(starts, rows, strict=True):
                    store(start, first, value)
        return context.get_dummy_value()

    return types.void(table, p, values), generate


@instruction
def clear_row(typingctx, table, p):
    """Write zeros into a row, or into many rows."""

    def generate(context, builder, sig, args):
        kind = ir.VectorType(_DOUBLE, _COLUMNS)
        for n in _places(builder, args[1]):
            pointer = _address(context, builder, sig.args[0], args[0], builder.mul(n, _long(_COLUMNS)), kind)
            builder.store(ir.Constant(kind, [0.0] * _COLUMNS), pointer, align=8)
        return context.get_dummy_value()

    return types.void(table, p), generate


def _gathered(builder: Any, found: list[Any]) -> Any:
    """One number as it is, or many in lanes."""
    if len(found) == 1:
        return found[0]
    many = ir.Constant(vector, ir.Undefined)
    for n, value in enumerate(found):
        many = builder.insert_element(many, value, ir.Constant(_INDEX, n))
    return many


@instruction
def number_in(typingctx, column, p):
    """Number p of a column of float64, or those of many."""
    if not (_is_table(column) and column.ndim == 1 and p in (types.uint64, place)):
        return None

    def generate(context, builder, sig, args):
        there = _places(builder, args[1])
        return _gathered(builder, [builder.load(_address(context, builder, sig.args[0], args[0], n)) for n in there])

    return (types.float64 if p == types.uint64 else lanes)(column, p), generate


@instruction
def entry(typingctx, table, p, c):
    """Number c of a row of a table of any width, or of many rows."""

    def generate(context, builder, sig, args):
        kind, columns = sig.args[0], context.make_array(sig.args[0])(context, builder, args[0])
        width = builder.extract_value(columns.shape, 1)
        return _gathered(builder, [
            builder.load(_address(context, builder, kind, args[0], builder.add(builder.mul(n, width), args[2])))
            for n in _places(builder, args[1])
        ])

    one = types.float64 if p == types.uint64 else lanes
    return one(table, p, types.int64), generate


@instruction
def put_entry(typingctx, table, p, c, value):
    """Write number c of a row, or of many rows."""

    def generate(context, builder, sig, args):
        kind, columns = sig.args[0], context.make_array(sig.args[0])(context, builder, args[0])
        width = builder.extract_value(columns.shape, 1)
        for n, element in enumerate(_places(builder, args[1])):
            one = args[3]
            if sig.args[1] != types.uint64:
                one = builder.extract_element(args[3], ir.Constant(_INDEX, n))
            offset = builder.add(builder.mul(element, width), args[2])
            builder.store(one, _address(context, builder, kind, args[0], offset))
        return context.get_dummy_value()

    return types.void(table, p, types.int64, value), generate


@instruction
def side(typingctx, column, k):
    """Numbers k … k + WIDTH of an array."""
    if not _is_table(column):
        return None

    def generate(context, builder, sig, args):
        return builder.load(_address(context, builder, sig.args[0], args[0], args[1], vector), align=8)

    return lanes(column, types.uint64), generate


@instruction
def widened(typingctx, column, k):
    """Numbers k … k + WIDTH of an array of float32 or int32, as lanes."""
    kinds = {types.float32: (ir.FloatType(), "fpext"), types.int32: (_INDEX, "sitofp")}
    if not (isinstance(column, types.Array) and column.dtype in kinds and column.layout == "C"):
        return None
    narrow, word = kinds[column.dtype]

    def generate(context, builder, sig, args):
        pointer = _address(context, builder, sig.args[0], args[0], args[1], ir.VectorType(narrow, WIDTH))
        return getattr(builder, word)(builder.load(pointer, align=4), vector)

    return lanes(column, types.uint64), generate


@instruction
def put_side(typingctx, column, k, value, first):
    """Write numbers k + first … k + WIDTH of an array."""
    if not _is_table(column):
        return None

    def generate(context, builder, sig, args):
        column, k, value, first = args
        with builder.if_else(builder.icmp_signed("==", first, _long(0))) as (whole, partly):
            with whole:
                builder.store(value, _address(context, builder, sig.args[0], column, k, vector), align=8)
            with partly:
                for n in range(1, WIDTH):
                    with builder.if_then(builder.icmp_signed("<=", first, _long(n))):
                        one = builder.extract_element(value, ir.Constant(_INDEX, n))
                        builder.store(one, _address(context, builder, sig.args[0], column, builder.add(k, _long(n))))
        return context.get_dummy_value()

    return types.void(column, types.uint64, lanes, types.int64), generate


@instruction
def add_rows(typingctx, sums, p, q, to_p, to_q, first):
    """Add numbers first … WIDTH of eight columns to the rows p, and of eight to q, of a table (n, 8), one by one."""

    def generate(context, builder, sig, args):
        starts = [[builder.mul(n, _long(_COLUMNS)) for n in _places(builder, args[end])] for end in (1, 2)]
        columns = [[builder.extract_value(args[end], c) for c in range(_COLUMNS)] for end in (3, 4)]

        def accumulate(start: Any, first: int, value: Any) -> None:
            pointer = _address(context, builder, sig.args[0], args[0], builder.add(start, _long(first)), value.type)
            builder.store(builder.fadd(builder.load(pointer, align=8), value), pointer, align=8)

        if WIDTH == 8:
            parts = [(end, 0, _transposed8(builder, columns[end])) for end in (1, 0)]
        else:
            halves = [(end, first) for end in (1, 0) for first in (0, 4)]
            parts = [(end, c, _transposed4(builder, columns[end][c : c + 4])) for end, c in halves]

        def add(n: int) -> None:
            for end, column, rows in parts:
                accumulate(starts[end][n], column, rows[n])

        for n in range(WIDTH - 1):
            with builder.if_then(builder.icmp_signed("<=", args[5], _long(n)), likely=True):
                add(n)
        add(WIDTH - 1)
        return context.get_dummy_value()

    eight = types.UniTuple(lanes, _COLUMNS)
    return types.void(sums, place, place, eight, eight, types.int64), generate


@device
def add_loads(sums, p, q, force, torque_p, torque_q, first):
    """Add what bonds first … WIDTH do to the rows p of their first ends and q of their second ones, one by one.

    Each is a triple; `force` acts on the second end, its opposite on the first.
    """
    f, t, u, zero = force, torque_p, torque_q, zero_of(force[0])
    on_p, on_q = (-f[0], -f[1], -f[2], zero, t[0], t[1], t[2], zero), (f[0], f[1], f[2], zero, u[0], u[1], u[2], zero)
    add_rows(sums, p, q, on_p, on_q, first)


@instruction
def add_numbers(typingctx, column, p, q, to_p, to_q, first):
    """Add numbers first … WIDTH to the places p and q of an array, one pair after the other."""
    if not _is_table(column):
        return None

    def generate(context, builder, sig, args):
        ends = (_places(builder, args[1]), _places(builder, args[2]))
        pointers = [[_address(context, builder, sig.args[0], args[0], n) for n in end] for end in ends]

        def add(n: int) -> None:
            for pointer, value in ((pointers[1][n], args[4]), (pointers[0][n], args[3])):
                one = builder.extract_element(value, ir.Constant(_INDEX, n))
                builder.store(builder.fadd(builder.load(pointer), one), pointer)

        for n in range(WIDTH - 1):
            with builder.if_then(builder.icmp_signed("<=", args[5], _long(n)), likely=True):
                add(n)
        add(WIDTH - 1)
        return context.get_dummy_value()

    return types.void(column, place, place, lanes, lanes, types.int64), generate


@instruction
def prefetch(typingctx, table, p):
    """Ask for the first cache line of a row of a table (n, 8), or of many rows."""

    def generate(context, builder, sig, args):
        byte = ir.IntType(8).as_pointer()
        kind = ir.FunctionType(ir.VoidType(), [byte, _INDEX, _INDEX, _INDEX])
        function = cgutils.get_or_insert_function(builder.module, kind, "llvm.prefetch.p0")
        for n in _places(builder, args[1]):
            pointer = _address(context, builder, sig.args[0], args[0], builder.mul(n, _long(_COLUMNS)))
            # to read, to stay in all caches, data
            options = [ir.Constant(_INDEX, option) for option in (0, 3, 1)]
            builder.call(function, [builder.bitcast(pointer, byte), *options])
        return context.get_dummy_value()

    return types.void(table, p), generate
