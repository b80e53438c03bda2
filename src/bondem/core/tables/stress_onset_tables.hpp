// Tables of the passes over facets that crack by a function of the stress.
#pragma once
#include "damage_tables.hpp"

namespace bondem {

// Facets that begin to crack by a function of the stress.
struct CandidateFacets {
    Array<const double, 1> scale;  // f_t without scatter over f_t of each facet, 0 of material planes [-], (m,)
    Array<const double, 1> area;  // [m²], (m,)
    double tension;  // f_t without scatter [Pa]
    double least;  // size √(σ:σ) below which no stress reaches the criterion [Pa]
    double hot;  // f_t below which the facets of a cell are not evaluated [Pa]
    Array<double, 1> along;  // largest principal stress at which a facet began to crack, else its f_t [Pa], (m,)
    Array<Index, 1> bond;  // arrays of `StressCandidates`, (candidates,)
    Array<double, 3> stress;  // (candidates, 3, 3)
    Array<const double, 1> found;  // (candidates,)
    Array<Index, 1> number;  // (bond_portions,)
    Array<const Index, 1> total;  // (1,)
};

}  // namespace bondem
