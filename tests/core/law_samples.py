"""Laws of softening, cracks and yielding over arrays of samples, each evaluated by the core."""

import math

import numpy as np

from bondem._core import run_pass
from bondem._passes import calls
from bondem._tables.crack_sample_tables import CrackSamples, SofteningSamples, StressBoundSamples, YieldSamples


def evaluate_softening(samples: SofteningSamples) -> None:
    run_pass(calls.evaluate_softening(samples))


def evaluate_cracks(samples: CrackSamples) -> None:
    run_pass(calls.evaluate_cracks(samples))


def evaluate_yielding(samples: YieldSamples) -> None:
    run_pass(calls.evaluate_yielding(samples))


def evaluate_stress_bounds(samples: StressBoundSamples) -> None:
    run_pass(calls.evaluate_stress_bounds(samples))


#: Places of the components xx, yy, zz, xy, xz, yz in a matrix.
ROW, COLUMN = [0, 1, 2, 0, 0, 1], [0, 1, 2, 1, 2, 2]


def softening(
    s: float, traction, normal, stress, *, strength: float, last: float, bent=0.0, kink: float = 0.0,
    steep: float = 1.0, plane: bool = False, cohesion: float = math.inf, last_slip: float = math.inf,
    friction: float = 0.0,
) -> np.ndarray:  # fmt: skip
    """Return what is left of a facet under some loads, and the traction below which none softens it [Pa].

    The axes of the facet are the principal directions of the stress, the largest one first.

    Args:
        s: present integrity along the first axis; that along the others is 1.
        traction: tractions that the facet would have if it were whole [Pa], (3,) or (m, 3).
        normal: normal of the facet.
        stress: mean stress of its cells [Pa], (3, 3).
        strength: strength in tension [Pa].
        last: traction of the whole facet at its last opening [Pa].
        bent: rms of the tractions of bending [Pa], one or (m,).
        kink, steep: parameters of the softening curve.
        plane: whether the facet belongs to a material plane.
        cohesion, last_slip, friction: cohesion of a plane [Pa], `last` of its slip [Pa], and tan φ.

    Returns:
        s_1, s_2, s_3, grip and the least traction, (5,) or (5, m).
    """
    loads = np.atleast_2d(np.asarray(traction, dtype=float)).T
    m = loads.shape[1]
    axes = np.linalg.eigh(np.asarray(stress, dtype=float))[1][:, ::-1].T
    others = [
        strength, 1.0 / last, cohesion, 1.0 / last_slip, friction, float(plane), *axes.ravel(), s, 1.0, 1.0,
        s if plane else 1.0, 0.0, 0.0, 0.0, 0.0,
    ]  # fmt: skip
    columns = [loads, *([np.full(m, float(one))] for one in normal), [np.full(m, 0.0) + bent]]
    columns += [[np.full(m, float(one))] for one in (*np.asarray(stress)[ROW, COLUMN], *others)]
    samples = SofteningSamples(np.ascontiguousarray(np.vstack(columns)), kink, steep, False, np.empty((5, m)))
    evaluate_softening(samples)
    return samples.left if np.ndim(traction) == 2 else samples.left[:, 0]


def left_in_bulk(s: float, traction, normal, stress, **options) -> np.ndarray:
    """Return the least integrity of a facet of the material under loads (`softening`)."""
    return softening(s, traction, normal, stress, **options)[:3].min(axis=0)


def left_on_plane(s: float, traction, normal, **options) -> np.ndarray:
    """Return the integrity of a facet of a material plane under loads (`softening`)."""
    return softening(s, traction, normal, np.zeros((3, 3)), plane=True, **options)[0]


def softened(s: float, traction, strength: float, last: float, kink: float, steep: float) -> np.ndarray:
    """Return the integrity that tractions across a facet leave by the softening curve alone."""
    normal = np.array([1.0, 0.0, 0.0])
    loads = np.multiply.outer(traction, normal)
    return left_on_plane(s, loads, normal, strength=strength, last=last, kink=kink, steep=steep)


def yielding(stress: np.ndarray, strength: np.ndarray, *, cone: bool) -> np.ndarray:
    """Return the bound of F [Pa], Δγ, what is held of it, strain, principal stresses and load [Pa] of cells, (13, m).

    Args:
        stress: stresses xx, yy, zz, xy, xz, yz [Pa], (6, m).
        strength: strength [Pa], slope, dilation, stiffness [Pa] and slip held of each cell, (5, m).
        cone: whether by Drucker and Prager.
    """
    found = np.empty((13, stress.shape[1]))
    evaluate_yielding(YieldSamples(np.ascontiguousarray(stress), np.ascontiguousarray(strength), cone, False, found))
    return found


def stress_bounds(stress: np.ndarray, bent: np.ndarray) -> np.ndarray:
    """Return bounds of stresses and of what bending opens [Pa], (4, m).

    Args:
        stress: stresses xx, yy, zz, xy, xz, yz [Pa], (6, m).
        bent: rms of the tractions of bending [Pa], (m,).

    Returns:
        Bounds of the largest and the least principal stress, bending less the largest pressure, at least 0, and a
        bound of that.
    """
    found = np.empty((4, len(bent)))
    evaluate_stress_bounds(StressBoundSamples(np.ascontiguousarray(stress), bent, False, found))
    return found
