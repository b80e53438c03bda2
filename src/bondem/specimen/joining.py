"""Scenes: several bodies in one lattice."""

from collections.abc import Sequence
from typing import Literal

import numpy as np
from scipy.spatial import KDTree
from scipy.spatial.transform import Rotation

from bondem._checks import array, choice, count, instance, shown
from bondem._types import ArrayLike, Floats, Ints, Pairs, PerElement, PerElement3
from bondem.errors import InputError
from bondem.specimen.bodies import Bodies
from bondem.specimen.lattice import Lattice
from bondem.specimen.particles import Particles, filled, freeze

#: Largest overlap of spheres of two bodies, over the smaller radius.
_OVERLAP = 1e-3


def join(*bodies: Lattice | Particles, names: Sequence[str] | None = None, pairs: ArrayLike | None = None) -> Lattice:
    """Return several bodies in one lattice, one after the other, each at its present place.

    Args:
        bodies: lattices, or particles for loose grains, which are a body without bonds. All bodies of a lattice of
            several bodies are joined.
        names: name of each argument, such as ("rock", "anvil"); None for "body 0", "body 1", …. In an argument of
            several bodies "grains/0" becomes "name/0"; with None it keeps its name if no two are equal.
        pairs: bonds between spheres of different bodies, as elements of the joined lattice, shape (k, 2). Spheres
            that such a bond joins may overlap.

    Returns:
        A lattice whose elements, bonds and cells are those of the arguments, in their order.

    Raises:
        InputError: There are fewer than two arguments, equal names, a periodic body, cells together with spheres,
            bonds between cells, or spheres of two bodies that overlap by more than 0.001 of the smaller radius. For
            cells, the largest spheres inside them are compared, so that bodies may touch face to face.
    """
    for one in bodies:
        instance("join", "bodies", one, (Lattice, Particles), "lattices, or bd.Particles for loose grains")
    if len(bodies) < 2:
        raise InputError(f"join: {len(bodies)} bodies; give at least two")
    lattices = [one if isinstance(one, Lattice) else Lattice(one, np.zeros((0, 2), dtype=np.int64)) for one in bodies]
    if any(one.particles.period is not None for one in lattices):
        raise InputError("join: a periodic body fills its cell; pack a Box of the same size")
    shapes_of = [one.elements.shape_name for one in lattices]
    other = [k for k, shape in enumerate(shapes_of) if shape != shapes_of[0]]
    if other:
        raise InputError(
            f"join: argument 0 has {shapes_of[0]}, argument {other[0]} has {shapes_of[other[0]]}; cut all into cells"
            " (bd.connect(..., method='laguerre')), or none"
        )
    across = _across(pairs)
    if len(across) and lattices[0].elements.tables:
        raise InputError(
            "join: cells of different bodies share no facet; leave out pairs=, or pack one shape around a bd.Plane"
        )
    first = np.cumsum([0, *(len(one.particles) for one in lattices)])
    found = _names(lattices, names)
    before = np.cumsum([0, *(len(one.names) for one in lattices)])
    label = np.concatenate([one.body + k for one, k in zip(lattices, before, strict=False)])
    position = np.concatenate([one.particles.position for one in lattices])
    radius = np.concatenate([one.particles.radius for one in lattices])
    _refuse_overlap(position, np.concatenate([one.elements.inner_radius for one in lattices]), label, found, across)
    shapes = tuple(shape for one in lattices for shape in one.bodies.shapes)
    inner = [one.pairs + k for one, k in zip(lattices, first, strict=False)]
    bonds: Pairs = np.concatenate([*inner, across])
    tables = lattices[0].elements.joined([one.elements for one in lattices[1:]])
    return Lattice(Particles(position, radius), bonds, bodies=Bodies(freeze(label), found, shapes), **tables)


def replicate(
    body: Lattice, positions: ArrayLike, rotations: ArrayLike | Literal["random"] | None = None, *,
    name: str = "body", seed: int = 0,
) -> Lattice:  # fmt: skip
    """Return a scene of copies of a body.

    Args:
        body: a lattice of one body.
        positions: centres of mass of the copies [m], shape (k, 3).
        rotations: unit quaternions (w, x, y, z) of the copies, shape (k, 4), "random", or None for no rotation.
        name: group of the copies "name/0", "name/1", …; `bd.Body(name)` selects all of them.
        seed: number that selects the random rotations.

    Raises:
        InputError: `join` rejects the copies, there are several bodies, or an array has another shape or values.
    """
    instance("replicate", "body", body, Lattice, "a lattice, from bd.connect")
    body.bodies.require_one("replicate")
    place = array("replicate", "positions", positions, wanted="centres of mass, shape (k, 3) [m]")
    if place.ndim != 2 or place.shape[1] != 3 or not np.isfinite(place).all() or len(place) == 0:
        raise InputError(f"replicate: positions of shape {place.shape}; give centres of mass, finite, (k, 3) [m]")
    instance("replicate", "name", name, str, "the name of the group of copies")
    turns = turns_of("replicate", rotations, len(place), seed)
    centre = np.average(body.centre, axis=0, weights=body.element_volume)
    copies = [body.placed(turn, x - turn @ centre) for turn, x in zip(turns, place, strict=True)]
    names = [f"{name}/{k}" for k in range(len(copies))]
    if len(copies) == 1:
        one = copies[0]
        return Lattice(
            one.particles, one.pairs, facets=one.facets, cells=one.cells,
            bodies=Bodies(one.body, tuple(names), one.bodies.shapes),
        )  # fmt: skip
    return join(*copies, names=names)


def turns_of(owner: str, rotations: ArrayLike | str | None, number: int, seed: int) -> Floats:
    """Return rotation matrices, (number, 3, 3).

    Args:
        owner: function that was called, for messages.
        rotations: unit quaternions (w, x, y, z), (number, 4), "random", or None for no rotation.
        number: number of matrices.
        seed: number that selects the random rotations.

    Raises:
        InputError: `rotations` is anything else.
    """
    if rotations is None:
        return np.tile(np.eye(3), (number, 1, 1))
    if isinstance(rotations, str):
        choice(owner, "rotations", rotations, Literal["random"])
        seed = count(owner, "seed", seed)
        return np.asarray(Rotation.random(number, random_state=np.random.default_rng(seed)).as_matrix())
    q = array(owner, "rotations", rotations, wanted="unit quaternions (w, x, y, z), shape (k, 4), or 'random'")
    if q.shape != (number, 4) or not (np.abs((q**2).sum(axis=1) - 1.0) < 1e-6).all():
        raise InputError(f"{owner}: rotations = {shown(rotations)}; give {number} unit quaternions (w, x, y, z)")
    return np.asarray(Rotation.from_quat(q[:, [1, 2, 3, 0]]).as_matrix())


def parts(lattice: Lattice) -> list[tuple[Ints, Particles]]:
    """Return, for each body, the indices of its elements, (k,), and its particles with their shape."""
    if len(lattice.names) == 1:
        return [(np.arange(len(lattice.particles)), lattice.particles)]
    position, radius = lattice.particles.position, lattice.particles.radius
    order = np.argsort(lattice.body, kind="stable")
    own = np.split(order, np.cumsum(lattice.bodies.count)[:-1])
    shapes = lattice.bodies.shapes
    return [(k, filled(Particles(position[k], radius[k]), shape)) for k, shape in zip(own, shapes, strict=True)]


def _across(pairs: ArrayLike | None) -> Pairs:
    if pairs is None:
        return np.zeros((0, 2), dtype=np.int64)
    found = array("join", "pairs", pairs, wanted="elements of the scene, shape (k, 2)")
    if found.ndim != 2 or found.shape[1] != 2 or not (found == np.rint(found)).all():
        raise InputError(f"join: pairs = {shown(pairs)}; give elements of the scene, shape (k, 2)")
    return found.astype(np.int64)


def _names(lattices: Sequence[Lattice], given: Sequence[str] | None) -> tuple[str, ...]:
    if given is None:
        own = [name for one in lattices if len(one.names) > 1 for name in one.names]
        grouped, wanted = len(set(own)) < len(own), [f"body {k}" for k in range(len(lattices))]
    elif isinstance(given, str) or len(given) != len(lattices) or not all(isinstance(n, str) and n for n in given):
        raise InputError(f"join: names = {shown(given)}; give {len(lattices)} names, one per argument")
    else:
        grouped, wanted = True, given
    inner = ((name,) if len(one.names) == 1 else _inner(name, one) if grouped else one.names
             for name, one in zip(wanted, lattices, strict=True))  # fmt: skip
    found = tuple(name for names in inner for name in names)
    if len(set(found)) < len(found):
        twice = next(name for name in found if found.count(name) > 1)
        raise InputError(f"join: two bodies are called {twice!r}; give names= that differ")
    return found


def _inner(name: str, scene: Lattice) -> tuple[str, ...]:
    """Return names of the bodies of a scene in the group `name`, without their old group if they stay unique."""
    short = [own.rpartition("/")[2] for own in scene.names]
    return tuple(f"{name}/{own}" for own in (short if len(set(short)) == len(short) else scene.names))


def _refuse_overlap(position: PerElement3, r: PerElement, label: Ints, names: tuple[str, ...], bonded: Pairs) -> None:
    near = KDTree(position).query_pairs(2.0 * r.max(), output_type="ndarray").astype(np.int64)
    near = near[label[near[:, 0]] != label[near[:, 1]]]
    key = np.array([len(r), 1])
    i, j = near[~np.isin(np.sort(near, axis=1) @ key, np.sort(bonded, axis=1) @ key)].T
    if len(i) == 0:
        return
    overlap = r[i] + r[j] - np.linalg.norm(position[j] - position[i], axis=1)
    over = overlap - _OVERLAP * np.minimum(r[i], r[j])
    k = int(np.argmax(over))
    if over[k] > 0.0:
        raise InputError(
            f"join: bodies {names[label[i[k]]]!r} and {names[label[j[k]]]!r} overlap by {overlap[k]:.3g} m at"
            f" elements {i[k]} and {j[k]} ({int((over > 0.0).sum())} such pairs); move them apart with .moved(...)"
        )
