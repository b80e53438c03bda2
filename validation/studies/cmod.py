"""Opening of the mouth of a notch in three-point bending, against Tada's formula and finite elements.

Beams 480 × 100 × 100 mm over 400 mm, E = 40 GPa, ν = 0.2, with a notch to half the depth, until the first facet
fails: `bd.labtests.three_point_bending(..., most=1)`. Both references are in plane stress, because the opening at the
bottom depends on the section far from the tip:

- Tada, Paris and Irwin (2000) for a sharp crack at a span of four depths: CMOD = 4 σ a V(a/W) / E with
  σ = 3 P S / (2 b W²), V = 0.76 - 2.28 α + 3.87 α² - 2.04 α³ + 0.66 / (1 - α)²; 1 % for any α.
- finite elements (`measures/plane_stress.py`, graded to 0.02 mm at the corners of the notch) of the notch with its
  width, under the strips of the test. A notch opens more than a crack of its depth, by the ratio `notch_over_crack`.

"opening" is `BendingTest.cmod`; "over_tada" divides it by Tada's value times `notch_over_crack`. "centres" is the
former measure, the difference of the mean displacements of the centres of the cells on both sides of the mouth.
"""

from functools import cache, partial
from itertools import pairwise, product

import numpy as np
from scipy.sparse.linalg import splu

import bondem as bd
from validation.frame.record import Record
from validation.measures.plane_stress import quads, stiffness

E, NU = 40e9, 0.2
SPAN, DEPTH, WIDTH, BEYOND, NOTCH = 400e-3, 100e-3, 100e-3, 40e-3, 50e-3
# Edge of the finite elements at the corners of a notch, how it grows with the distance, and at most [m].
_FINE, _GROWTH, _COARSE = 2e-5, 0.25, 2e-3


def tada(load: float) -> float:
    """Opening of the mouth of a sharp crack [m]."""
    ratio = NOTCH / DEPTH
    opening = 0.76 - 2.28 * ratio + 3.87 * ratio**2 - 2.04 * ratio**3 + 0.66 / (1.0 - ratio) ** 2
    return 4.0 * 1.5 * load * SPAN / (WIDTH * DEPTH**2) * NOTCH / E * opening


def beam(count: int, seed: int, width: float) -> bd.Lattice:
    """Beam of cells with a notch of a width [m]."""
    length = SPAN + 2.0 * BEYOND
    slot = bd.Box((width, NOTCH, 2.0 * WIDTH)).moved((0.5 * (length - width), 0.0, -0.5 * WIDTH))
    shape = bd.Box((length, DEPTH, WIDTH)).cut(slot, name="notch")
    return bd.connect(bd.pack(shape, count=count, method="even", seed=seed), method="laguerre")


def strip_of(body: bd.Lattice) -> float:
    """Usual width of the loaded strips of the test [m]."""
    assert body.cells is not None
    return max(0.1 * DEPTH, 1.5 * float(np.cbrt(body.cells.volume.mean())))


def measured(count: int, seed: int, width: float) -> list[dict]:
    """Openings of one beam over both references."""
    body = beam(count, seed, 1e-3 * width)
    failure = bd.Rankine(tension=4e6, fracture_energy=100.0)
    test = bd.labtests.three_point_bending(body, bd.CellBond(E=E, nu=NU), failure, span=SPAN, most=1)
    assert body.cells is not None
    assert body.cells.free is not None
    assert test.cmod is not None
    free, middle = body.cells.free, 0.5 * (SPAN + 2.0 * BEYOND)
    side = (free.face == list(body.particles.envelope.faces).index("notch")) & (np.abs(free.normal[:, 0]) > 0.5)
    side &= free.centroid[:, 1] < strip_of(body)
    moved = test.state.displacement[:, 0]
    left, right = (np.unique(free.cell[side & part]) for part in (free.centroid[:, 0] < middle,
                                                                 free.centroid[:, 0] > middle))  # fmt: skip
    load, strip = float(test.load[1]), strip_of(body)
    notch, crack = opening(1e-3 * width, strip), opening(0.0, strip)
    exact = tada(load) * notch / crack
    return [{
        "edge": float(np.cbrt(body.cells.volume.mean())), "over_tada": float(test.cmod[1]) / exact,
        "notch_over_crack": notch / crack, "crack_over_tada": load * crack / tada(load),
        "centres_over_tada": float(moved[right].mean() - moved[left].mean()) / exact,
    }]  # fmt: skip


@cache
def opening(width: float, strip: float) -> float:
    """Opening of the mouth by finite elements over the load [m/N], 0 for the width of a sharp crack."""
    half, end = 0.5 * width, 0.5 * SPAN + BEYOND
    marks = sorted({0.0, half, 0.5 * strip, 0.5 * (SPAN - strip), 0.5 * SPAN, 0.5 * (SPAN + strip), end})
    x, y = _graded(marks, half), _graded([0.0, NOTCH, DEPTH], NOTCH)
    number = np.arange(len(x) * len(y)).reshape(len(x), len(y))
    nodes = np.stack(np.meshgrid(x, y, indexing="ij"), axis=-1).reshape(-1, 2)
    elements = quads(number)
    middle = nodes[elements].mean(axis=1)
    elements = elements[(middle[:, 0] > half) | (middle[:, 1] > NOTCH)]
    # half of the beam, under half of 1 N
    load = np.zeros(2 * len(nodes))
    load[2 * number[:, -1] + 1] = -0.5 * _pressed(x, 0.0, 0.5 * strip)
    load[2 * number[:, 0] + 1] = 0.5 * _pressed(x, 0.5 * (SPAN - strip), 0.5 * (SPAN + strip))
    held = np.r_[2 * number[0, y > NOTCH - 1e-9], 2 * number[np.abs(x - 0.5 * SPAN).argmin(), 0] + 1]
    there = np.unique(elements)
    free = np.setdiff1d(np.r_[2 * there, 2 * there + 1], held)
    moved = np.zeros_like(load)
    moved[free] = splu(stiffness(nodes, elements, E, NU, WIDTH)[free][:, free].tocsc()).solve(load[free])
    return 2.0 * float(moved[2 * number[np.abs(x - half).argmin(), 0]])


def _pressed(x: np.ndarray, low: float, high: float) -> np.ndarray:
    """Shares of the nodes of an edge in a force that is spread from one place to another."""
    middle = 0.5 * (x[1:] + x[:-1])
    part = 0.5 * np.diff(x) / (high - low) * ((middle > low) & (middle < high))
    return np.append(part, 0.0) + np.append(0.0, part)


def _graded(marks: list[float], fine: float) -> np.ndarray:
    """Coordinates between marks, denser towards one of them."""
    parts = []
    for low, high in pairwise(marks):
        points = [low]
        while points[-1] < high - 1e-12:
            near = np.inf
            if low == fine:
                near = points[-1] - low
            elif high == fine:
                near = max(high - points[-1] - _FINE, 0.0) / (1.0 + _GROWTH)
            points.append(points[-1] + min(_COARSE, _FINE + _GROWTH * near))
        part = np.array(points)
        parts.append((low + (part - low) * (high - low) / (part[-1] - low))[:-1])
    return np.append(np.concatenate(parts), marks[-1])


def measure(
    record: Record, *, counts: tuple[int, ...] = (500, 2000, 5000), seeds: tuple[int, ...] = (1, 2, 3, 4),
    widths: tuple[float, ...] = (5.0,),
) -> None:  # fmt: skip
    """Bend beams with notches of several widths [mm]."""
    for width, count, seed in product(widths, counts, seeds):
        case = {"count": count, "seed": seed, "width": width}
        record.add(partial(measured, **case), **case)
