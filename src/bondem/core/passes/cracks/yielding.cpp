// Passes over cells that yield under their stress tensor, the average over the cell. Plastic deformation stretches
// the levers of a cell, which are the vectors from its centre to its facets.
#include "../../registered.hpp"
#include "yielding_cells.hpp"

namespace bondem {
namespace {

// Cells that may flow, as many as there are lanes, with their remaining cohesion [Pa] and the slip carried over.
struct Batch {
    Index count = 0, cell[lanes];
    double cohesion[lanes], carry[lanes];
};
void flow_together(const Moving &all, const StressesOfCells &stresses, const YieldingCells &cells, Batch &batch) {
    if (batch.count == 0) return;
    for (Index n = batch.count; n < lanes; n++) {
        batch.cell[n] = batch.cell[0];
        batch.cohesion[n] = batch.cohesion[0];
        batch.carry[n] = batch.carry[0];
    }
    const auto each = [&](const auto &of) {
        Lanes a;
        for (int n = 0; n < lanes; n++) a[n] = of(batch.cell[n]);
        return a;
    };
    const auto component = [&](Index c) { return each([&](Index p) { return stresses.tensor(p, c); }); };
    const Symmetric3<Lanes> s = {component(0), component(1), component(2), component(3), component(4), component(5)};
    const YieldStrength<Lanes> by = {load(batch.cohesion), each([&](Index p) { return cells.slope(p); }),
                                     each([&](Index p) { return cells.dilation(p); }),
                                     each([&](Index p) { return cells.stiffness(p); }), load(batch.carry)};
    const PlasticFlow<Lanes> found = flow_under(s, by, cells.cone != 0);
    const Symmetric3<Lanes> &e = found.strain;
    for (int n = 0; n < batch.count; n++)
        flow(all, stresses, cells, batch.cell[n],
             {found.gamma[n], found.carry[n], {e.xx[n], e.yy[n], e.zz[n], e.xy[n], e.xz[n], e.yz[n]}});
    batch.count = 0;
}

}  // namespace

// Applies plastic flow to the cells of a portion whose stress reaches their yield surface.
void yield_cells(const Range &range, const Moving &all, const FacetStrengths &, const StressesOfCells &stresses,
                 const YieldingCells &cells, const CrackOnset &onset) {
    if (!(range.clock.dt > 0.0)) return;
    Batch batch;
    for (Index p = range.first; p < range.last; p++)
        where_yields(stresses, cells, onset, p, [&](const YieldStrength<double> &by) {
            batch.cell[batch.count] = p;
            batch.carry[batch.count] = by.carry;
            batch.cohesion[batch.count++] = by.cohesion;
            if (batch.count == lanes) flow_together(all, stresses, cells, batch);
        });
    flow_together(all, stresses, cells, batch);
}
BONDEM_PASS(yield_cells, of_elements, "own pose tensor; ends slipped; adds carry plastic; changes judged")

// Stretches levers of facets with the plastic deformation of their cells, where it has grown.
void stretch_cells(const Range &range, const ElasticFacets &facets, const FacetsOfCells &of_cells,
                   const YieldingCells &cells) {
    if (!(range.clock.dt > 0.0)) return;
    for (Index p = range.first; p < range.last; p++)
        if (grows(cells, p)) stretch_cell(facets, of_cells, cells, p);
}
BONDEM_PASS(stretch_cells, of_elements, "ends plastic; changes slipped")

// Stretches levers of all facets with the plastic deformation of their cells, as a run begins.
void stretch_all_cells(const Range &range, const ElasticFacets &facets, const FacetsOfCells &of_cells,
                       const YieldingCells &cells) {
    for (Index p = range.first; p < range.last; p++)
        if (has_yielded(cells, p)) stretch_cell(facets, of_cells, cells, p);
}
BONDEM_PASS(stretch_all_cells, of_elements, "ends plastic; changes slipped")

// Stretches levers of walls and cracks with the plastic deformation of their cells, where it has grown.
void stretch_walls_and_cracks(const Range &range, const ElasticFacets &facets, const WallConstraints &walls,
                              const YieldingCells &cells, const CohesiveCracks &cracks) {
    if (!(range.clock.dt > 0.0)) return;
    for (Index g = 0; g < walls.cell.size(); g++) stretch_yielding_wall(walls, cells, g);
    // in the order of facets: neighbours have the same cells
    for (Index k = 0, m = cracks.integrity.size(); k < m; k++)
        if (cracks.listed(k) != 0) stretch_crack(facets, cells, cracks, k);
}
BONDEM_PASS(stretch_walls_and_cracks, of_cracks, "own base_wall; ends plastic; adds arm")

// Stretches levers with the plastic deformation of their cells, where stress-free strains have changed them.
void stretch_anew(const Range &, const CellStrains &strains, const ElasticFacets &facets,
                  const FacetsOfCells &of_cells,
                  const WallConstraints &walls, const YieldingCells &cells) {
    if (!strains.due(strain_due::levers)) return;
    for (Index e = 0; e < cells.base_i.all(); e++) {
        cells.base_i.data[e] = facets.lever_i.data[e];
        cells.base_j.data[e] = facets.lever_j.data[e];
    }
    for (Index p = 0; p < cells.plastic.size(); p++)
        if (has_yielded(cells, p)) stretch_cell(facets, of_cells, cells, p);
    for (Index g = 0; g < walls.cell.size(); g++) stretch_from_present(walls, cells, g);
}
BONDEM_PASS(stretch_anew, of_rows, "ends plastic; changes arm slipped; writes base_wall")

// Adds the work of loads on free facets that move as their cells yield to the rows of these cells.
void add_yielding_work(const Range &range, const FacetTractions &tractions, const StressesOfCells &stresses,
                       const YieldingCells &cells, const Rows &rows) {
    if (!(range.clock.dt > 0.0)) return;
    for (Index e = range.first_owner; e < range.last; e++)
        add_yielding_work_of(tractions, stresses, cells, rows, range.element[e]);
}
BONDEM_PASS(add_yielding_work, elements_of_blocks, "own plastic tensor")

}  // namespace bondem
