"""Contacts of a model in the reference: laws, walls, and overlaps that carry no force."""

from dataclasses import dataclass

import numpy as np

from bondem._cache_lines import lines
from bondem._indices import group_starts
from bondem._tables.packing_tables import SphereGrid
from bondem._threads import current_threads
from bondem._types import Floats, Ints, PerBond, PerElement
from bondem.boundary.wall_rows import walls_at_rest
from bondem.boundary.wall_table import WallTable
from bondem.geometry.neighbours import neighbours, sphere_grid
from bondem.interactions.contact.contact_assignment import ContactLaws
from bondem.interactions.contact.contact_search import found_walls, new_wall_sources, walls_at
from bondem.specimen.lattice import Lattice
from bondem.specimen.local_origin import local_rest
from bondem.specimen.ordering import Layout


@dataclass(frozen=True, eq=False)
class RestGaps:
    """Overlaps of the reference configuration, which carry no force; sorted by the later element, internal order.

    Attributes:
        start: start of the entries of each element, (n + 1,).
        partner: earlier element, or wall, uint32, (c,).
        gap: gap, at most 0 [m], (c,).
    """

    start: Ints
    partner: np.ndarray
    gap: Floats

    @classmethod
    def none(cls, n: int) -> "RestGaps":
        """Return an empty table for n elements."""
        return cls(np.zeros(n + 1, dtype=np.int64), np.zeros(0, dtype=np.uint32), np.zeros(0))


@dataclass(frozen=True, eq=False)
class ContactModel:
    """Contacts of a model; without contact laws the arrays of elements are empty.

    Attributes:
        laws: contact laws.
        radius: radii of the elements in contact [m], internal order, (n,) or (0,).
        walls: walls of the model.
        pairs: initial overlaps of elements.
        at_walls: initial overlaps with walls.
        own: normal stiffness of the pairs of bonds that break [N/m], internal order, (m,); such pairs touch at the
            rest length of the bond. None if they are treated like other pairs.
    """

    laws: ContactLaws
    radius: PerElement
    walls: WallTable
    pairs: RestGaps
    at_walls: RestGaps
    own: PerBond | None

    @classmethod
    def of(
        cls, lattice: Lattice, layout: Layout, laws: ContactLaws, walls: WallTable, own: PerBond | None,
        radius: PerElement,
    ) -> "ContactModel":
        """Return the contacts of a model, with the overlaps at rest that carry no force.

        Args:
            lattice: elements.
            layout: order of the elements.
            laws: laws of their contacts.
            walls: walls that they touch.
            own: normal stiffness of pairs whose bond breaks [N/m], (m,); None to treat them like other pairs.
            radius: radii of the elements in contact [m], user's order, (n,).
        """
        n = len(laws.kind)
        radius = np.ascontiguousarray(radius[layout.order[:n]])
        if not laws.stress_free:
            return cls(laws, radius, walls, RestGaps.none(n), RestGaps.none(n), own)
        position = np.ascontiguousarray(local_rest(lattice)[layout.order])
        start, partner = near(position, radius, lattice.particles.period, 0.0)
        later = np.repeat(np.arange(n), np.diff(start))
        retained = partner < later
        later, earlier = later[retained], partner[retained]
        order = np.lexsort((earlier, later))
        later, earlier = later[order], earlier[order]
        user = layout.order
        branch = lattice.particles.nearest(lattice.centre[user[later]] - lattice.centre[user[earlier]])
        distance = np.linalg.norm(branch, axis=1)
        gap = np.minimum(distance - radius[earlier] - radius[later], 0.0)
        pairs = RestGaps(group_starts(later, n), earlier.astype(np.uint32), gap)
        # the core finds the walls that each sphere at rest touches, so that only it evaluates shapes of walls
        count = len(walls.shape)
        still = walls_at(walls, walls_at_rest(count))
        pose = lines(n)
        pose[:, :3] = position
        sources = new_wall_sources(radius, 0.0)
        touching = found_walls(pose, still, sources)
        return cls(laws, radius, walls, pairs, RestGaps(sources.start, touching.wall, touching.now), own)

    def of_broken(self, layout: Layout) -> tuple[PerBond, PerBond, PerBond]:
        """Return ks / kn (0 without friction), friction μ, damping β of broken bonds, internal order, each (m,)."""
        soft, friction, beta = self.laws.of_pairs(layout.order[layout.i], layout.order[layout.j])
        return np.where(friction > 0.0, soft, 0.0), friction, beta


def near(position: Floats, radius: Floats, period: Floats | None, skin: float) -> tuple[Ints, np.ndarray]:
    """Return neighbours with gaps up to `skin` [m]: start of the list of each element, (n + 1,), and all lists."""
    return neighbours(*_boxed(position, radius, period), skin, threads=current_threads())


def grid_of(position: Floats, radius: Floats, period: Floats | None, skin: float) -> SphereGrid:
    """Return the grid of elements for a search of neighbours with gaps up to `skin` [m]."""
    return sphere_grid(*_boxed(position, radius, period), skin)


def _boxed(position: Floats, radius: Floats, period: Floats | None) -> tuple[Floats, Floats, Floats, Floats]:
    """Return spheres (n, 4), both corners of a box around their centres, and periodic edges, 0 if not periodic."""
    sphere = np.column_stack([position, radius])
    if period is None:
        lower, upper = sphere[:, :3].min(axis=0), sphere[:, :3].max(axis=0)
        margin = 1e-9 * max(float((upper - lower).max()), float(radius.max()))
        return sphere, lower - margin, upper + margin, np.zeros(3)
    sphere[:, :3] %= period
    return sphere, np.zeros(3), period, period
