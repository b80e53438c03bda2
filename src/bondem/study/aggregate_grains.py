"""Table [aggregates] of a study: aggregates in a matrix, which is the material of the study, and their interface."""

import math
from dataclasses import dataclass, replace

from bondem.damage.criteria.criterion import Criterion
from bondem.damage.failure_assignment import FailureAssignment, criteria_of
from bondem.errors import InputError, StudyError
from bondem.geometry.elementary_shapes import Shape
from bondem.interactions.cells.cell_bond import CellBond
from bondem.interactions.law_catalogue import AnyLaw
from bondem.packing.inclusions import aggregates, least_count, radii_with_room
from bondem.packing.sizes import Sieve
from bondem.specimen.aggregates import Aggregates
from bondem.specimen.regions import Everything
from bondem.study.failure import read_failure
from bondem.study.toml_table import TomlTable, made

# Default gap between two aggregates over the size of a cell, so that at least one layer of matrix fits in.
_GAP = 1.2


@dataclass(frozen=True, kw_only=True)
class AggregatePlan:
    """Coarse aggregates in a matrix, which is the material of the study.

    Attributes:
        sieve: grading curve with diameters [m].
        fraction: volume fraction of the aggregates [-].
        E, nu: Young's modulus [Pa] and Poisson's ratio [-] of the aggregates.
        gap: smallest distance between surfaces of aggregates [m]; None for 1.2 cell sizes.
        failure: failure criterion of the aggregates; None for that of the matrix.
        interface: failure criterion of the interface of aggregates and matrix; None for that of the matrix.
    """

    sieve: Sieve
    fraction: float
    E: float
    nu: float
    gap: float | None = None
    failure: Criterion | None = None
    interface: Criterion | None = None

    def require_room(self, shape: Shape, count: int) -> None:
        """Check that cells resolve the smallest aggregates, and that all aggregates fit into the shape.

        Raises:
            StudyError: the cells are too large, or the aggregates do not fit.
        """
        smallest = self.sieve.diameters[0]
        least = least_count(shape, 0.5 * smallest)
        if count < least:
            raise StudyError(
                f"'specimen.count' = {count}: the smallest aggregates, of {smallest:g} m, need at least {least}"
                " cells; give a larger count, or leave out smaller aggregates in 'aggregates.diameters'"
            )
        try:
            radii_with_room(shape, self.sieve, self.fraction, self._gap(shape, count))
        except InputError as error:
            raise StudyError(f"'aggregates.fraction' = {self.fraction:g}: {error}") from None

    def _gap(self, shape: Shape, count: int) -> float:
        return _GAP * math.cbrt(shape.volume / count) if self.gap is None else self.gap

    def placed(self, shape: Shape, count: int, seed: int) -> Aggregates:
        """Place the aggregates of a packing of `count` cells in a shape.

        Raises:
            InputError, PackingError: there is no room for the aggregates.
        """
        return aggregates(shape, self.sieve, fraction=self.fraction, gap=self._gap(shape, count), seed=seed)

    def laws(self, matrix: CellBond, balls: Aggregates) -> AnyLaw:
        """Return the cell laws of matrix and aggregates by region, the matrix first."""
        return {Everything(): matrix, balls: replace(matrix, E=self.E, nu=self.nu)}

    def criteria(self, matrix: Criterion, balls: Aggregates) -> FailureAssignment:
        """Return the failure criteria of matrix, aggregates and interface by region, the matrix first."""
        own, between = self.failure or matrix, self.interface or matrix
        return {Everything(): matrix, balls: own, (balls, balls.matrix): between}

    def require_criteria(self, matrix: Criterion | None) -> None:
        """Check that the criteria of matrix, aggregates and interface are compatible.

        Raises:
            StudyError: criteria of different kinds, or criteria without [failure].
        """
        given = {"aggregates.failure": self.failure, "aggregates.interface": self.interface}
        for key, criterion in given.items():
            if criterion is None:
                continue
            if matrix is None:
                raise StudyError(
                    f"'{key}' is given without [failure] of the matrix; give [failure], or leave out '{key}'"
                )
            try:
                criteria_of({"matrix": matrix, key: criterion})
            except InputError as error:
                raise StudyError(f"'{key}.criterion': {error}") from None


def read_aggregates(table: TomlTable) -> AggregatePlan:
    """Read the plan of the aggregates from its table.

    Raises:
        StudyError: a key that is unknown, missing or out of range.
    """
    with table:
        diameters, passing = table.numbers("diameters"), table.numbers("mass_passing")
        sieve = made(table.name("diameters"), lambda: Sieve(diameters, passing))
        fraction, E, nu = (table.number(key) for key in ("fraction", "E", "nu"))
        gap = table.number("gap", default=None)
        own, between = (table.optional(key, read_failure) for key in ("failure", "interface"))
        return AggregatePlan(sieve=sieve, fraction=fraction, E=E, nu=nu, gap=gap, failure=own, interface=between)
