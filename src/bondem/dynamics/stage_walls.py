"""Initial places of walls that fix facets of cells, for a stage of loading that begins from a state."""

from typing import cast

import numpy as np

from bondem._types import Floats
from bondem.boundary.wall_constraints import Supports, reference_base
from bondem.geometry.rotations import rotation_vector, turned_vectors
from bondem.interactions.cells.cell_body import body_of
from bondem.model.model import Model
from bondem.model.state import State
from bondem.observables.cell_forces import wall_arms, wall_places
from bondem.observables.cell_stress import lambda_theta
from bondem.observables.facet_loads import loads_on_facets


def goes_on(model: Model, state: State) -> bool:
    """Return True if the walls of a model are those of the model of a state, and move in the same way."""
    return model.interaction.supports.fixed.same(state.model.interaction.supports.fixed)


def stage_walls(model: Model, state: State) -> Floats:
    """Return the initial places [m] and orientations of walls that fix facets of cells, as `State.grips`, (g, 7).

    A wall that fixed a facet along an axis continues from its place, even if another condition moves it now. Other
    walls begin at their facets, which then initially transmit the loads on them that were removed, if any. If a wall
    resists the rotation of its facet more than before, the moment on the cell does not jump.

    Args:
        model: model of the new stage.
        state: initial state, with the model that made it.
    """
    supports = model.interaction.supports
    base = reference_base(len(supports.cell))
    if not len(base):
        return base
    rest = wall_places(model, state, base)  # for schedules that count from the reference
    base[:, 3:] = state.orientation[supports.cell]
    if goes_on(model, state):
        return state.grips.copy()
    before = state.model.interaction.supports
    _, mine, theirs = np.intersect1d(supports.fixed.facet, before.fixed.facet, return_indices=True)
    base[mine, 3:] = _origins(supports, before, mine, theirs, state)
    fixed = before.axes[theirs] > 0.0
    fresh = supports.axes.copy()
    fresh[mine] *= ~fixed
    start = _of_facets(model, state, fresh) if fresh.any() else rest.copy()
    start[mine] = np.where(fixed, wall_places(cast(Model, state.model), state)[theirs], start[mine])
    base[:, :3] = supports.axes * (start - rest)
    same = fixed & _same_motion(supports, before, mine, theirs)
    base[mine, :3] = np.where(same, state.grips[theirs, :3], base[mine, :3])
    return base


def _same_motion(supports: Supports, before: Supports, mine: np.ndarray, theirs: np.ndarray) -> np.ndarray:
    """Return a mask of facets that move as before along each axis, shape (k, 3)."""
    def motions(one: Supports) -> list[object]:
        return [*zip(one.fixed.drives, one.fixed.rate, strict=True), None]  # -1 is the last: at rest

    known = motions(before)
    match = np.array([[motion == other for other in known] for motion in motions(supports)])
    return match[supports.fixed.drive[mine], before.fixed.drive[theirs]]


def _origins(supports: Supports, before: Supports, mine: np.ndarray, theirs: np.ndarray, state: State) -> Floats:
    """Return quaternions, (k, 4), from which walls measure rotations of cells, for facets that both models fix."""
    now, origin = state.orientation[supports.cell[mine]], state.grips[theirs, 3:]
    was = before.flatness(state.grips[:, 3:])[theirs]
    more = supports.flatness(state.orientation[supports.cell])[mine]
    share = np.where(more > was, was / np.maximum(more, 1e-300), 1.0)[:, None]
    turn = share * rotation_vector(_product(now, origin * np.array([1.0, -1.0, -1.0, -1.0])))
    half = 0.5 * np.linalg.norm(turn, axis=1, keepdims=True)
    back = np.hstack([np.cos(half), -0.5 * turn * np.sinc(half / np.pi)])
    return np.where(share == 1.0, origin, _product(back, now))


def _of_facets(model: Model, state: State, fresh: Floats) -> Floats:
    """Return displacements of facets that were free [m], (g, 3): motion of the rigid cell, and opening by its stress.

    `fresh` is 1 along the axes along which walls begin to fix the facets, (g, 3). Loads that continue to act on these
    facets act on the cell itself from now on. They open no facet, and their part of the stress of the cell vanishes.
    """
    supports, constants, q = model.interaction.supports, model.cell_constants, state.orientation
    facet, area = supports.fixed.facet, body_of(model.lattice)[1].free.area[:, None]
    rigid = state.displacement[supports.cell] + wall_arms(model, state) - supports.lever
    going_on = loads_on_facets(model, state.time, q)
    before = cast(Model, state.model)
    force = loads_on_facets(before, state.time, q) - going_on
    soft, way = constants.softness[facet, None], turned_vectors(q[supports.cell], supports.way)
    opened = (fresh * soft * way * going_on[facet]).sum(axis=1)
    swelling = np.asarray(np.bincount(supports.cell, weights=opened, minlength=len(q)), dtype=float)
    stress = lambda_theta(before, state) - before.interaction.dilatational_stress(swelling)
    return rigid + soft * ((force / area)[facet] - stress[supports.cell, None] * way)


def _product(p: Floats, q: Floats) -> Floats:
    """Return products of quaternions, (k, 4)."""
    w = p[:, :1] * q[:, :1] - (p[:, 1:] * q[:, 1:]).sum(axis=1, keepdims=True)
    return np.hstack([w, p[:, :1] * q[:, 1:] + q[:, :1] * p[:, 1:] + np.cross(p[:, 1:], q[:, 1:])])
