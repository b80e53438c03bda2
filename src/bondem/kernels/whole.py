"""Rounding to whole numbers, in a form that CPUs and CUDA devices share (`numpy.rint` is unknown to CUDA)."""

from bondem._compile import device

# 1.5 · 2⁵²: adding it drops the fraction of a double, to the nearest whole number, halves to the even one
_WHOLE = 6755399441055744.0


@device
def whole(x):
    """The nearest whole number to x, as numpy.rint has it; |x| below 2⁵¹."""
    return (x + _WHOLE) - _WHOLE
