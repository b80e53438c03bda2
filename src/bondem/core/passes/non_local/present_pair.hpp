// A bond of the non-local law, or as many as there are lanes, in a step: what it stores then, and what it does.
#pragma once
#include "bond_columns.hpp"

namespace bondem {

template <class T> struct PresentPair {
    PairPose<T> pose;
    PairStore<T> store;
    NonLocalLoads<T> loads;
};
// `mean()` returns the mean stress of both elements a step ago. A step of no time (`steps` is false) does not ask for it:
// the extra force stays what it is.
template <bool steps, class T, class Mean>
BONDEM_INLINE PresentPair<T> present_pair(const Ends<T> &ends, const PairShape<T> &shape, const PairStiffness<T> &stiffness,
                                          const PairLaw &law, const PairStore<T> &before, T s, Mean mean) {
    const PairPose<T> pose = pair_pose(ends.branch, ends.i, ends.j, shape);
    PairStore<T> store = {turned_by(inverse(ends.i), pose.gap), before.extra, before.taken};
    if constexpr (steps) store = after_step(before, mean(), pose, ends.i, s, stiffness, law);
    return {pose, store, non_local_loads(pose, turned_by(ends.i, store.extra), stiffness)};
}

}  // namespace bondem
