"""Environment variables that must be read before the compiler is imported."""

import os

from bondem.errors import InputError


def use_environment() -> None:
    """Set the largest number of threads to BONDEM_NUM_THREADS; the default is all cores.

    Raises:
        InputError: the variable is not a positive whole number.
    """
    asked = os.environ.get("BONDEM_NUM_THREADS", "").strip()
    if not asked:
        return
    if not asked.isdecimal() or int(asked) == 0:
        raise InputError(f"BONDEM_NUM_THREADS = '{asked}' is not a number of threads; give a whole number from 1")
    os.environ.setdefault("NUMBA_NUM_THREADS", asked)
