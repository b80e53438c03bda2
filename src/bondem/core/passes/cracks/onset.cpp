// Passes that find the facets that begin to crack, and begin their cracks (`onset_of_facets.hpp`).
#include "../../registered.hpp"
#include "../../tables/cell_tables.hpp"
#include "../../tables/crack_tables.hpp"
#include "onset_of_facets.hpp"

namespace bondem {
namespace {

BONDEM_INLINE Vector3<Lanes> traction_of(const FacetForces &stored, Index m, Index k, Lanes area) {
    return (1.0 / area) * vector_at<Lanes>(stored.force.data, m, 0, k);
}
BONDEM_INLINE Lanes of_cells(const StressesOfCells &stresses, const Short *i, const Short *j, Index column,
                             bool smaller) {
    Lanes all;
    for (int n = 0; n < lanes; n++) {
        const double a = stresses.tensor.data[8 * Index(i[n]) + column],
            b = stresses.tensor.data[8 * Index(j[n]) + column];
        all[n] = smaller ? least(a, b) : a + b;
    }
    return all;
}

}  // namespace

// Marks facets of the material that begin to crack, and all whole facets of cells without cohesion.
void mark_cracking_facets(const Range &range, const Moving &all, const ElasticFacets &facets, const FacetForces &stored,
                          const FacetStrengths &strengths, const StressesOfCells &stresses,
                          const CrackOnset &onset) {
    if (!(range.clock.dt > 0.0)) return;
    const FacetColumns columns(facets);
    const Index m = columns.m;
    const Short *const at_i = facets.i.data, *const at_j = facets.j.data;
    const Byte *const judged = onset.judged.data;
    Index found = 0;
    const auto mark = [&](Index k, Byte how) {
        found += onset.marked(k) == 0;
        onset.marked(k) = how;
    };
    for_each_group(range.first, range.last, [&](Group group) {
        const Index k = group.first;
        int whole = 0, judged_here = 0;
        for (int n = 0; n < lanes; n++) whole += onset.listed.data[k + n] == 0;
        if (whole == 0) return;
        Byte now[lanes];
        for (int n = 0; n < lanes; n++) {
            now[n] = onset.listed.data[k + n] != 0 ? 0 : most(judged[at_i[k + n]], judged[at_j[k + n]]);
            judged_here += now[n] != 0;
        }
        if (judged_here == 0) return;
        const Lanes area = load(strengths.area.data + k), strength = load(strengths.strength.data + k);
        const Vector3<Lanes> t = traction_of(stored, m, k, area);
        const Short *const i = at_i + k, *const j = at_j + k;
        const Lanes size = of_cells(stresses, i, j, 7, false);
        const Lanes bends = of_cells(stresses, i, j, 6, true);
        const auto place = [&]() -> FacetInBody<Lanes> {
            const Ends<Lanes> ends = ends_of(gather(all.pose.data, i), gather(all.pose.data, j), columns.period);
            const Vector3<Lanes> n = vector_at<Lanes>(facets.normal.data, m, 0, k);
            const Symmetric3<Lanes> H = columns.stiffness<Lanes>(k, bondem::all<Lanes>(1.0)).H;
            const Symmetric3<Lanes> mean = mean_stress(gather_sums(stresses.tensor.data, i, j));
            return {turned_by(ends.i, n), mean, bending_traction(ends, load(stored.bends.data + k), H)};
        };
        const Mask<Lanes> begin = begins_to_crack(t, size, bends, strength, place);
        for (int n = group.known; n < lanes; n++) {
            if (now[n] == 2)
                mark(k + n, 2);
            else if (now[n] == 1 && begin[n] != 0 && strengths.plane(k + n) == 0.0)
                mark(k + n, 1);
        }
    });
    onset.found(range.block) = found;
}
BONDEM_PASS(mark_cracking_facets, of_bonds, "ends judged pose tensor")

// Marks facets of planes, such as joints, that begin to crack.
void mark_cracking_planes(const Range &range, const Moving &all, const ElasticFacets &facets, const FacetForces &stored,
                          const FacetStrengths &strengths, const CrackOnset &onset) {
    if (!(range.clock.dt > 0.0)) return;
    Index found = 0;
    for (Index e = 0; e < strengths.planes.size(); e++) {
        const Index k = strengths.planes(e);
        if (onset.listed(k) != 0 || onset.marked(k) != 0) continue;
        if (plane_begins(all, facets, stored, strengths, k)) {
            onset.marked(k) = 1;
            found++;
        }
    }
    onset.found(onset.found.size() - 1) = found;
}
BONDEM_PASS(mark_cracking_planes, of_rows, "ends pose")

// Begins the cracks of facets that are marked.
void begin_cracks(const Range &range, const ElasticFacets &facets, const FacetForces &stored,
                  const FacetStrengths &strengths,
                  const CrackOnset &onset, const CohesiveCracks &cracks) {
    if (!(range.clock.dt > 0.0)) return;
    const Index portions = onset.found.size() - 1;
    const auto begin = [&](Index k) {
        cracks.order(cracks.size(crack_number::cracks)++) = k;
        begin_crack(facets, stored, strengths, onset, cracks, k, range.clock.step);
    };
    const bool on_planes = onset.found(portions) > 0;
    for (Index q = 0; q < portions; q++) {
        if (onset.found(q) == 0 && !on_planes) continue;
        const Index first = q * bonds_of_portion, last = least(first + bonds_of_portion, onset.marked.size());
        for (Index k = first; k < last; k++)
            if (onset.marked(k) != 0) begin(k);
        onset.found(q) = 0;
    }
    onset.found(portions) = 0;
}
BONDEM_PASS(begin_cracks, of_events, "adds cracked")

}  // namespace bondem
