"""The limit of a quantity for ever more elements, from packings of several sizes.

Walls change the packing within a few radii of them, in a share of the volume that falls as N^(-1/3); edges, where two
walls meet, in one that falls as N^(-2/3). So

    y(N) = y_limit + a N^(-1/3) + b N^(-2/3)
"""

from dataclasses import asdict, dataclass
from typing import Any

import numpy as np

from bondem._types import Floats


@dataclass(frozen=True)
class Limit:
    """A fit of the above.

    Attributes:
        value: y_limit.
        error: its standard deviation, from the scatter of packings and, where that is more, of sizes about the fit.
        walls: a.
        edges: b.
        fewest: elements of the smallest packings in the fit.
        misfit: χ² per degree of freedom, of the means at each size against the scatter of packings [-]; 1 where the
            law holds.
    """

    value: float
    error: float
    walls: float
    edges: float
    fewest: int
    misfit: float

    def at(self, count: Floats) -> Floats:
        """The fit at numbers of elements."""
        x = count ** (-1.0 / 3.0)
        return self.value + self.walls * x + self.edges * x**2

    def as_dict(self) -> dict[str, Any]:
        """What a file of results holds."""
        return asdict(self)


def limit(count: Floats, value: Floats) -> Limit | None:
    """Fit the limit to single packings.

    Args:
        count: number of elements of each, (k,).
        value: what was measured, (k,).

    Returns:
        The fit, or None with fewer than five sizes or without a second packing of any.
    """
    size = np.unique(count)
    groups = [value[count == one] for one in size]
    freedom = sum(len(group) - 1 for group in groups)
    if len(size) < 5 or freedom < 1:
        return None
    mean = np.array([group.mean() for group in groups])
    # Independent parts of a packing add up: the variance over packings falls as 1/N, at all sizes by one factor.
    variance = sum(n * ((group - group.mean()) ** 2).sum() for n, group in zip(size, groups, strict=True)) / freedom
    deviation = np.sqrt(max(variance, 1e-300) / (size * np.array([len(group) for group in groups])))
    x = size ** (-1.0 / 3.0)
    terms = np.column_stack([np.ones_like(x), x, x**2]) / deviation[:, None]
    inverse = np.linalg.pinv(terms)
    chosen = inverse @ (mean / deviation)
    misfit = float(((terms @ chosen - mean / deviation) ** 2).sum()) / (len(size) - 3)
    error = float(np.sqrt((inverse[0] ** 2).sum() * max(misfit, 1.0)))
    return Limit(float(chosen[0]), error, float(chosen[1]), float(chosen[2]), int(size[0]), misfit)
