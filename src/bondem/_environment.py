"""Environment variables that are checked when bondem is imported."""

import os

from bondem.errors import InputError


def check_environment() -> None:
    """Check BONDEM_NUM_THREADS, the largest number of threads (`bondem._threads`).

    Raises:
        InputError: the variable is not a positive whole number.
    """
    asked = os.environ.get("BONDEM_NUM_THREADS", "").strip()
    if asked and (not asked.isdecimal() or int(asked) == 0):
        raise InputError(f"BONDEM_NUM_THREADS = '{asked}' is not a number of threads; give a whole number from 1")
