// Changes by the failure of a bond of the non-local law: loads and stresses of its ends, and released energy.
#pragma once
#include "../damage/integrity.hpp"
#include "../damage/pipeline.hpp"
#include "bond_columns.hpp"

namespace bondem {

// Subtracts the loads of a bond from the kept sum of its end i, or of its end j.
inline void take_off_pair(double *row, bool is_i, const NonLocalBonds &bonds, Index k) {
    const double sign = is_i ? 1.0 : -1.0;
    take_off(row, sign, output_at(bonds, force_column, k), sign, output_at(bonds, is_i ? on_i_column : on_j_column, k));
}
inline Removal removal_of_pair(const Moving &all, const Beams &beams, const NonLocalBonds &bonds, Index k) {
    const double *const pose = all.pose.data;
    const PairPose<double> now = pair_pose(pose, beams, bonds, k);
    const PairStiffness<double> stiffness = pair_stiffness<double>(bonds, k);
    const SpringEnergy<double> energy = spring_energy(now, stiffness);
    const double gap = dot(now.gap, now.normal), pull = dot(output_at(bonds, force_column, k), now.normal);
    return {beams.integrity(k) * (energy.normal + energy.shear), gap,
            plus(centre(pose, beams.i(k)) + now.lever_i, 0.5, now.gap), undefined,
            positive(-most(gap, pull / stiffness.kn))};
}
// Subtracts the moment of the force of a bond from the stress of an element, in the frame of the element.
inline void relieve(const Moving &all, const LaggedStresses &stresses, Short p, bool is_i, const NonLocalBonds &bonds,
                    Index k) {
    const PairShape<double> shape = pair_shape<double>(bonds, k);
    const Vector force = output_at(bonds, force_column, k);
    const Vector own = turned_by(inverse(orientation(gather(all.pose.data, p))), force);
    const double sign = is_i ? 1.0 : -1.0;
    const Stress<double> s = (sign * stresses.inverse(p)) * symmetric_product(is_i ? shape.lever_i : shape.lever_j, own);
    for (Index c = 0; c < 6; c++) stresses.stress(p, c) -= s[c];
}
inline void end_pair(const NonLocalBonds &bonds, const BeamIntegrity &state, Index k) {
    for (Index c = 0; c < bonds.output.size(); c++) bonds.output(c, k) = 0.0;
    put_integrity(state, k, 0.0);
}

}  // namespace bondem
