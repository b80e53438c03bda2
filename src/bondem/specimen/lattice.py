"""A lattice: elements and the bonds between them, in one reference configuration."""

from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any, cast

import numpy as np
from scipy.spatial.transform import Rotation

from bondem._checks import choice, instance, number, shown, vector
from bondem._indices import components, inverse
from bondem._outlets import OUTLETS
from bondem._types import (
    ArrayLike,
    Axis,
    Floats,
    Ints,
    Mask,
    Pairs,
    PerBond,
    PerBond3,
    PerElement,
    PerElement3,
    Triple,
)
from bondem.errors import DisconnectedError, InputError
from bondem.geometry.elementary_shapes import Shape
from bondem.geometry.planes import turn_about
from bondem.geometry.shape import place_shape
from bondem.specimen.bodies import Bodies, Which
from bondem.specimen.elements import CellElements, Elements
from bondem.specimen.filling import check_within
from bondem.specimen.particles import Particles, filled, freeze
from bondem.specimen.tessellation.facets import Cells, Facets


@dataclass(frozen=True, eq=False)
class Lattice:
    """Elements and bonds, both in the user's order.

    Pieces of a body other than its largest one are rattlers if they have fewer elements than max(10, 0.1 % of the
    body). Rattlers stay in `particles` but are left out of matrices, loads, faces and fits. Several bodies in one
    lattice come from `bd.join` or `bd.replicate`; the elements of a body without bonds are no rattlers.

    Attributes:
        particles: the elements.
        pairs: elements i, j of each bond, shape (m, 2).
        facets: facets of a body cut into cells, one per bond; None for other lattices.
        cells: cells of such a body; None for other lattices.
        bodies: labels, names and shapes of the bodies.

    Raises:
        InputError: `pairs` has another shape or type, an index is out of range, a bond joins an element to itself, a
            bond is given twice, or bonded centres coincide.
        DisconnectedError: A body has a second large piece.
    """

    particles: Particles
    pairs: Pairs
    facets: Facets | None
    cells: Cells | None
    bodies: Bodies

    def __init__(
        self, particles: Particles, pairs: ArrayLike, *, facets: Facets | None = None, cells: Cells | None = None,
        bodies: Bodies | None = None,
    ) -> None:  # fmt: skip
        instance("Lattice", "particles", particles, Particles, "bd.Particles")
        bonds = _whole(pairs)
        if bonds.ndim != 2 or bonds.shape[1] != 2:
            raise InputError(f"pairs has shape {bonds.shape}; give element indices as an array of shape (m, 2)")
        _check_pairs(bonds, len(particles))
        if bodies is None:
            bodies = Bodies(freeze(np.zeros(len(particles), dtype=np.int64)), ("body",), (particles.shape,))
        own = {"particles": particles, "pairs": freeze(bonds), "facets": facets, "cells": cells, "bodies": bodies}
        for name, value in own.items():
            object.__setattr__(self, name, value)
        if (self.length <= 0.0).any():
            k = int(np.argmin(self.length))
            raise InputError(f"bond {k} joins coincident centres {tuple(bonds[k])}; remove one of the elements")
        self.connected  # noqa: B018  a second large piece is an error now, not at first use

    @cached_property
    def elements(self) -> Elements:
        """Elements with their shape, spheres or cells: sizes, faces, and geometry of the bonds."""
        if self.cells is None:
            return Elements(self.particles, self.pairs, self.bodies)
        return CellElements(self.particles, self.pairs, self.bodies, cast(Facets, self.facets), self.cells)

    @property
    def bonds(self) -> "Lattice":
        """The lattice itself, so that `lattice.bonds.pairs` equals `lattice.pairs`."""
        return self

    @property
    def centre(self) -> PerElement3:
        """Centres of the spheres, or centres of mass of the cells of a body [m], shape (n, 3)."""
        return self.elements.centre

    @property
    def volume(self) -> float:
        """Volume of the shapes of the bodies, or of their cells [m³], voids between spheres included."""
        return self.elements.whole_volume

    @property
    def branch(self) -> PerBond3:
        """Vectors from centre i to centre j in the reference configuration [m], shape (m, 3)."""
        return self.elements.branch

    @property
    def length(self) -> PerBond:
        """Distance between the bonded centres [m], shape (m,)."""
        return self.elements.length

    @cached_property
    def pieces(self) -> Ints:
        """Number of the connected piece to which each element belongs, shape (n,); piece 0 is the largest."""
        label = components(self.pairs, len(self.particles))
        return freeze(inverse(np.argsort(-np.bincount(label), kind="stable"))[label])

    @cached_property
    def connected(self) -> Mask:
        """Mask of the connected elements, shape (n,): True for the bodies, False for rattlers."""
        label, several = self.bodies.label, len(self.bodies.names) > 1
        # parts: intersections of pieces and bodies, ordered by body, the largest first
        pieces = int(self.pieces.max()) + 1
        part, of_element, size = np.unique(label * pieces + self.pieces, return_inverse=True, return_counts=True)
        of_body = part // pieces
        order = np.lexsort((-size, of_body))
        body = of_body[order]
        first = np.searchsorted(body, np.arange(len(self.bodies.names)))
        bonded = np.zeros(len(self.bodies.names), dtype=bool)
        bonded[label[self.pairs.ravel()]] = True
        retained = np.zeros(len(part), dtype=bool)
        retained[order[first]] = True
        retained |= several & ~bonded[of_body]
        second = first + 1
        second = second[(second < len(part)) & (np.append(body, -1)[second] == body[first])]
        for k in second[bonded[body[second]]]:
            least = max(10.0, 0.001 * self.bodies.count[body[k]])
            if size[order[k]] >= least:
                what = f"body {self.bodies.names[body[k]]!r}" if several else "the bonded specimen"
                raise DisconnectedError(
                    f"{what} consists of pieces of {size[order[k - 1]]} and {size[order[k]]} elements;"
                    " bond over larger gaps (tolerance=, reach=), or make bodies of them with bd.join"
                )
        return freeze(retained[of_element])

    @property
    def body(self) -> Ints:
        """Number of the body of each element, shape (n,); 0 if there is only one body."""
        return self.bodies.label

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the bodies."""
        return self.bodies.names

    def envelope(self, body: Which | None = None) -> Shape:
        """Return the shape of a body, or the box around its spheres if none is given; None selects the only body.

        Raises:
            InputError: There is no such body, or there are several and none is named.
        """
        return self.bodies.shape_of("envelope", body, self.particles)[1]

    @property
    def element_volume(self) -> PerElement:
        """Volumes of the spheres, or of the cells of a body [m³], shape (n,)."""
        return self.elements.volume

    def moved(self, by: Triple) -> "Lattice":
        """Return the lattice and its shapes moved by a vector [m], (3,); a periodic lattice raises InputError."""
        return self.placed(np.eye(3), np.array(vector("Lattice.moved", "by", by, unit="m")))

    def rotated(self, axis: Axis | Triple, angle: float, about: Triple | None = None) -> "Lattice":
        """Return the lattice and its shapes rotated right-handed about an axis.

        Args:
            axis: "x", "y", "z", or a vector of any length, (3,).
            angle: angle of rotation [rad].
            about: point of the axis [m], (3,); None for the centre of volume of all elements.

        Raises:
            InputError: The axis is unknown or has no length, a number is not finite, or the lattice is periodic.
        """
        owner = "Lattice.rotated"
        angle = number(owner, "angle", angle, unit="rad")
        if isinstance(axis, str):
            choice(owner, "axis", axis, Axis)
            turn = turn_about(axis, angle)
        else:
            line = np.array(vector(owner, "axis", axis))
            if not np.linalg.norm(line) > 0.0:
                raise InputError(f"{owner}: axis = {shown(axis)} has no length; give a vector along the axis")
            turn = Rotation.from_rotvec(angle * line / np.linalg.norm(line)).as_matrix()
        if about is None:
            centre = np.average(self.centre, axis=0, weights=self.element_volume)
        else:
            centre = np.array(vector(owner, "about", about, unit="m"))
        return self.placed(turn, centre - turn @ centre)

    def placed(self, turn: Floats, by: Floats) -> "Lattice":
        """Return the lattice and its shapes rotated by a matrix (3, 3) about the origin, then moved by (3,) [m].

        Raises:
            InputError: The lattice is periodic.
        """
        if self.particles.period is not None:
            raise InputError("a periodic lattice fills its cell and cannot be moved; pack a Box of the same size")
        shapes = tuple(None if one is None else place_shape(one, turn, by) for one in self.bodies.shapes)
        shape = None if self.particles.shape is None else shapes[0]
        return Lattice(
            filled(Particles(self.particles.position @ turn.T + by, self.particles.radius), shape), self.pairs,
            bodies=Bodies(self.bodies.label, self.names, shapes), **self.elements.placed(turn, by),
        )  # fmt: skip

    def plot(
        self, path: str | Path | None = None, *, values: ArrayLike | None = None, label: str = "",
        view: tuple[float, float] = (28.0, 24.0),
    ) -> Any:  # fmt: skip
        """Draw the elements as spheres, or cells as polyhedra, with coordinates.

        Args:
            path: PNG, PDF or SVG to write; nothing is written when None.
            values: numbers that colour the elements, shape (n,); None for their sizes, or for the bodies of a scene.
            label: name and unit of the values, for the scale.
            view: azimuth and elevation of the camera [degree].

        Returns:
            A `matplotlib.figure.Figure`, which Jupyter shows; its `show()` opens a window.

        Raises:
            InputError: The values have another shape, the file cannot be written, or the view is not two angles.
        """
        return OUTLETS.draw_lattice(self, path, values=values, label=label, view=view)

    def on_face(self, name: str, body: Which | None = None) -> Ints:
        """Return the free facets on a face or patch of a body's shape, as ascending indices into `cells.free`, (k,).

        `body` is the name or number of the body, None for the only one.

        Raises:
            InputError: The shape has no such face, there is no such body, no cells, or several bodies and none named.

        Warns:
            FaceWarning: A patch ends within a plane, and its facets cover another area than the patch.
        """
        return self.elements.require_cells().on_face(name, body)

    @property
    def rattlers(self) -> int:
        """Number of elements in small pieces without bonds to their body."""
        return int(len(self.particles) - self.connected.sum())

    @property
    def coordination_number(self) -> float:
        """Coordination number z = 2 m / n over all elements, including rattlers [-]."""
        return 2.0 * len(self.pairs) / len(self.particles)


def _whole(pairs: ArrayLike) -> Ints:
    try:
        found = np.array(pairs)
    except (TypeError, ValueError, OverflowError):
        found = np.zeros(1, dtype=object)
    if found.size == 0 and found.dtype.kind in "iuf":
        return np.zeros((0, 2), dtype=np.int64)
    if found.dtype.kind not in "iu":
        raise InputError(f"pairs = {shown(pairs)} holds {found.dtype}; give integer element indices, shape (m, 2)")
    return found.astype(np.int64)


def _check_pairs(pairs: Pairs, count: int) -> None:
    outside = np.flatnonzero(((pairs < 0) | (pairs >= count)).any(axis=1))
    if outside.size:
        k = outside[0]
        raise InputError(f"bond {k} joins {tuple(map(int, pairs[k]))}, but element indices run from 0 to {count - 1}")
    itself = np.flatnonzero(pairs[:, 0] == pairs[:, 1])
    if itself.size:
        raise InputError(f"bond {itself[0]} joins element {pairs[itself[0], 0]} to itself; remove it")
    key = np.sort(pairs, axis=1) @ np.array([count, 1])
    first = np.unique(key, return_index=True)[1]
    if len(first) < len(pairs):
        k = int(np.setdiff1d(np.arange(len(pairs)), first)[0])
        raise InputError(f"bond {k} joins {tuple(map(int, pairs[k]))} a second time; remove duplicate pairs")


def carve(lattice: Lattice, shape: Shape) -> Lattice:
    """Cut out the part of a lattice whose centres lie inside `shape`, which becomes the shape of the part.

    A body of cells is tessellated again, so that the cells of the kept elements fill the new shape up to its walls.

    Args:
        lattice: lattice to cut.
        shape: region to keep, within the body; its faces name the faces of the part.

    Returns:
        A lattice of the kept elements, in their old order, with the bonds between them. The part of a body has new
        facets and cells.

    Raises:
        InputError: No element lies in the shape, over 1 % of it lies outside the body, or there are several bodies.
        DisconnectedError: The part consists of two large pieces.
    """
    instance("carve", "lattice", lattice, Lattice, "a lattice, from bd.connect")
    instance("carve", "shape", shape, Shape, "a shape such as bd.Box(...)")
    lattice.bodies.require_one("carve")
    keep = shape.contains(lattice.particles.position)
    if not keep.any():
        raise InputError(f"no element lies inside {shown(shape)}; check its size and position (metres)")
    check_within(shape, lattice.envelope(), lattice.particles.radius)
    number = np.cumsum(keep) - 1
    inside = keep[lattice.pairs].all(axis=1)
    period = shape.period
    if lattice.particles.period is not None and period is None:
        plain = lattice.particles.position[lattice.pairs[:, 1]] - lattice.particles.position[lattice.pairs[:, 0]]
        inside &= np.isclose(plain, lattice.branch, atol=1e-9 * lattice.particles.mean_radius).all(axis=1)
    elif lattice.particles.period is not None:
        period = lattice.particles.period
    part = filled(Particles(lattice.particles.position[keep], lattice.particles.radius[keep], period), shape)
    pairs, tables = lattice.elements.carved(part, number[lattice.pairs[inside]])
    return Lattice(part, pairs, **tables)
