"""Forces of a body of cells in any pose, and their derivative, for Newton's method."""

from abc import abstractmethod
from dataclasses import dataclass

import numpy as np
from scipy.sparse import bsr_array, csr_array

from bondem._cache_lines import lines
from bondem._core import run_pass
from bondem._passes import calls
from bondem._tables.cell_tables import (
    CellDilatation,
    CellEnergies,
    CellPoses,
    DilatationGradients,
    ElasticFacets,
    WallConstraints,
)
from bondem._tables.damage_tables import FailureIndices, Strengths
from bondem._tables.step_tables import BeamSums, Poses
from bondem._tables.stiffness_tables import BondTangents
from bondem._types import Floats, PerBond, PerElement6
from bondem.geometry.rotations import relative_rotations, turned_vectors
from bondem.interactions.beams.bond_table import BondTable
from bondem.interactions.cells.cell_constants import CellConstants
from bondem.interactions.cells.cell_tables import STRESS, cell_tables, gradient_tables
from bondem.interactions.energy_parts import EnergyParts
from bondem.interactions.interaction import Arrays, Interaction, SurfaceState
from bondem.interactions.stiffness import Stiffness
from bondem.interactions.stiffness_product import Product, loads_in, product_by
from bondem.specimen.local_origin import local_rest


@dataclass(frozen=True, eq=False)
class BodyTables:
    """Tables of the facets, cells and walls of a body in the layout of the core.

    Tractions on facets are constant: those of the constants, or of a `SurfaceState`.

    Attributes:
        facets: facets of the body.
        cells: cells of the body.
        gradients: gradients of the dilatation.
        walls: facets that walls constrain.
    """

    facets: ElasticFacets
    cells: CellDilatation
    gradients: DilatationGradients
    walls: WallConstraints

    @classmethod
    def of(
        cls, law: "CellsAtAnyPose", constants: CellConstants, integrity: PerBond, surface: SurfaceState | None = None
    ) -> "BodyTables":
        """Return the tables of a body with facets of a given integrity [-], (m,).

        Walls and tractions on facets are those of `surface`, or of the constants if it is None.
        """
        layout = law.layout
        base, motion, pressed = surface or (None, constants.supports.motion, constants.pressed)
        walls = constants.supports.table(layout, np.zeros(len(layout.order), dtype=np.int64), base)
        walls.wall[:] = motion
        facets, cells = cell_tables(constants, layout, law.period, integrity, layout.i)
        cells.given[:] = pressed
        return cls(facets, cells, gradient_tables(constants.gradients, len(layout.order), walls), walls)

    def load(self, pose: Floats, rest: Floats, sums: Floats) -> None:
        """Add loads of facets and walls on cells to `sums` [N, N·m], (n, 8); store stresses λ θ in the poses."""
        to = BeamSums(self.facets.i, self.facets.j, sums)
        run_pass(calls.load_body(CellPoses(pose, rest), *self.tables, to))

    def energies(self, pose: Floats, rest: Floats) -> EnergyParts:
        """Return the energies of facets, cells and walls in a pose [J]; the normal part includes the dilatation."""
        found = np.empty(4)
        run_pass(calls.measure_cell_energies(CellPoses(pose, rest), *self.tables, CellEnergies(found)))
        return EnergyParts(*found.tolist())

    @property
    def tables(self) -> tuple[ElasticFacets, CellDilatation, DilatationGradients, WallConstraints]:
        """All four tables, in the order of the passes of a body."""
        return self.facets, self.cells, self.gradients, self.walls


class CellsAtAnyPose(Interaction):
    """Interaction of cells in any pose: energy, forces, and their derivative for Newton's method."""

    @property
    @abstractmethod
    def constants(self) -> CellConstants:
        """Constants of the law, internal order."""

    def product(self, pose: Floats, integrity: PerBond, table: BondTable) -> Product:
        body, poses = BodyTables.of(self, self.constants, integrity), CellPoses(pose, self._rest)
        body.walls.wall[:] = 0.0
        body.load(pose, poses.rest, lines(len(pose)))  # stresses of cells, bending of layers
        body.cells.given[:] = 0.0
        return product_by(len(pose), lambda by: calls.multiply_body(poses, by, *body.tables))

    @property
    def _rest(self) -> Floats:
        """Centres at rest [m], internal order, (n, 3)."""
        return local_rest(self.lattice)[self.layout.order]

    def energy(
        self, pose: Floats, rest: Floats, integrity: PerBond, strain: PerBond, surface: SurfaceState | None = None
    ) -> EnergyParts:
        constants = self.constants.stretched(strain, self.layout).damaged(integrity, self.layout.i, self.layout.j)
        return BodyTables.of(self, constants, integrity, surface).energies(pose, rest)

    def indices(self, pose: Floats, arrays: Arrays, kind: str, strengths: Strengths) -> PerBond:
        layout, constants = self.layout, self.constants.stretched(arrays["rest_strain"], self.layout)
        facets, _ = cell_tables(constants, layout, self.period, arrays["integrity"], layout.i)
        found = FailureIndices(np.zeros(len(facets.i)))
        run_pass(calls.INDEX_FACETS_BY[kind](Poses(pose), facets, strengths, found))
        return found.index[: len(layout.i)]

    def tangent(self, pose: Floats, data: Floats, pattern: bsr_array) -> Stiffness:
        supported, own = self._support_blocks(pose)
        diagonal = pattern.indptr[:-1] + np.diff(self.layout.in_start)
        np.add.at(data, diagonal[supported], own)
        bonds = bsr_array((data, pattern.indices, pattern.indptr), shape=pattern.shape)
        return Stiffness(bonds, self._current_forms(pose, pattern), self.constants.weight, *self._gradients_at(pose))

    def gradient(self, pose: Floats) -> tuple[PerElement6, PerElement6]:
        """Return the derivative of the energy, and wall loads [N, N·m], (n, 6) each; store stresses in the pose."""
        body = BodyTables.of(self, self.constants, np.ones(len(self.layout.i)))
        sums, walls = lines(len(pose)), np.zeros((len(pose), 6))
        body.load(pose, self._rest, sums)
        np.add.at(walls, body.walls.cell, body.walls.load)
        return -loads_in(sums), walls

    def bond_tangents(self, pose: Floats) -> Floats:
        """Return tangents of facets (`Interaction.bond_tangents`); stresses of cells are those of the pose."""
        m = len(self.layout.i)
        facets = BodyTables.of(self, self.constants, np.ones(m)).facets
        found = BondTangents(np.empty((12, 12, len(facets.i))))
        run_pass(calls.differentiate_facets(Poses(pose), facets, found))
        return found.tangent[:, :, :m]

    def _current_forms(self, pose: Floats, pattern: bsr_array) -> bsr_array:
        """Return volume changes V θ of cells by unit motions from the present pose [m², m³], 1×6 blocks, (n, 6 n)."""
        layout, cells = self.layout, self.constants
        i, j = layout.i.astype(np.int64), layout.j.astype(np.int64)
        a, b = turned_vectors(pose[i, 4:], cells.lever_i), turned_vectors(pose[j, 4:], cells.lever_j)
        gap = self.lattice.particles.nearest(pose[j, :3] - pose[i, :3]) + b - a
        start, inward = pattern.indptr, np.diff(layout.in_start)
        diagonal, place = start[:-1] + inward, np.arange(len(i))
        forms = np.zeros((len(pattern.indices), 1, 6))
        for end, lever, share, sign, other, far in (
            (i, a, turned_vectors(pose[i, 4:], cells.share_i), -1.0, j, b),
            (j, b, turned_vectors(pose[j, 4:], cells.share_j), 1.0, i, a),
        ):
            own = sign * np.hstack([share, np.cross(lever, share)])
            own[:, 3:] += np.cross(share, gap)
            np.add.at(forms[:, 0], diagonal[end], own)
            towards = -sign * np.hstack([share, np.cross(far, share)])
            if other is i:  # row j, column i
                forms[start[j] + place - layout.in_start[j], 0] = towards
            else:
                leaving = layout.i[layout.out_bond]
                forms[diagonal[leaving] + 1 + place - layout.out_start[leaving], 0] = towards[layout.out_bond]
        supports = cells.supports
        supported = layout.rank[supports.cell]
        lever = turned_vectors(pose[supported, 4:], supports.arm)
        np.add.at(forms[:, 0], diagonal[supported], -np.hstack([supports.share, np.cross(lever, supports.share)]))
        return bsr_array((forms, pattern.indices, start), shape=(len(pose), 6 * len(pose)))

    def _support_blocks(self, pose: Floats) -> tuple[np.ndarray, Floats]:
        """Return the cells that walls constrain, (g,), and their parts of diagonal blocks in a pose, (g, 6, 6)."""
        supports = self.constants.supports
        supported = self.layout.rank[supports.cell]
        arm = turned_vectors(pose[supported, 4:], supports.arm)
        moved = pose[supported, :3] + arm - self._rest[supported] - supports.lever
        force = supports.k[:, None] * supports.axes * (supports.motion - moved)
        force = force + pose[supported, STRESS, None] * supports.share
        own, _ = supports.blocks(arm)
        # the lever turns under the force
        along = (arm * force).sum(axis=1)[:, None, None] * np.eye(3) - arm[:, :, None] * force[:, None, :]
        own[:, 3:, 3:] += 0.5 * (along + np.swapaxes(along, 1, 2))
        return supported, own

    def _gradients_at(self, pose: Floats) -> tuple[csr_array | None, bsr_array | None]:
        """Return the matrices S and T of `Stiffness` for the gradients of the dilatation, in the present pose.

        They neglect that n × s of bent layers, with the normal n and shares s, changes as their cells rotate.
        """
        cells = self.constants
        gradients = cells.gradients
        w, v = relative_rotations(pose[gradients.a, 4:], pose[gradients.b, 4:])
        ways = tuple(
            turned_vectors(
                np.repeat(pose[gradients.a, 4:], 2, axis=0),
                (w[:, None, None] * way + np.cross(v[:, None], way)).reshape(-1, 3),
            ).reshape(-1, 2, 3)
            for way in (gradients.way_a, gradients.way_b)
        )  # fmt: skip
        own = pose[gradients.wall_cell, 4:]
        w, v = relative_rotations(own * [1.0, -1.0, -1.0, -1.0], np.eye(4)[np.zeros(len(own), dtype=np.int64)])
        at_wall = w[:, None, None] * gradients.wall_way + np.cross(v[:, None], gradients.wall_way)
        return gradients.coupling(cells.weight), gradients.turns((ways[0], ways[1], at_wall), len(pose))
