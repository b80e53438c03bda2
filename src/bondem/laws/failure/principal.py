"""Criteria on the largest and the least principal stress, in the form for bonds of the non-local law."""

from bondem._compile import device
from bondem.laws.failure.criterion import SHEAR, TENSION


@device
def principal_size(high, low, s):
    """Return the index alone, of one bond or of many."""
    return max(s[0] * high, s[1] * high - s[2] * low)


@device
def principal_index(high, low, s):
    """Return index and mode for the principal stresses σ1 and σ3: max(a σ1, b σ1 - c σ3) of the coefficients a, b, c.

    `bd.Rankine` has a = 1 / f_t alone. Mohr and Coulomb have b, c = (1 ± sin φ) / 2 c cos φ, with their cohesion c.
    """
    pulled, sheared = s[0] * high, s[1] * high - s[2] * low
    return (pulled, TENSION) if pulled >= sheared else (sheared, SHEAR)
