// An array in memory that Python owns: its address and the lengths of its axes. The core allocates no memory.
//
// Arrays are contiguous, with the last axis fastest. `_core.py` checks type and lengths of each array once, as a
// table (a struct of arrays and numbers) is filled. The debug build (BONDEM_CHECKED) also checks indices.
#pragma once
#include "scalars.hpp"

namespace bondem {

#ifdef BONDEM_CHECKED
inline void require(bool sound) {
    if (!sound) __builtin_trap();
}
#else
inline void require(bool) {}
#endif

template <class T, int axes> struct Array {
    T *data;
    Index shape[axes];

    Index size() const { return shape[0]; }
    Index all() const {
        Index n = 1;
        for (int a = 0; a < axes; a++) n *= shape[a];
        return n;
    }
    T &operator()(Index i) const {
        static_assert(axes == 1);
        require(0 <= i && i < shape[0]);
        return data[i];
    }
    T &operator()(Index i, Index j) const {
        static_assert(axes == 2);
        require(0 <= i && i < shape[0] && 0 <= j && j < shape[1]);
        return data[i * shape[1] + j];
    }
    T &operator()(Index i, Index j, Index k) const {
        static_assert(axes == 3);
        require(0 <= i && i < shape[0] && 0 <= j && j < shape[1] && 0 <= k && k < shape[2]);
        return data[(i * shape[1] + j) * shape[2] + k];
    }
    // Row i of an array whose last axis contains the numbers of a V, such as a vector of three.
    template <class V> V &row(Index i) const {
        static_assert(axes == 2);
        require(0 <= i && i < shape[0] && shape[1] * Index(sizeof(T)) >= Index(sizeof(V)));
        return *reinterpret_cast<V *>(data + i * shape[1]);
    }
    template <class V> V &row(Index i, Index j) const {
        static_assert(axes == 3);
        require(0 <= i && i < shape[0] && 0 <= j && j < shape[1] && shape[2] * Index(sizeof(T)) >= Index(sizeof(V)));
        return *reinterpret_cast<V *>(data + (i * shape[1] + j) * shape[2]);
    }
};

}  // namespace bondem
