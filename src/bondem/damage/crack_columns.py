"""Columns of the table of cracked facets in a state."""

# FACET: number of the facet. ONSET: strength [Pa], 0 where a cell had lost its cohesion. AXES: e_1, e_2, e_3 as a
# unit quaternion in the frame of cell i, w < 0 where e_3 = -e_1 × e_2. LEFT: s_1, s_2, s_3 and the grip γ on
# traction along the crack (`core/laws/crack.hpp`). BEFORE: these a step ago. ROOT: roots of the energies of an
# intact facet along e_1, e_2, e_3 and by bending, a step ago [√J]. SLIP: in the frame of cell i [m]. RUB: friction
# force a step ago in space [N], or slip in this step if there is grip [m]. SPENT: energy dissipated [J]. TOP: force
# below which a crack at rest does not soften [N]; once its faces have parted, distance of centres at which its cells
# touch [m]. FRESH: 1 for a crack new in this step. ONSET_STEP: step of onset, or nan.
FACET, ONSET, AXES, LEFT, ROOT, BEFORE, SLIP, RUB = 0, 1, 2, 6, 10, 14, 18, 21
STATUS, SPENT, TOP, FRESH, KIND, ONSET_STEP = 24, 25, 26, 27, 28, 29
CRACK_COLUMNS = 30
