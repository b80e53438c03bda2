"""Columns of the walls of a state.

A row is displacement (3) and growth of the radius [m], their rates [m/s] (4), the force of the elements on the wall
(3) and on its radius [N], the work of the wall on the elements [J], and the sum of the normal forces [N].
"""

WALL_COLUMNS = 14
WALL_RATE, WALL_FORCE, WALL_WORK = 4, 8, 12
