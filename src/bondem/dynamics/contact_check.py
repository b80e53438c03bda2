"""Checks of the contacts of a run against the range of their law and of the time step."""

import warnings
from typing import NamedTuple, cast

import numpy as np
from scipy.spatial import KDTree

from bondem._names import users_line
from bondem._tables.columns import CrackStatus
from bondem._types import Floats, Ints, Uint32s
from bondem.damage.crack_columns import FACET, STATUS
from bondem.damage.softening_table import SofteningTable
from bondem.errors import ContactWarning
from bondem.geometry.rotations import turned_vectors
from bondem.interactions.contact.contact_model import ContactModel
from bondem.model.model import Model
from bondem.model.state import State

# Relative displacement per step over the smaller radius from which a contact is not resolved.
_FAST = 0.1
# Distance of centres over the sum of radii below which elements that nothing joins are inside each other, and over
# the distance at rest where a bond or facet joined them.
_SUNK, _SUNK_PAIR = 0.6, 0.75
# Largest product of the normals of faces that stand against each other, their largest gap over the size of a cell,
# their least area over that of a facet, and the share of a velocity along them below which bodies collide head-on.
_OPPOSED, _AGAINST, _FEW_CELLS, _HEAD_ON = -0.9999, 0.1, 3.0, 0.1


class ListedContacts(NamedTuple):
    """Columns of a neighbour list that the checks of contacts read."""

    first: np.ndarray  #: elements of each pair, (c,)
    second: np.ndarray
    bond: Ints  #: the bond of each pair, or -1, (c,)
    joined: Floats  #: above 0 for each bond that joins its elements, (m,)
    element: Uint32s  #: element of each contact with a wall, (b,)
    velocity: Floats  #: velocity of its wall there [m/s], (b, 3)
    deepest: float  #: deepest overlap so far over the smaller radius [-]


class ContactCheck:
    """Check that warns once of overlaps beyond the range of the contact law, and once of too much motion per step.

    `examine` is called after each call of the core, which takes several steps and ends early if the neighbour list is
    out of date.
    """

    def __init__(self, contacts: ContactModel, dt: float) -> None:
        self._radius, self._dt = contacts.radius, dt
        self._deepest = contacts.laws.deepest
        self._law = contacts.laws.name
        self._deep = self._fast = False

    def examine(self, c: ListedContacts, motion: Floats, time: float) -> None:
        """Warn about listed contacts that overlap too far or move too fast.

        Args:
            c: contacts to check.
            motion: motion of the elements, (n, 6), with velocities [m/s] in the first three columns.
            time: present time [s].

        Warns:
            ContactWarning: An overlap exceeds the range of the law, or an element moves too far per step; each
                warning is issued once.
        """
        if not self._deep and c.deepest > self._deepest:
            self._deep = True
            warnings.warn(
                f"a contact overlaps by {c.deepest:.2g} of the smaller radius at t = {time:.6g} s, beyond the"
                f" {self._deepest:.2g} up to which {self._law} describes it; use a stiffer law, a lower speed"
                " or load, or a smaller dt",
                ContactWarning, stacklevel=users_line(),
            )  # fmt: skip
        if not self._fast:
            share = self._dt * self._fastest(c, motion[:, :3])
            if share > _FAST:
                self._fast = True
                warnings.warn(
                    f"an element moves by {share:.2g} of its radius per step against others at t = {time:.6g} s, and"
                    f" may pass through them; give dt= at most {_FAST / share * self._dt:.2g} s",
                    ContactWarning, stacklevel=users_line(),
                )  # fmt: skip

    def _fastest(self, c: ListedContacts, velocity: Floats) -> float:
        """Return the largest relative velocity over the smaller radius [1/s].

        The velocities are those of listed pairs without an intact bond, of elements relative to walls, and of
        elements relative to the mean of all.
        """
        speed = [np.linalg.norm(velocity - velocity.mean(axis=0), axis=1) / self._radius]
        free = (c.bond < 0) | (c.joined[np.maximum(c.bond, 0)] <= 0.0) if len(c.joined) else c.bond < 0
        a, b = c.first[free], c.second[free]
        speed.append(np.linalg.norm(velocity[b] - velocity[a], axis=1) / np.minimum(self._radius[a], self._radius[b]))
        p = c.element
        speed.append(np.linalg.norm(velocity[p] - c.velocity, axis=1) / self._radius[p])
        return max(float(values.max(initial=0.0)) for values in speed)


def doubt_of_faces(model: Model, state: State) -> str:
    """Return a warning if plane faces of bodies of cells stand against each other and do not collide, else nothing.

    Their cells touch as spheres of their volume, which interlock and do not slide with the friction of the law.
    """
    elements, bodies = model.lattice.elements, model.lattice.bodies
    if not (elements.tables and model.contact and len(bodies.names) > 1):
        return ""
    free, h = elements.require_cells().cells.free, elements.size
    a, b = KDTree(free.centroid).query_pairs(h, output_type="ndarray").T
    label, normal, velocity = bodies.label[free.cell], free.normal, state.velocity[free.cell]
    gap = np.einsum("kc,kc->k", free.centroid[b] - free.centroid[a], normal[a])
    opposed = np.einsum("kc,kc->k", normal[a], normal[b]) < _OPPOSED
    a, b = np.column_stack([a, b])[(label[a] != label[b]) & opposed & (np.abs(gap) < _AGAINST * h)].T
    speed = velocity[b] - velocity[a]
    ahead = np.einsum("kc,kc->k", speed, normal[a])
    aside = np.linalg.norm(speed - ahead[:, None] * normal[a], axis=1)
    few = free.area[np.unique(np.concatenate([a, b]))].sum() < 2.0 * _FEW_CELLS * h**2
    if few or aside.max() < _HEAD_ON * np.abs(ahead).max():
        return ""
    first, second = (bodies.names[k] for k in sorted((label[a[0]], label[b[0]])))
    return (
        f"plane faces of bodies stand against each other ({first!r} and {second!r}): their cells touch as spheres,"
        " which interlock, whatever the friction; to let bodies slide, pack one body around=bd.Plane(...) with a pair"
        " of regions in failure= as a joint, or use a bd.PlaneWall"
    )


class SinkingCheck:
    """Check that warns once where elements of a model without contact law would have to touch.

    It finds cells of a joint whose faces have slid off each other, and separated elements that overlap. Only elements
    with a broken bond, or a facet whose faces have separated, are checked.
    """

    def __init__(self, model: Model) -> None:
        self._model, self._warned = model, False
        self._radius = model.contact_radius[model.layout.order]

    def examine(self, state: State) -> None:
        """Warn if elements of a state would have to touch.

        Warns:
            ContactWarning: Faces of a joint have slid off each other, or elements overlap; issued once.
        """
        if self._warned:
            return
        slid = self._slid(state)
        if slid:
            self._warn(
                f"faces of a joint slid off each other by t = {state.time:.6g} s ({slid} facets) and carry nothing"
            )
            return
        layout, n = self._model.layout, len(self._radius)
        parted = state.integrity <= 0.0
        facing = state.cracks[state.cracks[:, STATUS] != CrackStatus.PARTED, FACET].astype(np.int64)
        parted[facing] = False
        if not parted.any():
            return
        some = np.unique(np.concatenate([layout.i[parted], layout.j[parted]])).astype(np.int64)
        particles = self._model.lattice.particles
        position, period = state.pose[some, :3], particles.period
        if not np.isfinite(position).all():
            return
        reach = 2.0 * _SUNK * float(self._radius[some].max())
        tree = KDTree(position) if period is None else KDTree(position % period, boxsize=period)
        pairs = tree.query_pairs(reach, output_type="ndarray")
        low, high = np.sort(some[pairs], axis=1).T
        apart = particles.nearest(state.pose[high, :3] - state.pose[low, :3])
        limit = _SUNK * (self._radius[low] + self._radius[high])
        key = np.minimum(layout.i, layout.j).astype(np.int64) * n + np.maximum(layout.i, layout.j)
        order = np.argsort(key)
        place = order[np.minimum(np.searchsorted(key, low * n + high, sorter=order), len(key) - 1)]
        bonded = key[place] == low * n + high
        limit = np.where(bonded, _SUNK_PAIR * np.minimum(self._model.bonds.length[place], limit / _SUNK), limit)
        sunk = np.linalg.norm(apart, axis=1) < np.where(bonded & ~parted[place], 0.0, limit)
        if sunk.any():
            self._warn(f"separated elements overlap at t = {state.time:.6g} s ({int(sunk.sum())} pairs)")

    def _warn(self, what: str) -> None:
        self._warned = True
        warnings.warn(
            f"{what}, because the model has no contact law; pass contact=bd.LinearContact(...) to bd.Model",
            ContactWarning, stacklevel=users_line(),
        )  # fmt: skip

    def _slid(self, state: State) -> int:
        """Return the number of facets of material planes whose faces have separated by slip and not by a gap."""
        layout = self._model.layout
        parted = state.cracks[state.cracks[:, STATUS] == CrackStatus.PARTED, FACET].astype(np.int64)
        if not len(parted):
            return 0
        softening = cast(SofteningTable, self._model.softening)
        facets = self._model.lattice.elements.require_cells().facets
        parted = parted[softening.plane[parted] != 0]
        user, i, j = layout.bond_order[parted], layout.i[parted], layout.j[parted]
        normal = np.where(layout.flipped[parted, None], -1.0, 1.0) * facets.normal[user]
        normal = turned_vectors(state.pose[i, 4:], normal) + turned_vectors(state.pose[j, 4:], normal)
        normal /= np.linalg.norm(normal, axis=1)[:, None]
        apart = self._model.lattice.particles.nearest(state.pose[j, :3] - state.pose[i, :3])
        along, edge = np.einsum("ek,ek->e", apart, normal), np.sqrt(facets.area[user])
        across = np.linalg.norm(apart - along[:, None] * normal, axis=1)
        return int(((np.abs(along - facets.span[user]) < 0.5 * edge) & (across < 2.0 * edge)).sum())
