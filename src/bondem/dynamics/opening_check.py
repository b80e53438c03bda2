"""Check of cracks that open in few time steps, whose fracture energy depends on the step.

The trapezoidal rule computes the work of forces at the ends of steps. It is exact along a straight line. Let a crack
open by d in the step that passes the corner at the strength. The error of the work is then at most d²/8 times the
change of slope there, and at most half the strength times d. With n steps of softening, d ≤ (1 - β) / (n - 1) times
the last opening, where β is the opening at the strength over the last one. Relative to the fracture energy of a
straight softening curve the error is

    error ≤ min((1 - β) / (n - 1), (1 - β) / (4 β (n - 1)²))

The corner at the last opening causes a smaller error. For n < 2 the error may be all of the energy, because one step
may end far beyond the last opening. Beams dissipate the exact energy in any number of steps
(`core/laws/beam_softening.hpp`).
"""

import warnings

import numpy as np

from bondem._names import users_line
from bondem._tables.columns import EventColumn
from bondem._types import Floats
from bondem.damage.softening_table import SofteningTable
from bondem.errors import UnresolvedOpeningWarning
from bondem.model.state import State

# Relative error of the fracture energy above which a run warns.
_LIMIT = 0.15


def warn_of_openings(state: State, dt: float) -> None:
    """Issue a warning if cracks that opened in few time steps make the fracture energy of a run uncertain.

    Args:
        state: state at the end of the run.
        dt: time step of the run [s].

    Warns:
        UnresolvedOpeningWarning: The fracture energy may be off by more than 15 %.
    """
    text = doubt_about_openings(state, dt)
    if text:
        warnings.warn(text, UnresolvedOpeningWarning, stacklevel=users_line())


def doubt_about_openings(state: State, dt: float) -> str:
    """Return the text of the warning of `warn_of_openings`; empty if the bound of the error is at most 15 %."""
    table = state.model.softening
    if table is None:
        return ""
    rows = state.broken[state.broken[:, EventColumn.TIME] > state.time - (state.step + 0.5) * dt]
    rows = rows[np.isfinite(rows[:, EventColumn.OPENING_STEPS])]
    # brittle facets and joints without cohesion have no curve
    rows = rows[np.isfinite(table.absorbed[rows[:, EventColumn.BOND].astype(np.int64)])]
    facet = rows[:, EventColumn.BOND].astype(np.int64)
    steps, energy = rows[:, EventColumn.OPENING_STEPS], rows[:, EventColumn.ENERGY]
    error = opening_error(table, facet, steps)
    whole = float(state.released[0])
    if not whole > 0.0 or not error @ energy > _LIMIT * whole:
        return ""
    fast = error > _LIMIT
    least, median, most = steps[fast].min(), float(np.median(steps[fast])), steps[fast].max()
    off, share, shorter = error @ energy / whole, energy[fast].sum() / whole, max(median, 0.5) / (most + 1.0)
    return (
        f"cracks open in so few time steps that the fracture energy may be off by {100.0 * off:.0f} %:"
        f" {fast.sum()} of {len(rows)} broken facets, with {100.0 * share:.0f} % of the energy, lost all within"
        f" {least:g} to {most:g} steps (median {median:g}); use a step of {dt * shorter:.1g} s by dt=,"
        f" or {shorter:.1g} of safety="
    )


def opening_error(table: SofteningTable, facet: np.ndarray, steps: Floats) -> Floats:
    """Return bounds of the relative error of the fracture energy of broken facets [-], (e,).

    Args:
        table: softening properties of the facets of the model.
        facet: internal numbers of the facets, (e,).
        steps: number of steps from onset to zero integrity of each, (e,).
    """
    first = table.strength[facet] / table.last[facet]
    step = (1.0 - first) / np.maximum(steps - 1.0, 1.0)
    kink, end = table.kink, table.steep * (1.0 - table.kink)
    area = 0.5 * (end * (1.0 + kink) + kink * (1.0 - end))  # under the curve, 1/2 for a straight line
    slopes = 1.0 / first + 1.0 / (table.steep - first)
    error = np.minimum(0.5 * step, 0.125 * step**2 * slopes) / area
    return np.where(steps < 2.0, 1.0, np.minimum(error, 1.0))
