"""Tables of the packing passes; `core/tables/packing_tables.hpp` declares their types and shapes."""

import numpy as np

from bondem._tables.columns import GrowthReport, RelaxationReport
from bondem._tables.packing_tables import Flight, Growing, Relaxing

# Columns of the sums of a block of spheres, and number of spheres in a block.
_SUMS, _BLOCK = 8, 128


def new_relaxing(count: int, tolerance: float, loose: float) -> Relaxing:
    """Return the table of a relaxation of `count` spheres down to a relative rms force or a mean overlap [m]."""
    part = np.zeros((-(-count // _BLOCK), _SUMS))
    return Relaxing(tolerance, loose, 0, np.zeros(3), part, np.zeros(RelaxationReport.COUNT))


def new_growing(scale: float, rate: float, duration: float, events: int) -> Growing:
    """Return the table of growth from `scale` at `rate` [1/s] for `duration` [s], or `events` collisions."""
    return Growing(scale, rate, duration, events, np.zeros(GrowthReport.COUNT))


def new_flight(count: int) -> Flight:
    """Return uninitialised work arrays for the flight of `count` spheres."""
    return Flight(np.empty(count), np.empty(count), *(np.empty(count, np.int64) for _ in range(3)))
