"""Check of the energy balance during a run."""

import warnings

import numpy as np

from bondem._names import users_line
from bondem._tables.columns import HistoryColumn
from bondem._types import Floats
from bondem.dynamics.history import STORED_ENERGIES, History
from bondem.errors import ImbalanceWarning
from bondem.model.model import Model
from bondem.model.state import State

# An imbalance counts once it has been beyond a limit for this many steps: a sudden load sets the shortest waves in
# motion, whose energy the scheme resolves worst and which soon is a small part of all.
_SUSTAINED = 200
# Displacement per step over the mean radius, and in units of the rounding of the largest coordinate. Energies of
# motions below the sum of both are rounding errors.
_STILL, _ROUNDING = 1e-9, 1e3
# Velocity Verlet lets the energy of the shortest waves oscillate, by a quarter of that of noise at 0.9 of the
# critical step. This oscillation does not grow. An error up to this share of the vibration energy therefore stops no
# run.
_SWING = 0.25


class EnergyCheck:
    """Check that compares the error of the energy balance with the energies of a run, record by record.

    Errors are relative to the largest energy so far: stored energies, and work and losses since the first record.
    The outcome depends on the records alone, so that a resumed run is checked like an uninterrupted one.
    """

    def __init__(self, model: Model, state: State, dt: float, limits: tuple[float, float], first: Floats) -> None:
        """Start a check from the first record of a run.

        Args:
            model: model of the run.
            state: initial state.
            dt: time step [s].
            limits: shares of the largest energy at which the check warns and stops the run; infinity for never [-].
            first: first record of the run, (1, columns).
        """
        self._limits, self._first = limits, first[:, :HistoryColumn.COUNT]
        self._span = (_SUSTAINED - 0.5) * dt
        coarse = _STILL * model.lattice.particles.mean_radius
        coarse += _ROUNDING * np.finfo(float).eps * float(np.abs(state.pose[:, :3]).max(initial=0.0))
        self._scale = 0.5 * float(model.mass.sum()) * (coarse / dt) ** 2
        self._good = [float(first[0, 0])] * 2  # last times within the limits
        self.remark = ""

    def examine(self, records: Floats) -> str:
        """Examine further records, (s, columns), and return a text about a balance beyond the second limit.

        The text is empty for a balance within this limit.

        Warns:
            ImbalanceWarning: The balance is beyond the first limit, but not the second; issued once.
        """
        if not len(records):
            return ""
        ledger = History(np.vstack([self._first, records[:, :HistoryColumn.COUNT]])).energy
        balance = ledger.pop("balance")[1:]
        sizes = [np.abs(values if name in STORED_ENERGIES else values - values[0]) for name, values in ledger.items()]
        sizes[0][0] = max(sizes[0][0], self._scale)
        scale = np.maximum.accumulate(np.max(sizes, axis=0))[1:]
        self._scale = float(scale[-1])
        parts = STORED_ENERGIES[:2], STORED_ENERGIES[2:]
        kinetic, elastic = (np.sum([ledger[name][1:] for name in part], axis=0) for part in parts)
        vibration = np.minimum(kinetic, elastic)
        missing = np.abs(balance), np.abs(balance) - _SWING * np.maximum(vibration, 0.0)
        shares = [one / np.where(scale > 0.0, scale, np.inf) for one in missing]
        texts = [self._beyond(level, records[:, 0], shares[level], balance) for level in (0, 1)]
        if texts[0] and not self.remark:
            self.remark = texts[0]
            if not texts[1]:
                warnings.warn(f"{texts[0]}; {_ADVICE}", ImbalanceWarning, stacklevel=users_line())
        return f"{texts[1]}; {_ADVICE}" if texts[1] else ""

    def _beyond(self, level: int, time: Floats, share: Floats, balance: Floats) -> str:
        """Return a text on the first record that ends a sustained excess over a limit, else an empty text."""
        above = ~(share <= self._limits[level])  # nan counts as beyond
        times = np.concatenate([[self._good[level]], np.where(above, -np.inf, time)])
        good = np.maximum.accumulate(times)[1:]
        self._good[level] = float(good[-1])
        found = np.flatnonzero(above & (time - good >= self._span))
        if not len(found):
            return ""
        k = found[0]
        way = "gained" if balance[k] > 0.0 else "lost"
        return (
            f"the run has {way} {abs(balance[k]):.3g} J that no load supplied and no loss accounts for, "
            f"{100.0 * share[k]:.2g} % of its largest energy, at t = {time[k]:.6g} s"
        )


_ADVICE = "use a smaller dt, or load more gently; imbalance= sets both limits"
