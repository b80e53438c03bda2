"""Neighbours of spheres, by a grid of cells: the list every short-range force runs over.

The list is full (each pair stands in the list of both partners), so that a force can be gathered sphere by
sphere in a fixed order and does not depend on the number of threads.
"""

import numpy as np

from bondem._compile import device, kernel, prange


@device
def inverse_period(period):
    """1 / period, or 0 where the axis is not periodic (period 0)."""
    return 1.0 / period if period > 0.0 else 0.0


@device
def nearest_image(d, period, inverse):
    """Component of a separation over the nearest periodic image [m]; as it is where `period` is 0.

    Without a branch: in the inner loop one costs half as much again as the whole force.
    """
    return d - period * np.rint(d * inverse)


@device
def _cell_of(x, lower, edge, cells):
    return min(max(int((x - lower) / edge), 0), cells - 1)


@device
def _span(centre, cells, wraps):
    """First and last cell to visit along an axis; a wrapped axis of one or two cells visits each once."""
    if not wraps:
        return max(centre - 1, 0), min(centre + 1, cells - 1)
    if cells < 3:
        return 0, cells - 1
    return centre - 1, centre + 1


@kernel(parallel=True)
def neighbours(sphere, lower, upper, period, skin):
    """Pairs of spheres whose surfaces are at most `skin` apart.

    Args:
        sphere: centres and radii [m], shape (n, 4): x, y, z, R.
        lower: lower corner of the box that holds the centres [m], (3,).
        upper: upper corner [m], (3,).
        period: periodic edge lengths [m], (3,), 0 where an axis is not periodic. A periodic edge must
            exceed four largest radii plus two skins.
        skin: largest gap [m].

    Returns:
        start: where the list of each sphere begins, shape (n + 1,), int64.
        neighbour: the lists one after the other, uint32.
    """
    n = sphere.shape[0]
    px, py, pz = period[0], period[1], period[2]
    qx, qy, qz = inverse_period(px), inverse_period(py), inverse_period(pz)
    reach = 0.0
    for i in range(n):
        reach = max(reach, sphere[i, 3])
    reach = 2.0 * reach + skin
    cells = np.empty(3, np.int64)
    edge = np.empty(3)
    for a in range(3):
        # More cells than spheres along an axis would only cost memory.
        cells[a] = max(1, min(int((upper[a] - lower[a]) / reach), n, 1024))
        edge[a] = (upper[a] - lower[a]) / cells[a]

    cell = np.empty(n, np.int64)
    first = np.zeros(cells[0] * cells[1] * cells[2] + 1, np.int64)
    for i in range(n):
        c = _cell_of(sphere[i, 0], lower[0], edge[0], cells[0])
        c = c * cells[1] + _cell_of(sphere[i, 1], lower[1], edge[1], cells[1])
        c = c * cells[2] + _cell_of(sphere[i, 2], lower[2], edge[2], cells[2])
        cell[i] = c
        first[c + 1] += 1
    for c in range(first.size - 1):
        first[c + 1] += first[c]
    fill = first.copy()
    member = np.empty(n, np.uint32)
    for i in range(n):
        member[fill[cell[i]]] = i
        fill[cell[i]] += 1

    start = np.zeros(n + 1, np.int64)
    neighbour = np.empty(0, np.uint32)
    for sweep in range(2):  # count, then fill
        for i in prange(n):
            x, y, z, r = sphere[i, 0], sphere[i, 1], sphere[i, 2], sphere[i, 3]
            cz = cell[i] % cells[2]
            cy = cell[i] // cells[2] % cells[1]
            cx = cell[i] // (cells[2] * cells[1])
            ax, bx = _span(cx, cells[0], period[0] > 0.0)
            ay, by = _span(cy, cells[1], period[1] > 0.0)
            az, bz = _span(cz, cells[2], period[2] > 0.0)
            k = start[i] if sweep == 1 else 0
            for gx in range(ax, bx + 1):
                for gy in range(ay, by + 1):
                    for gz in range(az, bz + 1):
                        c = (gx % cells[0] * cells[1] + gy % cells[1]) * cells[2] + gz % cells[2]
                        for p in range(first[c], first[c + 1]):
                            j = member[p]
                            dx = nearest_image(sphere[j, 0] - x, px, qx)
                            dy = nearest_image(sphere[j, 1] - y, py, qy)
                            dz = nearest_image(sphere[j, 2] - z, pz, qz)
                            near = r + sphere[j, 3] + skin
                            if dx * dx + dy * dy + dz * dz <= near * near and j != i:
                                if sweep == 1:
                                    neighbour[k] = j
                                k += 1
            if sweep == 0:
                start[i + 1] = k
        if sweep == 0:
            for i in range(n):
                start[i + 1] += start[i]
            neighbour = np.empty(start[n], np.uint32)
    return start, neighbour
