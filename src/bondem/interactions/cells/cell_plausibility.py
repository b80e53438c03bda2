"""Warnings about bodies of cells that are less accurate than expected, as far as a model shows it."""

import warnings
from collections.abc import Callable, Mapping

import numpy as np

from bondem._names import users_line
from bondem._types import Floats, PerElement3
from bondem.errors import IncompressibleWarning, RaggedInterfaceWarning, ThinBodyWarning
from bondem.interactions.cells.cell_bond import CellBond
from bondem.specimen.aggregates import Aggregates
from bondem.specimen.lattice import Lattice
from bondem.specimen.regions import Difference, Intersection, Plane, Region, Union, Within

# A cell is one of a layer where its facets without a neighbour are this share of all of them along some axis: 1 of a
# plate one cell thick, 1/2 at a plain wall. So many of all cells, and as many in number, make a layer.
_THIN, _PART, _FEW = 0.9, 0.1, 8
# Poisson's ratio times this is what a layer bends too softly; less is no matter.
_MATTERS = 0.01
# Poisson's ratio from which bulk moduli of a confined body are off by half a per cent.
_NEARLY = 0.45
# Ratio of E that makes an interface, and distance of its facets from the surface, over the size of a cell, root mean
# square: 0.02 to 0.12 where cells end on it, 0.2 to 0.3 where they do not.
_CONTRAST, _ROUGH = 1.25, 0.15


def question_cells(body: Lattice, bond: object) -> None:
    """Warn about a body of cells that is one cell thick somewhere, nearly incompressible, or has ragged interfaces.

    Args:
        body: lattice of a model.
        bond: laws of the body; only `CellBond` is considered.
    """
    laws = tuple(bond.values()) if isinstance(bond, Mapping) else (bond,)
    if body.cells is None or body.facets is None or not all(isinstance(law, CellBond) for law in laws):
        return
    cell_laws = [law for law in laws if isinstance(law, CellBond)]
    _question_thin(body, cell_laws)
    _question_incompressible(max(law.nu for law in cell_laws))
    if isinstance(bond, Mapping):
        _question_ragged(body, bond)


def _question_incompressible(nu: float) -> None:
    """Warn about nearly incompressible cells, which are too compliant under uniform pressure."""
    if nu > _NEARLY:
        _warn(
            f"CellBond: nu = {nu:g} is nearly incompressible: confined on all sides, 300 cells have a bulk modulus"
            " 0.4, 1.9 and 15 % too small at 0.45, 0.49 and 0.499 (1500 cells: 0.3, 1.3, 11 %), and hoop stress at a"
            " hole is 10 % too small with 4 cells across the wall and 4 % with 6; free bodies are right. Use"
            " nu = 0.45 if the body cannot bulge, or compare with another nu", IncompressibleWarning,
        )  # fmt: skip


def _question_thin(body: Lattice, laws: list[CellBond]) -> None:
    """Warn about parts of a body that are one cell thick, and about those that are one cell wide as well."""
    assert body.cells is not None
    thin = (free_shares(body) > _THIN).sum(axis=1)
    count = int((thin > 0).sum())
    if count < max(_FEW, _PART * len(thin)):
        return
    nu = max((law.nu for law in laws), key=abs)
    rotation = laws[0].facet_rotation
    if int((thin > 1).sum()) >= max(_FEW, _PART * len(thin)):
        error = {"bending": "20 % too stiffly", "full": "2.4 times too stiffly"}.get(rotation, "without resistance")
        _warn(
            f"{count} of {len(thin)} cells have no neighbour on opposite sides, and the body is one cell thick both"
            f" ways there: it twists {error}, and bends with about E / (1 + ν); pack smaller cells, four across the"
            " thickness", ThinBodyWarning,
        )  # fmt: skip
    elif abs(nu) >= _MATTERS:
        _warn(
            f"{count} of {len(thin)} cells have no neighbour on opposite sides: the body is one cell thick there"
            f" and bends with about E / (1 + ν), a deflection {100.0 * nu:+.0f} % off (two cells 3 %, four 0.2 %);"
            " pack smaller cells, four across the thickness", ThinBodyWarning,
        )  # fmt: skip


def _question_ragged(body: Lattice, bond: Mapping[object, object]) -> None:
    """Warn about an interface between two materials that cuts through cells, if a surface defines it."""
    assert body.cells is not None
    assert body.facets is not None
    surfaces = [one for where in bond for one in _surfaces(where)]
    E = np.full(len(body.particles), np.nan)
    for where, law in bond.items():
        if isinstance(where, Region) and isinstance(law, CellBond):
            E[where.mask(body)] = law.E
    i, j = body.pairs.T
    border = np.flatnonzero(np.maximum(E[i], E[j]) > _CONTRAST * np.minimum(E[i], E[j]))
    if not surfaces or len(border) < _FEW:
        return
    at, area = body.facets.centroid[border], body.facets.area[border]
    off = np.min([np.abs(depth(at)) for depth in surfaces], axis=0) / np.cbrt(body.cells.volume.mean())
    rough = float(np.sqrt((area * off**2).sum() / area.sum()))
    if rough > _ROUGH:
        _warn(
            f"cells cut through the interface between materials that differ in E: its facets are {rough:.2f} cell"
            " sizes off the surface (root mean square), and a bimetal strip of such cells bends 1 to 15 % too much at"
            ' a ratio of 10; pack with bd.pack(..., method="even", around=surface), so that cells end there',
            RaggedInterfaceWarning,
        )  # fmt: skip


def _surfaces(where: object) -> list[Callable[[PerElement3], Floats]]:
    """Return distances from the surfaces that a region is made of, none for those that name elements."""
    match where:
        case Within():
            return [where.shape.depth]
        case Plane() | Aggregates():
            return [where.depth]
        case Intersection() | Union() | Difference():
            return _surfaces(where.first) + _surfaces(where.second)
        case _:
            return []


def free_shares(body: Lattice) -> Floats:
    """Return the part of free facets in (1/V) Σ A d n⊗n of each cell, along its three axes [-], (n, 3), ascending."""
    return _free_axes(body)[0]


def _free_axes(body: Lattice) -> tuple[Floats, Floats]:
    """Return the shares of free facets, (n, 3), ascending, and their unit vectors, columns of (n, 3, 3)."""
    cells, facets = body.cells, body.facets
    assert cells is not None
    assert facets is not None
    n, free = len(cells.volume), cells.free
    open_part = _sums(free.cell, free.area * free.depth, free.normal, n)
    whole = open_part + _sums(body.pairs[:, 0], facets.area * facets.depth_i, facets.normal, n)
    whole += _sums(body.pairs[:, 1], facets.area * facets.depth_j, facets.normal, n)
    root = np.linalg.inv(np.linalg.cholesky(whole))
    share, turned = np.linalg.eigh(root @ open_part @ np.swapaxes(root, 1, 2))
    axis = np.swapaxes(root, 1, 2) @ turned
    return share, axis / np.linalg.norm(axis, axis=1, keepdims=True)


def layer_axes(body: Lattice) -> Floats:
    """Return the direction in which a body is one cell thick at each cell, (n, 3); zero where it is thicker."""
    share, axis = _free_axes(body)
    thin = share[:, 2] > _THIN
    if thin.sum() < max(_FEW, _PART * len(thin)):
        return np.zeros((len(thin), 3))
    return np.where(thin[:, None], axis[:, :, 2], 0.0)


def _sums(cell: np.ndarray, weight: Floats, normal: Floats, n: int) -> Floats:
    """Return Σ weight n⊗n of each cell, (n, 3, 3)."""
    found = np.zeros((n, 3, 3))
    for a in range(3):
        for b in range(3):
            found[:, a, b] = np.bincount(cell, weights=weight * normal[:, a] * normal[:, b], minlength=n)
    return found


def _warn(text: str, category: type[Warning]) -> None:
    warnings.warn(text, category, stacklevel=users_line())
