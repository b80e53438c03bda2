"""Criteria that are functions of the stress tensor: called by their address, compiled apart from all loops."""

import math

import numpy as np

from bondem._compile import called, device, loop

# How far the σ* of a facet may be beyond the stresses of its two cells, over the size of these: towards tension from
# all sides, in which criteria weaken.
_BEYOND = 0.1


@device
def stress_index(onset, s, scale, matrix):
    """Index of a stress s times `scale`; `matrix` is (3, 3) to use."""
    matrix[0, 0], matrix[1, 1], matrix[2, 2] = scale * s[0], scale * s[1], scale * s[2]
    matrix[0, 1] = matrix[1, 0] = scale * s[3]
    matrix[0, 2] = matrix[2, 0] = scale * s[4]
    matrix[1, 2] = matrix[2, 1] = scale * s[5]
    return called(onset.judge, matrix, onset.given)


@loop(parallel=False)
def cool_cells(stress, onset, first, last):
    """Let the facets of those cells first … last be that are far below the criterion, into `onset.hotter`.

    Its index is below 1 at the stress of a cell over a share of the strength, and at that with a tension from all
    sides, a share of the size of the stress.
    """
    matrix, tensor, scale = np.empty((3, 3)), stress.tensor, onset.tension / onset.hot
    for p in range(first, last):
        if onset.hotter[p] == 2:
            continue
        s = tensor[p, 0], tensor[p, 1], tensor[p, 2], tensor[p, 3], tensor[p, 4], tensor[p, 5]
        onset.hotter[p] = 1
        if stress_index(onset, s, scale, matrix) < 1.0:
            square = s[0] * s[0] + s[1] * s[1] + s[2] * s[2]
            more = _BEYOND * math.sqrt(square + 2.0 * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5]))
            s = s[0] + more, s[1] + more, s[2] + more, s[3], s[4], s[5]
            if stress_index(onset, s, scale, matrix) < 1.0:
                onset.hotter[p] = 0


@device
def strength_along(onset, s, high, strength, matrix):
    """Largest principal stress at which a stress like s, of which it is `high`, reaches the criterion [Pa].

    `strength` is that of the facet in uniaxial tension, and what it is where s is far below.
    """
    index = stress_index(onset, s, onset.tension / strength, matrix)
    return high / index if index > 0.5 and high > 0.0 else strength
