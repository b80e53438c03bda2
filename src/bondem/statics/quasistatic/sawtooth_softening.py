"""Softening in steps: a curve from the strength to an opening, followed by teeth within a band around it."""

import math
from dataclasses import dataclass

import numpy as np

from bondem._types import Floats

# A facet whose strength has fallen to this share of that at its onset breaks next.
_REST = 0.12
# One that softens is weaker than one that has not begun by as little: it goes on, and others do not begin.
_BELOW = 0.999


@dataclass(frozen=True)
class SofteningLine:
    """Traction of a softening facet: the larger of two straight lines in its opening (`core/laws/softening.hpp`).

    T stands for |F⁺| / A, the traction that the facet would have if it were whole, which is proportional to its gap;
    the facet carries s T. Each line is s T = a - b (1 - s) T.

    Attributes:
        onset: traction from which the facet softens [Pa].
        last: T at zero integrity [Pa], 0 for a brittle facet.
        kink: traction where both lines meet, over `onset`; 0 for one line.
        steep: T at which the first line would reach zero, over `last`.
    """

    onset: float
    last: float
    kink: float = 0.0
    steep: float = 1.0

    @property
    def lines(self) -> tuple[tuple[float, float], ...]:
        """Coefficients a [Pa] and b [-] of each line."""
        end = self.steep * self.last
        first = self.onset, self.onset / end
        if self.kink == 0.0:
            return (first,)
        slope = self.kink * self.onset / (self.last - (1.0 - self.kink) * end)
        return first, (slope * self.last, slope)

    def borne(self, T: float) -> float:
        """Return s T at T [Pa]."""
        return max(0.0, *((a - b * T) / (1.0 - b) for a, b in self.lines))

    def reached(self, s: float, share: float) -> float:
        """Return T at which a facet of integrity s carries `share` times its traction on the curve [Pa]."""
        return max(share * a / (s * (1.0 - b) + share * b) for a, b in self.lines)

    def energy(self, now: float) -> float:
        """Return ∫ T² (-ds) from T = `now` on [Pa²]."""
        lines, taken = self.lines, 0.0
        ends = (
            [self.last]
            if len(lines) == 1
            else [self.kink * self.onset + (1.0 - self.kink) * self.steep * self.last, self.last]
        )
        for (a, b), end in zip(lines, ends, strict=True):
            taken += max(end - now, 0.0) * a / (1.0 - b)
            now = max(now, end)
        return taken


@dataclass(frozen=True, eq=False)
class Teeth:
    """Softening steps of a facet from its onset on.

    Between two events a facet is elastic with its integrity. At an event it loses some of its integrity and
    dissipates T² Δs, in units of A / 2k.

    Attributes:
        integrity: integrity after events 1 … t, falling to 0, (t,).
        limit: T of events 2 … t [Pa], (t - 1,).
        beyond: limits over the T at which the curve itself softens the facet further [-], (t - 1,).
    """

    integrity: Floats
    limit: Floats
    beyond: Floats

    @classmethod
    def of(cls, line: SofteningLine, ripple: float, now: float = 0.0) -> "Teeth":
        """Return the teeth of a curve; a brittle facet has one.

        The first event is at the onset. The others are at a traction `ripple` above the curve, as a share of it, and
        at most a little below that of the onset; each leaves the traction as much below the curve. If T is beyond the
        onset when a facet begins, the traction falls to the curve there. The last event is where all of them together
        have dissipated the energy under the curve: the energy missing from the band that is cut at the onset is added
        where a facet carries least. Peaks depend on the beginning of a curve, which stays unchanged.

        Args:
            line: curve of the material.
            ripple: half-width of the band as a share, in (0, 1).
            now: T at the beginning, if it exceeds the onset [Pa].
        """
        now = max(now, line.onset)
        if line.last <= now:
            return cls(np.zeros(1), np.zeros(0), np.zeros(0))
        integrity, limit = _steps(line, ripple, now)
        if len(limit):
            lost = integrity[:-1] - integrity[1:]
            taken = ripple / (1.0 - ripple) * float(integrity[0]) * now**2 + float(lost[:-1] @ limit[:-1] ** 2)
            before = float(limit[-2]) if len(limit) > 1 else now
            limit[-1] = max(before, math.sqrt(max(line.energy(now) - taken, 0.0) / float(lost[-1])))
        curve = np.array([line.reached(float(s), 1.0) for s in integrity[:-1]])
        return cls(integrity, limit, limit / curve)


def _steps(line: SofteningLine, ripple: float, now: float) -> tuple[Floats, Floats]:
    """Return integrities and limits within a band around a curve, from T = `now` on."""
    borne = line.borne(now)
    s, T = [(1.0 - ripple) * borne / now], []
    while borne > _REST * line.onset:
        T.append(min(line.reached(s[-1], 1.0 + ripple), _BELOW * line.onset / s[-1]))
        borne = line.borne(T[-1])
        s.append((1.0 - ripple) * borne / T[-1] if borne > _REST * line.onset else 0.0)
    if not T:
        s = [0.0]
    return np.array(s), np.array(T)
