"""Steps of the core: lists of its passes, with the tables that they take.

Python composes these lists once; the core then executes them for many steps without a return to Python
(`core/steps.hpp`). Physics that a model does not contain has no pass in these lists.
"""

from collections.abc import Iterable
from typing import Any

import numpy as np

from bondem._core import fields_of, filled_table, step_pass
from bondem._core_functions import address_of
from bondem._passes import StepEntry

__all__ = ["Composer"]

# Words of an entry of a list: address, kind, and pointers to tables.
_WORDS = 8


class Composer:
    """Composer of lists of passes, which fills each table once and must live as long as its lists.

    A length that a header names, such as n, has one value in all tables of a composer.

    Args:
        known: composer whose filled tables are reused.
    """

    def __init__(self, known: "Composer | None" = None) -> None:
        self._lengths: dict[str, tuple[int, str]] = {} if known is None else known._lengths.copy()
        self._filled: dict[int, tuple[Any, np.ndarray, int]] = {} if known is None else known._filled.copy()

    def __call__(self, passes: Iterable[StepEntry]) -> np.ndarray:
        """Return the entries of a list of passes, int64, (passes, 8).

        Raises:
            ImportError: other tables than those of the library.
            InputError: an array of another type, shape or order in memory than declared.
        """
        entries = []
        for name, tables in passes:
            word, names = step_pass(name)
            addresses = [self._address(kind, table) for kind, table in zip(names, tables, strict=True)]
            entries.append([*word, *addresses, *[0] * (_WORDS - 2 - len(addresses))])
        return np.array(entries, dtype=np.int64).reshape(-1, _WORDS)

    def _address(self, name: str, table: tuple[Any, ...]) -> int:
        """Return the address of a table, which is filled at the first request."""
        fields, found = fields_of(table, name), self._filled.get(id(table))
        if found is None:
            words = filled_table(name, fields, table, self._lengths)
            found = self._filled[id(table)] = table, words, address_of(words)
        return found[2]
