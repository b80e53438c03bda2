"""Strengths and softening of facets, and strengths of yielding cells, internal order."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from bondem._tables.crack_tables import FacetStrengths
from bondem._types import Floats, Ints, Mask, PerBond, PerElement
from bondem.damage.cohesive_softening import SNAP, Softening, StressIndex
from bondem.damage.crack_columns import FACET, ONSET
from bondem.damage.failure_assignment import FailurePart
from bondem.damage.shear_bands import band_widths, cells_of_bands
from bondem.errors import InputError
from bondem.interactions.cells.cell_body import body_of
from bondem.interactions.cells.cell_constants import CellConstants
from bondem.specimen.lattice import Lattice
from bondem.specimen.ordering import Layout

# Share of the strength from which on the facets of a cell are evaluated. The stress of a pair of cells agrees with
# the traction of their facet, and may exceed that of both cells (`core/laws/agreed_stress.hpp`).
_MARGIN = 0.7
# For other criteria: this share of the strength, and the reduction of the least stress that reaches them, because it
# is computed in some directions only.
_WIDER, _NEARER = 0.5, 0.7
# Excess of the element length that no refinement can cure (a million times as many elements): a unit error.
_OUT_OF_REACH = 100.0


@dataclass(frozen=True, eq=False)
class SlipTable:
    """Yielding of each cell by its `bondem.damage.cohesive_softening.Slip`, internal order, (n,) each.

    Attributes:
        cone: True for Drucker–Prager, False for Mohr–Coulomb.
        strength: c cos φ, or k of the cone [Pa]; inf for cells that do not yield.
        slope: sin φ, or α [-].
        dilation: sin ψ, or β [-].
        fade: share of its cohesion that a cell loses per mean slip, B c / 2 G_II with the width B of
            bands [-].
        near_start, near: cells over which the slip of each is averaged (`damage/shear_bands.py`), (n + 1,), (l,).
    """

    cone: bool
    strength: PerElement
    slope: PerElement
    dilation: PerElement
    fade: PerElement
    near_start: Ints
    near: Ints

    @classmethod
    def of(
        cls, body: Lattice, layout: Layout, volume: PerElement, parts: tuple[FailurePart, ...]
    ) -> "tuple[SlipTable, ...]":
        """Return the table of a body in a tuple, which is empty if no cell can yield.

        Args:
            body: the body of cells.
            layout: internal order of the cells.
            volume: volumes of the cells [m³], in that order, (n,).
            parts: criteria with their cells.

        Raises:
            InputError: Shear bands are too thin for the cells, or too wide for a periodic body.
        """
        n, cone, rank = len(volume), False, layout.rank
        strength, slope, dilation, fade = np.full(n, np.inf), np.zeros(n), np.zeros(n), np.zeros(n)
        given = np.zeros(n)
        for part in parts:
            for slip in (one for softening in part.criterion._softenings for one in softening.slips):
                own, cone = rank[part.elements], slip.cone
                strength[own], slope[own], dilation[own] = slip.strength, slip.slope, slip.dilation
                given[own], fade[own] = slip.width or 0.0, slip.cohesion / (2.0 * slip.fracture_energy)
        edge, yields = np.cbrt(volume), np.isfinite(strength)
        if not yields.any():
            return ()
        width = band_widths(edge, yields, given)
        near_start, near = cells_of_bands(body, layout.order, edge, yields, width)
        return (cls(cone, strength, slope, dilation, width * fade, near_start, near),)

    def spent(self, slipped: PerElement) -> PerElement:
        """Return the share of its cohesion that each cell has lost [-], (n,), by the slips of all cells [-], (n,)."""
        count = np.diff(self.near_start)
        own = np.repeat(np.arange(len(count)), count)
        mean = np.bincount(own, weights=slipped[self.near], minlength=len(count)) / np.maximum(count, 1)
        return np.minimum(self.fade * mean, 1.0)


@dataclass(frozen=True, eq=False)
class SofteningTable:
    """Facets that soften and cells that yield; internal order.

    Attributes:
        strength: f_t of each facet [Pa], (m,).
        absorbed: energy that a facet absorbs as it fractures [J], (m,): G_f A; the larger of G_f A and G_II A for a
            material plane that slips; inf for brittle facets.
        last: k u / A at the last opening [Pa], 0 for brittle facets, (m,).
        kink, steep: parameters of the softening curve (`core/laws/softening.hpp`) [-].
        area: areas [m²], (m,).
        part: share of cell i in the compliance of a facet [-], (m,).
        hot: size √(σ:σ) of the stress of a cell from which on its facets are evaluated [Pa]. With `judge` they are
            evaluated where this stress times tension / hot reaches `judge`.
        judge: criterion other than the largest principal stress, or None.
        least: lower bound of the sizes √(σ:σ) of stresses that reach `judge` [Pa]; 0 without `judge`.
        tension: f_t without scatter [Pa].
        friction: μ of each facet [-], (m,).
        plane: mask of facets of material planes, evaluated by their own traction, (m,).
        cohesion: cohesion of such facets [Pa], inf for those that do not slip and for all others, (m,).
        last_slip: k u / A of such facets at the slip that exhausts the cohesion [Pa], (m,).
        yielding: yielding of cells, none or one.
    """

    strength: PerBond
    absorbed: PerBond
    last: PerBond
    kink: float
    steep: float
    area: PerBond
    part: PerBond
    hot: float
    judge: StressIndex | None
    least: float
    tension: float
    friction: PerBond
    plane: Mask
    cohesion: PerBond
    last_slip: PerBond
    yielding: tuple[SlipTable, ...]

    def absorbed_by(self, cracks: Floats) -> Floats:
        """Return the energy that cracked facets absorb as they fracture [J], (c,); 0 if a cell had lost its cohesion.

        Args:
            cracks: rows of the facets (`bondem.damage.crack_columns`), (c, CRACK_COLUMNS).
        """
        return np.where(cracks[:, ONSET] > 0.0, self.absorbed[cracks[:, FACET].astype(np.int64)], 0.0)

    def strengths(
        self, fastest: PerBond | None = None, filled: Callable[[PerBond], PerBond] = np.ascontiguousarray
    ) -> FacetStrengths:
        """Return the table in the layout of the core.

        Args:
            fastest: largest loss of integrity of brittle facets in a step [-], (m,); 0 without steps.
            filled: function that fills a column to the length that passes need.
        """
        with np.errstate(divide="ignore"):
            brittleness, slip = 1.0 / self.last, 1.0 / self.last_slip
        return FacetStrengths(
            filled(self.area), filled(self.strength), filled(self.absorbed), filled(brittleness), filled(self.part),
            filled(np.zeros(len(self.area)) if fastest is None else fastest), filled(self.friction),
            filled(self.plane.astype(float)), filled(self.cohesion), filled(slip),
            np.flatnonzero(self.plane).astype(np.int64), self.kink, self.steep, self.hot,
        )  # fmt: skip

    @classmethod
    def of(
        cls, body: Lattice, layout: Layout, cells: CellConstants, parts: tuple[FailurePart, ...]
    ) -> "SofteningTable | None":
        """Return the table of a body, or None if no criterion has cracks or yielding cells.

        Args:
            body: facets and cells.
            layout: order of the bonds.
            cells: constants of the law, in that order.
            parts: criteria with their facets and cells.

        Raises:
            InputError: Elements are too long for the fracture energy, or shear bands do not fit the cells or the
                period.
        """
        materials = [softening for one in parts for softening in one.criterion._softenings]
        if not materials:
            return None
        softening = materials[0]
        facets, _ = body_of(body)
        order, surface = layout.bond_order, softening.surface
        area = facets.area[order]
        strength, last, friction = np.full(len(area), np.inf), np.zeros(len(area)), np.zeros(len(area))
        plane = np.zeros(len(area), dtype=bool)
        cohesion, last_slip, absorbed = np.full((3, len(area)), np.inf)
        back = np.empty_like(order)
        back[order] = np.arange(len(order))
        for part in parts:
            soft, own = part.criterion.softening, back[part.bonds]
            assert soft is not None
            factor = part.criterion.factors(
                facets.area * facets.span, facets.centroid, body.particles.period, body.volume
            )[part.bonds]
            strength[own], friction[own] = soft.tension * factor, soft.friction
            plane[own] = part.plane
            # ends of softening as tractions: those of an uncracked facet with this slip or opening
            stiff, slips = cells.k[own] / area[own], soft.slips if part.plane else ()
            for slip in slips:
                cohesion[own] = slip.cohesion * factor
                end = stiff * 2.0 * slip.fracture_energy / cohesion[own]
                last_slip[own] = np.maximum(end, SNAP * cohesion[own])
            if soft.fracture_energy > 0.0:
                absorbed[own] = max([soft.fracture_energy, *(slip.fracture_energy for slip in slips)]) * area[own]
                require_short(facets.span[part.bonds], cells.modulus[layout.i[own]], soft)
                end = stiff * soft.last * soft.fracture_energy / strength[own]
                last[own] = np.maximum(end, SNAP * strength[own] / soft.steep)
            if part.open:
                absorbed[own] = np.inf
        depth = np.where(layout.flipped, facets.depth_j[order], facets.depth_i[order])
        other = np.where(layout.flipped, facets.depth_i[order], facets.depth_j[order])
        soft_i, soft_j = depth / cells.G[layout.i], other / cells.G[layout.j]
        least = float(strength[~plane].min(initial=max(soft.tension for soft in materials)))
        return cls(
            strength=strength, absorbed=absorbed, last=last, kink=softening.kink, steep=softening.steep, area=area,
            part=soft_i / (soft_i + soft_j), hot=(_MARGIN if surface is None else _WIDER) * least,
            judge=surface,
            least=0.0 if surface is None else _NEARER * surface.nearest(), tension=softening.tension,
            friction=friction, plane=plane, cohesion=cohesion, last_slip=last_slip,
            yielding=SlipTable.of(body, layout, cells.volume, parts),
        )  # fmt: skip


def require_short(span: PerBond, E: PerBond, softening: Softening) -> None:
    """Reject elements that snap back, because they release more energy than their crack absorbs at first.

    Such elements stretch more at their strength than up to the opening at which the first line of the softening curve
    would reach zero.

    Args:
        span: lengths across the facets of a material [m], (c,).
        E: Young's modulus of their cells [Pa], (c,).
        softening: softening of the material.

    Raises:
        InputError: More than half of the elements are too long for the fracture energy.
    """
    if not len(span):
        return
    steepest = softening.steep * softening.last
    longest = steepest * E * softening.fracture_energy / softening.tension**2
    excess = float(np.median(span / longest))
    if excess > 1.0:
        advice = "use smaller elements, or fracture_energy=None for brittle facets"
        if excess > _OUT_OF_REACH:
            advice = "check the units of the strength, the fracture energy and E (SI)"
        raise InputError(
            f"elements {np.median(span):.3g} m long release more energy than fracture_energy="
            f"{softening.fracture_energy:g} J/m² absorbs: they snap back above {steepest:.3g} E G_f / f_t² ="
            f" {np.median(longest):.3g} m; {advice}"
        )
