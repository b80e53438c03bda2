"""Fracture without inertia by displacements that grow: what `bd.solve_quasistatic` has where nothing snaps back.

At each displacement all facets go to the integrity that their softening curve has at the traction that they would
bear whole, and equilibrium is found anew, until no integrity changes: secant iterations, without steps of softening
and without facets that fail together. It stops being of use where the path turns back: integrities then fall without
a load until another equilibrium is found, or none is.
"""

from dataclasses import dataclass

import numpy as np

import bondem as bd
from bondem._tables.stress_onset_tables import SofteningSearch
from bondem.statics.quasistatic import quasistatic_run
from bondem.statics.quasistatic.damaged_body import DamagedBody, Loaded
from bondem.statics.quasistatic.load_response import Reading
from bondem.statics.quasistatic.onset import StressOnset

# Largest change of an integrity, as a share of it, that counts as none; and rounds until a step is given up.
_STILL, _ROUNDS = 1e-3, 300
# Integrity that a facet loses as it begins, and below which losses are not measured against what is left.
_BEGUN, _SMALL = 1e-6, 1e-3


@dataclass(frozen=True)
class Steps:
    """Of each displacement: itself [m], the load [N], and how many rounds it took."""

    displacement: np.ndarray
    load: np.ndarray
    rounds: np.ndarray


def pulled_in_steps(model: bd.Model, drive: bd.Face, first: float, step: float, until: float) -> Steps:
    """Pull from a displacement on, each time by `step` more, until the load is below `until` of its peak.

    Args:
        model: cells with `bd.Rankine` and a fracture energy, driven by a `bd.Drive`.
        drive: the face that is driven.
        first, step: displacements [m].
        until: share of the largest load.
    """
    body, equilibrium, onset = quasistatic_run._begin(model)
    assert isinstance(onset, StressOnset)
    reading, motion = Reading(body, drive), body.motion.copy()
    rows: list[tuple[float, float, int]] = []
    peak, way, load, factor, stored = 0.0, first, 0.0, 0.0, 0.0
    while True:
        rounds, settled = 0, False
        while not settled and rounds < _ROUNDS:
            rounds += 1
            motion, found = quasistatic_run._balance(body, equilibrium, motion, stored)
            stored = body.size(found)
            load, size = reading.read(found, motion)
            factor = way / size
            facets, at = onset.factors(found, np.flatnonzero(body.integrity == 1.0), factor, 0.0)
            begun = facets[at <= factor]
            body.weaken(begun, 1.0 - _BEGUN, (False, False))
            settled = _softened(body, onset, found, factor) < _STILL and not len(begun)
        rows.append((way, factor * load, rounds))
        peak = max(peak, factor * load)
        if factor * load < until * peak:
            return Steps(*(np.array(column) for column in zip(*rows, strict=True)))
        way += step


def _softened(body: DamagedBody, onset: StressOnset, found: Loaded, factor: float) -> float:
    """Take facets that have begun to their curves; by what share of it any integrity has fallen."""
    k = found.cracked
    before = body.integrity[k]
    after = np.minimum(before, _left(onset.along(found, k, found.opening), onset._curve, factor))
    fallen = after < before
    body.weaken(k[fallen], after[fallen], body.closed[k[fallen]])
    return float(((before - after) / np.maximum(before, _SMALL)).max(initial=0.0))


def _left(of: SofteningSearch, curve: tuple[float, float], factor: float) -> np.ndarray:
    """The least integrity that the curve leaves along any direction: s T is on one of its two lines."""
    kink, steep = curve
    traction, strength, last = np.moveaxis(of.line, 2, 0)
    T = np.maximum(factor * traction, 1e-30)
    slope = strength / (steep * last)
    left = (strength / T - slope) / (1.0 - slope)
    if kink > 0.0:
        slope = kink * strength / (last * (1.0 - (1.0 - kink) * steep))
        left = np.maximum(left, (slope * last / T - slope) / (1.0 - slope))
    least = np.clip(left, 0.0, 1.0).min(axis=1)
    return np.where(factor >= of.ended, 0.0, least)
