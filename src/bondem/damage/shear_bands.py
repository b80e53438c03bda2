"""Width of shear bands, and the cells whose mean plastic shear strain reduces the cohesion of a cell."""

import numpy as np

from bondem._types import Ints, Mask, PerElement
from bondem.errors import InputError
from bondem.geometry.neighbours import neighbours
from bondem.specimen.lattice import Lattice

#: Default width of a band over the edge V^(1/3) of its cells.
USUAL_WIDTH = 4.0
# Least width over the edge: bands of fewer cells lock against their rigid sides.
_LEAST_WIDTH = 3.0
# Half of the thickness of the shell of averaged cells, over the edge of a cell.
_HALF_SHELL = 0.25


def band_widths(edge: PerElement, yields: Mask, given: PerElement) -> PerElement:
    """Return the widths of bands [m], (n,): the given width, or four edges of the cell where it is zero.

    Args:
        edge: edges V^(1/3) of the cells [m], (n,).
        yields: mask of the cells that yield, (n,).
        given: widths that the criteria give [m], 0 for none, (n,).

    Raises:
        InputError: More than half of the yielding cells have a given band thinner than three cells.
    """
    thin = yields & (given > 0.0) & (given < _LEAST_WIDTH * edge)
    if 2 * np.count_nonzero(thin) > np.count_nonzero(yields):
        raise InputError(
            f"band_width = {given[thin].min():.3g} m is less than three cells of {np.median(edge[thin]):.3g} m; give"
            " smaller cells, a wider band, or None for four cells"
        )
    return np.where(given > 0.0, given, USUAL_WIDTH * edge)


def cells_of_bands(
    body: Lattice, order: Ints, edge: PerElement, yields: Mask, width: PerElement
) -> tuple[Ints, Ints]:
    """List the cells over which the plastic shear strain of each cell is averaged, about half a shear band away.

    B is the width of a shear band. On a sphere of radius ρ, the coordinate along any axis is distributed uniformly
    over -ρ … ρ. The mean strain on the sphere ρ = B/2 around a cell of a flat band is therefore s / B, with s [m] the
    displacement across the band. This is true for every profile of a band thinner than B/2. Only cells that yield are
    listed. A cell without such a neighbour lists itself.

    Args:
        body: the body of cells.
        order: user's index of each cell, internal order, (n,).
        edge: edges V^(1/3) of the cells [m], internal order, (n,).
        yields: mask of the cells that yield, internal order, (n,).
        width: B of each cell [m], internal order, (n,).

    Returns:
        Start of the list of each cell, (n + 1,), and all lists, one after the other.

    Raises:
        InputError: A periodic edge is shorter than a band and half a cell together.
    """
    n, period = len(order), body.particles.period
    own = np.flatnonzero(yields)
    centre, reach = body.particles.position[order][own], 0.25 * width[own] + 0.5 * _HALF_SHELL * edge[own]
    lower, upper, wrapped = centre.min(axis=0), centre.max(axis=0), np.zeros(3)
    if period is not None:
        wrapped = np.where(np.isfinite(period), period, 0.0)
        if ((wrapped > 0.0) & (wrapped <= 4.0 * reach.max())).any():
            raise InputError(
                f"periodic edges of {wrapped[wrapped > 0.0].min():.3g} m do not hold a shear band of"
                f" {width[own].max():.3g} m; give a larger cell or a smaller band_width"
            )
    start, listed = neighbours(np.column_stack([centre, reach]), lower, upper, wrapped, 0.0)
    first, second = np.repeat(np.arange(len(own)), np.diff(start)), listed.astype(np.int64)
    apart = centre[second] - centre[first]
    apart -= np.divide(apart, wrapped, out=np.zeros_like(apart), where=wrapped > 0.0).round() * wrapped
    first, second, distance = own[first], own[second], np.sqrt((apart**2).sum(axis=1))
    off = np.abs(distance - 0.25 * (width[first] + width[second])) / (edge[first] + edge[second])
    retained = off <= 0.5 * _HALF_SHELL
    first, second = first[retained], second[retained]
    alone = np.setdiff1d(own, first)
    first, second = np.concatenate([first, alone]), np.concatenate([second, alone])
    place = np.lexsort((second, first))
    return np.searchsorted(first[place], np.arange(n + 1)).astype(np.int64), second[place]
