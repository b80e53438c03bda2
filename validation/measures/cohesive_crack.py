"""Notched beams as a continuum with one cohesive crack: what their input gives without particles.

One half of the beam in plane stress, by bilinear finite elements; at mid-span above the notch its nodes are held
where the crack has not come, and pulled by the softening curve where it has. The tip of the crack is set, node after
node, at the strength; the load that goes with it follows, and snap-back does no harm. Loads and supports are points.

Reference: Hillerborg, Modéer and Petersson (1976); the tip as the control, Petersson (1981).
"""

from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.sparse import coo_array
from scipy.sparse.linalg import splu

from bondem._types import Floats, Ints
from bondem.damage.bilinear import Bilinear
from bondem.errors import ConvergenceError
from validation.cases.beams import BentBeam
from validation.cases.case import Case

# Elements across the depth, and how much longer each is than the one before, away from mid-span.
_ACROSS, _GROWTH = 160, 1.06
# Largest length of an element over its height, rounds until no opening changes its line, and what counts as none.
_LONGEST, _ROUNDS, _SMALL = 8.0, 200, 1e-12


@dataclass(frozen=True)
class CohesiveCrack:
    """A path of a beam, an entry for each place of the crack's tip.

    Attributes:
        tip: how far the crack has come above the notch [m], (k,).
        load: in the middle [N], (k,).
        deflection: of the load [m], (k,).
    """

    tip: Floats
    load: Floats
    deflection: Floats

    @property
    def peak(self) -> float:
        """Largest load [N]."""
        return float(self.load.max())


def cohesive_crack(case: Case, beam: BentBeam, curve: Bilinear | None, across: int = _ACROSS) -> CohesiveCrack:
    """The path of a beam that is pressed above its notch, half-way between its supports.

    Args:
        case: its material.
        beam: its geometry; its notch is a line here.
        curve: how the material softens; None for a straight line.
        across: elements across its depth.

    Raises:
        ConvergenceError: openings that change their lines for ever.
    """
    K, ligament = _condensed(case, beam, across)
    n, step = len(ligament), beam.depth / across
    area = np.full(n, step * beam.width)
    area[0] = area[-1] = 0.5 * step * beam.width
    unit = case.fracture_energy / case.tension
    kink = (1.0, 0.5) if curve is None else (curve.opening, curve.stress)  # of a straight line any point is one
    w = unit * np.array([0.0, kink[0], 2.0 if curve is None else curve.last])
    stress = case.tension * np.array([1.0, kink[1], 0.0])
    slope = np.append(np.diff(stress) / np.diff(w), 0.0)
    at_zero = np.append(stress[:2] - slope[:2] * w[:2], 0.0)
    rows = []
    line = np.zeros(n, dtype=int)
    for tip in range(1, n - 1):
        # unknown: half openings of what is open, the deflection, and the load; the tip bears f_t and is closed
        for _ in range(_ROUNDS):
            moved = np.append(np.arange(tip), n)
            A = np.zeros((tip + 2, tip + 2))
            A[:, :-1] = K[np.ix_(np.append(np.arange(tip + 1), n), moved)]
            A[np.arange(tip), np.arange(tip)] += 2.0 * slope[line[:tip]] * area[:tip]
            A[-1, -1] = 0.5
            right = np.append(-at_zero[line[:tip]] * area[:tip], [-case.tension * area[tip], 0.0])
            found = np.linalg.solve(A, right)
            before = line[:tip].copy()
            line[:tip] = np.clip(np.searchsorted(w, 2.0 * found[:tip] + _SMALL * unit, side="right") - 1, 0, 2)
            if (line[:tip] == before).all():
                break
        else:
            raise ConvergenceError(f"the cohesive crack of {case.name} finds no openings at node {tip}")
        rows.append((tip * step, found[-1], -found[-2]))
    return CohesiveCrack(*np.array(rows).T)


def _condensed(case: Case, beam: BentBeam, across: int) -> tuple[Floats, Ints]:
    """Stiffness of the ligament's nodes along x and of the loaded node along y, last [N/m], and these nodes."""
    half = 0.5 * (beam.supports[1] - beam.supports[0])
    step = beam.depth / across
    length = [step]
    while sum(length) < half:
        length.append(min(length[-1] * _GROWTH, _LONGEST * step))
    x = np.append(0.0, np.cumsum(length)) * half / sum(length)
    over = beam.length - 0.5 * (beam.length - 2.0 * half) - half
    x = np.append(x, half + over / 4 * np.arange(1, 5))
    y = np.linspace(0.0, beam.depth, across + 1)
    columns, lines = len(x), len(y)
    number = np.arange(columns * lines).reshape(columns, lines)
    corner = np.stack([number[:-1, :-1], number[1:, :-1], number[1:, 1:], number[:-1, 1:]], axis=-1)
    a: Floats = np.repeat(np.diff(x), lines - 1).astype(np.float64)
    b: Floats = np.tile(np.diff(y), columns - 1).astype(np.float64)
    block = quad(a, b, case.E, case.nu, beam.width)
    dof = (2 * corner.reshape(-1, 4)[:, :, None] + np.arange(2)).reshape(-1, 8)
    i, j = np.broadcast_to(dof[:, :, None], block.shape), np.broadcast_to(dof[:, None, :], block.shape)
    size = 2 * columns * lines
    whole: Any = coo_array((block.ravel(), (i.ravel(), j.ravel())), shape=(size, size)).tocsc()
    ligament = number[0, y >= beam.notch[1] - 1e-9]
    kept = np.append(2 * ligament, 2 * number[0, -1] + 1)
    support = 2 * number[np.argmin(np.abs(x - half)), 0] + 1
    inner = np.setdiff1d(np.arange(size), np.append(kept, support))
    mixed = whole[:, kept][inner].toarray()
    return whole[:, kept][kept].toarray() - mixed.T @ splu(whole[:, inner][inner]).solve(mixed), ligament


def quad(a: Floats, b: Floats, E: float, nu: float, width: float) -> Floats:
    """Stiffness of rectangles a × b in plane stress, two by two points, (e, 8, 8)."""
    D = E / (1.0 - nu**2) * np.array([[1.0, nu, 0.0], [nu, 1.0, 0.0], [0.0, 0.0, 0.5 * (1.0 - nu)]])
    found = np.zeros((len(a), 8, 8))
    sx, sy = np.array([-1.0, 1.0, 1.0, -1.0]), np.array([-1.0, -1.0, 1.0, 1.0])
    for r in (-(3**-0.5), 3**-0.5):
        for s in (-(3**-0.5), 3**-0.5):
            dx = 0.25 * sx * (1.0 + sy * s) * 2.0 / a[:, None]
            dy = 0.25 * sy * (1.0 + sx * r) * 2.0 / b[:, None]
            B = np.zeros((len(a), 3, 8))
            B[:, 0, 0::2] = B[:, 2, 1::2] = dx
            B[:, 1, 1::2] = B[:, 2, 0::2] = dy
            found += np.einsum("eki,kl,elj,e->eij", B, D, B, 0.25 * a * b * width)
    return found
