"""Warnings about bodies of cells that are less accurate than expected, as far as a model shows it."""

import warnings
from collections.abc import Callable, Mapping

import numpy as np

from bondem._names import users_line
from bondem._types import Floats, PerElement3
from bondem.errors import IncompressibleWarning, RaggedInterfaceWarning, ThinBodyWarning
from bondem.interactions.cells.cell_bond import CellBond
from bondem.interactions.cells.free_walls import is_layer, thin_ways
from bondem.specimen.aggregates import Aggregates
from bondem.specimen.lattice import Lattice
from bondem.specimen.regions import Difference, Intersection, Plane, Region, Union, Within

# Poisson's ratio times this is what a layer bends too softly; less is no matter.
_MATTERS = 0.01
# Poisson's ratio from which bulk moduli of a confined body are off by half a per cent.
_NEARLY = 0.45
# Ratio of E that makes an interface, and distance of its facets from the surface, over the size of a cell, root mean
# square: 0.02 to 0.12 where cells end on it, 0.2 to 0.3 where they do not.
_CONTRAST, _ROUGH, _FEW_FACETS = 1.25, 0.15, 8


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
    thin = thin_ways(body)
    count = int((thin > 0).sum())
    if not is_layer(thin > 0):
        return
    nu = max((law.nu for law in laws), key=abs)
    rotation = laws[0].facet_rotation
    if is_layer(thin > 1):
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
    if not surfaces or len(border) < _FEW_FACETS:
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


def _warn(text: str, category: type[Warning]) -> None:
    warnings.warn(text, category, stacklevel=users_line())
