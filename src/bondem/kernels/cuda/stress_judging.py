"""Criteria that are functions of the stress, on a device: kernels compiled for the function of one criterion.

A device knows no address of a function, by which the loops of the CPU call it (`bondem.kernels.stress_index`): it is
compiled into the three kernels that ask it. What is asked, and when, is that of the CPU.
"""

import functools
from collections.abc import Callable
from typing import Any, NamedTuple

from bondem._compile import device
from bondem._compile_cuda import cuda, cuda_kernel
from bondem.kernels.crack_onset import agreed_stress
from bondem.kernels.crack_tables import CRACKS
from bondem.kernels.cuda.breaking import FOUND
from bondem.kernels.cuda.crack_beginnings import BEFORE_STEP, hotness, mean_at_onset, pulled_at_onset, set_up
from bondem.kernels.stress_index import may_reach, reaches, strength_along


class Judging(NamedTuple):
    """Kernels that ask one function of the stress."""

    cool: Any  #: which cells have facets that are looked at
    mark: Any  #: which facets begin to crack
    begin: Any  #: sets these up


@functools.cache
def judging(function: Callable[..., float], values: tuple[float, ...]) -> Judging:
    """The kernels of a criterion.

    Args:
        function: index of a stress (3, 3) [Pa] and of the values, compiled or plain.
        values: its parameters.
    """

    @device
    def index(_, matrix):
        return function(matrix, *values)

    @cuda_kernel
    def cool_some(tensor, moment, onset):
        p = cuda.grid(1)
        if p >= tensor.shape[0] or onset.hotter[p] == 2:
            return
        hot = onset.cracked[p] != 0
        if not hot:
            matrix = cuda.local.array((3, 3), "float64")
            s = tensor[p, 0], tensor[p, 1], tensor[p, 2], tensor[p, 3], tensor[p, 4], tensor[p, 5]
            hot = may_reach(index, onset, s, moment[p, 6], matrix)
        onset.hotter[p] = 1 if hot else 0

    @cuda_kernel
    def mark_judged(pose, body, cracks, onset, lists):
        k = cuda.grid(1)
        if k >= body.m or cracks.listed[k] != 0 or hotness(body, onset, k) == 0:
            return
        begins = hotness(body, onset, k) == 2
        if not begins:
            n, t, across, mean = pulled_at_onset(pose, body, cracks, k)
            if across > 0.0:
                matrix, scale = cuda.local.array((3, 3), "float64"), onset.tension / onset.strength[k]
                begins = reaches(index, onset, agreed_stress(mean, n, t), scale, matrix)
        if begins:
            lists.found[cuda.atomic.add(lists.counts, FOUND, 1)] = k

    @cuda_kernel
    def begin_judged(pose, body, cracks, onset, lists):
        c = lists.counts[BEFORE_STEP] + cuda.grid(1)
        if c >= cracks.sizes[CRACKS]:
            return
        a, v = cuda.local.array((3, 3), "float64"), cuda.local.array((3, 3), "float64")
        k, strength = cracks.facet[c], 0.0
        if hotness(body, onset, k) != 2:
            mean, high = mean_at_onset(pose, body, cracks, k, a, v)
            strength = strength_along(index, onset, mean, high, onset.strength[k], a)
        set_up(body, cracks, lists, c, k, strength)
        # threads may write this together: it is the same number
        onset.cracked[body.i[k]] = onset.cracked[body.j[k]] = 1

    return Judging(cool_some, mark_judged, begin_judged)
