"""Random numbers that a seed and the index of each number determine, independent of the order of computation."""

import numpy as np

from bondem._types import Floats, Ints

_GOLDEN = np.uint64(0x9E3779B97F4A7C15)


def uniform_by_counter(seed: int, many: int) -> Floats:
    """Return uniform numbers in (0, 1) for the counters 0 … many - 1, (many,).

    The numbers are the upper 53 bits of splitmix64 (Steele, Lea and Flood 2014), started from a hash of the seed.
    """
    with np.errstate(over="ignore"):
        start = _mixed(np.array([seed % 2**64], dtype=np.uint64) + _GOLDEN)
        bits = _mixed(start + (np.arange(many, dtype=np.uint64) + np.uint64(1)) * _GOLDEN)
    return ((bits >> np.uint64(11)).astype(float) + 0.5) * 2.0**-53


def uniform_by_cube(seed: int, cube: Ints, many: int) -> Floats:
    """Return `many` uniform numbers in (0, 1) for each cube of space, (k, many), by its three indices, (k, 3)."""
    with np.errstate(over="ignore"):
        bits = _mixed(np.full(len(cube), seed % 2**64, dtype=np.uint64) + _GOLDEN)
        for axis in cube.T:
            bits = _mixed(bits ^ (axis.astype(np.uint64) + _GOLDEN))
        each = _mixed(bits[:, None] + (np.arange(many, dtype=np.uint64) + np.uint64(1)) * _GOLDEN)
    return ((each >> np.uint64(11)).astype(float) + 0.5) * 2.0**-53


def _mixed(z: np.ndarray) -> np.ndarray:
    z = (z ^ (z >> np.uint64(30))) * np.uint64(0xBF58476D1CE4E5B9)
    z = (z ^ (z >> np.uint64(27))) * np.uint64(0x94D049BB133111EB)
    return z ^ (z >> np.uint64(31))
