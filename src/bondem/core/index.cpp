// What Python finds in the library: its tables, its passes, and what the CPU is capable of.
#include "cell_descriptions.hpp"
#include "crack_descriptions.hpp"
#include "described.hpp"
#include "device_descriptions.hpp"
#include "exported.hpp"
#include "instructions.hpp"
#include "lagged_descriptions.hpp"
#include "lanes.hpp"
#include "passes/assembly/stiffness.hpp"
#include "passes/packing/growth.hpp"
#include "passes/packing/neighbours.hpp"
#include "passes/packing/relaxation.hpp"
#include "passes/surface/nearest_triangle.hpp"
#include "passes/tessellation/balance.hpp"
#include "passes/tessellation/clip_to_shape.hpp"
#include "passes/tessellation/interfaces.hpp"
#include "passes/tessellation/laguerre.hpp"
#include "passes/tessellation/measures.hpp"
#include "passes/tessellation/ownership.hpp"
#include "quasistatic_descriptions.hpp"
#include "statics_descriptions.hpp"
#include "step_descriptions.hpp"

namespace bondem {

#define F BONDEM_FIELD

BONDEM_TABLE(Spheres, F(sphere, "n 4"), F(unit, "n"), F(velocity, "n 3"), F(force, "n 3"), F(period, "3"), F(ease, "n"))
BONDEM_TABLE(PackingWalls, F(lower, "3"), F(upper, "3"), F(weight, "3"), F(radius, ""), F(corner, "3"), F(spacing, ""),
             F(depth, "grid_x grid_y grid_z"))
BONDEM_TABLE(Near, F(start, "n+1"), F(neighbour, "neighbours"), F(listed, "n 3"), F(slack, ""))
BONDEM_TABLE(Relaxing, F(tolerance, ""), F(loose, ""), F(steps, ""), F(fire, "3"), F(part, "blocks 8"), F(report, "5"))
BONDEM_TABLE(Growing, F(scale, ""), F(rate, ""), F(duration, ""), F(events, ""), F(report, "3"))
BONDEM_TABLE(Flight, F(since, "n"), F(when, "n"), F(what, "n"), F(heap, "n"), F(place, "n"))
BONDEM_TABLE(SphereGrid, F(sphere, "n 4"), F(lower, "3"), F(edge, "3"), F(period, "3"), F(cells, "3"), F(skin, ""),
             F(cell, "n"), F(first, "cells+1"), F(member, "n"), F(place, "4 n+8"), F(start, "n+1"))
BONDEM_TABLE(NeighbourLists, F(neighbour, "neighbours"))

BONDEM_TABLE(Bins, F(position, "n 3"), F(radius, "n"), F(lower, "3"), F(upper, "3"), F(period, "3"), F(boxes, "3"),
             F(start, "boxes+1"), F(member, "n"), F(bound, "n"), F(first, "n"), F(reach, ""), F(tolerance, ""))
BONDEM_TABLE(Solids, F(cell, "solids"), F(face, "solids+1"), F(tag, "faces"), F(plane, "faces 4"),
             F(corner, "faces+1"), F(vertex, "corners 3"))
BONDEM_TABLE(Pile, F(what, "* 4"), F(plane, "* 4"), F(vertex, "* 3"), F(used, "3"))
BONDEM_TABLE(CellRequest, F(chosen, "cells"), F(half, "cells"), F(found, "room"), F(offset, "room 4"),
             F(order, "room"), F(end, "cells+1"), F(done, "2"))
BONDEM_TABLE(CellRoom, F(plane, "402 4"), F(tag, "402"), F(size, "402"), F(vertex, "205824 3"), F(work, "512 3"),
             F(other, "512 3"))
BONDEM_TABLE(WallTree, F(corner, "triangles 3 3"), F(plane, "triangles 4"), F(lower, "boxes 3"), F(upper, "boxes 3"),
             F(owner, "leaves"))
BONDEM_TABLE(Splitting, F(position, "n 3"), F(tolerance, ""), F(found, "*"), F(below, "*"), F(lid, "512 3"),
             F(work, "512 3"), F(other, "512 3"), F(cell, "pieces"), F(end, "pieces"), F(done, "2"))
BONDEM_TABLE(Dividing, F(sphere, "n 4"), F(near, "claims"), F(start, "solids+1"), F(tolerance, ""), F(lid, "512 3"),
             F(work, "512 3"), F(cell, "parts"), F(owner, "parts"), F(end, "parts"), F(done, "2"))
BONDEM_TABLE(FaceGroups, F(of_face, "faces"), F(plus, "forth"), F(first, "groups+1"), F(minus, "back"),
             F(second, "groups+1"), F(shift, "groups 3"), F(tolerance, ""), F(work, "512 3"), F(other, "512 3"),
             F(done, "1"))
BONDEM_TABLE(PolygonMeasures, F(corner, "polygons+1"), F(vertex, "corners 3"), F(area, "polygons"),
             F(centroid, "polygons 3"), F(moment, "polygons 3 3"))
BONDEM_TABLE(Bulk, F(volume, "solids"), F(first, "solids 3"), F(second, "solids 3 3"), F(middle, "solids 3"),
             F(farthest, "solids"), F(beyond, "solids"))
BONDEM_TABLE(CellBranches, F(start, "n+1"), F(other, "sides"), F(branch, "sides 3"))
BONDEM_TABLE(BalanceField, F(given, "n 6"), F(found, "n 6"))

BONDEM_TABLE(BeamRows, F(i, "m"), F(j, "m"), F(direction, "3 m"), F(length, "m"), F(lever, "m"), F(kn, "m"), F(ks, "m"),
             F(kb, "m"), F(kt, "m"))
BONDEM_TABLE(FacetRows, F(i, "m"), F(j, "m"), F(k, "m"), F(lever_i, "m 3"), F(lever_j, "m 3"), F(H, "m 3 3"),
             F(share_i, "m 3"), F(share_j, "m 3"))
BONDEM_TABLE(BlockRows, F(in_start, "n+1"), F(out_start, "n+1"), F(out_bond, "m"), F(indptr, "n+1"),
             F(indices, "blocks"), F(data, "blocks 6 6"))
BONDEM_TABLE(DilatationRows, F(forms, "blocks 1 6"))

BONDEM_TABLE(TriangleTree, F(lower, "boxes 3"), F(upper, "boxes 3"), F(owner, "pieces"), F(corner, "triangles 3 3"),
             F(side, "triangles 3 3"), F(normal, "triangles 3"))
BONDEM_TABLE(Nearest, F(points, "points 3"), F(triangle, "points"))

#undef F

namespace {

const TableDescription tables[] = {
    described<Spheres>(), described<PackingWalls>(), described<Near>(), described<Relaxing>(), described<Growing>(),
    described<Flight>(), described<SphereGrid>(), described<NeighbourLists>(), described<Bins>(), described<Solids>(),
    described<Pile>(), described<CellRequest>(), described<CellRoom>(), described<WallTree>(), described<Splitting>(),
    described<Dividing>(), described<FaceGroups>(), described<PolygonMeasures>(), described<Bulk>(),
    described<CellBranches>(), described<BalanceField>(),
    described<BeamRows>(), described<FacetRows>(), described<BlockRows>(), described<DilatationRows>(),
    described<TriangleTree>(), described<Nearest>(),
    described<Moving>(), described<Beams>(), described<AlikeBeams>(), described<Dashpots>(), described<StepCut>(),
    described<StepScheme>(), described<Rows>(), described<Timeline>(), described<Drives>(), described<RowLoads>(),
    described<CoupleTable>(), described<BodyForces>(), described<Resistance>(), described<Strain>(),
    described<Poses>(), described<BeamSums>(), described<BeamEnergies>(), described<BeamTurns>(),
    described<Portions>(), described<Gauges>(), described<HistoryRows>(), described<StepPasses>(), described<StepSpan>(),
    BONDEM_DEVICE_TABLES,
    BONDEM_LAGGED_TABLES,
    BONDEM_STATICS_TABLES,
    BONDEM_DAMAGE_TABLES,
    BONDEM_CELL_TABLES,
    BONDEM_QUASISTATIC_TABLES,
    BONDEM_CONTACT_TABLES,
    BONDEM_CRACK_TABLES,
};

#define P(pass, outcomes) described(#pass, outcomes, pass)
const PassDescription passes[] = {
    P(relax_spheres, "converged out_of_date exhausted loose"),
    P(fly_and_grow, "grown list_out_of_date too_many_events"),
    P(sort_into_cells, ""),
    P(sort_and_count_neighbours, ""),
    P(list_neighbours, ""),
    P(make_cells, "cells_made crowded narrow swallowed lists_full pile_full"),
    P(split_by_walls, "all_split pieces_full scratch_full"),
    P(divide_solids, "all_divided parts_full room_full"),
    P(match_faces, "all_matched patches_full rest_full"),
    P(measure_polygons, ""),
    P(measure_solids, ""),
    P(apply_balance, ""),
    P(assemble_beams, ""),
    P(assemble_facets, ""),
    P(find_nearest_triangles, ""),
    P(load_beams, ""),
    P(load_alike_beams, ""),
    P(measure_beam_energies, ""),
    P(count_turned_beams, ""),
    BONDEM_LAGGED_LOADS,
    BONDEM_STATICS_PASSES,
    BONDEM_DAMAGE_INDICES,
    BONDEM_CELL_PASSES,
    BONDEM_QUASISTATIC_PASSES,
    BONDEM_CONTACT_SEARCH,
    BONDEM_CRACK_PASSES,
    P(take_steps, "sound not_finite runaway out_of_date"),
};
#undef P

// What a step is composed of.
#define S(kind, pass) described(#pass, kind, Called<pass>::call, pass)
const StepPassDescription step_passes[] = {
    S(serial, clear_row_forces),
    S(serial, follow_loads),
    S(serial, follow_couples),
    S(serial, follow_drives),
    S(serial, follow_body_forces),
    S(serial, follow_strains),
    S(of_elements, open_elements),
    S(of_elements, open_elements_and_rows),
    S(of_elements, open_body_work),
    S(bonds_of_blocks, add_beam_loads),
    S(bonds_of_blocks, add_alike_beam_loads),
    S(bonds_of_blocks, add_dashpot_loads),
    S(parts_of_shared, collect_sums),
    S(parts_of_shared, collect_dashpots),
    S(elements_of_blocks, add_dashpots),
    S(elements_of_blocks, add_body_forces),
    S(elements_of_blocks, move_elements),
    S(elements_of_blocks, move_rows),
    S(elements_of_blocks, move_resisted),
    S(elements_of_blocks, move_resisted_rows),
    S(elements_of_blocks, add_body_work),
    S(elements_of_blocks, reopen_elements),
    S(elements_of_blocks, reopen_rows),
    S(of_bonds, check_beams),
    S(of_bonds, sum_beam_energies),
    S(of_elements, sum_element_energies),
    S(serial, judge_energy),
    S(serial, write_ledger),
    S(serial, read_gauges),
    BONDEM_LAGGED_PASSES,
    BONDEM_DAMAGE_PASSES,
    BONDEM_CELL_STEP_PASSES,
    BONDEM_CONTACT_PASSES,
    BONDEM_CRACK_STEP_PASSES,
    BONDEM_STRESS_ONSET_PASSES,
};
#undef S

#define X(pass) IndexPass<pass>::described(#pass),
const PassDescription index_passes[] = {BONDEM_INDEX_PASSES(X)};
#undef X

}  // namespace
}  // namespace bondem

BONDEM_EXPORT const bondem::TableDescription *bondem_tables(bondem::Index *count) {
    *count = sizeof(bondem::tables) / sizeof(bondem::tables[0]);
    return bondem::tables;
}
BONDEM_EXPORT const bondem::PassDescription *bondem_passes(bondem::Index *count) {
    *count = sizeof(bondem::passes) / sizeof(bondem::passes[0]);
    return bondem::passes;
}
BONDEM_EXPORT const bondem::StepPassDescription *bondem_step_passes(bondem::Index *count) {
    *count = sizeof(bondem::step_passes) / sizeof(bondem::step_passes[0]);
    return bondem::step_passes;
}
BONDEM_EXPORT const bondem::PassDescription *bondem_index_passes(bondem::Index *count) {
    *count = sizeof(bondem::index_passes) / sizeof(bondem::index_passes[0]);
    return bondem::index_passes;
}
// Numbers of a register, as many as there are bonds in a group; tables of fewer bonds are filled.
BONDEM_EXPORT bondem::Index bondem_lanes() { return bondem::lanes; }
// The level that this library was compiled for.
BONDEM_EXPORT bondem::Index bondem_compiled_level() { return bondem::compiled_level; }
