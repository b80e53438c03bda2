"""Columns of failed bonds and of beams that soften in a state."""

# Columns of a failure: time [s], step, bond, mode, gap [m], energy released [J], place [m], and the number of time
# steps since the onset of softening, nan of bonds that failed at once.
BROKEN_TIME, BROKEN_STEP, BROKEN_BOND, BROKEN_MODE, BROKEN_GAP, BROKEN_ENERGY, BROKEN_PLACE = range(7)
OPENING_STEPS = 9
BROKEN_COLUMNS = 10
# Columns of a beam that has begun to soften: number of the beam, its opening λ then and where nothing is left [√J],
# -∂U/∂s a step ago [J], energy dissipated [J], mode of the larger part of the index, step of onset.
SOFT_BOND, FIRST, LAST, SOFT_RATE, SOFT_SPENT, SOFT_MODE, SOFT_ONSET = range(7)
SOFT_COLUMNS = 7
