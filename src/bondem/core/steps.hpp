// A step as a list of passes, which Python composes and the core runs without returning to Python.
//
// A pass is a function over tables (structs of arrays and numbers). The list has no pass for a feature that the model
// lacks. `take_steps` calls the passes in their order, each with the tables that its entry names, and with a `Range`:
// the part of the step to process. The kind of the pass (`PassKind`) decides over which parts it runs.
//
// A block is a range of consecutive bonds, with the elements whose last bond is in the block. A domain is a range of
// blocks that one thread processes. Successive passes are called block by block, so that the data of a block remain
// in the cache. A pass over bonds that follows a pass over elements begins after all elements are processed.
//
// An element opens a step by the first change of its velocity and the change of its position. The second change of
// its velocity closes the step (`passes/motion/moving.hpp`). Elements whose bonds fail are postponed: they close the
// step with the others, but do not open the next one. At the end of the step a pass lists all postponed elements.
// Further passes then find the accelerations of these elements, with a time step of 0, and open their next step.
#pragma once
#include "tables/columns.hpp"
#include "tables/step_tables.hpp"

namespace bondem {

// Time of a call of passes, and the coefficients of the scheme.
struct Clock {
    double time, dt;  // [s]
    double finish, begin, extra;  // coefficients as in `StepScheme` [s, s, s²]
    Index step;
    Index first;  // 1 at the start of a call of the core, before its first step
    Index goes_on;  // 1 if elements open the next step
    Index record;  // row of the history
};

// Elements first … last - 1 of a list; those from `first_owner` on own rows of the boundary.
struct ElementList {
    Index first, last, first_owner;
    const Short *element, *row;
};
// Elements of a block that continue to the next step, and those that continue after failed bonds are removed.
struct ElementDivision {
    ElementList going, postponed;
};

// Part of a step for which a pass is called.
struct Range {
    const Clock &clock;
    Index first, last;  // bonds of a block, elements of a list, or a portion of all
    Index first_owner;  // elements first_owner … last - 1 of the list own rows of the boundary
    const Short *element, *row;  // the list, and rows of their sums
    Index block;  // number of the block or portion; of shared elements the number of blocks
    ElementDivision *division;  // division of the elements of a block, nullptr for other ranges
    Index threads;  // number that may share the tasks of a pass that is called once; 0 for other passes
};

// Parts of a step that a pass runs over. Passes of the kinds up to `single` are called once, for all parts; among
// these, only passes over cracks share portions among threads.
enum PassKind : Index {
    of_rows,  // rows of a table, in the order of the table
    of_cracks,  // cracks or their cells, of which threads may share portions
    of_events,  // events of the step, such as failures, in their order
    single,  // single numbers, such as those of a record
    bonds_of_blocks,  // bonds of a block
    elements_of_blocks,  // elements of a block, then shared ones
    parts_of_shared,  // elements that domains share
    of_elements,  // elements, in portions
    of_bonds,  // bonds, in portions
    divides_elements,  // elements of a block, which it divides
    postponed_of_blocks,  // postponed elements of a block
    of_ranges  // elements, one range per thread
};
inline bool called_once(PassKind kind) { return kind <= single; }

inline Index portions(Index count, Index size) { return (count + size - 1) / size; }

// ---- how a pass is called with the tables of its entry

using PassFunction = void (*)(const Range &, const void *const *);

template <Index... numbers> struct Numbers {};
template <Index n, Index... rest> struct CountTo : CountTo<n - 1, n - 1, rest...> {};
template <Index... numbers> struct CountTo<0, numbers...> {
    using type = Numbers<numbers...>;
};

template <auto pass> struct Called;
template <class... Tables, void (*pass)(const Range &, const Tables &...)> struct Called<pass> {
    template <Index... n> static void with(const Range &range, const void *const *tables, Numbers<n...>) {
        pass(range, *static_cast<const Tables *>(tables[n])...);
    }
    static void call(const Range &range, const void *const *tables) {
        with(range, tables, typename CountTo<sizeof...(Tables)>::type{});
    }
};

}  // namespace bondem
