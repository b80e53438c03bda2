"""Limit of BLAS to one thread within the solvers.

Dense matrices of the solvers are small, so that more threads save no time. Contention of BLAS with the threads of the
core can cost a factor of ten. One thread also fixes the order of sums, and so their bits.
"""

from collections.abc import Callable
from typing import ParamSpec, TypeVar

import scipy.linalg  # noqa: F401  loads SciPy's BLAS before libraries are listed
from threadpoolctl import ThreadpoolController

P = ParamSpec("P")
R = TypeVar("R")

_LIBRARIES = ThreadpoolController()


def one_blas_thread(function: Callable[P, R]) -> Callable[P, R]:
    """Decorate a function to run with BLAS on one thread."""
    return _LIBRARIES.wrap(limits=1, user_api="blas")(function)
