// Heap sort by one thread, for lists that many threads have filled in any order.
#pragma once
#include "../scalars.hpp"

namespace bondem {

// Sorts places 0 … count - 1 by key(place), with swap(a, b) exchanging two of them.
template <class Key, class Swap> inline void sort_by_heap(Index count, Key key, Swap swap) {
    const auto sift = [&](Index root, Index end) {
        for (Index child = 2 * root + 1; child < end; child = 2 * root + 1) {
            if (child + 1 < end && key(child) < key(child + 1)) child++;
            if (key(root) >= key(child)) return;
            swap(root, child);
            root = child;
        }
    };
    for (Index root = count / 2 - 1; root >= 0; root--) sift(root, count);
    for (Index last = count - 1; last > 0; last--) {
        swap(0, last);
        sift(0, last);
    }
}

}  // namespace bondem
