"""Interfaces by which results declare their pictures for `bondem.report` and their tables for `bondem.io`."""

from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any, NamedTuple, Protocol

import numpy as np

from bondem._outlets import OUTLETS
from bondem._types import Floats, Mask


class Coloured(NamedTuple):
    """Picture of a body with displaced elements, coloured by values of the elements."""

    lattice: Any
    values: Floats  #: one value per element, (n,)
    label: str  #: name and unit of the values
    moved: Floats  #: displacements [m], (n, 3)
    turned: Floats | None  #: rotation vectors [rad], (n, 3), or quaternions, (n, 4); None if unknown
    title: str = "motion × {:.3g}"  #: title, with the factor on displacements


class Present(NamedTuple):
    """Picture of the body of a state at its current position, with its walls; fragments have different colours."""

    state: Any


class _WithState(Protocol):
    @property
    def state(self) -> Any: ...


class _Path(Protocol):
    @property
    def load(self) -> Floats: ...
    @property
    def table(self) -> Mapping[str, Floats]: ...
    @property
    def _outer(self) -> Mask: ...


class Plotted:
    """Base of results that can be drawn and written as a table."""

    @property
    def table(self) -> Mapping[str, Floats]:
        """Columns of the result by name and SI unit, such as "load [N]", arrays of one length."""
        raise NotImplementedError

    @property
    def drawn(self) -> Mapping[str, Floats]:
        """Columns that `plot` draws, all over the first one; none for a picture of the body alone.

        By default these are the first column of `table`, and those with the unit of its second column.
        """
        return of_one_unit(self.table)

    @property
    def _pictures(self) -> "tuple[Coloured | Present, ...]":
        """Pictures of the body beside the curve."""
        return ()

    @property
    def _outer(self) -> Mask | None:
        """Rows of the envelope of a path that may go back; None for other results."""
        return None

    def plot(
        self, path: str | Path | None = None, *, reach: float | None = None, view: tuple[float, float] = (28.0, 24.0)
    ) -> Any:
        """Draw the result: its curve or energies, and the specimen in its current pose, with walls and coordinates.

        Args:
            path: PNG, PDF or SVG to write; nothing is written when None.
            reach: factor on displacements [-]; None chooses a factor with which they are visible.
            view: azimuth and elevation of the camera [degree].

        Returns:
            A `matplotlib.figure.Figure`, which Jupyter shows; its `show()` opens a window.

        Raises:
            InputError: a file that cannot be written, a negative reach, or a view that is not two angles.
            RunFileError: the disk is full, or another failure to write.
        """
        return OUTLETS.draw_result(self, path, reach=reach, view=view)

    def to_csv(self, path: str | Path) -> None:
        """Write `table` as CSV: names with units in the first line, then a line per row, in SI units.

        Args:
            path: file to write; an existing file is replaced once the new one is complete.

        Raises:
            InputError: the file cannot be written; RunFileError if writing fails, as on a full disk.
        """
        OUTLETS.write_csv(path, self.table, owner=f"{type(self).__name__}.to_csv")


class PlottedState(Plotted):
    """Base of results with a state, whose body is drawn at its current position."""

    @property
    def _pictures(self: _WithState) -> tuple[Present, ...]:
        return (Present(self.state),)


class PlottedPath(PlottedState):
    """Base of results along a path of equilibria, which may go back at single events."""

    @property
    def _outer(self: _Path) -> Mask:
        return enveloping(self.load)

    @property
    def envelope(self: _Path) -> dict[str, Floats]:
        """Rows of `table` that a laboratory would record, by name and unit: on the envelope of the loads.

        No earlier, or no later, row of `table` has a larger load. Rows at which the first column goes back are left
        out, so that `numpy.interp` accepts it.
        """
        outer, table = np.flatnonzero(self._outer), self.table
        first = next(iter(table.values()))[outer]
        outer = outer[first > np.append(-np.inf, np.maximum.accumulate(first)[:-1])]
        return {name: column[outer] for name, column in table.items()}


def enveloping(load: Floats) -> Mask:
    """Return a mask of points on the envelope of a path, (k,): no earlier, or no later, point has a larger load."""
    rising, falling = np.maximum.accumulate(load), np.maximum.accumulate(load[::-1])[::-1]
    return load >= np.minimum(rising, falling)


def columns_of(pattern: str, names: Iterable[str], values: Floats) -> dict[str, Floats]:
    """Split values (n, k) into columns named by a pattern, such as "displacement {} [m]" for x, y and z."""
    return {pattern.format(name): column for name, column in zip(names, values.T, strict=True)}


def of_one_unit(table: Mapping[str, Floats]) -> dict[str, Floats]:
    """Return the first column of a table, and those with the unit of its second column."""
    first, *others = table
    unit = unit_of(others[0] if others else first)
    return {first: table[first]} | {name: table[name] for name in others if unit_of(name) == unit}


def unit_of(column: str) -> str:
    """Return the unit in the name of a column, such as "N" for "load [N]"."""
    return column.rpartition("[")[2].rstrip("]")
