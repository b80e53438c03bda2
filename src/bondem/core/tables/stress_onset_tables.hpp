// Tables of facets that begin to crack: by a function of the stress in a step, and under proportional loads.
#pragma once
#include "crack_tables.hpp"
#include "damage_tables.hpp"

namespace bondem {

// Facets that begin to crack by a function of the stress.
struct CandidateFacets {
    Array<const double, 1> scale;  // f_t without scatter over f_t of each facet, 0 of material planes [-], (m,)
    Array<const double, 1> area;  // [m²], (m,)
    double tension;  // f_t without scatter [Pa]
    double least;  // size √(σ:σ) below which no stress reaches the criterion [Pa]
    double hot;  // strength by which cells are evaluated: stresses of a cell count tension / hot times [Pa]
    Array<double, 1> along;  // largest principal stress at which a facet began to crack, else its f_t [Pa], (m,)
    Array<Index, 1> bond;  // arrays of `StressCandidates`, (candidates,)
    Array<double, 3> stress;  // (candidates, 3, 3)
    Array<const double, 1> found;  // (candidates,)
    Array<Index, 1> number;  // (bond_portions,)
    Array<const Index, 1> total;  // (1,)
};
// Facets and cells under a load factor of 1.
struct LoadedFacets {
    Array<const Index, 1> i;  // (m,)
    Array<const Index, 1> j;  // (m,)
    Array<const double, 2> normal;  // [-], (m, 3)
    Array<const double, 2> traction;  // [Pa], (m, 3)
    Array<const double, 1> bending;  // T_b [Pa], (m,)
    Array<const double, 2> tensor;  // σ of each cell, xx, yy, zz, xy, xz, yz [Pa], (n, 6)
};
// Whole facets, and the load factors at which they begin to crack.
struct OnsetSearch {
    Array<const Index, 1> whole;  // numbers of the facets, (whole,)
    double below;  // largest factor of interest
    double spread;  // largest factor over the least of all
    Array<double, 1> factor;  // load factor at onset, inf of facets that are not evaluated or never begin, (whole,)
};
// Facets that have begun to crack, and the load factors at which they soften further.
struct SofteningSearch {
    Array<const Index, 1> facet;  // (listed,)
    Array<const double, 2> traction;  // as if they were whole [Pa], (listed, 3)
    Array<const double, 1> integrity;  // [-], (listed,)
    Array<const double, 2> across;  // direction in which a facet softens alone, zero for all directions [-], (listed, 3)
    // load factor where the integrity along each of three directions falls below `integrity`, inf for never
    Array<double, 2> factor;  // (listed, 3)
    // for each direction [Pa]: traction as of a whole facet, at onset of softening, at zero integrity (0 if brittle)
    Array<double, 3> line;  // (listed, 3, 3)
    Array<double, 3> direction;  // these directions, by rows; without meaning for material planes, (listed, 3, 3)
    Array<double, 1> ended;  // load factors at which the integrity is zero in all directions, (listed,)
};
// Steps of a softening curve within a band around it.
struct SofteningTeeth {
    double onset;  // traction from which the facet softens [Pa]
    double last;  // T at zero integrity [Pa], 0 for a brittle facet
    double kink;  // κ of the curve [-]
    double steep;  // m of the curve [-]
    double ripple;  // half-width of the band, as a share
    double now;  // T at the beginning, if it exceeds the onset [Pa]
    Array<double, 1> left;  // integrity after each event but the last, after which it is zero, (teeth,)
    Array<double, 1> limit;  // T of the event that follows `left` [Pa], (teeth,)
    Array<double, 1> beyond;  // `limit` over the T at which the curve itself softens the facet further [-], (teeth,)
    Array<Index, 1> number;  // number of steps; only as many are written as there is room, (1,)
};

}  // namespace bondem
