"""Tractions on the free facets of cells, as far as they change the dilatation of the cells.

A traction opens its facet by its own half of the cell, and with it adds A d t·M⁻¹n / 2G to V θ. For constant loads
the energy ½ V λ θ² of the cells is the potential; a load that changes does the work σ d(V θ) on it.
"""

from bondem._compile import loop
from bondem.kernels.boundary import value_at
from bondem.kernels.cell_pass import STRESS


@loop(parallel=False)
def press(t, schedules, presses, given):
    """Bring the tractions to time t."""
    changed = False
    for l in range(len(presses.schedule)):
        now = value_at(schedules, presses.schedule[l], t)
        presses.came[l] = now - presses.factor[l]
        presses.factor[l] = now
        changed |= presses.came[l] != 0.0
    if changed:
        given[:] = 0.0
        for l in range(len(presses.schedule)):
            for p in range(len(given)):
                given[p] += presses.factor[l] * presses.value[l, p]


@loop(parallel=False)
def book_presses(pose, presses, work):
    """Half the work of tractions that change: once with the stresses before, and once with those after."""
    for l in range(len(presses.schedule)):
        if presses.came[l] != 0.0:
            power = 0.0
            for p in range(len(pose)):
                power += pose[p, STRESS] * presses.value[l, p]
            work[presses.place] += 0.5 * presses.came[l] * power
