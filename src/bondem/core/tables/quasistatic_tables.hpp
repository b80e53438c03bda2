// What quasi-static loading takes: facets of any integrity in small motions, and the search for those that fail next.
// Named once more in `bondem/statics/quasistatic/facet_passes.py`.
#pragma once
#include "../array.hpp"

namespace bondem {

using Byte = uint8_t;

// Facets, m of them, about the reference; see `bondem/interactions/cells/cell_constants.py`.
struct WeakenedFacets {
    Array<const Index, 1> i, j;  // (m,)
    Array<const double, 1> k;  // [N/m]
    Array<const double, 1> area;  // [m²]
    Array<const double, 1> part;  // part of cell i in the compliance [-]
    Array<const double, 2> lever_i, lever_j;  // [m], (m, 3)
    Array<const double, 2> share_i, share_j;  // A w m [m²]
    Array<const double, 2> normal;  // [-]
    Array<const double, 3> H;  // [N·m], (m, 3, 3)
    Array<const double, 1> integrity;  // [-]
    Array<const Byte, 2> closed;  // halves that press, (m, 2)
};
// Small motions of n cells, and what follows from them.
struct SmallMotions {
    Array<const double, 2> displacement, rotation;  // [m, rad], (n, 3)
    Array<double, 2> gap;  // of the facets [m], (m, 3)
    Array<double, 1> swelling;  // V θ of the cells [m³], to which facets add, (n,)
};
// Loads of facets and cells at given stresses.
struct FacetLoading {
    Array<const double, 1> stress;  // λ θ of the cells [Pa], (n,)
    Array<double, 2> traction;  // [Pa], (m, 3)
    Array<double, 1> bending;  // T_b of each facet, as if it were whole [Pa], (m,)
    Array<double, 2> opening;  // traction of facets that have lost integrity, as if they were whole [Pa], (m, 3)
    Array<double, 1> opened;  // |F⁺| / A of these [Pa], (m,)
    Array<Byte, 2> turned;  // halves of these that close or open, (m, 2)
    Array<double, 2> moment;  // V σ of the cells, to which facets add, xx, yy, zz, xy, xz, yz [J], (n, 6)
};
// Facets and cells under a load factor of 1.
struct LoadedFacets {
    Array<const Index, 1> i, j;  // (m,)
    Array<const double, 2> normal, traction;  // [-], [Pa], (m, 3)
    Array<const double, 1> bending;  // T_b [Pa], (m,)
    Array<const double, 2> tensor;  // σ of each cell, xx, yy, zz, xy, xz, yz [Pa], (n, 6)
    Array<const double, 1> strength;  // f_t [Pa], (m,)
};
// Which whole facets begin to crack, and at what load factors.
struct OnsetSearch {
    Array<const Index, 1> whole;  // (c,)
    double below;  // factors above it do not count
    double spread;  // how far above the least of all a factor may be, over it
    Array<double, 1> factor;  // inf of facets that are passed over, (c,)
};

}  // namespace bondem
