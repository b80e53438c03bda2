"""BLAS on one thread within the solvers.

Their dense algebra is thin (a few vectors, small blocks), so that threads gain nothing; contention with each other
and with the threads of the core can cost a factor of ten. A sum on one thread also has one order.
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
