"""Coefficients of the surface correction, from the rows of the surface study, and how well they predict others."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from bondem._types import Floats
from bondem.calibration.surface_correction import lattice_terms, law_terms
from bondem.interactions.law_catalogue import PARAMETERS
from validation.frame.files import column
from validation.frame.study import Row

# The scatter that sets the weights of rows, √(a² + b² / elements): first guess, then as found.
_SCATTER = (0.01, 0.7)
_ROUNDS = 3

# Which f_j g_k are fitted: all five g for E, the first three for ν, which scatters too much for more.
_TERMS = {name: np.tile(np.arange(5) < count, 4) for name, count in (("E", 5), ("nu", 3))}

#: Shapes so stubby that equal tractions on their ends lower ν in the gauge.
STUBBY = ("cube",)


def design(rows: Sequence[Row]) -> Floats:
    """f_j g_k of each row, (k, 20)."""
    f = law_terms(column(rows, "shear"), column(rows, "bending"))
    g = lattice_terms(*(column(rows, name) for name in ("coordination", "looseness", "wall")))
    return np.einsum("rj,rk->rjk", f, g).reshape(len(rows), -1)


def target(rows: Sequence[Row], quantity: str) -> Floats:
    """What the model is to give: ln(E / E_affine), or ν - ν_affine."""
    found, affine = column(rows, quantity), column(rows, f"{quantity}_affine")
    return np.log(found / affine) if quantity == "E" else found - affine


def relative_miss(rows: Sequence[Row], quantity: str, coefficients: Floats) -> Floats:
    """Predicted over measured, less one [-], (k,)."""
    predicted = design(rows) @ coefficients
    if quantity == "E":
        return np.exp(predicted - target(rows, "E")) - 1.0
    return (predicted - target(rows, "nu")) / column(rows, "nu")


class Fit:
    """The model fitted to rows, and tested on shapes left out."""

    def __init__(self, rows: Sequence[Row], quantity: str) -> None:
        """Fit.

        Args:
            rows: with all columns of `ModuliRequest`.
            quantity: "E" or "nu".
        """
        self.rows = [row for row in rows if quantity == "E" or row["form"] not in STUBBY]
        self.quantity = quantity
        self.scatter = _SCATTER
        for _ in range(_ROUNDS):
            self.coefficients = self._solved(self.rows)
            self.held_out = self._held_out()
            self.scatter = _scatter(self.held_out, column(self.rows, "elements"), column(self.rows, "wall") > 0.0)

    def _solved(self, rows: Sequence[Row]) -> Floats:
        a, b = self.scatter
        weight = 1.0 / np.sqrt(a * a + b * b / column(rows, "elements"))
        terms = _TERMS[self.quantity]
        matrix, right = design(rows)[:, terms] * weight[:, None], target(rows, self.quantity) * weight
        coefficients = np.zeros(len(terms))
        coefficients[terms] = np.linalg.lstsq(matrix, right, rcond=1e-10)[0]
        return coefficients

    def _held_out(self) -> Floats:
        """Miss of each row by a model fitted without its form; of cells, by the whole."""
        miss = relative_miss(self.rows, self.quantity, self.coefficients)
        forms = np.array([row["form"] for row in self.rows])
        for form in set(forms) - {"cell"}:
            mine = forms == form
            others = [row for row in self.rows if row["form"] != form]
            own = [row for row in self.rows if row["form"] == form]
            miss[mine] = relative_miss(own, self.quantity, self._solved(others))
        return miss


def _scatter(miss: Floats, elements: Floats, bodies: np.ndarray) -> tuple[float, float]:
    """A, b of the standard deviation √(a² + b² / n), both at least 0."""
    square, inverse = miss[bodies] ** 2, 1.0 / elements[bodies]
    matrix = np.stack([np.ones_like(inverse), inverse], axis=1)
    # the spread of a square grows with itself: relative misses count
    size = matrix @ np.array([1e-4, 0.5])
    a2, b2 = np.linalg.lstsq(matrix / size[:, None], square / size, rcond=None)[0]
    if a2 < 0.0 or b2 < 0.0:
        a2, b2 = (0.0, float(np.mean(square / inverse))) if a2 < 0.0 else (float(square.mean()), 0.0)
    return float(np.sqrt(a2)), float(np.sqrt(b2))


class CurveFit:
    """E/E_bulk - 1 over R̄S/V alone, for comparison: bodies with 6.2 contacts a sphere."""

    def __init__(self, rows: Sequence[Row], bulk: dict[str, dict[str, float]], quantity: str) -> None:
        """Fit.

        Args:
            rows: of all bodies; those of other targets are left out.
            bulk: mean "E", "nu" and "shear" of the periodic cells with 6.2 contacts a sphere, by law.
            quantity: "E" or "nu".
        """
        self.rows = [
            row for row in rows
            if row["target"] == "contacts" and row["form"] not in ("cell", *(STUBBY if quantity == "nu" else ()))
        ]  # fmt: skip
        self._bulk, self._quantity = bulk, quantity
        self.coefficients = self._solved(self.rows)
        self.held_out = np.empty(len(self.rows))
        forms = np.array([row["form"] for row in self.rows])
        for form in set(forms):
            mine = forms == form
            others = self._solved([row for row in self.rows if row["form"] != form])
            self.held_out[mine] = self.miss([row for row in self.rows if row["form"] == form], others)

    def _matrix(self, rows: Sequence[Row]) -> Floats:
        s = column(rows, "surface_ratio")
        x = np.log([self._bulk[law_name(row)]["shear"] for row in rows])
        return np.stack([s, s * x, s * s, s * s * x], axis=1)

    def _ratio(self, rows: Sequence[Row]) -> Floats:
        bulk = np.array([self._bulk[law_name(row)][self._quantity] for row in rows])
        return column(rows, self._quantity) / bulk

    def _solved(self, rows: Sequence[Row]) -> Floats:
        weight = np.sqrt(column(rows, "elements"))
        right = self._ratio(rows) - 1.0
        matrix = self._matrix(rows) * weight[:, None]
        return np.asarray(np.linalg.lstsq(matrix, right * weight, rcond=1e-10)[0], dtype=float)

    def miss(self, rows: Sequence[Row], coefficients: Floats) -> Floats:
        """Predicted over measured, less one [-], (k,)."""
        return (1.0 + self._matrix(rows) @ coefficients) / self._ratio(rows) - 1.0


def law_name(row: Row) -> str:
    """A law of a row, to read and to group by."""
    parts = [f"{one.symbol} {row[name]:g}" for name, one in PARAMETERS.items() if row[name] is not None]
    return f"{row['law']} {', '.join(parts)}"


def bulk_means(rows: Sequence[Row], target_name: str = "contacts") -> dict[str, dict[str, float]]:
    """Mean E/E_μ, ν, and what the estimate says, of the periodic cells of one target, by law."""
    names = ("E", "nu", "E_affine", "nu_affine", "shear", "bending", "coordination", "looseness")
    groups: dict[str, list[Row]] = {}
    for row in rows:
        if row["form"] == "cell" and row["target"] == target_name:
            groups.setdefault(law_name(row), []).append(row)
    return {law: {name: float(column(own, name).mean()) for name in names} for law, own in groups.items()}


def fitted_range(rows: Sequence[Row]) -> dict[str, list[float]]:
    """Lowest and highest of what the model depends on."""
    softness = 12.0 * column(rows, "bending") / column(rows, "shear")
    found: dict[str, Any] = {name: column(rows, name) for name in ("coordination", "looseness", "wall", "shear")}
    found["softness"] = softness
    return {name: [float(values.min()), float(values.max())] for name, values in found.items()}
