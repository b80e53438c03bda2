"""Softening of a facet in steps: its traction follows a sawtooth within a band around the softening curve."""

from dataclasses import dataclass

import numpy as np

from bondem._core import run_pass
from bondem._passes import calls
from bondem._tables.stress_onset_tables import SofteningTeeth
from bondem._types import Floats


@dataclass(frozen=True)
class SofteningLine:
    """Traction of a softening facet: the larger of two straight lines in its opening (`core/laws/softening.hpp`).

    T is the size of the traction that the facet would have with full integrity, which is proportional to its gap. The
    facet of integrity s carries s T.

    Attributes:
        onset: traction from which the facet softens [Pa].
        last: value of T at zero integrity [Pa], 0 for a brittle facet.
        kink: traction where both lines meet, over `onset` [-]; 0 for one line.
        steep: value of T at which the first line would reach zero, over `last` [-].
    """

    onset: float
    last: float
    kink: float = 0.0
    steep: float = 1.0


@dataclass(frozen=True, eq=False)
class Teeth:
    """Softening steps of a facet from its onset on, as a sawtooth.

    Between two events a facet of integrity s carries s T, with T the traction at full integrity. An event that
    reduces its integrity by Δs dissipates T² Δs, in units of A / 2k for area A and stiffness k.

    Attributes:
        integrity: integrity after events 1 … t, 0 after the last [-], (t,).
        limit: values of T at events 2 … t [Pa], (t - 1,).
        beyond: `limit` over the value of T at which the curve itself would soften the facet further [-], (t - 1,).
    """

    integrity: Floats
    limit: Floats
    beyond: Floats

    @classmethod
    def of(cls, line: SofteningLine, ripple: float, now: float = 0.0) -> "Teeth":
        """Return the softening steps for a curve; a brittle facet has one.

        The first event is at the onset. Later events occur where the traction exceeds the curve by the share
        `ripple`, but stay a little below the onset. Each drops the traction by as much below the curve. If `now`
        exceeds the onset, the traction first falls to the curve. The last event is placed so that all
        events together dissipate the energy under the curve. The band is cut off at the onset, and the last event
        compensates this energy. The beginning of the curve, which determines the peak load, stays unchanged.

        Args:
            line: curve of the material.
            ripple: half-width of the band as a share, in (0, 1).
            now: traction at full integrity at the beginning, if it exceeds the onset [Pa].
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
