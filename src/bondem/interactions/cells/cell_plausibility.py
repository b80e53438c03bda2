"""Warnings about bodies of cells for which the cell law is less accurate than usual."""

import warnings
from collections.abc import Callable, Iterable, Mapping

import numpy as np

from bondem._names import users_line
from bondem._types import Floats, Ints, PerElement3
from bondem.errors import AuxeticWarning, RaggedInterfaceWarning, ThinBodyWarning
from bondem.interactions.cells.cell_body import body_of
from bondem.interactions.cells.cell_bond import CellBond
from bondem.interactions.cells.cell_constants import CellAssignment, compliance
from bondem.interactions.cells.free_walls import is_layer, thin_ways
from bondem.specimen.aggregates import Aggregates
from bondem.specimen.lattice import Lattice
from bondem.specimen.regions import Difference, Intersection, Plane, Region, Union, Within

# Least |ν| for a warning: a layer without gradients of the dilatation bends with an error of about ν.
_MATTERS = 0.01
# Ratio of E that makes an interface. Root mean square distance of its facets from the surface over the size of a
# cell: 0.02 to 0.12 where cells end on the surface, 0.2 to 0.3 where they do not. Least number of such facets.
_CONTRAST, _ROUGH, _FEW_FACETS = 1.25, 0.15, 8


def question_cells(body: Lattice, bond: CellAssignment, *, may_fail: bool) -> None:
    """Warn about cells that bend or twist inaccurately, do not end at interfaces, or are too uneven for their ν.

    Args:
        body: lattice of a model.
        bond: law of the body, or laws by region.
        may_fail: True for a model with failure.
    """
    laws = list(bond.values()) if isinstance(bond, Mapping) else [bond]
    _question_thin(body, laws, may_fail)
    _question_auxetic(body, min(law.nu for law in laws))
    if isinstance(bond, Mapping):
        _question_ragged(body, bond)


def _question_auxetic(body: Lattice, nu: float) -> None:
    """Warn about cells so uneven that their energy would not be positive for a negative ν."""
    if nu >= 0.0:
        return
    most = compliance(body)
    limit = -1.0 / (most - 2.0)  # λ = -2 G / q
    count = int((limit > nu).sum())
    if count:
        _warn(
            f"CellBond: nu = {nu:g} is too low for {count} of {len(most)} cells, which are uneven: they keep"
            f" λ = -2 G / q for a positive energy, as if nu were {limit.max():.2f} at worst; pack more even cells, as"
            ' bd.pack(..., method="even") does', AuxeticWarning,
        )  # fmt: skip


def _question_thin(body: Lattice, laws: list[CellBond], may_fail: bool) -> None:
    """Warn about parts of a body that are one cell thick, where facets alone resist bending."""
    nu, rotation = max((law.nu for law in laws), key=abs), laws[0].facet_rotation
    thin = thin_ways(body)
    count, columns = int((thin > 0).sum()), is_layer(thin > 1)
    if not is_layer(thin > 0):
        return
    where = f"{count} of {len(thin)} cells have no neighbour on opposite sides: the body is one cell thick there"
    if rotation != "bending" and columns:
        error = {"full": "2.4 times too stiffly"}.get(rotation, "without resistance")
        _warn(f'{where} both ways, and twists {error}; use facet_rotation="bending"', ThinBodyWarning)
    elif abs(nu) >= _MATTERS and (may_fail or nu < 0.0 or rotation != "bending"):
        cause = (
            "models with failure= lack the gradient of the dilatation across it" if may_fail
            else "the gradient of the dilatation across it counts for nu >= 0 only" if nu < 0.0
            else f'facet_rotation="{rotation}" lacks the gradient of the dilatation across it'
        )  # fmt: skip
        _warn(
            f"{where}, and bends with about E / (1 + ν), a deflection {100.0 * nu:+.0f} % off (two cells 3 %, four"
            f" 0.2 %): {cause}; pack smaller cells, four across the thickness", ThinBodyWarning,
        )  # fmt: skip


def _question_ragged(body: Lattice, bond: Mapping[Region, CellBond]) -> None:
    """Warn about cells that cut through an interface between two materials, if a surface defines it."""
    E = np.full(len(body.particles), np.nan)
    for where, law in bond.items():
        E[where.mask(body)] = law.E
    i, j = body.pairs.T
    border = np.flatnonzero(np.maximum(E[i], E[j]) > _CONTRAST * np.minimum(E[i], E[j]))
    effect = "a bimetal strip of such cells bends 1 to 15 % too much at a ratio of 10"
    _question_rough(body, border, bond, "the interface between materials that differ in E", effect)


def question_joint(body: Lattice, between: tuple[Region, Region], facets: Ints) -> None:
    """Warn about cells that cut through a joint of `facets`, (k,), between two regions, if a surface defines it."""
    sides = np.array([where.mask(body) for where in between])[:, body.pairs[facets]]
    border = facets[(sides[:, :, 0] != sides[:, :, 1]).any(axis=0)]
    effect = "it is about twice as strong as entered and does not slide"
    _question_rough(body, border, between, "a joint, a pair of regions in failure=", effect)


def _question_rough(body: Lattice, border: Ints, regions: Iterable[Region], what: str, effect: str) -> None:
    """Warn if facets are far from the surfaces that define the regions on both sides."""
    surfaces = [one for where in regions for one in _surfaces(where)]
    if not surfaces or len(border) < _FEW_FACETS:
        return
    facets, cells = body_of(body)
    at, area = facets.centroid[border], facets.area[border]
    off = np.min([np.abs(depth(at)) for depth in surfaces], axis=0) / np.cbrt(cells.volume.mean())
    rough = float(np.sqrt((area * off**2).sum() / area.sum()))
    if rough > _ROUGH:
        _warn(
            f"cells cut through {what}: its facets are {rough:.2f} cell sizes off the surface (root mean square), and"
            f' {effect}; pack with bd.pack(..., method="even", around=surface), so that cells end there',
            RaggedInterfaceWarning,
        )  # fmt: skip


def _surfaces(where: object) -> list[Callable[[PerElement3], Floats]]:
    """Return functions of the distance [m] from the surfaces that define a region; none if it lists elements."""
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
