"""Interaction of cells by the cell law: facets between cells, and the dilatation of cells."""

from collections.abc import Mapping
from copy import copy
from dataclasses import replace
from functools import cached_property
from typing import Any, ClassVar, Self

import numpy as np
from scipy.sparse import bsr_array

from bondem._checks import shown
from bondem._core import run_pass
from bondem._passes import calls
from bondem._tables.stiffness_tables import DilatationRows, FacetRows
from bondem._threads import current_threads
from bondem._types import Floats, Ints, PerBond, PerBond3, PerElement, PerElement3, PerElement6
from bondem.boundary.conditions import Load
from bondem.boundary.loads import Pressure, is_face
from bondem.boundary.wall_constraints import FixedFacets, Supports, on_centres
from bondem.errors import InputError
from bondem.interactions.beams.bond_law import BondStiffness
from bondem.interactions.beams.bond_table import BondTable
from bondem.interactions.cells.cell_body import body_of
from bondem.interactions.cells.cell_bond import CellBond
from bondem.interactions.cells.cell_constants import CellAssignment, CellConstants
from bondem.interactions.cells.cell_plausibility import question_cells
from bondem.interactions.cells.cell_strain import CellStrain
from bondem.interactions.cells.cell_tangent import CellsAtAnyPose
from bondem.interactions.energy_parts import EnergyParts
from bondem.interactions.interaction import Arrays, Boundary, Evaluated
from bondem.interactions.stiffness import Stiffness, new_block_rows
from bondem.specimen.lattice import Lattice
from bondem.specimen.ordering import Layout

_NO_LOADS = "bond_forces: facets of cells have no moments of their own; use bd.cell_stress instead"


class CellInteraction(CellsAtAnyPose):
    """Interaction of cells by their facets and dilatations, in the reference and for small motions."""

    law: ClassVar[type] = CellBond
    bond: ClassVar[str] = "facet"
    turned: ClassVar[str] = "the strains of their cells are not small: use lower loads"
    title: ClassVar[str] = "cell law"
    name: ClassVar[str] = "cells"
    evaluated: ClassVar[Evaluated] = "traction"
    on_facets: ClassVar[bool] = True
    corrects_mass: ClassVar[bool] = True
    isotropic_springs: ClassVar[bool] = True

    def __init__(
        self, lattice: Lattice, layout: Layout, laws: CellAssignment, fixed: FixedFacets, may_fail: bool
    ) -> None:
        super().__init__(lattice, layout)
        self._laws, self._may_fail = laws, may_fail
        self._own = CellConstants.of(lattice, laws, fixed, may_fail=may_fail).ordered(layout)

    @classmethod
    def join(cls, lattice: Lattice, layout: Layout, bond: Any, boundary: Boundary, may_fail: bool) -> Self:
        body_of(lattice)
        for law in bond.values() if isinstance(bond, Mapping) else ():
            if not isinstance(law, cls.law):
                advice = "give bd.CellBond(...) for all cells"
                raise InputError(f"bond= has {shown(law)} in a part of the cells; {advice}")
        return cls(lattice, layout, bond, FixedFacets.of(lattice, boundary), may_fail)

    def question(self) -> None:
        question_cells(self.lattice, self._laws, may_fail=self._may_fail)

    @classmethod
    def require_facets(cls, refusal: str) -> None:
        return

    @classmethod
    def refuse_facets(cls, refusal: str) -> None:
        raise InputError(refusal)

    def on_elements(self, boundary: Boundary) -> Boundary:
        return [one for given in boundary for one in on_centres(given)]

    def facet_forces(self, load: Load | Pressure) -> tuple[Ints, Floats]:
        return load.on_facets(self.lattice) if is_face(load.region) else super().facet_forces(load)

    def under(self, boundary: Boundary) -> Self:
        return self.join(self.lattice, self.layout, self._laws, boundary, self._may_fail)

    @property
    def supports(self) -> Supports:
        return self._own.supports

    def strained(self, strain: PerBond, base: Floats, motion: Floats, pressed: PerElement) -> Self:
        twin, cells = copy(self), self.constants.stretched(strain, self.layout)
        supports = replace(cells.supports.taken(base), motion=motion)
        twin.__dict__["constants"] = replace(cells, supports=supports, pressed=pressed)
        return twin

    def pressed(self, facet: Ints, force: Floats) -> PerElement:
        every = np.zeros((len(self._own.softness), 3))
        every[facet] = force
        return self._own.pressed_by(every)

    def dilatational_stress(self, swelling: PerElement) -> PerElement:
        return self.by_user.stress_of(swelling)

    @cached_property
    def constants(self) -> CellConstants:
        return self._own

    @property
    def by_user(self) -> CellConstants:
        """Constants without strains, user's order, computed at each access."""
        return self._own.ordered(self.layout.reversed)

    @property
    def bonds(self) -> BondStiffness:
        return self.by_user.as_bonds(self.lattice)

    @property
    def table(self) -> BondTable:
        return BondTable.of(self.lattice, self.layout, self.bonds).stretched(self.constants.strain)

    def stiffness(self) -> Stiffness:
        layout, c = self.layout, self.constants
        rows, n = new_block_rows(layout), len(layout.order)
        columns = c.k, c.lever_i, c.lever_j, c.H, c.share_i, c.share_j
        facets = FacetRows(layout.i, layout.j, *map(np.ascontiguousarray, columns))
        forms = np.empty((len(rows.indices), 1, 6))
        run_pass(calls.assemble_facets(facets, rows, DilatationRows(forms)), threads=current_threads())
        indptr, indices, data = rows.indptr, rows.indices, rows.data
        own, form = c.supports.blocks()
        supported = layout.rank[c.supports.cell]
        diagonal = indptr[supported] + (layout.in_start[supported + 1] - layout.in_start[supported])
        np.add.at(data, diagonal, own)
        np.add.at(forms, diagonal, form[:, None])
        return Stiffness(
            bsr_array((data, indices, indptr), shape=(6 * n, 6 * n)),
            bsr_array((forms, indices, indptr), shape=(n, 6 * n)),
            c.weight,
            c.gradients.coupling(c.weight),
            c.gradients.turns((c.gradients.way_a, c.gradients.way_b, c.gradients.wall_way), n),
        )

    def loads(self, pose: Floats, arrays: Arrays) -> Floats:
        raise InputError(_NO_LOADS)

    def small_loads(self, displacement: PerElement3, rotation: PerElement3, strain: PerBond) -> Floats:
        raise InputError(_NO_LOADS)

    def joints(self) -> tuple[PerBond, PerBond, PerBond3]:
        facets, _ = body_of(self.lattice)
        return (facets.area, facets.span, facets.centroid)

    def modulus(self, volume: float) -> float:
        return float(np.median(self._own.modulus))

    def wave_speed(self, mass: PerElement) -> float:
        return float(np.median(np.sqrt(self._own.modulus[self.layout.rank] * self.lattice.element_volume / mass)))

    # ---- small motions

    def small_strain(
        self, displacement: PerElement3, rotation: PerElement3, strain: PerBond, pressed: PerElement
    ) -> CellStrain:
        """Return the deformation by small motions [m, rad], user's order, with walls at their final places.

        `strain` are stress-free strains of the facets [-], internal order, (m,). `pressed` are the volume
        changes V θ of cells by tractions [m³], (n,).
        """
        own, supports = np.empty(len(strain)), self.supports
        own[self.layout.bond_order] = strain
        wall = supports.motion + supports.lever - supports.grown(self.layout.of_elements(strain)).arm
        slip = -own[:, None] * self.lattice.branch
        return CellStrain.of(
            self.lattice, self.by_user, displacement, rotation, slip=slip, wall=wall, pressed=pressed
        )

    def surface_motion(self, displacement: PerElement3, rotation: PerElement3, traction: Floats) -> Floats:
        moved = super().surface_motion(displacement, rotation, traction)
        constants, supports = self.by_user, self.supports
        free = body_of(self.lattice)[1].free
        pressed = constants.pressed_by(free.area[:, None] * traction)
        found = CellStrain.of(self.lattice, constants, displacement, rotation, wall=supports.motion, pressed=pressed)
        pull = traction - found.stress(constants)[free.cell, None] * constants.way
        moved = moved + constants.softness[:, None] * pull
        moved[supports.fixed.facet] = np.where(supports.axes > 0.0, supports.motion, moved[supports.fixed.facet])
        return moved

    def strain_load(self, strain: PerBond, pressed: PerElement) -> PerElement6:
        still = np.zeros((len(pressed), 3))
        found = self.small_strain(still, still, strain, pressed)
        return found.nodal(self.lattice, self.by_user)[self.layout.order]

    def swelling_load(self, pressed: PerElement) -> PerElement6:
        still, wall = np.zeros((len(pressed), 3)), np.zeros_like(self.supports.motion)
        found = CellStrain.of(self.lattice, self.by_user, still, still, wall=wall, pressed=pressed)
        return found.nodal(self.lattice, self.by_user)

    def of_walls(
        self, displacement: PerElement3, rotation: PerElement3, strain: PerBond, pressed: PerElement
    ) -> PerElement6:
        return self.small_strain(displacement, rotation, strain, pressed).of_walls(len(displacement), self.by_user)

    def small_energy(
        self, displacement: PerElement3, rotation: PerElement3, strain: PerBond, pressed: PerElement,
        traction: Floats,
    ) -> EnergyParts:  # fmt: skip
        constants, supports = self.by_user, self.supports
        found = self.small_strain(displacement, rotation, strain, pressed)
        facets, cells = body_of(self.lattice)
        # ½ V λ θ² is the potential of cells and loads; less the work of the loads on the openings of their facets
        opened = constants.softness / cells.free.area @ (traction**2).sum(axis=1)
        opened -= 2.0 * found.stress(constants) @ pressed
        normal = (found.gap * facets.normal).sum(axis=1)
        turned = (found.turn * facets.normal).sum(axis=1)
        along = np.einsum("ma,mab,mb->m", facets.normal, constants.H, facets.normal) * turned**2
        whole = np.einsum("ma,mab,mb->m", found.turn, constants.H, found.turn)
        moments, at_wall = constants.gradients.moments(found.turn, rotation)
        whole += (moments * found.turn).sum(axis=1)
        own = rotation[supports.cell]
        supported = (supports.k[:, None] * found.wall_gap**2).sum() + np.einsum("ga,gab,gb->", own, supports.H, own)
        supported -= (at_wall * rotation).sum()
        stretched = (constants.k * normal**2).sum() + found.stress(constants) @ found.swelling
        return EnergyParts(
            normal=0.5 * float(stretched + supported + opened),
            shear=0.5 * float((constants.k * ((found.gap**2).sum(axis=1) - normal**2)).sum()),
            bending=0.5 * float((whole - along).sum()),
            twisting=0.5 * float(along.sum()),
        )
