"""Fracture without inertia by displacements that grow: what `bd.solve_quasistatic` has where nothing snaps back.

At each displacement all facets go to the integrity that their softening curve has at the traction that they would
bear whole, and equilibrium is found anew, until no integrity changes: secant iterations, without steps of softening
and without facets that fail together. It stops being of use where the path turns back: integrities then fall without
a load until another equilibrium is found, or none is.
"""

import math
from dataclasses import dataclass

import numpy as np

import bondem as bd
from bondem.statics.quasistatic import quasistatic_run
from bondem.statics.quasistatic.damaged_body import DamagedBody, Loaded
from bondem.statics.quasistatic.limits import StressOnset
from bondem.statics.quasistatic.load_response import Reading
from bondem.statics.quasistatic.sawtooth_softening import SofteningLine
from bondem.statics.quasistatic.tensors import full_tensor

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
    lines: dict[int, SofteningLine] = {}
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
            for k, begun in zip(facets.tolist(), at.tolist(), strict=True):
                if begun <= factor:
                    lines[k] = _line(body, onset, found, k, begun)
            settled = _softened(body, lines, found, factor) < _STILL
        rows.append((way, factor * load, rounds))
        peak = max(peak, factor * load)
        if factor * load < until * peak:
            return Steps(*(np.array(column) for column in zip(*rows, strict=True)))
        way += step


def _line(body: DamagedBody, onset: StressOnset, found: Loaded, k: int, factor: float) -> SofteningLine:
    """The curve of a facet that begins at a factor: from min(|t|, f |n·e1|) on (`bondem.laws.softening`)."""
    n, t = body.constants.normal[k], factor * found.traction[k]
    mean = factor * full_tensor(body.mean(found.tensor, np.array([k]))[0])
    bent = factor * float(body.bent(found.tensor, found.bending, np.array([k]))[0])
    along = max(float(n @ mean @ n), 0.0)
    direction = np.linalg.eigh(mean + max(bent - along, 0.0) * np.outer(n, n))[1][:, 2]
    opening = t - min(float(t @ n), 0.0) * n
    begun = min(math.hypot(float(np.linalg.norm(opening)), bent), onset._strength[k] * abs(float(n @ direction)))
    table = onset._table
    return SofteningLine(begun, float(table.last[k]), table.kink, table.steep)


def _softened(body: DamagedBody, lines: dict[int, SofteningLine], found: Loaded, factor: float) -> float:
    """Take facets to their curves; by what share of it any integrity has fallen."""
    opening = dict(zip(found.cracked.tolist(), (factor * found.opening).tolist(), strict=True))
    most = 0.0
    for k, line in lines.items():
        before = float(body.integrity[k])
        # one that begins now bears its onset; nearly whole, it is known by its opening from now on
        after = 1.0 - _BEGUN
        if k in opening:
            now = opening[k]
            after = min(before, line.borne(now) / now) if now > line.onset else before
        if after < before:
            most = max(most, (before - after) / max(before, _SMALL))
            body.weaken(k, after, (bool(body.closed[k, 0]), bool(body.closed[k, 1])))
    return most
