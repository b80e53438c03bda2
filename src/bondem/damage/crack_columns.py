"""Columns of cracked facets and of yielding cells in a state."""

# Columns of a cracked facet: number of the facet, strength [Pa] (0 where one of its cells had lost its cohesion),
# slip in the frame of cell i [m], present -∂U/∂s [J], status, integrity a step ago, friction force a step ago in
# space [N], energy dissipated [J], and of a crack at rest the force below which it does not soften in any direction
# [N]. Once faces no longer face each other, it is the distance of centres at which their cells touch [m]. The last is
# the step of onset, nan if it is unknown.
FACET, ONSET, SLIP, RATE, STATUS, BEFORE, RUB, SPENT, TOP, ONSET_STEP = 0, 1, 2, 5, 6, 7, 8, 11, 12, 13
CRACK_COLUMNS = 14
# Status of a cracked facet: treated one by one; a facet of less stiffness among all others, while it is open and does
# not soften; or left out, once its faces no longer face each other.
ACTIVE, RESTING, PARTED = 0, 1, 2
# Columns of a cell that yields: P - 1 of its plastic deformation P in its own frame, row by row, Σ Δγ, the last
# increment of strain in space xx, yy, zz, xy, xz, yz, energy dissipated [J].
DEFORMATION, GAMMA, INCREMENT, HEAT = 0, 9, 10, 16
PLASTIC_COLUMNS = 17
