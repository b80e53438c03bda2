// Neighbours of spheres by a grid of cells, for packing, shear bands and contact models. Contacts in a run have lists
// of their own (`passes/contacts/candidates.cpp`), by the same grid.
//
// Each pair is in the lists of both spheres, so that forces can be summed sphere by sphere. The order of sums does
// not depend on the number of threads.
#include "../../registered.hpp"
#include "../../tables/packing_tables.hpp"
#include "../../threads.hpp"
#include "grid_visits.hpp"

namespace bondem {
namespace {

constexpr Index block = 256;  // spheres in a task

Index cell_along(const SphereGrid &grid, Index i, Index axis) {
    const Index at = Index((grid.sphere(i, axis) - grid.lower(axis)) / grid.edge(axis));
    return within(at, Index(0), grid.cells(axis) - 1);
}

}  // namespace

// Sorts spheres into the cells of their grid: fills `cell`, `first`, `member` and `place`.
Index sort_into_cells(Index, const SphereGrid &grid) {
    const Index n = grid.sphere.size(), cells = grid.first.size() - 1;
    for (Index c = 0; c <= cells; c++) grid.first(c) = 0;
    for (Index i = 0; i < n; i++) {
        const Index c = (cell_along(grid, i, 0) * grid.cells(1) + cell_along(grid, i, 1)) * grid.cells(2);
        grid.cell(i) = c + cell_along(grid, i, 2);
        grid.first(grid.cell(i) + 1) += 1;
    }
    for (Index c = 0; c < cells; c++) grid.first(c + 1) += grid.first(c);
    // each cell is filled from its end, the last sphere first
    for (Index i = n - 1; i >= 0; i--) grid.member(--grid.first(grid.cell(i) + 1)) = Short(i);
    for (Index c = 0; c < cells; c++) grid.first(c) = grid.first(c + 1);
    grid.first(cells) = n;
    for (Index p = 0; p < n; p++)
        for (Index a = 0; a < 4; a++) grid.place(a, p) = grid.sphere(grid.member(p), a);
    return 0;
}
BONDEM_CALL(sort_into_cells, "")

// Sorts spheres into the cells of their grid, and sets `start` to running sums of their numbers of neighbours.
Index sort_and_count_neighbours(Index threads, const SphereGrid &grid) {
    sort_into_cells(threads, grid);
    const Index n = grid.sphere.size();
    const Period period(grid.period);
    for_each_in_tasks(threads, n, block, [&](Index i) {
        Index count = 0;
        visit_neighbours(grid, period, i, [&](Index j) { return j != i; }, [&](Index) { count++; });
        grid.start(i + 1) = count;
    });
    grid.start(0) = 0;
    for (Index i = 0; i < n; i++) grid.start(i + 1) += grid.start(i);
    return 0;
}
BONDEM_CALL(sort_and_count_neighbours, "")

// Lists the neighbours of spheres that are sorted and counted, start[n] numbers in all.
Index list_neighbours(Index threads, const SphereGrid &grid, const NeighbourLists &lists) {
    const Period period(grid.period);
    for_each_in_tasks(threads, grid.sphere.size(), block, [&](Index i) {
        Index k = grid.start(i);
        visit_neighbours(
            grid, period, i, [&](Index j) { return j != i; }, [&](Index j) { lists.neighbour(k++) = Short(j); });
    });
    return 0;
}
BONDEM_CALL(list_neighbours, "")

}  // namespace bondem
