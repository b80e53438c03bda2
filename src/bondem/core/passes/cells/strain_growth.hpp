// Growth of levers by the present stress-free strains: 1 + ε*.
#pragma once
#include "../../tables/cell_tables.hpp"
#include "../boundary/strain_factors.hpp"

namespace bondem {

inline double growth_of(const CellStrains &strains, Index k) {
    double sum = strains.still(k);
    for (Index g = 0; g < strains.schedule.size(); g++) sum += strains.factor(strain_factor::now, g) * strains.part(g, k);
    return sum;
}
inline double wall_growth(const CellStrains &strains, Index w) {
    double sum = strains.wall_still(w);
    for (Index g = 0; g < strains.schedule.size(); g++)
        sum += strains.factor(strain_factor::now, g) * strains.wall_part(g, w);
    return sum;
}

}  // namespace bondem
