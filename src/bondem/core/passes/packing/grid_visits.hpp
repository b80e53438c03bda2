// Search for the spheres near a sphere, by a grid of cells into which the spheres are sorted.
#pragma once
#include "../../lanes.hpp"
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

inline Index wrapped(Index at, Index cells) { return at < 0 ? at + cells : (at >= cells ? at - cells : at); }

// Mask of the members first … first + lanes - 1 of the grid whose gap to a sphere is at most `skin`, a bit each.
inline unsigned near_bits(const SphereGrid &grid, const Period &period, Vector centre, double radius, Index first) {
    const auto column = [&](Index axis) { return load(&grid.place(axis, first)); };
    const Lanes x = over_nearest_image(column(0) - centre.x, period.edge.x, period.inverse.x);
    const Lanes y = over_nearest_image(column(1) - centre.y, period.edge.y, period.inverse.y);
    const Lanes z = over_nearest_image(column(2) - centre.z, period.edge.z, period.inverse.z);
    const Lanes reach = radius + column(3) + grid.skin;
    return bits_of(x * x + y * y + z * z <= reach * reach);
}

// Calls found(j) for every wanted neighbour j of sphere i, cell by cell.
template <class Wanted, class Found>
inline void visit_neighbours(const SphereGrid &grid, const Period &period, Index i, Wanted wanted, Found found) {
    const Index a = grid.cells(0), b = grid.cells(1), c = grid.cells(2);
    const Vector centre = grid.sphere.row<const Vector>(i);
    const double radius = grid.sphere(i, 3);
    const auto visit_cells = [&](Index from, Index to) {
        const Index end = grid.first(to + 1);
        for (Index p = grid.first(from); p < end; p += lanes) {
            unsigned bits = near_bits(grid, period, centre, radius, p);
            if (end - p < lanes) bits &= (1u << (end - p)) - 1u;
            for (; bits != 0; bits &= bits - 1u) {
                const Index j = grid.member(p + __builtin_ctz(bits));
                if (wanted(j)) found(j);
            }
        }
    };
    const Index column = grid.cell(i) / c, row = column / b;
    const VisitedCells x = visited_cells(row, a, period.edge.x > 0.0);
    const VisitedCells y = visited_cells(column - row * b, b, period.edge.y > 0.0);
    const VisitedCells z = visited_cells(grid.cell(i) - column * c, c, period.edge.z > 0.0);
    for (Index u = x.first; u <= x.last; u++)
        for (Index v = y.first; v <= y.last; v++) {
            const Index base = (wrapped(u, a) * b + wrapped(v, b)) * c;
            // cells along z follow one another, but for those beyond a periodic edge
            if (z.first < 0) visit_cells(base + c - 1, base + c - 1);
            visit_cells(base + most(z.first, Index(0)), base + least(z.last, c - 1));
            if (z.last >= c) visit_cells(base, base);
        }
}

}  // namespace bondem
