"""Criteria that are functions of the stress tensor: called by their address, compiled apart from all loops."""

import math

import numpy as np

from bondem._calls import called
from bondem._compile import device, loop

# How far the σ* of a facet may be beyond the stresses of its two cells, over the size of these: towards tension from
# all sides, in which criteria weaken.
_BEYOND = 0.2


@device
def by_address(onset, matrix):
    """Index of a stress (3, 3) by the function at the address that `Onset` has: what `index` is on a CPU."""
    return called(onset.judge, matrix, onset.given)


@device
def stress_index(index, onset, s, scale, matrix):
    """Index of a stress s times `scale`.

    Args:
        index: function of `onset` and of a stress (3, 3).
        onset: `Onset`, or that of a device.
        s: stress [Pa].
        scale: of the stress [-].
        matrix: (3, 3) to use.
    """
    matrix[0, 0], matrix[1, 1], matrix[2, 2] = scale * s[0], scale * s[1], scale * s[2]
    matrix[0, 1] = matrix[1, 0] = scale * s[3]
    matrix[0, 2] = matrix[2, 0] = scale * s[4]
    matrix[1, 2] = matrix[2, 1] = scale * s[5]
    return index(onset, matrix)


@device
def _size(s):
    return math.sqrt(s[0] * s[0] + s[1] * s[1] + s[2] * s[2] + 2.0 * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5]))


@device
def reaches(index, onset, s, scale, matrix):
    """Whether a stress s times `scale` reaches the criterion; a small one does without a call.

    What is no number reaches it: a facet that breaks is seen, one that never breaks is not.
    """
    if scale * _size(s) < onset.least:
        return False
    return not stress_index(index, onset, s, scale, matrix) < 1.0


@device
def may_reach(index, onset, s, square, matrix):
    """Whether the facets of a cell of stress s, that bend by Σ T_b² `square`, may reach the criterion.

    They do not while the cell stays below it at its stress over a share of the strength, and at that with a tension
    from all sides, a share of its size and what its facets bend.
    """
    scale = onset.tension / onset.hot
    if reaches(index, onset, s, scale, matrix):
        return True
    bent = math.sqrt(max(square, 0.0)) + min((s[0] + s[1] + s[2]) / 3.0, 0.0)
    more = _BEYOND * _size(s) + max(bent, 0.0)
    return reaches(index, onset, (s[0] + more, s[1] + more, s[2] + more, s[3], s[4], s[5]), scale, matrix)


@loop(parallel=False)
def cool_cells(stress, onset, first, last):
    """Let the facets of those cells first … last be that are far below the criterion, into `onset.hotter`.

    They have no cracks: the stress of a cell with cracks says little about its other facets.
    """
    matrix, tensor = np.empty((3, 3)), stress.tensor
    for p in range(first, last):
        if onset.hotter[p] == 2:
            continue
        hot = onset.cracked[p] != 0
        if not hot:
            s = tensor[p, 0], tensor[p, 1], tensor[p, 2], tensor[p, 3], tensor[p, 4], tensor[p, 5]
            hot = may_reach(by_address, onset, s, stress.bending[p], matrix)
        onset.hotter[p] = 1 if hot else 0


@device
def strength_along(index, onset, s, high, strength, matrix):
    """Largest principal stress at which a stress like s, of which it is `high`, reaches the criterion [Pa].

    `strength` is that of the facet in uniaxial tension, and what it is where s is far below.
    """
    of = stress_index(index, onset, s, onset.tension / strength, matrix)
    return high / of if of > 0.5 and high > 0.0 else strength
