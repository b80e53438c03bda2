// Vectors between points of a periodic cell, over the nearest images.
#pragma once
#include "../../array.hpp"
#include "../../vector3.hpp"

namespace bondem {

// Edges of the cell, 0 along axes that are not periodic, and their inverses, 0 there too.
struct Period {
    Vector edge, inverse;

    explicit Period(const Array<const double, 1> &period) {
        for (Index a = 0; a < 3; a++) {
            edge[a] = period(a);
            inverse[a] = period(a) > 0.0 ? 1.0 / period(a) : 0.0;
        }
    }
    // A separation over the nearest images [m]. No branch: in the inner loop one costs half as much as the force.
    Vector nearest_image(Vector d) const {
        return {over_nearest_image(d.x, edge.x, inverse.x), over_nearest_image(d.y, edge.y, inverse.y),
                over_nearest_image(d.z, edge.z, inverse.z)};
    }
};

}  // namespace bondem
