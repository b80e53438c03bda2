// Axes of a crack of the material as the crack begins, before any loss of integrity.
//
// If the axes of neighbouring cracks differ, the cracks block each other, and too much energy is dissipated: 6 to 8 %
// more than the fracture energy at a notch, and 10 to 22 % where parts of a body rotate apart. A new crack therefore
// has the axes of the first rule that applies. σ is the mean stress of its two cells and all their neighbours, and e
// the direction of the largest principal stress of σ. Of some cells, the leading crack is the active crack that has
// lost most integrity.
//
// 1. The axes of the leading crack of its two cells, if any of these axes is within 45° of e. Behind the front of a
// crack the largest stress is often along the crack.
// 2. The axes of the leading crack of its two cells and all their neighbours, if the normal of that crack is within
// 45° of e. If all three axes counted here too, cracks under mixed mode would not curve.
// 3. The principal directions of σ.
#pragma once
#include "../../laws/principal.hpp"
#include "single_cracks.hpp"
#include "stress_state.hpp"

namespace bondem {

namespace crack {
constexpr double near_enough = 0.70710678118654752;  // cosine of 45°
}

// The crack that has lost most integrity along its first axis; facet -1 if none has lost any.
struct LeadingCrack {
    Index facet = -1;
    double left = 1.0;

    void add(const CohesiveCracks &cracks, Index k) {
        const double s = frame_of(cracks, k).left[0];
        if (s < left || (s == left && s < 1.0 && k < facet)) facet = k, left = s;
    }
};
// Finds the leading crack of cell p: the active crack of the material with a grip that has lost most integrity.
inline void find_leader(const CohesiveCracks &cracks, const CrackLists &lists, Index p) {
    LeadingCrack leader;
    for (Index h = lists.head(p); h > 0; h = lists.next(h)) {
        const Index k = facet_of(h);
        const bool grips = state_of(cracks, k).kind == crack::of_material && frame_of(cracks, k).left[3] > 0.0;
        if (grips && is_treated(cracks, k)) leader.add(cracks, k);
    }
    lists.leader(p) = int32_t(leader.facet);
}

// Sums over several cells, Σ V σ [J] and Σ V [m³], and their leading crack.
struct CellsAround {
    Symmetric3<double> sum = {};
    double volume = 0.0;
    LeadingCrack leader;

    void add(const StressesOfCells &stresses, const CohesiveCracks &cracks, const CrackLists &lists, Index p) {
        const double v = stresses.volume(p);
        sum = sum + v * tensor_of(stresses, p);
        volume += v;
        if (lists.leader(p) >= 0) leader.add(cracks, lists.leader(p));
    }
};

// Chooses the axes of crack k of the material. Those of other cracks, which are read, do not change in this pass,
// because these cracks have lost integrity along their first direction.
inline void choose_axes(const Moving &all, const ElasticFacets &facets, const CellSlack &of,
                        const StressesOfCells &stresses, const CohesiveCracks &cracks, const CrackLists &lists, Index k) {
    const Short cells[2] = {facets.i(k), facets.j(k)};
    CellsAround around;
    LeadingCrack own;
    const auto add = [&](Index p) { around.add(stresses, cracks, lists, p); };
    for (const Short p : cells) {
        if (lists.leader(p) >= 0) own.add(cracks, lists.leader(p));
        add(p);
        for_each_bond_of(of, p, [&](Index h, bool is_i) { add(is_i ? facets.j(h) : facets.i(h)); });
    }
    const PrincipalStress<double> here = principal((1.0 / around.volume) * around.sum);
    int first = 0;
    for (int d = 1; d < 3; d++)
        if (here.stress[d] > here.stress[first]) first = d;
    CrackAxes<double> axes = {{here.direction[first], here.direction[(first + 1) % 3], here.direction[(first + 2) % 3]}};
    const auto follows = [&](Index leader, int compared) {  // where one of its first `compared` axes is near
        if (leader < 0) return false;
        const Quaternion<double> turn = orientation(gather(all.pose.data, facets.i(leader)));
        const CrackAxes<double> other = axes_of(turn, quaternion_of(frame_of(cracks, leader).axes));
        for (int d = 0; d < compared; d++)
            if (absolute(dot(other.e[d], here.direction[first])) > crack::near_enough) return axes = other, true;
        return false;
    };
    if (!follows(own.facet, 3)) follows(around.leader.facet, 1);
    put_axes(cracks, k, orientation(gather(all.pose.data, cells[0])), axes);
}

}  // namespace bondem
