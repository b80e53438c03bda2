// Loop over the rows of a stiffness matrix of 6 × 6 blocks, one row per element. One thread fills a row of blocks.
#pragma once
#include "../../tables/stiffness_tables.hpp"
#include "../../threads.hpp"

namespace bondem {

// One 6×6 block of the motion (u, θ) of two elements.
struct Block {
    double *entry;

    double &operator()(Index r, Index c) const { return entry[6 * r + c]; }
    void clear() const {
        for (int e = 0; e < 36; e++) entry[e] = 0.0;
    }
};

inline Block block_at(const BlockRows &rows, Index slot) { return {&rows.data(slot, 0, 0)}; }

// Calls ends(bond, diagonal, slot) for every bond that ends in an element and begins(bond, diagonal, slot) for every
// bond that begins there, in the order of the columns; begin(diagonal) is called first in each row.
template <class Begin, class Ends, class Begins>
inline void for_each_row(Index threads, const BlockRows &rows, const Array<const Short, 1> &i,
                         const Array<const Short, 1> &j, Begin begin, Ends ends, Begins begins) {
    constexpr Index rows_of_a_task = 64;
    for_each_in_tasks(threads, rows.in_start.size() - 1, rows_of_a_task, [&](Index p) {
        Index slot = rows.indptr(p);
        const Index diagonal = slot + rows.in_start(p + 1) - rows.in_start(p);
        rows.indices(diagonal) = int32_t(p);
        block_at(rows, diagonal).clear();
        begin(diagonal);
        for (Index k = rows.in_start(p); k < rows.in_start(p + 1); k++, slot++) {
            rows.indices(slot) = int32_t(i(k));
            ends(k, diagonal, slot);
        }
        slot++;
        for (Index e = rows.out_start(p); e < rows.out_start(p + 1); e++, slot++) {
            const Index k = rows.out_bond(e);
            rows.indices(slot) = int32_t(j(k));
            begins(k, diagonal, slot);
        }
    });
}

}  // namespace bondem
