"""Tables of the packing passes; `core/tables/packing_tables.hpp` declares their types and shapes."""

import numpy as np

from bondem._tables.columns import GrowthReport, RelaxationReport
from bondem._tables.packing_tables import Flight, Growing, Relaxing

# Columns of the sums of a block of spheres, and how many spheres a block has.
_SUMS, _BLOCK = 8, 128


def new_relaxing(count: int, tolerance: float, loose: float) -> Relaxing:
    """Return the initial table of a relaxation of some spheres."""
    part = np.zeros((-(-count // _BLOCK), _SUMS))
    return Relaxing(tolerance, loose, 0, np.zeros(3), part, np.zeros(RelaxationReport.COUNT))


def new_growing(scale: float, rate: float, duration: float, events: int) -> Growing:
    """Return a growth with an empty report."""
    return Growing(scale, rate, duration, events, np.zeros(GrowthReport.COUNT))


def new_flight(count: int) -> Flight:
    """Return room for the flight of some spheres."""
    return Flight(np.empty(count), np.empty(count), *(np.empty(count, np.int64) for _ in range(3)))
