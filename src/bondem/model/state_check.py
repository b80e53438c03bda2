"""Checks of the arrays of a state before a run begins, because the core reads them without checks of its own."""

from typing import Any

import numpy as np

from bondem._tables.columns import EventColumn, SoftColumn
from bondem.damage.crack_columns import FACET, STATUS
from bondem.errors import InputError
from bondem.model.state import State


def check_arrays(state: State) -> None:
    """Reject a state with an array that was replaced and does not fit the elements and bonds of its model.

    Raises:
        InputError: An array has another type or shape, values that are not finite, numbers of elements, bonds or
            walls that the model does not have, an unknown status of a crack, an unordered pair, or a bond twice.
    """
    fresh = State(state.model)
    m = len(fresh.integrity)
    for name in fresh.arrays:
        given, wanted = getattr(state, name), getattr(fresh, name)
        free = name in State.GROWING
        shape = wanted.shape[1:] if free else wanted.shape
        shapes = {shape, (m,)} if name == "eigenstrain" else {shape}
        if given.dtype != wanted.dtype or (given.shape[1:] if free else given.shape) not in shapes:
            rows = "(rows, " + ", ".join(map(str, shape)) + ")" if free else str(shape)
            raise InputError(
                f"state: {name} is an array of {given.dtype} of shape {given.shape}; {wanted.dtype} of shape {rows}"
                " is what its model needs"
            )
    for name in ("pose", "motion"):
        if not np.isfinite(getattr(state, name)).all():
            raise InputError(f"state: {name} has values that are not finite")
    _check_numbers(state, len(fresh.pose), m, len(fresh.walls))


def _check_numbers(state: State, n: int, m: int, walls: int) -> None:
    pair, at_wall = state.touching, state.wall_touching
    numbers = {
        "touching": (pair, n),
        "wall_touching": (at_wall[:, :1], n), "wall_touching of walls": (at_wall[:, 1:], walls),
        "broken": (state.broken[:, EventColumn.BOND], m), "cracks": (state.cracks[:, FACET], m),
        "status of cracks": (state.cracks[:, STATUS], 3), "softened": (state.softened[:, SoftColumn.BOND], m),
    }  # fmt: skip
    for name, (values, count) in numbers.items():
        if not _are_numbers(values, count):
            raise InputError(f"state: {name} has numbers beyond 0 … {count - 1}")
    if (pair[:, 0] >= pair[:, 1]).any():
        raise InputError("state: touching has pairs whose first element is not the lower one")
    for name, stretch, touching in (
        ("stretch", state.stretch, pair), ("wall_stretch", state.wall_stretch, at_wall),
        ("rolled", state.rolled, pair), ("wall_rolled", state.wall_rolled, at_wall),
    ):  # fmt: skip
        if len(stretch) != len(touching) and not (name.endswith("rolled") and not len(stretch)):
            raise InputError(f"state: {name} has {len(stretch)} rows for {len(touching)} contacts")
    for name in ("cracks", "softened"):
        if len(np.unique(numbers[name][0])) < len(numbers[name][0]):
            raise InputError(f"state: {name} has a bond more than once")


def _are_numbers(values: np.ndarray[Any, Any], count: int) -> bool:
    with np.errstate(invalid="ignore"):
        return bool(((values >= 0) & (values < count) & (values == np.floor(values))).all())
