"""Notched beams as a continuum with one cohesive crack: what their input gives without particles.

One half of the beam in plane stress (`validation.measures.plane_stress`); at mid-span above the notch its nodes are
held where the crack has not come, and pulled by the softening curve where it has. Loads and supports are points.

Reference: Hillerborg, Modéer and Petersson (1976); the tip as the control, Petersson (1981).
"""

from dataclasses import dataclass

import numpy as np

from bondem._types import Floats, Ints
from bondem.damage.bilinear import Bilinear
from validation.cases.beams import BentBeam
from validation.cases.case import Case
from validation.measures.plane_stress import condensed, crack_path, quads, stiffness

# Elements across the depth, and how much longer each is than the one before, away from mid-span.
_ACROSS, _GROWTH = 160, 1.06
# Largest length of an element over its height.
_LONGEST = 8.0


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
    step = beam.depth / across
    area = np.full(len(ligament), step * beam.width)
    area[0] = area[-1] = 0.5 * step * beam.width
    kink = (1.0, 0.5) if curve is None else (curve.opening, curve.stress)  # of a straight line any point is one
    last = 2.0 if curve is None else curve.last
    opening = case.fracture_energy / case.tension * np.array([0.0, kink[0], last])
    tips = range(1, len(ligament) - 1)
    path = crack_path(K, area, opening, case.tension * np.array([1.0, kink[1], 0.0]), tips)
    load, way = np.array(list(path)).T
    return CohesiveCrack(step * np.array(tips), -2.0 * load, -way)


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
    number = np.arange(len(x) * len(y)).reshape(len(x), len(y))
    nodes: Floats = np.column_stack([np.repeat(x, len(y)), np.tile(y, len(x))]).astype(np.float64)
    ligament = number[0, y >= beam.notch[1] - 1e-9]
    kept = np.append(2 * ligament, 2 * number[0, -1] + 1)
    support = 2 * number[np.argmin(np.abs(x - half)), :1] + 1
    return condensed(stiffness(nodes, quads(number), case.E, case.nu, beam.width), support, kept), ligament
