"""Variables of the environment that have to be read before the compiler is imported."""

import os

from bondem.errors import InputError


def use_environment() -> None:
    """Let BONDEM_NUM_THREADS be the largest number of threads; without it, all cores.

    Raises:
        InputError: the variable is no positive whole number.
    """
    asked = os.environ.get("BONDEM_NUM_THREADS", "").strip()
    if not asked:
        return
    if not asked.isdecimal() or int(asked) == 0:
        raise InputError(f"BONDEM_NUM_THREADS = '{asked}' is no number of threads; give a whole number from 1")
    os.environ.setdefault("NUMBA_NUM_THREADS", asked)
