"""Candidates for contact: pairs that may touch before the list is made anew, with the memory of those that do.

Each pair stands once, sorted by its later element, then by its earlier one, as bonds are. What a list holds beyond
the pairs that touch changes no bit of a run: what does not touch adds nothing to any sum.
"""

import numpy as np

from bondem._compile import device, kernel
from bondem.kernels.walls import wall_gap


@device
def _find(keys, first, last, wanted):
    """Place of `wanted` in the ascending keys[first:last], or -1."""
    for e in range(first, last):
        if keys[e] == wanted:
            return e
    return -1


@device
def _put(first, bond, begin, count, q, e):
    """Put element q and bond e into the ascending first[begin:count]; the new count."""
    k = count
    while k > begin and first[k - 1] > q:
        first[k], bond[k] = first[k - 1], bond[k - 1]
        k -= 1
    first[k], bond[k] = q, e
    return count + 1


@kernel(parallel=False)
def pair_candidates(
    start, neighbour, bond_start, bond_first, listed, rest_start, rest_first, rest_gap,
    kept_start, kept_first, kept_stretch,
):  # fmt: skip
    """Pairs of neighbours that no bond joins, and pairs of bonds that are asked for.

    Args:
        start, neighbour: neighbours of each element, as `specimen.neighbours.neighbours` gives them.
        bond_start, bond_first: earlier element of the bonds of each later one, and where they begin.
        listed: whether the pair of a bond is wanted, however far apart, uint8, (m,).
        rest_start, rest_first, rest_gap: the same of pairs that overlapped at first, and their gaps [m].
        kept_start, kept_first, kept_stretch: the same of pairs that touch, and their memory (c, 6).

    Returns:
        first, second: elements, uint32, (c,).
        bond: the bond of each pair, or -1, (c,).
        in_start: where the pairs of each later element begin, (n + 1,).
        gap: from which the overlap counts, at most 0 [m], (c,).
        stretch: memory of the contacts, in six of (c, 8).
        touch: 1 where there is one, uint8, (c,).
        out_start, out_pair: pairs of each earlier element.
    """
    n = len(start) - 1
    in_start = np.zeros(n + 1, np.int64)
    out_start = np.zeros(n + 1, np.int64)
    room = len(neighbour) // 2 + 1 + np.int64(listed.sum())
    first, second, bond = np.empty(room, np.uint32), np.empty(room, np.uint32), np.empty(room, np.int64)
    gap, stretch, touch = np.zeros(room), np.zeros((room, 8)), np.zeros(room, np.uint8)
    count = 0
    for p in range(n):
        begin = count
        for e in range(start[p], start[p + 1]):
            q = neighbour[e]
            if q >= p:
                continue
            if _find(bond_first, bond_start[p], bond_start[p + 1], q) < 0:
                count = _put(first, bond, begin, count, q, -1)
        for e in range(bond_start[p], bond_start[p + 1]):
            if listed[e] != 0:
                count = _put(first, bond, begin, count, bond_first[e], e)
        for k in range(begin, count):
            q = first[k]
            second[k] = p
            out_start[q + 1] += 1
            e = _find(rest_first, rest_start[p], rest_start[p + 1], q)
            if e >= 0:
                gap[k] = rest_gap[e]
            e = _find(kept_first, kept_start[p], kept_start[p + 1], q)
            if e >= 0:
                touch[k] = 1
                for d in range(6):
                    stretch[k, d] = kept_stretch[e, d]
        in_start[p + 1] = count
    for p in range(n):
        out_start[p + 1] += out_start[p]
    fill = out_start.copy()
    out_pair = np.empty(count, np.uint32)
    for k in range(count):
        out_pair[fill[first[k]]] = k
        fill[first[k]] += 1
    return (
        first[:count].copy(), second[:count].copy(), bond[:count].copy(), in_start, gap[:count].copy(),
        stretch[:count].copy(), touch[:count].copy(), out_start, out_pair,
    )  # fmt: skip


@kernel(parallel=False)
def wall_candidates(
    pose, radius, shape, walls, skin, rest_start, rest_wall, rest_gap, kept_start, kept_wall, kept_stretch
):  # fmt: skip
    """Walls within `skin` [m] of each element, in their order, with the memory of those that touch.

    Returns:
        start (n + 1,), wall uint32 (c,), rest gap [m] (c,), memory (c, 6), touch uint8 (c,), gap now [m] (c,).
    """
    n = len(pose)
    start = np.zeros(n + 1, np.int64)
    for p in range(n):
        count = 0
        for w in range(len(shape)):
            distance, _, _, _ = wall_gap(pose[p, 0], pose[p, 1], pose[p, 2], radius[p], shape, walls, w)
            count += 1 if distance <= skin else 0
        start[p + 1] = start[p] + count
    wall = np.empty(start[n], np.uint32)
    gap, stretch, touch = np.zeros(start[n]), np.zeros((start[n], 6)), np.zeros(start[n], np.uint8)
    now = np.empty(start[n])
    for p in range(n):
        k = start[p]
        for w in range(len(shape)):
            distance, _, _, _ = wall_gap(pose[p, 0], pose[p, 1], pose[p, 2], radius[p], shape, walls, w)
            if distance > skin:
                continue
            wall[k] = w
            now[k] = distance
            e = _find(rest_wall, rest_start[p], rest_start[p + 1], np.uint32(w))
            if e >= 0:
                gap[k] = rest_gap[e]
            e = _find(kept_wall, kept_start[p], kept_start[p + 1], np.uint32(w))
            if e >= 0:
                touch[k] = 1
                for d in range(6):
                    stretch[k, d] = kept_stretch[e, d]
            k += 1
    return start, wall, gap, stretch, touch, now


@kernel(parallel=False)
def farthest(pose, listed):
    """How far an element is from where the list was made [m]; not a number where a centre is none."""
    most = 0.0
    for p in range(len(pose)):
        x, y, z = pose[p, 0] - listed[p, 0], pose[p, 1] - listed[p, 1], pose[p, 2] - listed[p, 2]
        square = x * x + y * y + z * z
        if not square <= most:
            most = square
    return np.sqrt(most)
