"""The peak of a notched beam by a cracked hinge: what its input gives by beam theory, without elements.

The ligament is a hinge as long as half of the beam is deep, with plane sections; each of its fibres stretches
elastically and, from f_t on, opens along the softening curve. Its stress is found from how much longer it gets, its
axis from the balance of forces, and the moment over the turning angle has a largest value.

Reference: Ulfkjær, Krenk and Brincker (1995), analytical model for fictitious crack propagation in concrete beams.
"""

import numpy as np
from scipy.optimize import brentq

from bondem._types import Floats
from bondem.errors import InputError
from bondem.laws.failure.bilinear import Bilinear
from validation.cases.beams import BentBeam
from validation.cases.case import Case

# Length of the hinge over the depth of the beam, fibres across the ligament, and angles that are looked at.
_LENGTH, _FIBRES, _ANGLES = 0.5, 800, 300


def hinge_peak(case: Case, beam: BentBeam, curve: Bilinear | None) -> float:
    """Largest load in three-point bending, pressed above its notch at mid-span [N].

    Args:
        case: its material.
        beam: its geometry.
        curve: how the material softens; None for a straight line.

    Raises:
        InputError: so small a fracture energy that fibres snap back.
    """
    length, height = _LENGTH * beam.depth, beam.depth - beam.notch[1]
    unit = case.fracture_energy / case.tension
    kink = (1.0, 0.5) if curve is None else (curve.opening, curve.stress)  # of a straight line any point is one
    last = 2.0 if curve is None else curve.last
    w = unit * np.array([0.0, kink[0], last])
    stress = case.tension * np.array([1.0, kink[1], 0.0])
    # how much longer a fibre is where its crack opens by w
    longer = stress * length / case.E + w
    if not (np.diff(longer) > 0.0).all():
        raise InputError(f"a hinge of {case.name} snaps back: {case.fracture_energy:g} J/m² is too little for it")
    y = height * (np.arange(_FIBRES) + 0.5) / _FIBRES

    def fibres(angle: float, axis: float) -> Floats:
        u = angle * (axis - y)
        return np.where(u < longer[0], u * case.E / length, np.interp(u, longer, stress))

    span = beam.supports[1] - beam.supports[0]
    angles = np.geomspace(longer[0] / height, 5.0 * (longer[0] + unit) / height, _ANGLES)
    moments = []
    for angle in angles:
        axis = brentq(lambda at, turned=angle: float(fibres(turned, at).sum()), 1e-6 * height, height)
        moments.append(float(fibres(angle, axis) @ (0.5 * height - y)) * height / _FIBRES * beam.width)
    return 4.0 * max(moments) / span
