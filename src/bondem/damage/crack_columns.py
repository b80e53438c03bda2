"""Columns of cracked facets in a state."""

# Columns of a cracked facet: number of the facet, strength [Pa] (0 where one of its cells had lost its cohesion); its
# axes e_1, e_2, e_3 as a unit quaternion in the frame of cell i (its scalar part is negative where e_3 = -e_1 × e_2);
# s_1, s_2, s_3 and the grip γ on what acts along the crack (`core/laws/crack.hpp`), their rates -∂U/∂s [J], and both
# a step ago; slip in the frame of cell i [m]; friction force a step ago in space [N], or, of one of the material
# that has its grip, its slip of this step in that frame [m]; status, energy dissipated [J], and of one at rest
# the force below which it does not soften in any direction [N]. Once faces no longer face each other, the last is the
# distance of centres at which their cells touch [m]. Then 1 for a crack that begins to be treated, its kind, and the
# step of onset, nan if it is unknown.
FACET, ONSET, AXES, LEFT, RATE, BEFORE, SLIP, RUB = 0, 1, 2, 6, 10, 14, 18, 21
STATUS, SPENT, TOP, FRESH, KIND, ONSET_STEP = 24, 25, 26, 27, 28, 29
CRACK_COLUMNS = 30
