// Derivatives of the loads of bonds by dual numbers: stiffness matrix times motions, and tangent matrix of each bond.
#pragma once
#include "../../tables/stiffness_tables.hpp"
#include "../beams/bonds.hpp"

namespace bondem {

// Sets the product of the stiffness and given motions; `load(poses)` adds the changes of the loads to the sums.
template <class Load> inline void multiply(const double *pose, const StiffnessProduct &by, Load load) {
    for (Index p = 0; p < by.given.size(); p++)
        for (Index c = 0; c < 8; c++) {
            by.motion(p, c) = c % 4 == 3 ? 0.0 : by.given(p, c - c / 4);
            by.sums(p, c) = 0.0;
        }
    load(MovedPoses{pose, by.motion.data});
    for (Index p = 0; p < by.given.size(); p++)
        for (Index c = 0; c < 6; c++) by.found(p, c) = -by.sums(p, c + c / 3);
}

// Sets the tangent of each bond, the derivative of minus its loads; `loads(k, rows)` are those from bond k on.
template <class Bonds, class Loads>
BONDEM_INLINE void differentiate(const double *pose, const Bonds &bonds, const BondTangents &to, Loads loads) {
    for_each_group(0, bonds.i.size(), [&](Group group) {
        const Index k = group.first;
        const PairOfRows<Lanes> at = gather(pose, bonds.i.data + k, bonds.j.data + k);
        for (Index c = 0; c < 12; c++) {
            PairOfRows<Lanes> by = {};
            (c < 6 ? by.first : by.second).column[c % 6 + (c % 6 > 2)] = Lanes{} + 1.0;
            const PairOfRows<Dual<Lanes>> rows = {moved(at.first, by.first), moved(at.second, by.second)};
            const auto found = loads(k, rows);
            const Vector3<Lanes> f = written(found.force), a = written(found.on_i), b = written(found.on_j);
            const Lanes rows_of[12] = {f.x, f.y, f.z, -a.x, -a.y, -a.z, -f.x, -f.y, -f.z, -b.x, -b.y, -b.z};
            for (Index r = 0; r < 12; r++) store(&to.tangent(r, c, k), rows_of[r]);
        }
    });
}

}  // namespace bondem
