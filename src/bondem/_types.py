"""Type aliases of arrays, by the type of their numbers or by their shapes with n elements and m bonds."""

from collections.abc import Sequence
from typing import Annotated, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]
Mask = NDArray[np.bool_]
Bytes = NDArray[np.uint8]
Int32s = NDArray[np.int32]
Uint32s = NDArray[np.uint32]
Singles = NDArray[np.float32]

PerElement = Annotated[Floats, "(n,)"]
PerElement3 = Annotated[Floats, "(n, 3)"]
PerElement6 = Annotated[Floats, "(n, 6)"]
PerBond = Annotated[Floats, "(m,)"]
PerBond3 = Annotated[Floats, "(m, 3)"]
Pairs = Annotated[Ints, "(m, 2)"]
Vector = Annotated[Floats, "(3,)"]

# Three numbers that a user gives: a tuple, a list or an array, which classes store as a tuple.
Triple = Sequence[float] | Floats
Axis = Literal["x", "y", "z"]

__all__ = [
    "ArrayLike", "Axis", "Bytes", "Floats", "Int32s", "Ints", "Mask", "Pairs", "PerBond", "PerBond3", "PerElement",
    "PerElement3", "PerElement6", "Singles", "Triple", "Uint32s", "Vector",
]  # fmt: skip
