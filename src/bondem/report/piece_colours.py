"""Distinct colours for any number of pieces."""

import numpy as np
from matplotlib.colors import hsv_to_rgb

from bondem._types import Floats

# Colour of the heaviest piece, usually the rest of the specimen.
_LARGEST = (0.83, 0.86, 0.89)
# Hues advance by the golden ratio, so that neighbours in the order of size differ; saturation and value alternate.
_GOLDEN = 0.61803398875
_SATURATION, _VALUE = (0.55, 0.80, 0.40, 0.68), (0.92, 0.72, 0.86, 0.78, 0.66)


def piece_palette(count: int) -> Floats:
    """Return red, green and blue of pieces, in the order of their masses, in 0 … 1.

    Args:
        count: number of pieces.

    Returns:
        One colour per piece, all different, (count, 3); the first is pale grey.
    """
    number = np.arange(count)
    hue = (0.02 + _GOLDEN * number) % 1.0
    saturation = np.array(_SATURATION)[number % len(_SATURATION)]
    value = np.array(_VALUE)[number % len(_VALUE)]
    colour = hsv_to_rgb(np.column_stack([hue, saturation, value]))
    colour[:1] = _LARGEST
    return colour
