"""Columns of failed bonds and of beams that soften in a state."""

# Columns of a failure: time [s], step, bond, mode, gap [m], energy released [J], place [m].
BROKEN_TIME, BROKEN_STEP, BROKEN_BOND, BROKEN_MODE, BROKEN_GAP, BROKEN_ENERGY, BROKEN_PLACE = range(7)
BROKEN_COLUMNS = 9
# Columns of a beam that has begun to soften: number of the beam, its opening λ then and where nothing is left [√J],
# -∂U/∂s a step ago [J], energy dissipated [J], mode of the larger part of the index.
SOFT_BOND, FIRST, LAST, SOFT_RATE, SOFT_SPENT, SOFT_MODE = range(6)
SOFT_COLUMNS = 6
