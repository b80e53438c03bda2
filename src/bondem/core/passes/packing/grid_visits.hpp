// Visits of the spheres near a sphere, cell by cell of their grid.
#pragma once
#include "../../tables/packing_tables.hpp"
#include "periodic.hpp"

namespace bondem {

// Cells to visit along an axis; a periodic axis of one or two cells visits each once.
struct VisitedCells {
    Index first, last;
};
inline VisitedCells visited_cells(Index centre, Index cells, bool periodic) {
    if (!periodic) return {most(centre - 1, Index(0)), least(centre + 1, cells - 1)};
    if (cells < 3) return {0, cells - 1};
    return {centre - 1, centre + 1};
}

// Calls found(j) for every wanted neighbour j of sphere i, cell by cell.
template <class Wanted, class Found>
inline void visit_neighbours(const SphereGrid &grid, const Period &period, Index i, Wanted wanted, Found found) {
    const Index a = grid.cells(0), b = grid.cells(1), c = grid.cells(2);
    const Vector centre = grid.sphere.row<const Vector>(i);
    const double radius = grid.sphere(i, 3);
    const VisitedCells x = visited_cells(grid.cell(i) / (c * b), a, period.edge.x > 0.0);
    const VisitedCells y = visited_cells(grid.cell(i) / c % b, b, period.edge.y > 0.0);
    const VisitedCells z = visited_cells(grid.cell(i) % c, c, period.edge.z > 0.0);
    for (Index u = x.first; u <= x.last; u++)
        for (Index v = y.first; v <= y.last; v++)
            for (Index w = z.first; w <= z.last; w++) {
                const Index cell = ((u + a) % a * b + (v + b) % b) * c + (w + c) % c;
                for (Index p = grid.first(cell); p < grid.first(cell + 1); p++) {
                    const Index j = grid.member(p);
                    if (!wanted(j)) continue;
                    const Vector apart = period.nearest_image(grid.sphere.row<const Vector>(j) - centre);
                    const double reach = radius + grid.sphere(j, 3) + grid.skin;
                    if (dot(apart, apart) <= reach * reach) found(j);
                }
            }
}

}  // namespace bondem
