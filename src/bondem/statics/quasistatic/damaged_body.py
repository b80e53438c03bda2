"""Body of cells whose facets have any integrity, in small motions: its matrix, and the loads of its facets.

A facet of integrity s follows `core/laws/softening.hpp`, for small motions. It consists of two springs of stiffness
k, one towards each cell. A spring in compression keeps its stiffness along the normal n. Its stiffness is then
k (s 1 + (1 - s) n⊗n), and its share of the dilatation changes likewise. A facet with a pressure along its crack
softens in one direction e: its springs have k (1 - (1 - s) e⊗e) where it opens, else k. Closed cracks have no
friction. All values are for a load factor of 1, and proportional to the factor.
"""

from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from bondem._tables.quasistatic_tables import WeakenedFacets
from bondem._tables.stress_onset_tables import LoadedFacets
from bondem._types import ArrayLike, Floats, Ints, Mask, PerElement3
from bondem.damage.proportional_onset import softening_along
from bondem.interactions.cells.cell_body import body_of
from bondem.interactions.cells.cell_strain import CellStrain
from bondem.interactions.cells.cell_tables import STRESS
from bondem.model.model import Model
from bondem.model.state import State
from bondem.observables.facet_loads import loads_on_facets
from bondem.observables.posed_state import in_equilibrium
from bondem.statics.linear import System
from bondem.statics.quasistatic.facet_matrix import FacetMatrix, facet_stiffness
from bondem.statics.quasistatic.facet_passes import OpenedFacets
from bondem.statics.quasistatic.taken_cracks import CrackedHalves, taken_cracks

# Integrity of broken facets in the matrix, so that it has an inverse although cells may be cut off on all sides.
_NONE = 1e-7
_XX = ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))


@dataclass(frozen=True, eq=False)
class Loaded:
    """Loads of facets and cells, internal order.

    Attributes:
        traction: traction of each facet [Pa], (m, 3).
        bending: opening traction T_b by bending, of each facet with full integrity [Pa], (m,).
        tensor: σ of each cell, xx, yy, zz, xy, xz, yz [Pa], (n, 6).
        cracked: facets that have lost integrity, (c,).
        opening: traction of cracked facets as if they had full integrity [Pa], (c, 3).
        opened: size of the pulling part of `opening`, |F⁺| / A [Pa], (c,).
        turned: mask of the halves of cracked facets that have to be closed or opened now, (c, 2).
        wall: force of the walls on the facets that they fix [N], (g, 3).
        stress: dilatation stress λ θ of each cell [Pa], (n,).
    """

    traction: Floats
    bending: Floats
    tensor: Floats
    cracked: Ints
    opening: Floats
    opened: Floats
    turned: Mask
    wall: Floats
    stress: Floats


class _Moved(NamedTuple):
    """Motions of all elements, user's order."""

    displacement: PerElement3  #: [m], (n, 3)
    rotation: PerElement3  #: [rad], (n, 3)


class DamagedBody:
    """Facets of a body, each with its integrity, and the matrix that belongs to them.

    Attributes:
        integrity: integrity of the facets, (m,).
        closed: mask of the halves of cracked facets in compression, (m, 2).
        across: unit vector of the only direction in which each facet softens, zero if it softens in all, (m, 3).
        area: areas of the facets [m²], (m,).
        system: the whole body and its supports.
        given: volume change of cells at rest, from moved walls and tractions on free facets [m³], (n,).
        load: forces and torques on cells at rest, without those of the dilatation `given` [N, N·m], (6 n,).
        motion: displacements and rotations of driven elements, not of walls [m, rad], (6 n,).
    """

    def __init__(self, model: Model, system: System, root: Floats) -> None:
        """Prepare a body with uncracked facets.

        Args:
            model: model of cells.
            system: matrix and supports of the body.
            root: matrix S of each element that scales its unknowns, (n, 6, 6).
        """
        layout, order = model.layout, model.layout.order
        self.model, self.constants = model, model.cell_law.constants
        self.i, self.j = layout.i.astype(np.int64), layout.j.astype(np.int64)
        facets, cells = body_of(model.lattice)
        self.area = facets.area[layout.bond_order]
        # part of cell i in the compliance of a facet
        soft_i = np.where(layout.flipped, facets.depth_j[layout.bond_order], facets.depth_i[layout.bond_order])
        soft_j = np.where(layout.flipped, facets.depth_i[layout.bond_order], facets.depth_j[layout.bond_order])
        soft_i, soft_j = soft_i / self.constants.G[self.i], soft_j / self.constants.G[self.j]
        self._part = soft_i / (soft_i + soft_j)
        self.integrity = np.ones(len(self.i))
        self.closed = np.zeros((len(self.i), 2), dtype=bool)
        self.across = np.zeros((len(self.i), 3))
        c = self.constants
        self.weakened = WeakenedFacets(
            self.i, self.j, c.k, self.area, self._part, c.lever_i, c.lever_j, c.share_i, c.share_j, c.normal, c.H,
            self.integrity, self.closed.view(np.uint8), self.across,
        )  # fmt: skip
        self._facets = OpenedFacets(self.weakened, len(order))
        self.matrix = FacetMatrix(system.matrix, layout, root)
        self.system = replace(system, matrix=self.matrix.plain)
        self._slack, self._of_sides = np.zeros(len(order)), self.constants.slack()
        self._soft = c.volume / c.G

        users, still = model.cell_constants, np.zeros((len(order), 3))
        supports = users.supports
        at_rest = CellStrain.of(model.lattice, users, still, still, wall=supports.motion, pressed=model.pressed)
        self.given = at_rest.swelling[order]
        self._right: Floats | None = None  # valid until the next facet loses integrity
        rigid = replace(users, weight=np.zeros_like(users.weight))
        walls = at_rest.nodal(model.lattice, rigid)[order]
        self.load = (walls + model.constraints.final_load(len(order))).ravel()
        self.motion = model.constraints.final_motion(len(order)).ravel()
        self._supported = layout.rank[supports.cell]
        free, force = cells.free, loads_on_facets(model)
        self._pressed = np.zeros((len(order), 6))
        loaded = np.flatnonzero(np.abs(force).sum(axis=1))
        arm = free.centroid[loaded] - cells.centroid[free.cell[loaded]]
        _add_moments(self._pressed, layout.rank[free.cell[loaded]], arm, force[loaded])

    @property
    def left(self) -> Floats:
        """Integrity of the facets, 0 for broken ones, (m,)."""
        return np.where(self.integrity > _NONE, self.integrity, 0.0)

    @property
    def right(self) -> Floats:
        """Forces and torques that the displacements must balance [N, N·m], (6 n,)."""
        if self._right is None:
            self._right = self.load - self.matrix.swelling_force(self.system.matrix.weight * self.given)
        return self._right

    @property
    def pull(self) -> Floats:
        """Forces and torques K u of the prescribed motions u, with all other elements at rest [N, N·m], (6 n,)."""
        return self.matrix.force(self.motion) if self.motion.any() else self.motion

    def potential(self, motion: Floats) -> float:
        """Return the energy at a motion (6 n,) less the work of loads, up to a constant that no facet changes [J]."""
        stored = 0.5 * float(motion @ self.matrix.force(motion))
        stored += 0.5 * float(self.system.matrix.weight @ self.given**2)
        return stored - float(self.right @ motion)

    def size(self, found: Loaded) -> float:
        """Return Σ V σ:σ / 2 G of the cells, which is 1 + ν times twice their energy in tension [J]."""
        square = (found.tensor[:, :3] ** 2).sum(axis=1) + 2.0 * (found.tensor[:, 3:] ** 2).sum(axis=1)
        return 0.5 * float(self._soft @ square)

    def residual_energy(self, found: Loaded) -> float:
        """Return the energy of the residual stiffness of facets with zero integrity [J]."""
        none = found.cracked[self.integrity[found.cracked] <= _NONE]
        opened = found.opened[self.integrity[found.cracked] <= _NONE]
        force = self.area[none] * np.hypot(opened, found.bending[none])
        return 0.5 * _NONE * float((force**2 / self.constants.k[none]).sum())

    def state(self, motion: Floats, factor: float, *, balanced: bool = True) -> State:
        """Return the state at rest under a load factor, of a model whose conditions are constant at this factor.

        Args:
            motion: displacements and rotations at a factor of 1 [m, rad], (6 n,).
            factor: load factor [-].
            balanced: True if the body is in equilibrium. False if facets have just failed, so that a run must compute
                the forces first.
        """
        moved = _Moved(*np.hsplit(factor * motion.reshape(-1, 6)[self.model.layout.rank], 2))
        state = in_equilibrium(self.model, moved, factor)
        state.integrity[:] = self.left
        found, table = self.loaded(motion), self.model.softening
        state.pose[:, STRESS] = factor * found.stress
        if table is not None:
            state.facet_force[:] = factor * (self.area[:, None] * found.traction).T
            k = found.cracked
            along = (found.opening, self.left[k], self.across[k])
            opened = softening_along(self.facets(found), table.strengths(), k, *along)
            state.cracks = taken_cracks(table, self._halves(found, factor), opened)
        state.stale = not balanced
        return state

    def facets(self, found: Loaded) -> LoadedFacets:
        """Return the table of the loads of facets and cells that criteria evaluate."""
        return LoadedFacets(self.i, self.j, self.weakened.normal, found.traction, found.bending, found.tensor)

    def _halves(self, found: Loaded, factor: float) -> CrackedHalves:
        """Return the halves of cracked facets at a load factor; `found` must be the last result of `loaded`."""
        c, k = self.weakened, found.cracked
        part, stretched = self._part[k], c.k[k, None] * self._facets.motions.gap[k]
        force = [
            stretched + (found.stress[cell[k]] / of)[:, None] * share[k]
            for cell, of, share in ((self.i, part, c.share_i), (self.j, 1.0 - part, c.share_j))
        ]
        return CrackedHalves(k, c.k[k], part, c.normal[k], self.across[k], self.left[k], factor * np.stack(force))

    def weaken(self, facets: Ints, integrity: ArrayLike, closed: ArrayLike, across: ArrayLike | None = None) -> None:
        """Set the integrity of some facets, at least 1e-7, and their halves in compression.

        Args:
            facets: internal numbers, each once, (c,).
            integrity: integrity of the facets, (c,) or one for all.
            closed: mask of their halves in compression, (c, 2) or (2,) for all.
            across: unit vector of the only direction in which each facet softens, zero if it softens in all, (c, 3);
                None for no change.
        """
        before = self._stiffness(facets)
        self._weigh(facets, -1.0)
        self.integrity[facets], self.closed[facets] = np.maximum(integrity, _NONE), closed
        if across is not None:
            self.across[facets] = across
        after = self._stiffness(facets)
        self._weigh(facets, 1.0)
        self.matrix.add(facets, *(new - old for new, old in zip(after, before, strict=True)))
        self._right = None

    def restore(self, integrity: Floats, closed: Mask) -> None:
        """Restore earlier integrities (m,) and closed halves (m, 2) of all facets."""
        other = np.flatnonzero((integrity != self.integrity) | (closed != self.closed).any(axis=1))
        self.weaken(other, integrity[other], closed[other])

    def _stiffness(self, facets: Ints) -> tuple[Floats, Floats, Floats]:
        c, w = self.weakened, self._part[facets]
        s, along = self.integrity[facets, None], self._along(facets)
        whole, (one, other) = np.where(self.in_one[facets, None], 1.0, s), self._apart(facets)
        D = ((w * one + (1.0 - w) * other)[:, None] * (1.0 - s) * along)[:, :, None] * along[:, None, :]
        D += whole[:, :, None] * np.eye(3)
        shares = tuple(
            whole * share + apart[:, None] * (1.0 - s) * (share * along).sum(axis=1)[:, None] * along
            for share, apart in ((c.share_i[facets], one), (c.share_j[facets], other))
        )
        return facet_stiffness(
            (c.lever_i[facets], c.lever_j[facets]), c.k[facets, None, None] * D, s[:, :, None] * c.H[facets],
            (shares[0], shares[1]),
        )  # fmt: skip

    @property
    def in_one(self) -> Mask:
        """Mask of the facets that soften in one direction alone, (m,)."""
        return (self.across != 0.0).any(axis=1)

    def _along(self, facets: Ints) -> Floats:
        """Return the only direction in which each facet softens, or its normal if it softens in all, (c, 3)."""
        return np.where(self.in_one[facets, None], self.across[facets], self.weakened.normal[facets])

    def _apart(self, facets: Ints) -> Floats:
        """Return the stiffness of halves along `_along` less that across it, over k (1 - s), (2, c): 1, 0 or -1."""
        return (self.closed[facets] - self.in_one[facets, None].astype(float)).T

    def _weigh(self, facets: Ints, sign: float) -> None:
        """Add the lost integrity of facets to the compliance of their cells, times a sign, and set their weights."""
        c, weight, open_part = self.weakened, self.constants.weight, sign * (1.0 - self.integrity[facets])
        (slack_i, slack_j), along, (one, other) = self._of_sides, self._along(facets), self._apart(facets)
        for cells, slack, share, apart in (
            (self.i[facets], slack_i[facets], c.share_i[facets], one),
            (self.j[facets], slack_j[facets], c.share_j[facets], other),
        ):
            part, square = (share * along).sum(axis=1) ** 2, (share**2).sum(axis=1)
            part = np.divide(part, square, out=np.zeros_like(part), where=square > 0.0)
            across = np.where(self.in_one[facets], 0.0, 1.0) - apart * part
            np.add.at(self._slack, cells, open_part * slack * across)
            self.system.matrix.weight[cells] = weight[cells] / (1.0 + weight[cells] * self._slack[cells])

    def loaded(self, motion: Floats) -> Loaded:
        """Return the loads of facets and cells under displacements and rotations (6 n,)."""
        c, supports = self.constants, self.model.interaction.supports
        u, phi = (np.ascontiguousarray(part) for part in np.hsplit(motion.reshape(-1, 6), 2))
        n, rank = len(u), self.model.layout.rank
        swelling = self._facets.swelling(u, phi, self.given)
        if len(self._supported):
            moved = supports.gap(u[rank], phi[rank])  # the motion of walls is in `given`
            swelling += np.bincount(self._supported, (supports.share * moved).sum(axis=1), n)
        stress = self.system.matrix.weight * swelling
        loading = self._facets.load(stress, self._pressed)
        tensor, wall = loading.moment, np.zeros((0, 3))
        if len(self._supported):
            gap = supports.gap(u[rank], phi[rank], supports.motion)
            wall = supports.k[:, None] * gap + stress[self._supported, None] * supports.share
            _add_moments(tensor, self._supported, supports.lever, wall)
        tensor /= c.volume[:, None]
        cracked = np.flatnonzero(self.integrity < 1.0)
        return Loaded(
            loading.traction, loading.bending, tensor, cracked, loading.opening[cracked], loading.opened[cracked],
            loading.turned[cracked].astype(bool), wall, stress,
        )  # fmt: skip


def _add_moments(moment: Floats, owner: Ints, arm: Floats, force: Floats) -> None:
    """Add the symmetric parts of b⊗f, of arms b and forces f (c, 3), to the sums V σ of cells `owner` [J], (n, 6)."""
    for column, (a, b) in enumerate(_XX):
        part = arm[:, a] * force[:, b] if a == b else 0.5 * (arm[:, a] * force[:, b] + arm[:, b] * force[:, a])
        moment[:, column] += np.bincount(owner, part, len(moment))
