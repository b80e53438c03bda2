#pragma once
#include "../../steps.hpp"
#include "../../tables/cell_tables.hpp"

namespace bondem {

// Brings walls to the time of the clock; where it was not reached by a step, their forces are brought up to date as well.
void follow_walls(const Turn &turn, const Moving &all, const WallConstraints &walls, const Rows &rows);
// Adds what walls contribute to V θ of their cells.
void add_wall_dilatation(const Turn &turn, const Moving &all, const WallConstraints &walls, const CellDilatation &cells);
// Sets the forces of walls on the rows of their cells, whose stresses are known, and adds the work of walls that move:
// the trapezoid of the force over the displacement.
void apply_walls(const Turn &turn, const Moving &all, const WallConstraints &walls, const Rows &rows);
// Adds the forces of walls to the sums of their cells.
void add_wall_loads(const Turn &turn, const Rows &rows, const StepCut &cut);

}  // namespace bondem
