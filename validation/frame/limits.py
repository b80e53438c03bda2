"""What options of a study may be: words of a list, or numbers within bounds, one or several different ones."""

import math
from collections.abc import Callable, Collection
from typing import Any

from bondem._checks import shown
from bondem.errors import InputError

#: Refuses a value of an option, by the names of the study and of the option.
Limit = Callable[[str, str, Any], None]


def words(options: Collection[str]) -> Limit:
    """Words of a list."""
    return _limit(lambda one: one in options, 1, f"some of {', '.join(options)}")


def numbers(
    *, least: float = -math.inf, above: float = -math.inf, most: float = math.inf, below: float = math.inf,
    or_zero: bool = False, fewest: int = 1, advice: str = "",
) -> Limit:  # fmt: skip
    """Finite numbers within bounds, of which `least` and `most` are allowed.

    Args:
        least, above, most, below: bounds.
        or_zero: whether 0 is allowed beside them.
        fewest: how many are needed of an option that takes several.
        advice: end of the message, after "give"; made from the bounds by default.
    """
    bounds = (("at least", least), ("more than", above), ("at most", most), ("less than", below))
    wanted = advice or " and ".join(f"{word} {bound:g}" for word, bound in bounds if math.isfinite(bound))

    def fits(one: float) -> bool:
        within = math.isfinite(one) and least <= one <= most and above < one < below
        return within or (or_zero and one == 0)

    return _limit(fits, fewest, wanted)


def _limit(fits: Callable[[Any], bool], fewest: int, wanted: str) -> Limit:
    def check(study: str, name: str, value: Any) -> None:
        each = value if isinstance(value, tuple) else (value,)
        wrong = [one for one in each if not fits(one)]
        if wrong:
            raise InputError(f"{study}: {name} = {shown(wrong[0])}; give {wanted}")
        if isinstance(value, tuple) and not fewest <= len(each) == len(set(each)):
            raise InputError(f"{study}: {name} = {shown(value)}; give {fewest} or more different values, none twice")

    return check
