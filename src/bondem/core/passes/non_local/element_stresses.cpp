// Stresses of elements of the non-local law, from the forces of their bonds and contacts, eq (1).
//
// The stress of an element is kept in its own frame, where it does not change when all turns together, and in space,
// where bonds take the mean of both ends. Forces of dashpots of bonds do not count.
#include "element_stresses.hpp"

#include "bond_columns.hpp"

namespace bondem {
namespace {

// As many elements as there are lanes; behind the end, the last one again and again.
struct Elements {
    Short place[lanes];

    BONDEM_INLINE Elements(Index first, Index last) {
        for (int n = 0; n < lanes; n++) place[n] = Short(least(first + n, last - 1));
    }
};

BONDEM_INLINE Stress<Lanes> own_stress(const LaggedStresses &stresses, const Elements &p) {
    const auto component = [&](Index c) { return number_at(stresses.stress.data, 6, c, p.place); };
    return {component(0), component(1), component(2), component(3), component(4), component(5)};
}

void turn(Index first, Index last, const double *pose, const LaggedStresses &stresses) {
    const Lanes zero = {};
    for (Index e = first; e < last; e += lanes) {
        const Elements p(e, last);
        const Stress<Lanes> s = turned_by(orientation(gather(pose, p.place)), own_stress(stresses, p));
        scatter(stresses.space.data, p.place, {{s.xx, s.yy, s.zz, s.xy, s.xz, s.yz, zero, zero}});
    }
}

}  // namespace

void turn_stresses(const Turn &portion, const Moving &all, const LaggedStresses &stresses) {
    turn(portion.first, portion.last, all.pose.data, stresses);
}
Index turn_all_stresses(Index, const Poses &all, const LaggedStresses &stresses) {
    turn(0, all.pose.size(), all.pose.data, stresses);
    return 0;
}

void collect_moments(const Turn &turn, const StepCut &cut, const LaggedStresses &stresses) {
    const Index n = stresses.inverse.size();
    for (Index e = turn.first; e < turn.last; e++)
        for (Index q = n + cut.part(e); q < n + cut.part(e + 1); q++)
            for (Index c = 0; c < 6; c++) {
                stresses.moment(turn.element[e], c) += stresses.moment(q, c);
                stresses.moment(q, c) = 0.0;
            }
}

void find_stresses(const Turn &turn, const Moving &all, const LaggedStresses &stresses) {
    for (Index e = turn.first; e < turn.last; e += lanes) {
        const Elements p(e, turn.last);
        const Lanes one = number_at(stresses.inverse.data, 1, 0, p.place);
        const Stress<Lanes> m = stress_of(gather(stresses.moment.data, p.place));
        clear(stresses.moment.data, p.place);
        const Stress<Lanes> s = one * m;
        const PrincipalBounds<Lanes> bounds = principal_bounds(s);
        scatter(stresses.space.data, p.place, {{s.xx, s.yy, s.zz, s.xy, s.xz, s.yz, bounds.largest, bounds.least}});
        const Stress<Lanes> own = turned_by(inverse(orientation(gather(all.pose.data, p.place))), s);
        const Lanes all_of_it[6] = {own.xx, own.yy, own.zz, own.xy, own.xz, own.yz};
        for (Index c = 0; c < 6; c++) put_number(stresses.stress.data, 6, c, p.place, all_of_it[c]);
    }
}

}  // namespace bondem
