"""Softening in steps: a line from the strength to an opening followed by teeth within a band about it."""

from dataclasses import dataclass

import numpy as np

from bondem._types import Floats

# A facet whose strength has fallen to this share of that at its onset breaks next.
_REST = 0.12
# One that softens is weaker than one that has not begun by as little: it goes on, and others do not begin.
_BELOW = 0.999
# Until the energy is right: the number of teeth may change with the line, and the energy jumps then.
_ROUNDS = 8


@dataclass(frozen=True, eq=False)
class Teeth:
    """What a facet goes through from its onset on.

    Between two events a facet is elastic with its integrity; at an event it loses some of it. T stands for |F⁺| / A,
    the traction that the facet would have if it were whole, which is its gap but for a factor; it bears s T, and
    dissipates T² Δs per event, in units of A / 2k.

    Attributes:
        integrity: after events 1 … t, falling to 0, (t,).
        limit: T at which events 2 … t come [Pa], (t - 1,).
    """

    integrity: Floats
    limit: Floats

    @classmethod
    def of(cls, onset: float, last: float, ripple: float, now: float = 0.0) -> "Teeth":
        """Teeth of linear softening; a facet that breaks at once has one.

        The first event comes at the onset, the others where the traction is `ripple` above the line, as a share of
        it, but a little below that at the onset at most, and each leaves it as much below the line. The line is drawn
        out for all of them together to take the energy under that of the material, onset · last. Where T is beyond
        the onset when a facet begins, it falls to the line there.

        Args:
            onset: traction from which the facet softens [Pa].
            last: k u / A at the opening where nothing is left [Pa], 0 where it breaks at once (`softened`).
            ripple: in (0, 1).
            now: T as it begins, if that is more than the onset [Pa].
        """
        now = max(now, onset)
        if last <= now:
            return cls(np.zeros(1), np.zeros(0))
        wanted, longer = (last - now) * onset / (1.0 - onset / last), last
        integrity, limit = _steps(onset, longer, ripple, now)
        for _ in range(_ROUNDS):
            lost = integrity[:-1] - integrity[1:]
            taken = ripple / (1.0 - ripple) * integrity[0] * now**2 + float(lost @ limit**2)
            longer = now + (longer - now) * wanted / taken
            integrity, limit = _steps(onset, longer, ripple, now)
        return cls(integrity, limit)


def _steps(onset: float, last: float, ripple: float, now: float) -> tuple[Floats, Floats]:
    """Integrities and limits within a band about a line, from T = `now` on."""
    r = onset / last
    line = (1.0 - r * now / onset) / (1.0 - r)
    s, T = [(1.0 - ripple) * line * onset / now], []
    while line > _REST:
        above = (1.0 + ripple) * onset / (s[-1] * (1.0 - r) + (1.0 + ripple) * r)
        T.append(min(above, _BELOW * onset / s[-1]))
        line = (1.0 - r * T[-1] / onset) / (1.0 - r)
        s.append((1.0 - ripple) * line * onset / T[-1] if line > _REST else 0.0)
    if not T:
        s = [0.0]
    return np.array(s), np.array(T)
