// One crack at a time, for what concerns few of them: when they begin, rest, wake, or part.
#pragma once
#include "crack_groups.hpp"

namespace bondem {

inline double *constants_of(const CohesiveCracks &cracks, Index c) { return &cracks.constant(c, 0); }

// A crack in space, from the poses of its cells.
struct SingleCrack {
    Index facet;
    Ends<double> ends;
    FacetCompliance<double> stiffness;
    double area;
    FacedFaces<double> now;

    SingleCrack(const Array<double, 2> &pose, const double *period, const CohesiveCracks &cracks, Index c)
        : facet(cracks.facet(c)), ends(ends_of(gather(pose.data, cracks.i(c)), gather(pose.data, cracks.j(c)), period)) {
        const double *a = constants_of(cracks, c), *b = a + 8, *n = a + 16;
        stiffness = {a[6], a[7]};
        area = b[6];
        const FacetShape<double> shape = {{a[0], a[1], a[2]}, {b[0], b[1], b[2]}, {a[3], a[4], a[5]}, {b[3], b[4], b[5]}};
        now = crack_faces(ends, shape, {n[0], n[1], n[2]});
    }
    OfCells<double> stress(const Array<double, 2> &pose, const CohesiveCracks &cracks, Index c) const {
        return {pose(cracks.i(c), stress_column), pose(cracks.j(c), stress_column)};
    }
};
inline Vector row_vector(const CohesiveCracks &cracks, Index c, int column) {
    return {cracks.row(c, column), cracks.row(c, column + 1), cracks.row(c, column + 2)};
}
inline void put_vector(const CohesiveCracks &cracks, Index c, int column, Vector a) {
    for (int d = 0; d < 3; d++) cracks.row(c, column + d) = a[d];
}

// A half that adds nothing.
inline void clear_half(const CrackLists &lists, Index number) {
    for (Index c = 0; c < 7; c++) lists.half(number, c) = 0.0;
    lists.half(number, 7) = infinity;
    for (Index c = 0; c < 8; c++) lists.output(number, c) = 0.0;
}

// Treats a crack one by one from now on, or as a facet of its integrity among the others, or not at all.
inline void treat(const ElasticFacets &facets, const CohesiveCracks &cracks, Index c, int status) {
    const Index k = cracks.facet(c);
    cracks.row(c, crack::status) = status;
    cracks.listed(k) = Byte(1 + status);
    facets.integrity(k) = status == crack::active ? 0.0 : cracks.integrity(k);
    cracks.size(1) = 1;
}

// λ / V of a cell: of what its cracks lack that are not treated one by one, they are free facets.
inline void weigh_cracked(const CellDilatation &cells, const CellSlack &of, const CohesiveCracks &cracks, Index p) {
    double slack = 0.0;
    const auto add = [&](Index k, const Array<const double, 1> &side) {
        if (cracks.listed(k) > 1 + crack::active) slack += (1.0 - cracks.integrity(k)) * side(k);
    };
    for (Index k = of.in_start(p); k < of.in_start(p + 1); k++) add(k, of.slack_j);
    for (Index e = of.out_start(p); e < of.out_start(p + 1); e++)
        add(of.in_start(0) + Index(of.out_bond(e)), of.slack_i);
    cells.weight(p) = of.weight(p) / (1.0 + of.weight(p) * slack);
}

}  // namespace bondem
