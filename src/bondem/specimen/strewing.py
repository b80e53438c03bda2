"""Bodies at random places in a shape, one by one (random sequential addition; Widom, J. Chem. Phys. 44, 1966)."""

from dataclasses import dataclass

import numpy as np
from scipy.spatial import KDTree
from scipy.spatial.transform import Rotation

from bondem._checks import count as whole_number
from bondem._checks import instance, number, shown
from bondem._types import Floats, Vector
from bondem.errors import InputError, PackingError
from bondem.geometry.elementary_shapes import Shape
from bondem.specimen.joining import replicate
from bondem.specimen.lattice import Lattice

# Number of places that are drawn at once.
_BATCH = 32


def strew(
    body: Lattice, shape: Shape, count: int, *, seed: int = 0, gap: float = 0.0, attempts: int = 1000,
    name: str = "body",
) -> Lattice:  # fmt: skip
    """Return a scene of copies of a body at random places and in random orientations within a shape.

    Bodies are placed one by one, each at the first of its random places where its spheres lie inside the shape and
    touch no other body. Cells count as spheres of their volume, or of the radius of their particle if it is larger.

    Args:
        body: a lattice of one body.
        shape: space of the bodies, such as `bd.Box(...)`.
        count: number of bodies.
        seed: seed of places and orientations.
        gap: least distance of the spheres of two bodies [m].
        attempts: largest number of places tried per body.
        name: group of the bodies "name/0", "name/1", …; `bd.Body(name)` selects all of them.

    Returns:
        A lattice of `count` bodies.

    Raises:
        InputError: There are several bodies, the body or shape is periodic, or a number is out of range.
        PackingError: A body has no place; the message states how many have one.
    """
    instance("strew", "body", body, Lattice, "a lattice, from bd.connect")
    instance("strew", "shape", shape, Shape, "a shape such as bd.Box(...)")
    body.bodies.require_one("strew")
    if shape.period is not None:
        raise InputError("strew: bodies are not periodic; give a Box of the same size")
    wanted = whole_number("strew", "count", count, least=1)
    tries = whole_number("strew", "attempts", attempts, least=1)
    gap = number("strew", "gap", gap, unit="m", least=0.0, advice="a distance of zero or more")
    random = np.random.default_rng(whole_number("strew", "seed", seed))
    outline = _Outline.of(body)
    lower, upper = shape.bounds
    places, turns = np.zeros((0, 3)), Rotation.random(0, random_state=random)
    while len(places) < wanted:
        for start in range(0, tries, _BATCH):
            batch = min(_BATCH, tries - start)
            new, turned = random.uniform(lower, upper, (batch, 3)), Rotation.random(batch, random_state=random)
            spheres = np.einsum("kab,nb->kna", turned.as_matrix(), outline.centre) + new[:, None]
            deep = shape.depth(spheres.reshape(-1, 3)).reshape(batch, -1)
            inside = (deep >= outline.radius).all(axis=1)
            free = (k for k in np.flatnonzero(inside) if not outline.meets(spheres[k], new[k], places, turns, gap))
            found = next(free, None)
            if found is not None:
                places = np.vstack([places, new[found]])
                turns = Rotation.concatenate([turns, turned[found]])
                break
        else:
            raise PackingError(
                f"strew: {len(places)} of {wanted} bodies fitted into {shown(shape)}, and the next found no place in"
                f" {tries} attempts; give fewer bodies, a larger shape, a smaller gap= or more attempts="
            )
    return replicate(body, places, turns.as_quat()[:, [3, 0, 1, 2]], name=name)


@dataclass(frozen=True, eq=False)
class _Outline:
    """Spheres of a body about its centre of mass.

    Attributes:
        centre: centres relative to the centre of mass [m], (n, 3).
        radius: radii [m], (n,).
        reach: radius of the sphere about the centre of mass that contains all spheres [m].
        tree: search tree of the centres.
    """

    centre: Floats
    radius: Floats
    reach: float
    tree: KDTree

    @classmethod
    def of(cls, body: Lattice) -> "_Outline":
        """Return the spheres of a body; a cell counts as the larger of its particle and a sphere of its volume."""
        middle = np.average(body.centre, axis=0, weights=body.element_volume)
        centre = body.centre - middle
        radius = np.maximum(body.particles.radius, np.cbrt(0.75 / np.pi * body.element_volume))
        return cls(centre, radius, float((np.linalg.norm(centre, axis=1) + radius).max()), KDTree(centre))

    def meets(self, spheres: Floats, place: Vector, places: Floats, turns: Rotation, gap: float) -> bool:
        """Return True if a copy of the body is nearer than `gap` [m] to any of k other copies.

        Args:
            spheres: centres of the spheres of the copy [m], (n, 3).
            place: centre of mass of the copy [m], (3,).
            places: centres of mass of the other copies [m], (k, 3).
            turns: rotations of the other copies, k of them.
            gap: least distance of the spheres of two copies [m].
        """
        for k in np.flatnonzero(np.linalg.norm(places - place, axis=1) < 2.0 * self.reach + gap):
            own = turns[k].apply(spheres - places[k], inverse=True)
            near = np.flatnonzero(np.linalg.norm(own, axis=1) < self.reach + self.radius + gap)
            others = self.tree.query_ball_point(own[near], self.radius[near] + self.radius.max() + gap)
            i = np.repeat(near, [len(one) for one in others])
            j = np.array([other for one in others for other in one], dtype=np.int64)
            if (np.linalg.norm(own[i] - self.centre[j], axis=1) < self.radius[i] + self.radius[j] + gap).any():
                return True
        return False
