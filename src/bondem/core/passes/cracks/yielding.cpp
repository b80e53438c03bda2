// Cells that yield under their mean stress, and levers that their plastic deformation stretches.
#include "../../laws/plasticity.hpp"
#include "../../laws/stress.hpp"
#include "single_cracks.hpp"
#include "stress_state.hpp"

namespace bondem {
namespace {

// Columns of a cell.
enum Column : Index { deformation = 0, gamma = 9, increment = 10, heat = 16 };
// No stress σ is beyond Mohr and Coulomb's planes or a cone by more than √2 |σ| less their strength; the square, and
// something for rounding.
constexpr double reach = 2.01;

Symmetric3<double> strain_of(const YieldingCells &cells, Index p) {
    const double *e = &cells.plastic(p, increment);
    return {e[0], e[1], e[2], e[3], e[4], e[5]};
}

// Takes over what the last increment dissipated, and returns which share of the cohesion is left.
double close_increment(const StressesOfCells &stresses, const YieldingCells &cells, Index p) {
    if (!(cells.plastic(p, gamma) > 0.0)) return 1.0;
    cells.plastic(p, heat) += 0.5 * stresses.volume(p) * work_of(tensor_of(stresses, p), strain_of(cells, p));
    for (Index d = 0; d < 6; d++) cells.plastic(p, increment + d) = 0.0;
    return positive(1.0 - cells.fade(p) * cells.plastic(p, gamma));
}

void flow(const Moving &all, const StressesOfCells &stresses, const YieldingCells &cells, Index p, double g,
          const Symmetric3<double> &strain) {
    double *const row = &cells.plastic(p, 0);
    auto &P = *reinterpret_cast<PlasticDeformation<double> *>(row + deformation);
    P = deformed(P, turned_by(inverse(orientation(gather(all.pose.data, Short(p)))), strain));
    const double parts[6] = {strain.xx, strain.yy, strain.zz, strain.xy, strain.xz, strain.yz};
    for (Index d = 0; d < 6; d++) row[increment + d] += parts[d];
    row[gamma] += g;
    row[heat] += 0.5 * stresses.volume(p) * work_of(tensor_of(stresses, p), strain_of(cells, p));
}

// Cells that may flow, as many as there are lanes, with what is left of their cohesion.
struct Batch {
    Index count = 0, cell[lanes];
    double cohesion[lanes];
};
void flow_together(const Moving &all, const StressesOfCells &stresses, const YieldingCells &cells, Batch &batch) {
    if (batch.count == 0) return;
    for (Index n = batch.count; n < lanes; n++) {
        batch.cell[n] = batch.cell[0];
        batch.cohesion[n] = batch.cohesion[0];
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
                                     each([&](Index p) { return cells.stiffness(p); })};
    const PrincipalStress<Lanes> found = principal(s);
    const PlasticStep<Lanes> step = cells.cone ? cone_step(found, invariants(s), by) : slip_step(found, by);
    const Symmetric3<Lanes> strain = plastic_strain(found, step);
    for (int n = 0; n < batch.count; n++)
        if (step.gamma[n] > 0.0)
            flow(all, stresses, cells, batch.cell[n], step.gamma[n],
                 {strain.xx[n], strain.yy[n], strain.zz[n], strain.xy[n], strain.xz[n], strain.yz[n]});
    batch.count = 0;
}

template <class Number>
void stretch(const Array<int32_t, 2> &lever, const Array<Number, 2> &base, const Array<const double, 1> &pitch,
             const PlasticDeformation<double> &P, Index k) {
    const Vector b = {pitch(0) * double(base(0, k)), pitch(1) * double(base(1, k)), pitch(2) * double(base(2, k))};
    const Vector to = stretched(P, b);
    for (Index d = 0; d < 3; d++) lever(d, k) = int32_t(nearest(to[d] / pitch(d)));
}
const PlasticDeformation<double> &deformation_of(const YieldingCells &cells, Index p) {
    return *reinterpret_cast<const PlasticDeformation<double> *>(&cells.plastic(p, deformation));
}
void stretch_cell(const ElasticFacets &facets, const FacetsOfCells &of_cells, const YieldingCells &cells, Index p) {
    const PlasticDeformation<double> &P = deformation_of(cells, p);
    for (Index k = of_cells.in_start(p); k < of_cells.in_start(p + 1); k++)
        stretch(facets.lever_j, cells.base_j, facets.pitch, P, k);
    for (Index e = of_cells.out_start(p); e < of_cells.out_start(p + 1); e++)
        stretch(facets.lever_i, cells.base_i, facets.pitch, P, of_cells.in_start(0) + Index(of_cells.out_bond(e)));
}
bool grows(const YieldingCells &cells, Index p) {
    return cells.plastic(p, gamma) != 0.0 && work_of(strain_of(cells, p), strain_of(cells, p)) > 0.0;
}

}  // namespace

void yield_cells(const Turn &turn, const Moving &all, const FacetStrengths &, const StressesOfCells &stresses,
                 const YieldingCells &cells, const CrackOnset &onset) {
    if (!(turn.clock.dt > 0.0)) return;
    Batch batch;
    for (Index p = turn.first; p < turn.last; p++) {
        const double size = stresses.tensor(p, 7), whole = cells.cohesion(p);
        const bool flowed = cells.plastic(p, gamma) > 0.0;
        if (!flowed && reach * size * size < whole * whole) continue;
        const double kept = close_increment(stresses, cells, p);
        const YieldStrength<double> by = {kept * whole, cells.slope(p), cells.dilation(p), cells.stiffness(p)};
        if (flowed && kept == 0.0) onset.judged(p) = 2;
        if (!(yield_bound(invariants(tensor_of(stresses, p)), by, cells.cone != 0) > 0.0)) continue;
        batch.cell[batch.count] = p;
        batch.cohesion[batch.count++] = kept * whole;
        if (batch.count == lanes) flow_together(all, stresses, cells, batch);
    }
    flow_together(all, stresses, cells, batch);
}

void stretch_cells(const Turn &turn, const ElasticFacets &facets, const FacetsOfCells &of_cells,
                   const YieldingCells &cells) {
    if (!(turn.clock.dt > 0.0)) return;
    for (Index p = turn.first; p < turn.last; p++)
        if (grows(cells, p)) stretch_cell(facets, of_cells, cells, p);
}
void stretch_all_cells(const Turn &turn, const ElasticFacets &facets, const FacetsOfCells &of_cells,
                       const YieldingCells &cells) {
    for (Index p = turn.first; p < turn.last; p++)
        if (cells.plastic(p, gamma) != 0.0) stretch_cell(facets, of_cells, cells, p);
}
void stretch_walls_and_cracks(const Turn &turn, const ElasticFacets &facets, const WallConstraints &walls,
                              const YieldingCells &cells, const CohesiveCracks &cracks) {
    if (!(turn.clock.dt > 0.0)) return;
    for (Index g = 0; g < walls.cell.size(); g++) {
        const Vector b = stretched(deformation_of(cells, walls.cell(g)), cells.base_wall.row<const Vector>(g));
        for (Index d = 0; d < 3; d++) walls.arm(g, d) = b[d];
    }
    // in the order of facets: neighbours have the same cells
    for (Index k = 0, m = cracks.integrity.size(); k < m; k++)
        if (cracks.listed(k) != 0 && (grows(cells, facets.i(k)) || grows(cells, facets.j(k))))
            write_levers(facets, cracks, k);
}

void stretch_anew(const Turn &, const CellStrains &strains, const ElasticFacets &facets,
                  const FacetsOfCells &of_cells,
                  const WallConstraints &walls, const YieldingCells &cells) {
    if (!strains.due(1)) return;
    for (Index e = 0; e < cells.base_i.all(); e++) {
        cells.base_i.data[e] = facets.lever_i.data[e];
        cells.base_j.data[e] = facets.lever_j.data[e];
    }
    for (Index p = 0; p < cells.plastic.size(); p++)
        if (cells.plastic(p, gamma) != 0.0) stretch_cell(facets, of_cells, cells, p);
    for (Index g = 0; g < walls.cell.size(); g++) {
        cells.base_wall.row<Vector>(g) = walls.arm.row<Vector>(g);
        walls.arm.row<Vector>(g) = stretched(deformation_of(cells, walls.cell(g)), cells.base_wall.row<Vector>(g));
    }
}

void add_yielding_work(const Turn &turn, const FacetTractions &tractions, const StressesOfCells &stresses,
                       const YieldingCells &cells, const Rows &rows) {
    if (!(turn.clock.dt > 0.0)) return;
    for (Index l = 0; l < stresses.pressed.shape[0]; l++) {
        double power = 0.0;
        for (Index p = 0; p < cells.plastic.size(); p++) {
            const double *m = &stresses.pressed(l, p, 0);
            power += work_of({m[0], m[1], m[2], m[3], m[4], m[5]}, strain_of(cells, p));
        }
        rows.work(tractions.place) += tractions.factor(l) * power;
    }
}

}  // namespace bondem
