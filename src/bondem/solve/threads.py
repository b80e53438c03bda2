"""BLAS on one thread within the solvers.

Their dense algebra is thin (a few vectors, small blocks), so threads gain nothing; waiting for each other and
for those of the kernels they can cost a factor of ten. And a sum of one thread has one order.
"""

from collections.abc import Callable
from typing import ParamSpec, TypeVar

import scipy.linalg  # noqa: F401  brings SciPy's BLAS in before libraries are counted
from threadpoolctl import ThreadpoolController

P = ParamSpec("P")
R = TypeVar("R")

_LIBRARIES = ThreadpoolController()


def one_blas_thread(function: Callable[P, R]) -> Callable[P, R]:
    """Decorate a function to run with BLAS on one thread."""
    return _LIBRARIES.wrap(limits=1, user_api="blas")(function)
