// Contribution of a contact to the stress of an element: the force, at the lever from the centre to the contact.
#pragma once
#include "../contacts/pairs.hpp"
#include "bond_columns.hpp"

namespace bondem {

// Levers of both elements of a pair with the branch d [m].
struct TouchLevers {
    Vector of_first, of_second;

    TouchLevers(const ContactConstants &c, const ContactPairs &pairs, Index k, Vector d) {
        const double ra = c.radius(pairs.first(k)), rb = c.radius(pairs.second(k));
        of_first = (ra / (ra + rb)) * d;
        of_second = (-rb / (ra + rb)) * d;
    }
};
inline void add_moment(const LaggedStresses &stresses, Short p, Vector lever, Vector force) {
    const Stress<double> s = symmetric_product(lever, force);
    for (Index c = 0; c < 6; c++) stresses.moment(p, c) += s[c];
}

}  // namespace bondem
