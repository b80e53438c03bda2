"""Bažant's size-effect law: nominal strengths of beams that are alike but for their size.

    σ_N = B f_t / √(1 + D / D₀),    1 / σ_N² = A D + C

Between a strength limit, C = 1 / (B f_t)², and linear fracture mechanics, where A = (k / K_Ic)² with K = k σ_N √D.

Reference: Bažant (1984); the straight line as RILEM TC 89 (1990) fits it.
"""

from dataclasses import dataclass

import numpy as np

from bondem._types import Floats


@dataclass(frozen=True)
class SizeEffect:
    """The law of one shape.

    Attributes:
        strength: B f_t, of small bodies [Pa].
        transition: D₀ [m].
    """

    strength: float
    transition: float

    @classmethod
    def fitted(cls, depth: Floats, nominal: Floats) -> "SizeEffect":
        """By least squares of 1 / σ_N² over D.

        Args:
            depth: D [m], (k,), two or more.
            nominal: σ_N [Pa], (k,).
        """
        slope, base = np.polyfit(depth, (np.min(nominal) / nominal) ** 2, 1)
        return cls(float(np.min(nominal) / np.sqrt(base)), float(base / slope))

    def nominal(self, depth: Floats) -> Floats:
        """σ_N [Pa] at depths [m]."""
        return self.strength / np.sqrt(1.0 + depth / self.transition)
