// Passes over facets that a wall fixes or supports: places of the walls, dilatation, forces and work (`walls.hpp`).
#include "../../registered.hpp"
#include "../../tables/cell_tables.hpp"
#include "walls.hpp"

namespace bondem {
namespace {

void load_all(const Moving &all, const WallConstraints &walls, const Rows &rows) {
    for (Index g = 0; g < walls.cell.size(); g++) load_support(all.pose, all.rest, walls, g);
    set_rows(walls, rows);
}

void add_half_works(const WallConstraints &walls, const Rows &rows) {
    for (Index g = 0; g < walls.cell.size(); g++) add_half_work(walls, rows, g);
}

}  // namespace

// Moves walls to their places at the time of the clock, and updates their forces before the first step of a call.
void follow_walls(const Range &range, const Moving &all, const WallConstraints &walls, const Rows &rows) {
    for (Index g = 0; g < walls.cell.size(); g++) place_support(walls, range.clock.time, g);
    if (!range.clock.first) return;
    for (Index g = 0; g < walls.cell.size(); g++)
        for (Index axis = 0; axis < 3; axis++) walls.increment(g, axis) = 0.0;
    load_all(all, walls, rows);
}
BONDEM_PASS(follow_walls, of_rows, "own base; changes increment wall")

// Adds contributions of walls to V θ of their cells.
void add_wall_dilatation(const Range &, const Moving &all, const WallConstraints &walls,
                         const CellDilatation &cells) {
    for (Index g = 0; g < walls.cell.size(); g++)
        cells.swelling(walls.cell(g)) += dilatation_of_support(all.pose, all.rest, walls, g);
}
BONDEM_PASS(add_wall_dilatation, of_rows, "own arm pose wall; changes swelling")

// Sets the forces of walls on the rows of their cells, whose stresses are known, and adds the work of walls that
// move: the trapezoid of the force over the displacement.
void apply_walls(const Range &, const Moving &all, const WallConstraints &walls, const Rows &rows) {
    add_half_works(walls, rows);
    for (Index g = 0; g < walls.cell.size(); g++)
        all.loss(walls.cell(g), rubbed_loss) += slide_support(all.pose, all.rest, walls, g);
    load_all(all, walls, rows);
    add_half_works(walls, rows);
}
BONDEM_PASS(apply_walls, of_rows, "own arm pose pose.stress; changes base load loss wall; writes support")

// Adds the forces of walls to the sums of their cells.
void add_wall_loads(const Range &range, const Rows &rows, const StepBlocks &blocks) {
    for (Index e = range.first_owner; e < range.last; e++) {
        const double *load = &rows.support(rows.of(range.element[e]), 0);
        for (Index axis = 0; axis < 3; axis++) {
            blocks.sums(range.row[e], axis) += load[axis];
            blocks.sums(range.row[e], 4 + axis) += load[3 + axis];
        }
    }
}
BONDEM_PASS(add_wall_loads, elements_of_blocks, "own support; changes sums")

}  // namespace bondem
