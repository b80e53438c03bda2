"""What kernels read of facets that soften and cells that yield, in their order."""

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from bondem._compile import Callback, callback
from bondem._types import Floats, PerBond, PerBond3, PerElement
from bondem.errors import InputError
from bondem.laws.failure.softening import Slip, Softening
from bondem.model.cell_constants import CellConstants, body_of
from bondem.model.layout import Layout
from bondem.specimen.lattice import Lattice

# Share of its strength at which the facets of a cell are looked at: the stress of a pair of cells agrees with the
# traction of their facet, which may be above that of both (`kernels/stress_index.py`).
_MARGIN = 0.7
# The same of other criteria, and of the size of a stress at which they are reached, found in a few directions.
_WIDER, _NEARER = 0.5, 0.7
# Opening where nothing is left of a facet that is too long for its fracture energy, over that at its strength.
_SNAP = 1.05


@dataclass(frozen=True, eq=False)
class SofteningTable:
    """Facets that soften and cells that yield; internal order.

    Attributes:
        strength: f_t of each facet [Pa], (m,).
        last: k u / A at the opening where nothing is left [Pa], 0 where facets break at once, (m,).
        kink, steep: of the softening curve (`bondem.laws.softening.softened`) [-].
        area: [m²], (m,).
        part: part of cell i in the compliance of a facet [-], (m,).
        hot: largest principal stress of a cell from which its facets are looked at [Pa]; of another criterion that
            in uniaxial tension.
        judge: the index of another criterion, or None for the largest principal stress.
        given: its parameters.
        least: smallest size √(σ:σ) of a stress that reaches another criterion [Pa].
        tension: f_t without scatter [Pa].
        friction: μ [-].
        slip: how cells yield, or None.
        fade: share of its cohesion that a cell loses by a slip of 1, (n,).
    """

    strength: PerBond
    last: PerBond
    kink: float
    steep: float
    area: PerBond
    part: PerBond
    hot: float
    judge: Callback | None
    given: Floats
    least: float
    tension: float
    friction: float
    slip: Slip | None
    fade: PerElement

    @classmethod
    def of(
        cls,
        body: Lattice,
        layout: Layout,
        cells: CellConstants,
        softening: Softening,
        factors: Callable[[PerBond, PerBond3, Floats | None], PerBond],
    ) -> "SofteningTable":
        """The table of a body.

        Args:
            body: facets and cells.
            layout: their order in the kernels.
            cells: constants of the law, in that order.
            softening: how they fail.
            factors: strengths over the parameter (`Criterion.factors`).

        Raises:
            InputError: elements that are too long for the fracture energy.
        """
        facets, _ = body_of(body)
        order = layout.bond_order
        factor = factors(facets.area * facets.span, facets.centroid, body.particles.period)[order]
        area, strength = facets.area[order], softening.tension * factor
        last = np.zeros(len(area))
        if softening.fracture_energy > 0.0:
            _check_length(facets.span[order], cells, layout, softening)
            # the last opening, as the traction that it takes from a whole facet
            last = cells.k / area * softening.last * softening.fracture_energy / strength
            last = np.maximum(last, _SNAP * strength / softening.steep)
        depth = np.where(layout.flipped, facets.depth_j[order], facets.depth_i[order])
        other = np.where(layout.flipped, facets.depth_i[order], facets.depth_j[order])
        soft_i, soft_j = depth / cells.G[layout.i], other / cells.G[layout.j]
        fade, surface = np.zeros(len(cells.volume)), softening.surface
        if softening.slip is not None and math.isfinite(softening.slip.fracture_energy):
            fade = np.cbrt(cells.volume) * softening.slip.cohesion / (2.0 * softening.slip.fracture_energy)
        return cls(
            strength=strength, last=last, kink=softening.kink, steep=softening.steep, area=area,
            part=soft_i / (soft_i + soft_j),
            hot=(_MARGIN if surface is None else _WIDER) * float(strength.min(initial=softening.tension)),
            judge=None if surface is None else callback(surface.function, len(surface.values)),
            given=np.array(() if surface is None else surface.values, dtype=float),
            least=0.0 if surface is None else _NEARER * surface.nearest(), tension=softening.tension,
            friction=softening.friction, slip=softening.slip, fade=fade,
        )  # fmt: skip


def _check_length(span: PerBond, cells: CellConstants, layout: Layout, softening: Softening) -> None:
    """Refuse elements that snap back: that stretch more at their strength than the first line opens."""
    i = layout.i
    E = cells.G[i] * (3.0 * cells.lame[i] + 2.0 * cells.G[i]) / (cells.lame[i] + cells.G[i])
    steepest = softening.steep * softening.last
    longest = steepest * E * softening.fracture_energy / softening.tension**2
    if np.median(span / longest) > 1.0:
        raise InputError(
            f"elements {np.median(span):.3g} m long release more energy than fracture_energy="
            f"{softening.fracture_energy:g} J/m² takes up: they snap back above {steepest:.3g} E G_f / f_t² ="
            f" {np.median(longest):.3g} m; use smaller elements, or fracture_energy=None for brittle facets"
        )
