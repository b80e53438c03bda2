// Axes of a crack of the material before any loss of integrity.
//
// Neighbouring facets with axes of their own block each other, which costs 6 to 8 % of the fracture energy at a
// notch. So a crack takes the axes of that crack of its two cells which has lost most, where the first of these is
// within 45° of the largest principal stress around it; else the principal directions of that stress, the mean over
// both cells and all their neighbours.
#pragma once
#include "../../laws/principal.hpp"
#include "single_cracks.hpp"
#include "stress_state.hpp"

namespace bondem {

namespace crack {
constexpr double near_enough = 0.70710678118654752;  // cosine of 45°
}

// Sum of V σ over a cell and its neighbours [J], and of V [m³].
struct StressAround {
    Symmetric3<double> sum = {};
    double volume = 0.0;

    void add(const StressesOfCells &stresses, Index p) {
        const double v = stresses.volume(p);
        sum = sum + v * tensor_of(stresses, p);
        volume += v;
    }
    void add_around(const ElasticFacets &facets, const CellSlack &of, const StressesOfCells &stresses, Index p) {
        add(stresses, p);
        for (Index k = of.in_start(p); k < of.in_start(p + 1); k++) add(stresses, facets.i(k));
        for (Index e = of.out_start(p); e < of.out_start(p + 1); e++)
            add(stresses, facets.j(of.in_start(0) + Index(of.out_bond(e))));
    }
};

// Chooses the axes of crack k of the material. Cracks of which it reads axes have lost some of their first direction, so
// that these do not change in this pass.
inline void choose_axes(const Moving &all, const ElasticFacets &facets, const CellSlack &of,
                        const StressesOfCells &stresses, const CohesiveCracks &cracks, const CrackLists &lists, Index k) {
    const Short cells[2] = {facets.i(k), facets.j(k)};
    Index leader = -1;
    double least_left = 1.0;
    StressAround around;
    for (const Short p : cells) {
        around.add_around(facets, of, stresses, p);
        for (Index h = lists.head(p); h > 0; h = lists.next(h)) {
            const Index other = facet_of(h);
            const double s = past_of(cracks, other).left[0];  // a step ago: that of others does not depend on their order
            if (state_of(cracks, other).kind > 0.0 || !(s < least_left || (s == least_left && s < 1.0 && other < leader)))
                continue;
            leader = other;
            least_left = s;
        }
    }
    const PrincipalStress<double> here = principal((1.0 / around.volume) * around.sum);
    int first = 0;
    for (int d = 1; d < 3; d++)
        if (here.stress[d] > here.stress[first]) first = d;
    const Quaternion<double> cell = orientation(gather(all.pose.data, cells[0]));
    if (leader >= 0) {
        const Quaternion<double> of_leader = orientation(gather(all.pose.data, facets.i(leader)));
        const CrackAxes<double> axes = axes_of(of_leader, quaternion_of(frame_of(cracks, leader).axes));
        if (absolute(dot(axes.e[0], here.direction[first])) > crack::near_enough) {
            put_axes(cracks, k, cell, axes);
            return;
        }
    }
    put_axes(cracks, k, cell, {{here.direction[first], here.direction[(first + 1) % 3], here.direction[(first + 2) % 3]}});
}

}  // namespace bondem
