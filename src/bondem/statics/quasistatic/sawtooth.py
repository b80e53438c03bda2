"""Softening in steps: a curve from the strength to an opening, followed by teeth within a band around it."""

from dataclasses import dataclass

import numpy as np

from bondem._core import run_pass
from bondem._passes import calls
from bondem._tables.stress_onset_tables import SofteningTeeth
from bondem._types import Floats


@dataclass(frozen=True)
class SofteningLine:
    """Traction of a softening facet: the larger of two straight lines in its opening (`core/laws/softening.hpp`).

    T stands for |F⁺| / A, the traction that the facet would have if it were whole, which is proportional to its gap;
    the facet carries s T.

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
        room = 64
        while True:
            left, limit, beyond = np.empty((3, room))
            number, curve = np.zeros(1, dtype=np.int64), (line.onset, line.last, line.kink, line.steep)
            run_pass(calls.cut_teeth(SofteningTeeth(*curve, ripple, now, left, limit, beyond, number)))
            steps = int(number[0]) - 1
            if steps <= room:
                return cls(np.append(left[:steps], 0.0), limit[:steps], beyond[:steps])
            room = steps
