// Functions for observations of cells in given poses: rotated vectors, and moments of forces on cells.
#include "../../laws/rotations.hpp"
#include "../../registered.hpp"
#include "../../symmetric3.hpp"
#include "../../tables/cell_tables.hpp"

namespace bondem {

// Turns vectors by the quaternions of their elements.
Index turn_vectors(Index, const TurnedVectors &all) {
    for (Index e = 0; e < all.vector.size(); e++)
        all.turned.row<Vector>(e) = rotate(all.quaternion.row<const Quaternion<double>>(e), all.vector.row<const Vector>(e));
    return 0;
}
BONDEM_CALL(turn_vectors, "")

// Adds the moments sym b⊗f of forces about the centres of their owners, times a sign.
Index add_moments(Index, const MomentsOfForces &all) {
    for (Index e = 0; e < all.owner.size(); e++) {
        const Symmetric3<double> m = symmetric_product(all.sign * all.arm.row<const Vector>(e), all.force.row<const Vector>(e));
        const double parts[6] = {m.xx, m.yy, m.zz, m.xy, m.yz, m.xz};
        for (Index c = 0; c < 6; c++) all.moment(all.owner(e), c) += parts[c];
    }
    return 0;
}
BONDEM_CALL(add_moments, "")

}  // namespace bondem
