"""Columns of symmetric tensors, stored as six numbers per row."""

from typing import Any

import numpy as np

from bondem.specimen.particles import freeze

#: Indices of the components xx, yy, zz, xy, xz, yz among the nine of a tensor, and of the nine among these six.
SIX, NINE = [0, 4, 8, 1, 2, 5], [0, 3, 4, 3, 1, 5, 4, 5, 2]


class SymmetricColumn:
    """Column of tensors (k, 3, 3) of a frozen table, stored as (k, 6) if this loses no bit, else as it is.

    Each access builds the tensors anew. Tensors of rotated bodies are not symmetric to the last bit.
    """

    def __init__(self, name: str, *tables: type) -> None:
        self._name = name
        for table in tables:
            setattr(table, name, self)

    def __get__(self, table: Any, kind: type | None = None) -> Any:
        stored = vars(table)[self._name]
        return freeze(stored[:, NINE].reshape(-1, 3, 3)) if stored.ndim == 2 else stored

    def __set__(self, table: Any, value: np.ndarray) -> None:
        if value.shape[1:] == (3, 3):
            nine = value.reshape(-1, 9)
            six = nine[:, SIX]
            value = freeze(six) if six[:, NINE].tobytes() == nine.tobytes() else value
        vars(table)[self._name] = value
