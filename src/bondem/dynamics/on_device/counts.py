"""Numbers of threads of kernel launches on a device, as functions of the run and of the tables of a pass."""

from collections.abc import Callable
from typing import TypeVar

import numpy as np

from bondem._tables.cell_tables import WallConstraints
from bondem._tables.columns import TERMS_OF_THREAD
from bondem._tables.step_tables import Rows
from bondem.dynamics.on_device.translation import Count, Given, Translation

_T = TypeVar("_T")


def elements(run: Translation, _: Given) -> int:
    """Return the number of elements."""
    return run.span.n


def bonds(run: Translation, _: Given) -> int:
    """Return the number of bonds or facets."""
    return run.span.m


def portions_of_elements(run: Translation, _: Given) -> int:
    """Return the number of portions of `TERMS_OF_THREAD` elements, whose terms one thread adds up."""
    return -(-run.span.n // TERMS_OF_THREAD)


def portions_of_bonds(run: Translation, _: Given) -> int:
    """Return the number of portions of `TERMS_OF_THREAD` bonds or facets, whose terms one thread adds up."""
    return -(-run.span.m // TERMS_OF_THREAD)


def free(run: Translation, _: Given) -> int:
    """Return the number of elements that are not fixed, driven or loaded."""
    return run.span.n - run.owners


def owners(run: Translation, _: Given) -> int:
    """Return the number of elements that are fixed, driven or loaded."""
    return run.owners


def one_thread(_: Translation, __: Given) -> int:
    """Return 1, for a launch of one thread."""
    return 1


def length_of(kind: type[_T], column: Callable[[_T], np.ndarray]) -> Count:
    """Return a function for the number of threads of a launch: the length of a column of a table of the pass."""
    return lambda _, given: len(column(given[kind]))


def elements_where(kind: type[_T], column: Callable[[_T], np.ndarray]) -> Count:
    """Return a function for the number of threads of a launch: that of elements, or 0 if a column is empty."""
    return lambda run, given: run.span.n if len(column(given[kind])) else 0


#: Number of rows of the boundary, one per element that is fixed, driven or loaded.
rows = length_of(Rows, lambda of: of.force)
#: Number of facets that walls hold.
walls = length_of(WallConstraints, lambda of: of.cell)
